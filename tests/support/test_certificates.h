#pragma once

#include <filesystem>
#include <string>

namespace dualarm {

/// Real certificates, made by the openssl program in a folder: authorities and whom they sign. Names are file stems:
/// authority("root") makes root.pem and root.key.
class TestCertificates {
 public:
  explicit TestCertificates(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// A new authority of this name.
  void authority(const std::string& name) const;

  /// A certificate for 127.0.0.1 and localhost whose common name is `name`, signed by `authority`, valid for so many
  /// days from now (0: it has ended when it is made).
  void certificate(const std::string& name, const std::string& authority, int days = 1) const;

  std::string pem(const std::string& name) const { return (folder_ / (name + ".pem")).string(); }
  std::string key(const std::string& name) const { return (folder_ / (name + ".key")).string(); }

 private:
  void openssl(const std::string& arguments) const;

  std::filesystem::path folder_;
};

/// The whole of a file, "" where there is none.
std::string content_of(const std::string& path);

/// (Over)writes a file.
void write_file(const std::string& path, const std::string& text);

}  // namespace dualarm
