#include "tests/support/test_certificates.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace dualarm {

void TestCertificates::authority(const std::string& name) const {
  openssl("req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=" + name + " -keyout " +
          name + ".key -out " + name + ".pem -addext basicConstraints=critical,CA:TRUE");
}

void TestCertificates::certificate(const std::string& name, const std::string& authority, int days) const {
  write_file((folder_ / (name + ".ext")).string(), "subjectAltName=IP:127.0.0.1,DNS:localhost\n");
  openssl("req -new -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj /CN=" + name + " -keyout " + name +
          ".key -out " + name + ".csr");
  openssl("x509 -req -in " + name + ".csr -CA " + authority + ".pem -CAkey " + authority +
          ".key -CAcreateserial -days " + std::to_string(days) + " -extfile " + name + ".ext -out " + name + ".pem");
}

void TestCertificates::openssl(const std::string& arguments) const {
  const std::string command = "cd '" + folder_.string() + "' && openssl " + arguments + " >openssl.log 2>&1 </dev/null";
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error(command + ": " + content_of((folder_ / "openssl.log").string()));
  }
}

std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace dualarm
