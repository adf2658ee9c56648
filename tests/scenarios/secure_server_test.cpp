// SPDX-License-Identifier: AGPL-3.0-or-later
// A server that is reached by TLS, and one that must be.
#include "certs/authority.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

class SecureServer : public ::testing::Test {
protected:
  SecureServer() {
    options = options_for(folder, false);
    options.documents = folder.path() / "documents";
    value(certs::init(folder.path() / "ca"));
    value(certs::issue(folder.path() / "ca", {certs::role::server, "hall", {"127.0.0.1"}},
                       folder.path() / "hall"));
  }

  void be_secure() { options.certificates = folder.path() / "hall"; }

  [[nodiscard]] client::connect_options to_host() const {
    client::connect_options how;
    how.url = host->url();
    how.token = server_token;
    how.client_name = "test";
    how.timeout = patience;
    return how;
  }

  scratch_folder folder;
  server_options options;
  std::unique_ptr<server> host;
};

TEST_F(SecureServer, IsUsedAsAnyOther) {
  be_secure();
  host = start(options);
  EXPECT_THAT(host->url(), HasSubstr("wss://127.0.0.1:"));
  auto how = to_host();
  EXPECT_EQ(client::client::connect(how, {}).error().code, ec::untrusted_server);
  how.trust.authority = folder.path() / "ca" / certs::authority_certificate_file;
  const auto user = value(client::client::connect(how, {}));
  value(user->open("plate", true, false));
  const auto made = value(user->import_file(plate_mesh, "mm", {}));
  value(user->wait_surface(made.head.version_id, patience));
  const auto file = value(user->export_file("msh", {}, "mm", {}));
  EXPECT_GT(file.size(), 1'000'000u);

  auto known = to_host();
  known.trust.fingerprint = host->fingerprint();
  EXPECT_EQ(value(value(client::client::connect(known, {}))->status()).connections, 2u);
}

TEST_F(SecureServer, OtherMachinesAreLetInOnlyWithIt) {
  options.address = "0.0.0.0";
  const auto refused = server::start(options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::invalid_argument);
  EXPECT_THAT(refused.error().message, HasSubstr("0.0.0.0 without TLS"));
  EXPECT_THAT(refused.error().remedy, HasSubstr("tedit certs issue"));
  options.address = "::";
  EXPECT_FALSE(server::start(options));
  for (const auto* here : {"127.0.0.1", "127.0.0.2"}) {
    options.address = here;
    EXPECT_TRUE(server::start(options)) << here;
  }
  options.address = "0.0.0.0";
  options.unencrypted_behind_proxy = true;
  EXPECT_TRUE(server::start(options));
  options.unencrypted_behind_proxy = false;
  be_secure();
  EXPECT_TRUE(server::start(options));
}

}  // namespace
}  // namespace tedit::test
