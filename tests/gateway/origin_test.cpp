// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/origin.hpp"

#include <gtest/gtest.h>

namespace tedit::gateway {
namespace {

constexpr std::uint16_t port = 7411;

const std::vector<std::string> allowed = {
  "https://Mesh.Example.com",
  "https://mesh.example.com:8443",
  "http://[2001:db8::1]:9000",
  "https://xn--bcher-kva.example",
  "vscode-webview://panel",
  "null",
  "*",
  "https://slash.example/",
};

struct origin_case {
  const char* origin;
  bool expected;
};

class origins : public ::testing::TestWithParam<origin_case> {};

TEST_P(origins, are_compared_exactly) {
  EXPECT_EQ(origin_allowed(GetParam().origin, port, allowed), GetParam().expected)
    << GetParam().origin;
}

constexpr origin_case own[] = {
  {"http://localhost:7411", true},
  {"https://localhost:7411", true},
  {"http://127.0.0.1:7411", true},
  {"https://127.0.0.1:7411", true},
  {"http://[::1]:7411", true},
  {"HTTP://LocalHost:7411", true},
  {"http://localhost", false},
  {"http://localhost:7412", false},
  {"http://localhost:741", false},
  {"http://localhost:74110", false},
  {"http://localhost:07411", false},
  {"http://localhost:+7411", false},
  {"http://localhost:7411 ", false},
  {" http://localhost:7411", false},
  {"http://localhost:", false},
  {"http://localhost:72947", false},
  {"http://localhost.:7411", false},
  {"http://localhost.evil.com:7411", false},
  {"http://evil-localhost:7411", false},
  {"http://evil.localhost:7411", false},
  {"http://localhostevil:7411", false},
  {"http://127.0.0.1.evil.com:7411", false},
  {"http://127.0.0.2:7411", false},
  {"http://127.1:7411", false},
  {"http://2130706433:7411", false},
  {"http://0.0.0.0:7411", false},
  {"http://::1:7411", false},
  {"http://[::1:7411", false},
  {"http://[::1]7411", false},
  {"http://[::1]evil.com:7411", false},
  {"http://[::ffff:127.0.0.1]:7411", false},
  {"http://[]:7411", false},
};

constexpr origin_case tricks[] = {
  {"", false},
  {"null", false},
  {"NULL", false},
  {"*", false},
  {"://localhost:7411", false},
  {"localhost:7411", false},
  {"//localhost:7411", false},
  {"http:/localhost:7411", false},
  {"file://", false},
  {"file://localhost:7411", false},
  {"ws://localhost:7411", false},
  {"httpx://localhost:7411", false},
  {"javascript:http://localhost:7411", false},
  {"http://localhost:7411/", false},
  {"http://localhost:7411/v1", false},
  {"http://localhost:7411?x", false},
  {"http://localhost:7411#x", false},
  {"http://user@localhost:7411", false},
  {"http://localhost:7411@evil.com", false},
  {"http://evil.com#localhost:7411", false},
  {"http://evil.com\\@localhost:7411", false},
  {"http://localhost:7411 http://evil.com", false},
  {"http://localhost:7411,http://evil.com", false},
  {"http://l\xC3\xB6"
   "calhost:7411",
   false},
  {"http://\xEF\xBD\x8C"
   "ocalhost:7411",
   false},
  {"http://localhost%2eevil.com:7411", false},
  {"http://localhost\t:7411", false},
};

constexpr origin_case listed[] = {
  {"https://mesh.example.com", true},
  {"https://MESH.example.COM", true},
  {"https://mesh.example.com:443", true},
  {"https://mesh.example.com:8443", true},
  {"http://[2001:DB8::1]:9000", true},
  {"https://xn--bcher-kva.example", true},
  {"vscode-webview://panel", true},
  {"http://mesh.example.com", false},
  {"https://mesh.example.com:7411", false},
  {"https://mesh.example.com.", false},
  {"https://mesh.example.com.evil.com", false},
  {"https://evilmesh.example.com", false},
  {"https://sub.mesh.example.com", false},
  {"https://example.com", false},
  {"http://[2001:db8::1]", false},
  {"http://[2001:db8::2]:9000", false},
  {"https://b\xC3\xBC"
   "cher.example",
   false},
  {"vscode-webview://panel2", false},
  {"https://slash.example", false},
};

INSTANTIATE_TEST_SUITE_P(own, origins, ::testing::ValuesIn(own));
INSTANTIATE_TEST_SUITE_P(tricks, origins, ::testing::ValuesIn(tricks));
INSTANTIATE_TEST_SUITE_P(listed, origins, ::testing::ValuesIn(listed));

TEST(origin, none_is_a_native_client) {
  EXPECT_TRUE(origin_allowed(std::nullopt, port, {}));
}

TEST(origin, a_zero_byte_ends_nothing) {
  using std::string_view_literals::operator""sv;
  EXPECT_FALSE(origin_allowed("http://localhost:7411\0.evil.com"sv, port, allowed));
  EXPECT_FALSE(origin_allowed("http://localhost\0:7411"sv, port, allowed));
}

TEST(origin, the_default_port_may_be_left_out) {
  EXPECT_TRUE(origin_allowed("http://localhost", 80, {}));
  EXPECT_TRUE(origin_allowed("https://localhost", 443, {}));
  EXPECT_FALSE(origin_allowed("https://localhost", 80, {}));
}

TEST(host, loopback_names_with_and_without_port) {
  for (const char* good : {"localhost", "localhost:7411", "LOCALHOST:7411", "127.0.0.1",
                           "127.0.0.1:7411", "[::1]", "[::1]:7411"})
    EXPECT_TRUE(host_allowed(good, port)) << good;
}

TEST(host, everything_else_is_refused) {
  for (const char* bad :
       {"", ":7411", "localhost:", "localhost:7412", "localhost.", "localhost.evil.com", "evil.com",
        "evil.com:7411", "127.0.0.1.nip.io", "::1", "[::1]x", "user@localhost", "localhost/",
        "localhost, evil.com", "0.0.0.0", "mesh.example.com", "localhost:07411"})
    EXPECT_FALSE(host_allowed(bad, port)) << bad;
}

TEST(host, extra_names) {
  const std::vector<std::string> extra = {"Mesh.example.com", "proxy.example:443", "10.0.0.5"};
  for (const char* good :
       {"mesh.example.com", "MESH.EXAMPLE.COM:7411", "proxy.example:443", "10.0.0.5:7411"})
    EXPECT_TRUE(host_allowed(good, port, extra)) << good;
  for (const char* bad : {"mesh.example.com:80", "proxy.example", "proxy.example:7411",
                          "a.mesh.example.com", "mesh.example.com.evil.com", "10.0.0.50"})
    EXPECT_FALSE(host_allowed(bad, port, extra)) << bad;
}

}  // namespace
}  // namespace tedit::gateway
