// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/server_url.hpp"

#include <algorithm>
#include <string_view>

namespace tedit::client {

namespace {

constexpr std::string_view plain_scheme = "ws://";
constexpr std::string_view secure_scheme = "wss://";

tl::unexpected<error> bad_url(const std::string& url, const std::string& what) {
  return fail(ec::invalid_argument, "the address \"" + url + "\" " + what,
              "Give a server's address such as ws://127.0.0.1:7464/v1.");
}

bool is_port(const std::string& text) {
  if (text.empty() || text.size() > 5 || text.find_first_not_of("0123456789") != std::string::npos)
    return false;
  const int number = std::stoi(text);
  return number > 0 && number < 65536;
}

}  // namespace

std::string server_url::place() const {
  const bool v6 = host.find(':') != std::string::npos;
  return (v6 ? "[" + host + "]" : host) + ":" + port;
}

expected<server_url> parse_server_url(const std::string& url) {
  server_url result;
  result.secure = url.starts_with(secure_scheme);
  if (!result.secure && !url.starts_with(plain_scheme))
    return bad_url(url, "does not begin with ws:// or wss://");
  // A control character or a space would break the HTTP request that the URL becomes a part of.
  for (const char c : url)
    if (static_cast<unsigned char>(c) <= ' ' || c == 0x7f)
      return bad_url(url, "has a space or control character");
  const std::string rest = url.substr((result.secure ? secure_scheme : plain_scheme).size());
  const auto slash = std::min(rest.find('/'), rest.find('?'));
  result.port = result.secure ? "443" : "80";
  result.authority = rest.substr(0, slash);
  result.target = "/";
  if (slash != std::string::npos)
    result.target = rest[slash] == '/' ? rest.substr(slash) : "/" + rest.substr(slash);
  const bool bracketed = !result.authority.empty() && result.authority[0] == '[';
  const auto host_end = bracketed ? result.authority.find(']') : result.authority.find(':');
  if (bracketed && host_end == std::string::npos)
    return bad_url(url, "has no closing bracket");
  result.host = result.authority.substr(bracketed ? 1 : 0, host_end - (bracketed ? 1 : 0));
  const auto colon = bracketed ? host_end + 1 : host_end;
  if (colon < result.authority.size()) {
    if (result.authority[colon] != ':')
      return bad_url(url, "has something after the bracket that is no port");
    result.port = result.authority.substr(colon + 1);
  }
  if (result.host.empty() || !is_port(result.port))
    return bad_url(url, "names no host or no valid port");
  return result;
}

}  // namespace tedit::client
