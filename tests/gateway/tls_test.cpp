// SPDX-License-Identifier: AGPL-3.0-or-later
// The clients' port with TLS: what is shown, what is trusted, and who is turned away.
#include <fstream>
#include <future>
#include <random>

#include <openssl/err.h>
#include <openssl/ssl.h>

#include "base/metrics.hpp"
#include "certs/openssl.hpp"
#include "client/socket.hpp"
#include "tests/gateway/transport_fixture.hpp"
#include "tls/server_identity.hpp"

namespace tedit::gateway::test {
namespace {

namespace fs = std::filesystem;
using tedit::client::server_trust;
using tedit::test::value;

/// A server with an authority of its own, which a test may do anything with.
class transport_tls : public transport_fixture {
protected:
  transport_tls() {
    value(certs::init(at("ca")));
    issue("hall", {"127.0.0.1", "localhost"});
  }

  void issue(const std::string& name, const std::vector<std::string>& hosts) {
    value(certs::issue(at("ca"), {certs::role::server, name, hosts}, at(name)));
  }

  void start_as(const std::string& name) {
    options.certificates = at(name);
    start_with_options();
  }

  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

  /// What one says to the server, and its echo, as a client of the library.
  expected<std::string> say(const server_trust& trust, const std::string& scheme = "wss") {
    std::promise<std::string> heard;
    tedit::client::socket socket(
      {[&](std::string_view text) { heard.set_value(std::string(text)); }, [](const error&) {}});
    const auto url = scheme + "://" + host + "/v1";
    if (auto ok = socket.connect(url, patience, trust); !ok)
      return fail(ok.error());
    EXPECT_TRUE(socket.send("hello"));
    auto echo = heard.get_future();
    if (echo.wait_for(patience) != std::future_status::ready)
      return fail(ec::timeout, "no echo");
    return echo.get();
  }

  [[nodiscard]] server_trust of_authority(const std::string& name = "ca") const {
    server_trust trust;
    trust.authority = at(name) / certs::authority_certificate_file;
    return trust;
  }

