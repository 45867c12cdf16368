#pragma once

#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/options.h"
#include "server/security/admission.h"
#include "server/security/certificates.h"

namespace dualarm {

/// Who may call and how the line is kept from others: certificates and tokens as the options name them.
class Security {
 public:
  /// Reads the files. Throws std::runtime_error, with a message for the operator, where they are no good.
  explicit Security(const ServerOptions& options);

  /// Reads the files again, certificates and tokens each for themselves: those that are good are used from now on, for
  /// the others the old ones stay. What was done goes into `news`; returns what is wrong, empty if nothing is.
  struct Reload {
    std::vector<std::string> news;
    std::vector<std::string> complaints;
  };
  Reload reload();

  /// For the listening port; this object must outlive the server.
  std::shared_ptr<grpc::ServerCredentials> credentials();

  Admission& admission() { return admission_; }

  /// "TLS, certificate CN=a until ...; 3 tokens", or what there is of it.
  const std::string& summary() const { return summary_; }

 private:
  ServerOptions options_;
  Admission admission_;
  std::optional<CertificateStore> certificates_;
  std::string summary_;
};

}  // namespace dualarm
