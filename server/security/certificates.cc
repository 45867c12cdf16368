#include "server/security/certificates.h"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "server/security/small_file.h"

namespace dualarm {
namespace {

using Bio = std::unique_ptr<BIO, decltype(&BIO_free)>;
using X509Pointer = std::unique_ptr<X509, decltype(&X509_free)>;
using KeyPointer = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;

Bio bio_of(const std::string& text) { return {BIO_new_mem_buf(text.data(), static_cast<int>(text.size())), BIO_free}; }

// Never asks at the terminal.
int no_passphrase(char*, int, int, void*) { return 0; }

std::vector<X509Pointer> parse_certificates(const std::string& pem) {
  std::vector<X509Pointer> list;
  const Bio bio = bio_of(pem);
  while (X509* certificate = PEM_read_bio_X509(bio.get(), nullptr, no_passphrase, nullptr)) {
    list.emplace_back(certificate, X509_free);
  }
  ERR_clear_error();  // the end of the text is no news for whoever uses OpenSSL next
  return list;
}

KeyPointer parse_key(const std::string& pem) {
  return {PEM_read_bio_PrivateKey(bio_of(pem).get(), nullptr, no_passphrase, nullptr), EVP_PKEY_free};
}

std::string text_of(const ASN1_TIME& time) {
  const Bio bio(BIO_new(BIO_s_mem()), BIO_free);
  std::array<char, 64> text = {};
  ASN1_TIME_print(bio.get(), &time);
  const int length = BIO_read(bio.get(), text.data(), static_cast<int>(text.size()));
  return {text.data(), static_cast<std::size_t>(length > 0 ? length : 0)};
}

std::string summary_of(X509& certificate) {
  const std::unique_ptr<char, void (*)(char*)> subject(
      X509_NAME_oneline(X509_get_subject_name(&certificate), nullptr, 0), [](char* text) { OPENSSL_free(text); });
  return fmt::format("{} until {}", subject.get(), text_of(*X509_get0_notAfter(&certificate)));
}

// gRPC's own C++ credentials cannot be given a certificate later (but for a watcher that polls files and takes what it
// finds); its C interface can: it asks before each handshake.
class FetchingCredentials final : public grpc::ServerCredentials {
 public:
  explicit FetchingCredentials(grpc_server_credentials* credentials) : credentials_(credentials) {}
  ~FetchingCredentials() override { grpc_server_credentials_release(credentials_); }

  // Tokens are read by the service itself (admission.h).
  void SetAuthMetadataProcessor(const std::shared_ptr<grpc::AuthMetadataProcessor>& /*processor*/) override {}

 private:
  int AddPortToServer(const std::string& address, grpc_server* server) override {
    return grpc_server_add_http2_port(server, address.c_str(), credentials_);
  }

  grpc_server_credentials* credentials_;
};

}  // namespace

std::variant<Certificates, std::string> read_certificates(const std::string& chain_file, const std::string& key_file,
                                                          const std::string& client_ca_file) {
  const auto chain = small_file(chain_file);
  const auto key = small_file(key_file);
  const auto client_ca = client_ca_file.empty() ? std::optional(std::string()) : small_file(client_ca_file);
  if (!chain) return fmt::format("cannot read {}", chain_file);
  if (!key) return fmt::format("cannot read {}", key_file);
  if (!client_ca) return fmt::format("cannot read {}", client_ca_file);
  const std::vector<X509Pointer> certificates = parse_certificates(*chain);
  if (certificates.empty()) return fmt::format("{} holds no certificate in PEM", chain_file);
  X509& own = *certificates.front();
  if (X509_cmp_current_time(X509_get0_notAfter(&own)) < 0) {
    return fmt::format("the certificate in {} has expired: {}", chain_file, summary_of(own));
  }
  if (X509_cmp_current_time(X509_get0_notBefore(&own)) > 0) {
    return fmt::format("the certificate in {} is not valid yet: {}", chain_file, summary_of(own));
  }
  const KeyPointer parsed_key = parse_key(*key);
  if (parsed_key == nullptr) return fmt::format("{} holds no private key in PEM without a passphrase", key_file);
  if (X509_check_private_key(&own, parsed_key.get()) != 1) {
    return fmt::format("the key in {} is not that of the certificate in {}", key_file, chain_file);
  }
  if (!client_ca->empty() || !client_ca_file.empty()) {
    if (parse_certificates(*client_ca).empty()) return fmt::format("{} holds no certificate in PEM", client_ca_file);
  }
  return Certificates{*chain, *key, *client_ca, summary_of(own)};
}

void CertificateStore::replace(Certificates certificates) {
  const std::lock_guard lock(mutex_);
  certificates_ = std::move(certificates);
  fetched_ = false;
}

grpc_ssl_certificate_config_reload_status CertificateStore::fetch(void* store,
                                                                  grpc_ssl_server_certificate_config** config) {
  auto& self = *static_cast<CertificateStore*>(store);
  const std::lock_guard lock(self.mutex_);
  if (std::exchange(self.fetched_, true)) return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_UNCHANGED;
  const Certificates& current = self.certificates_;
  const grpc_ssl_pem_key_cert_pair pair = {current.key.c_str(), current.chain.c_str()};
  // gRPC wants authorities even where it asks clients for nothing; then any will do.
  const std::string& authorities = current.client_ca.empty() ? current.chain : current.client_ca;
  *config = grpc_ssl_server_certificate_config_create(authorities.c_str(), &pair, 1);
  return GRPC_SSL_CERTIFICATE_CONFIG_RELOAD_NEW;
}

std::shared_ptr<grpc::ServerCredentials> CertificateStore::credentials() {
  const auto request = certificates_.client_ca.empty() ? GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE
                                                       : GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY;
  return std::make_shared<FetchingCredentials>(grpc_ssl_server_credentials_create_with_options(
      grpc_ssl_server_credentials_create_options_using_config_fetcher(request, fetch, this)));
}

}  // namespace dualarm