  [[nodiscard]] server_trust of_fingerprint(const std::string& text) const {
    server_trust trust;
    trust.fingerprint = text;
    return trust;
  }

private:
  tedit::test::scratch_folder folder_;
};

std::uint64_t refused(const std::string& reason) {
  return metrics::count_of("tedit_tls_refused_total", "", {{"reason", reason}}).get();
}

/// What OpenSSL makes of the port with only this version: the version that was agreed on.
std::string handshake(std::uint16_t port, int version) {
  using context_ptr = std::unique_ptr<SSL_CTX, certs::openssl_end<SSL_CTX_free>>;
  using tls_ptr = std::unique_ptr<SSL, certs::openssl_end<SSL_free>>;
  const context_ptr context(SSL_CTX_new(TLS_method()));
  SSL_CTX_set_min_proto_version(context.get(), version);
  SSL_CTX_set_max_proto_version(context.get(), version);
  const tls_ptr tls(SSL_new(context.get()));
  net::io_context io;
  tcp::socket socket(io);
  socket.connect({net::ip::address_v4::loopback(), port});
  SSL_set_fd(tls.get(), socket.native_handle());
  const bool agreed = SSL_connect(tls.get()) == 1;
  ERR_clear_error();
  return agreed ? SSL_get_version(tls.get()) : "";
}

TEST_P(transport_tls, whoever_has_the_authoritys_certificate_is_served) {
  start_as("hall");
  EXPECT_EQ(value(say(of_authority())), "hello");
  EXPECT_EQ(server->fingerprint(), value(tls::server_identity::load(at("hall"))).fingerprint());
}

TEST_P(transport_tls, a_certificate_of_nobody_one_knows_is_told_and_refused) {
  start_as("hall");
  server_trust trust;
  tedit::client::server_certificate shown;
  trust.on_certificate = [&](const auto& certificate) { shown = certificate; };
  const auto refusal = say(trust).error();
  EXPECT_EQ(refusal.code, ec::untrusted_server);
  EXPECT_THAT(refusal.message,
              AllOf(HasSubstr(host.substr(host.find(':'))), HasSubstr(server->fingerprint())));
  EXPECT_EQ(shown.fingerprint, server->fingerprint());
  EXPECT_THAT(shown.hosts, ::testing::Contains("127.0.0.1"));
  EXPECT_THAT(shown.name, HasSubstr("hall"));
  EXPECT_THAT(shown.issuer, HasSubstr("TEdit"));
  EXPECT_FALSE(shown.fault.empty());
  EXPECT_TRUE(seen->opened.empty());  // Nothing was said to it.
}

TEST_P(transport_tls, another_authority_does_not_vouch_for_it) {
  value(certs::init(at("other"), "TEdit"));  // Of the same name.
  start_as("hall");
  const auto refusal = say(of_authority("other")).error();
  EXPECT_EQ(refusal.code, ec::untrusted_server);
  EXPECT_FALSE(refusal.remedy.empty());
}

TEST_P(transport_tls, a_certificate_for_another_host_is_refused_unless_it_is_the_known_one) {
  issue("elsewhere", {"10.0.0.7"});
  start_as("elsewhere");
  EXPECT_THAT(say(of_authority()).error().message, HasSubstr("mismatch"));
  EXPECT_EQ(value(say(of_fingerprint(server->fingerprint()))), "hello");
}

TEST_P(transport_tls, a_known_certificate_needs_no_authority) {
  start_as("hall");
  std::string plain = server->fingerprint();
  std::erase(plain, ':');
  for (auto& c : plain)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& written : {server->fingerprint(), "SHA256:" + plain, plain})
    EXPECT_EQ(value(say(of_fingerprint(written))), "hello") << written;
  plain[0] = plain[0] == '0' ? '1' : '0';
  EXPECT_EQ(say(of_fingerprint(plain)).error().code, ec::untrusted_server);
  EXPECT_EQ(say(of_fingerprint("ab:cd")).error().code, ec::invalid_argument);
}

TEST_P(transport_tls, a_renewed_certificate_is_shown_at_once_and_the_old_one_not_taken_for_it) {
  start_as("hall");
  const auto before = server->fingerprint();
  const auto there = std::make_unique<client>(
    server->port(), 0,
    value(tls::context::of_client(at("ca") / certs::authority_certificate_file)).get());
  EXPECT_EQ(there->upgrade(host), 101);
  EXPECT_EQ(there->round_trip("hello"), "hello");

  value(certs::renew(at("ca"), "hall", certs::node_days, at("hall")));

  const auto refusal = say(of_fingerprint(before)).error();
  EXPECT_EQ(refusal.code, ec::untrusted_server);
  const auto after = value(tls::server_identity::load(at("hall"))).fingerprint();
  EXPECT_NE(after, before);
  EXPECT_THAT(refusal.message, AllOf(HasSubstr(before), HasSubstr(after)));
  EXPECT_EQ(value(say(of_authority())), "hello");
  EXPECT_EQ(there->round_trip("still here"), "still here");
}

TEST_P(transport_tls, files_that_cannot_be_read_any_more_leave_the_certificate_as_it_was) {
  start_as("hall");
  const auto certificate = at("hall") / certs::node_certificate_file;
  std::ofstream(certificate, std::ios::trunc) << "half of it";
  EXPECT_EQ(value(say(of_authority())), "hello");
  fs::remove(certificate);
  EXPECT_EQ(value(say(of_authority())), "hello");
}

TEST_P(transport_tls, files_that_cannot_be_used_are_refused_by_name) {
  value(certs::issue(at("ca"), {certs::role::solver, "rack", {}}, at("rack")));
  options.accept = [](std::shared_ptr<connection>) { return nullptr; };
  const auto refusal_of = [&](const fs::path& where) {
    options.certificates = where;
    const auto started = transport::start(options);
    EXPECT_FALSE(started.has_value());
    return started ? error{} : started.error();
  };
  EXPECT_EQ(refusal_of(at("nothing")).code, ec::io_error);
  EXPECT_THAT(refusal_of(at("rack")).message, HasSubstr("role solver"));
  fs::permissions(at("hall") / certs::node_key_file, fs::perms::group_read, fs::perm_options::add);
  EXPECT_THAT(refusal_of(at("hall")).message, HasSubstr("others may read"));
  fs::permissions(at("hall") / certs::node_key_file, fs::perms::group_read,
                  fs::perm_options::remove);
  fs::copy_file(at("rack") / certs::node_key_file, at("hall") / certs::node_key_file,
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(refusal_of(at("hall")).message, HasSubstr("do not belong together"));
}

// As programs of public authorities leave them: the certificate and the one that vouches for it in
// one file. Here both are of the same authority.
TEST_P(transport_tls, a_chain_of_certificates_is_shown_whole) {
  fs::create_directory(at("public"));
  std::ofstream chain(at("public") / tls::chain_file);
  for (const auto& file :
       {at("hall") / certs::node_certificate_file, at("hall") / certs::authority_certificate_file})
    chain << std::ifstream(file).rdbuf();
  chain.close();
  fs::copy_file(at("hall") / certs::node_key_file, at("public") / tls::chain_key_file);
  start_as("public");
  EXPECT_EQ(value(say(of_authority())), "hello");
  EXPECT_EQ(server->fingerprint(), value(tls::server_identity::load(at("hall"))).fingerprint());
}

TEST_P(transport_tls, nothing_older_than_tls_1_3_is_spoken) {
  start_as("hall");
  const auto before = refused("old_tls");
  EXPECT_EQ(handshake(server->port(), TLS1_3_VERSION), "TLSv1.3");
  EXPECT_EQ(handshake(server->port(), TLS1_2_VERSION), "");
  EXPECT_TRUE(eventually([&] { return refused("old_tls") == before + 1; }));
}

TEST_P(transport_tls, who_speaks_the_wrong_one_of_both_is_told) {
  start_as("hall");
  EXPECT_THAT(client(server->port()).raw("GET /healthz HTTP/1.1\r\nHost: " + host + "\r\n\r\n"),
              AllOf(HasSubstr("HTTP/1.1 400 "), HasSubstr("use wss://")));
  EXPECT_THAT(say({}, "ws").error().message, HasSubstr("HTTP 400"));
  server.reset();
  options.certificates.clear();
  start_with_options();
  EXPECT_THAT(say(of_authority()).error().message, HasSubstr("it does not speak TLS"));
}

TEST_P(transport_tls, names_of_the_certificate_are_hosts) {
  issue("named", {"127.0.0.1", "mesh.example.org"});
  start_as("named");
  const auto how = value(tls::context::of_client(at("ca") / certs::authority_certificate_file));
  const auto status_for = [&](const std::string& name) {
    return client(server->port(), 0, how.get())
      .upgrade(name + ":" + std::to_string(server->port()));
  };
  EXPECT_EQ(status_for("mesh.example.org"), 101);
  EXPECT_EQ(status_for("evil.example.org"), 403);
}

TEST_P(transport_tls, unfinished_handshakes_take_no_clients_place) {
  options.limits.max_strangers = 6;
  options.limits.handshake_timeout = options.limits.hello_timeout = patience;
  start_as("hall");
  // The beginning of a ClientHello, of which the rest never comes.
  const std::string begun("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11);
  std::vector<std::unique_ptr<client>> halves;
  for (int i = 0; i < 30; ++i) {
    halves.push_back(std::make_unique<client>(server->port()));
    net::write(beast::get_lowest_layer(halves.back()->stream()).socket(),
               net::buffer(begun.data(), i % 2 == 0 ? 0 : begun.size()));
    EXPECT_EQ(value(say(of_authority())), "hello") << i;
  }
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(halves[static_cast<std::size_t>(i)]->raw(""), "") << i;
}

TEST_P(transport_tls, a_handshake_that_takes_too_long_is_ended) {
  options.limits.handshake_timeout = 100ms;
  start_as("hall");
  const auto before = refused("silent");
  EXPECT_EQ(client(server->port()).raw(""), "");
  EXPECT_TRUE(eventually([&] { return refused("silent") == before + 1; }));
}

/// Bytes that a client began with, changed here and there.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto changes = 1 + random() % 8;
  for (unsigned i = 0; i < changes && !bytes.empty(); ++i)
    switch (random() % 4) {
      case 0:
        bytes.resize(random() % (bytes.size() + 1));
        break;
      case 1:
        bytes.insert(random() % (bytes.size() + 1), 1 + random() % 40, static_cast<char>(random()));
        break;
      default:
        bytes[random() % bytes.size()] = static_cast<char>(random());
    }
  return bytes;
}

/// What a client says first.
std::string client_hello() {
  using context_ptr = std::unique_ptr<SSL_CTX, certs::openssl_end<SSL_CTX_free>>;
  using tls_ptr = std::unique_ptr<SSL, certs::openssl_end<SSL_free>>;
  const context_ptr context(SSL_CTX_new(TLS_method()));
  const tls_ptr tls(SSL_new(context.get()));
  SSL_set_bio(tls.get(), BIO_new(BIO_s_mem()), BIO_new(BIO_s_mem()));
  SSL_connect(tls.get());
  ERR_clear_error();
  char* data = nullptr;
  const auto size = BIO_get_mem_data(SSL_get_wbio(tls.get()), &data);
  return {data, static_cast<std::size_t>(size)};
}

std::size_t hostile_sessions() {
  const char* wanted = std::getenv("TEDIT_HOSTILE_SESSIONS");
  return wanted != nullptr ? std::stoul(wanted) : 10'000;
}

TEST_P(transport_tls, hostile_bytes_disturb_nobody) {
  start_as("hall");
  std::mt19937 random(26);
  const auto hello = client_hello();
  ASSERT_GT(hello.size(), 100u);
  net::io_context io;
  for (std::size_t i = 0; i < hostile_sessions(); ++i) {
    tcp::socket socket(io);
    error_code ignored;
    socket.connect({net::ip::address_v4::loopback(), server->port()}, ignored);
    const auto bytes = i % 3 == 0 ? noise(random() % 600) : mutated(hello, random);
    socket.send(net::buffer(bytes), MSG_NOSIGNAL, ignored);
    if (i % 1000 == 0) {
      EXPECT_EQ(value(say(of_authority())), "hello") << i;
    }
  }
  EXPECT_EQ(value(say(of_authority())), "hello");
}

INSTANTIATE_TEST_SUITE_P(with, transport_tls, ::testing::Values(true), with_or_without);

}  // namespace
}  // namespace tedit::gateway::test
