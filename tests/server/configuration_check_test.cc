#include "server/configuration_check.h"

#include <gmock/gmock.h>

#include "tests/server/test_server.h"
#include "tests/support/test_certificates.h"

namespace dualarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ConfigurationCheck : public ::testing::Test {
 protected:
  ConfigurationCheck() {
    certificates_.authority("root");
    certificates_.certificate("server", "root");
    write_file(path("tokens"), "a aaaaaaaaaaaaaaaa\n");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  ServerOptions with_tls() const {
    ServerOptions options;
    options.tls_cert = certificates_.pem("server");
    options.tls_key = certificates_.key("server");
    return options;
  }

  TemporaryFolder folder_;
  TestCertificates certificates_{folder_.path()};
};

TEST_F(ConfigurationCheck, FindsNothingWrongWithDefaultsOrGoodFiles) {
  EXPECT_THAT(complaints_about({}), IsEmpty());
  ServerOptions options = with_tls();
  options.listen = "0.0.0.0:50051";
  options.tls_client_ca = certificates_.pem("root");
  options.token_file = path("tokens");
  options.replay_dir = path("replay");
  EXPECT_THAT(complaints_about(options), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(path("replay")));
}

TEST_F(ConfigurationCheck, RefusesAPortFileWithoutAFolderAndOneAddressForTwo) {
  ServerOptions options;
  options.port_file = path("no/such/folder/port");
  EXPECT_THAT(complaints_about(options), ElementsAre(HasSubstr("--port-file")));
  options.port_file = path("port");
  EXPECT_THAT(complaints_about(options), IsEmpty());
  options.listen = "127.0.0.1:9464";
  options.metrics_listen = "9464";
  EXPECT_THAT(complaints_about(options), ElementsAre(HasSubstr("--metrics-listen")));
  options.metrics_listen = "127.0.0.1:9465";
  EXPECT_THAT(complaints_about(options), IsEmpty());
}

TEST_F(ConfigurationCheck, RefusesPlaintextAndTokensThatOthersCouldRead) {
  ServerOptions options;
  options.listen = "0.0.0.0:0";
  EXPECT_THAT(complaints_about(options), ElementsAre(HasSubstr("--allow-insecure-remote")));
  options.allow_insecure_remote = true;
  EXPECT_THAT(complaints_about(options), IsEmpty());
  options.token_file = path("tokens");
  EXPECT_THAT(complaints_about(options), ElementsAre(HasSubstr("tokens on 0.0.0.0:0 could be read by others")));
  options.listen = "127.example.com:50051";
  EXPECT_THAT(complaints_about(options), ElementsAre(HasSubstr("could be read by others")));
  for (const char* local : {"127.0.0.1:0", "localhost:1", "[::1]:0", "unix:/tmp/x"}) {
    options.listen = local;
    EXPECT_THAT(complaints_about(options), IsEmpty()) << local;
  }
}

TEST_F(ConfigurationCheck, SaysWhatIsWrongWithCertificates) {
  certificates_.certificate("other", "root");
  certificates_.certificate("ended", "root", -1);
  write_file(path("empty"), "");
  const auto about = [&](const std::string& cert, const std::string& key, const std::string& client_ca = "") {
    ServerOptions options;
    options.tls_cert = cert;
    options.tls_key = key;
    options.tls_client_ca = client_ca;
    return complaints_about(options);
  };
  const std::string cert = certificates_.pem("server");
  const std::string key = certificates_.key("server");
  EXPECT_THAT(about(path("none"), key), ElementsAre(HasSubstr("cannot read " + path("none"))));
  EXPECT_THAT(about(cert, folder_.path().string()), ElementsAre(HasSubstr("cannot read")));
  EXPECT_THAT(about(path("tokens"), key), ElementsAre(HasSubstr("holds no certificate in PEM")));
  EXPECT_THAT(about(cert, path("empty")), ElementsAre(HasSubstr("holds no private key")));
  EXPECT_THAT(about(cert, certificates_.key("other")), ElementsAre(HasSubstr("is not that of the certificate")));
  EXPECT_THAT(about(certificates_.pem("ended"), certificates_.key("ended")), ElementsAre(HasSubstr("has expired")));
  EXPECT_THAT(about(cert, key, path("empty")), ElementsAre(HasSubstr("holds no certificate in PEM")));
}

TEST_F(ConfigurationCheck, SaysEverythingThatIsWrong) {
  ServerOptions options;
  options.listen = "nonsense";
  options.token_file = path("none");
  options.replay_dir = path("no/such/folder");
  EXPECT_THAT(complaints_about(options),
              ElementsAre(HasSubstr("is no address"), HasSubstr("cannot read"), HasSubstr("cannot write to")));
}

}  // namespace
}  // namespace dualarm
