#include "server/security/security.h"

#include <fmt/format.h>

#include <stdexcept>

#include "server/security/token_table.h"

namespace dualarm {
namespace {

std::variant<Certificates, std::string> certificates_of(const ServerOptions& options) {
  return read_certificates(options.tls_cert, options.tls_key, options.tls_client_ca);
}

std::string on(const Certificates& certificates) {
  return fmt::format("{}TLS with {}", certificates.client_ca.empty() ? "" : "mutual ", certificates.summary);
}

}  // namespace

Security::Security(const ServerOptions& options) : options_(options), summary_("plaintext") {
  if (!options.tls_cert.empty()) {
    auto read = certificates_of(options);
    if (const auto* complaint = std::get_if<std::string>(&read)) throw std::runtime_error(*complaint);
    summary_ = on(std::get<Certificates>(read));
    certificates_.emplace(std::get<Certificates>(std::move(read)));
  }
  if (options.token_file.empty()) return;
  auto read = read_tokens(options.token_file, options.token_concurrency);
  if (const auto* complaint = std::get_if<std::string>(&read)) throw std::runtime_error(*complaint);
  summary_ += fmt::format("; {} tokens", std::get<TokenTable>(read).size());
  admission_.set_tokens(std::get<TokenTable>(std::move(read)));
}

Security::Reload Security::reload() {
  Reload result;
  if (certificates_) {
    auto read = certificates_of(options_);
    if (const auto* complaint = std::get_if<std::string>(&read)) {
      result.complaints.push_back(*complaint + "; the certificates in use stay");
    } else {
      result.news.push_back(on(std::get<Certificates>(read)));
      certificates_->replace(std::get<Certificates>(std::move(read)));
    }
  }
  if (!options_.token_file.empty()) {
    auto read = read_tokens(options_.token_file, options_.token_concurrency);
    if (const auto* complaint = std::get_if<std::string>(&read)) {
      result.complaints.push_back(*complaint + "; the tokens in use stay");
    } else {
      result.news.push_back(fmt::format("{} tokens", std::get<TokenTable>(read).size()));
      admission_.set_tokens(std::get<TokenTable>(std::move(read)));
    }
  }
  return result;
}

std::shared_ptr<grpc::ServerCredentials> Security::credentials() {
  return certificates_ ? certificates_->credentials() : grpc::InsecureServerCredentials();
}

}  // namespace dualarm
