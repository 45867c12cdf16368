#include "clients/cpp/secure_channel.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "clients/cpp/command_error.h"

namespace dualarm {
namespace {

constexpr int kConnectTimeoutMilliseconds = 5000;

std::string content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream || text.empty()) throw CommandError(ExitStatus::kInvalid, file + ": cannot be read, or is empty");
  return text;
}

std::shared_ptr<grpc::ChannelCredentials> credentials_of(const ConnectionOptions& options) {
  if (options.tls_ca.empty()) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions tls;
  tls.pem_root_certs = content(options.tls_ca);
  if (!options.tls_cert.empty()) {
    tls.pem_cert_chain = content(options.tls_cert);
    tls.pem_private_key = content(options.tls_key);
  }
  return grpc::SslCredentials(tls);
}

// "127.example.com" does not.
bool stays_on_this_machine(std::string_view address) {
  const std::string_view host = address.substr(0, address.rfind(':'));
  const bool numeric = host.find_first_not_of("0123456789.") == std::string_view::npos;
  return address.starts_with("unix:") || host == "localhost" || host == "[::1]" ||
         (host.starts_with("127.") && numeric);
}

}  // namespace

std::shared_ptr<grpc::Channel> open_channel(const std::string& address, const ConnectionOptions& options) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, kConnectTimeoutMilliseconds);
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);  // the address given is the address meant
  arguments.SetMaxReceiveMessageSize(-1);           // a plan of any length is welcome
  return grpc::CreateCustomChannel(address, credentials_of(options), arguments);
}

std::string token_for(const ConnectionOptions& options) {
  if (options.token_file.empty()) return "";
  if (options.tls_ca.empty() && !stays_on_this_machine(options.server)) {
    throw CommandError(ExitStatus::kInvalid,
                       "a token sent to " + options.server + " in plaintext could be read by others: give --tls-ca");
  }
  std::string token = content(options.token_file);
  constexpr char kSpace[] = " \t\r\n";
  token.erase(0, std::min(token.find_first_not_of(kSpace), token.size()));
  token.erase(token.find_last_not_of(kSpace) + 1);
  const bool printable = std::all_of(token.begin(), token.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (token.empty() || !printable) throw CommandError(ExitStatus::kInvalid, options.token_file + ": holds no token");
  return token;
}

}  // namespace dualarm
