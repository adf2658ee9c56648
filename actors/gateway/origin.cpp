// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/origin.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace tedit::gateway {
namespace {

constexpr std::array<std::string_view, 3> loopback = {"localhost", "127.0.0.1", "[::1]"};

/// Host in lower case, port as written; port 0 stands for none.
struct authority {
  std::string host;
  std::uint16_t port = 0;

  bool operator==(const authority&) const = default;
};

struct web_origin {
  std::string scheme;
  authority where;

  bool operator==(const web_origin&) const = default;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_alpha(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// ASCII only, whatever the locale.
std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// 1 to 65535 without sign or leading zeros.
std::optional<std::uint16_t> parse_port(std::string_view text) {
  if (text.empty() || text.size() > 5 || text[0] == '0')
    return std::nullopt;
  std::uint16_t port = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (problem != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return port;
}

bool name_character(char c) {
  return is_alpha(c) || is_digit(c) || c == '-' || c == '.' || c == '_';
}

bool address_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F') || c == ':' || c == '.';
}

/// The length of the host at the start of `text`: a name, or an IPv6 address in brackets. 0: none.
std::size_t host_length(std::string_view text) {
  if (!text.starts_with('[')) {
    const auto* end = std::find_if_not(text.begin(), text.end(), name_character);
    return static_cast<std::size_t>(end - text.begin());
  }
  const std::size_t close = text.find(']');
  if (close == std::string_view::npos || close < 3)
    return 0;
  const std::string_view inside = text.substr(1, close - 1);
  return std::all_of(inside.begin(), inside.end(), address_character) ? close + 1 : 0;
}

/// `host` or `host:port` and nothing around it.
std::optional<authority> parse_authority(std::string_view text) {
  const std::size_t length = host_length(text);
  if (length == 0)
    return std::nullopt;
  authority a{lower(text.substr(0, length)), 0};
  const std::string_view rest = text.substr(length);
  if (rest.empty())
    return a;
  const auto port = parse_port(rest.substr(1));
  if (rest[0] != ':' || !port)
    return std::nullopt;
  a.port = *port;
  return a;
}

std::uint16_t default_port(std::string_view scheme) {
  if (scheme == "http")
    return 80;
  return scheme == "https" ? 443 : 0;
}

std::optional<web_origin> parse_origin(std::string_view text) {
  const std::size_t colon = text.find("://");
  if (colon == std::string_view::npos || colon == 0 || !is_alpha(text[0]))
    return std::nullopt;
  const std::string_view scheme = text.substr(0, colon);
  const auto scheme_character = [](char c) {
    return is_alpha(c) || is_digit(c) || c == '+' || c == '-' || c == '.';
  };
  auto where = parse_authority(text.substr(colon + 3));
  if (!where || !std::all_of(scheme.begin(), scheme.end(), scheme_character))
    return std::nullopt;
  web_origin origin{lower(scheme), *std::move(where)};
  if (origin.where.port == 0)
    origin.where.port = default_port(origin.scheme);
  return origin;
}

bool is_loopback(std::string_view host) {
  return std::find(loopback.begin(), loopback.end(), host) != loopback.end();
}

}  // namespace

bool host_allowed(std::string_view host_header, std::uint16_t port,
                  const std::vector<std::string>& extra) {
  const auto host = parse_authority(host_header);
  if (!host)
    return false;
  const bool port_fits = host->port == 0 || host->port == port;
  if (port_fits && is_loopback(host->host))
    return true;
  return std::any_of(extra.begin(), extra.end(), [&](const std::string& entry) {
    const auto known = parse_authority(entry);
    if (!known || known->host != host->host)
      return false;
    return known->port == 0 ? port_fits : known->port == host->port;
  });
}

bool origin_allowed(std::optional<std::string_view> origin, std::uint16_t port,
                    const std::vector<std::string>& allowed) {
  if (!origin)
    return true;
  const auto from = parse_origin(*origin);
  if (!from)
    return false;
  const bool web = from->scheme == "http" || from->scheme == "https";
  if (web && from->where.port == port && is_loopback(from->where.host))
    return true;
  return std::any_of(allowed.begin(), allowed.end(),
                     [&](const std::string& entry) { return parse_origin(entry) == from; });
}

}  // namespace tedit::gateway
