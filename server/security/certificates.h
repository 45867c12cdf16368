#pragma once

#include <grpc/grpc_security.h>
#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <mutex>
#include <string>
#include <variant>

namespace dualarm {

/// What TLS needs, in PEM.
struct Certificates {
  std::string chain;      ///< the server's certificate and those between it and a root
  std::string key;        ///< its private key, not encrypted
  std::string client_ca;  ///< who signs clients' certificates; "" for TLS that asks clients for none
  std::string summary;    ///< for the log: subject and end of validity of the server's certificate
};

/// Reads the files (client_ca_file may be "") and holds them against each other: the chain parses and is valid today,
/// the key is the certificate's, the authorities parse. Else what is wrong, with the file's name and no content.
std::variant<Certificates, std::string> read_certificates(const std::string& chain_file, const std::string& key_file,
                                                          const std::string& client_ca_file);

/// The certificates in use. They can be replaced at any time: handshakes that begin later use the new ones, connections
/// that stand stay as they are.
class CertificateStore {
 public:
  explicit CertificateStore(Certificates certificates) : certificates_(std::move(certificates)) {}
  CertificateStore(const CertificateStore&) = delete;
  CertificateStore& operator=(const CertificateStore&) = delete;

  void replace(Certificates certificates);

  /// For one listening port of one server. The store must outlive the server. Clients must present a certificate where
  /// the first certificates had authorities for them.
  std::shared_ptr<grpc::ServerCredentials> credentials();

 private:
  static grpc_ssl_certificate_config_reload_status fetch(void* store, grpc_ssl_server_certificate_config** config);

  std::mutex mutex_;
  Certificates certificates_;
  bool fetched_ = false;  // by gRPC, which asks at each handshake
};

}  // namespace dualarm
