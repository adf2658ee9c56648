// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/server_checks.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>

#include "actors/store/documents_folder.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"
#include "base/utc.hpp"
#include "cli/config.hpp"
#include "cli/node_checks.hpp"
#include "cli/token.hpp"
#include "tls/server_identity.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

check_row failed(const std::string& name, const error& e) {
  return {name, false, render(e)};
}

std::string configuration_in_use(const std::optional<fs::path>& given) {
  if (given)
    return given->string();
  std::error_code code;
  for (const auto& file : config_files())
    if (fs::exists(file, code))
      return file.string();
  return "none, the defaults hold";
}

check_row check_documents(const server_config& config) {
  const auto folder = documents_folder(config);
  if (!folder)
    return failed("documents", folder.error());
  struct stat about {};
  if (::stat(folder->c_str(), &about) == 0 && !S_ISDIR(about.st_mode))
    return {"documents", false, folder->string() + " is no folder"};
  if (auto ok = store::check_writable(*folder); !ok)
    return failed("documents", ok.error());
  const bool there = ::stat(folder->c_str(), &about) == 0;
  return {"documents", true, folder->string() + (there ? "" : " (made when the server starts)")};
}

check_row check_token(const server_config& config) {
  const auto file = token_path(config);
  if (!file)
    return failed("token", file.error());
  struct stat about {};
  if (::stat(file->c_str(), &about) == 0) {
    const auto token = read_private_token(*file);
    return token ? check_row{"token", true, file->string()} : failed("token", token.error());
  }
  if (auto ok = store::check_writable(file->parent_path()); !ok)
    return failed("token", ok.error());
  return {"token", true, file->string() + " (made when the server starts)"};
}

/// Whether clients of other machines may be let in, and until when the certificate for it holds.
check_row check_certificate(const server_config& config) {
  if (config.certificates.empty())
    return {"certificate", true, "none: clients connect by ws://"};
  const auto identity = tls::server_identity::load(config.certificates);
  if (!identity)
    return failed("certificate", identity.error());
  return {"certificate", true,
          config.certificates + " holds until " + utc_text(identity->until()) + ", SHA-256 " +
            identity->fingerprint()};
}

unique_fd tcp_socket(int family) {
  return unique_fd(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0));
}

struct tcp_address {
  sockaddr_storage where{};
  socklen_t size = 0;

  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&where); }
};

/// @pre the configuration was read: its address is one in numbers.
tcp_address address_of(const std::string& address, int number) {
  tcp_address result;
  const auto port = htons(static_cast<std::uint16_t>(number));
  auto* v4 = reinterpret_cast<sockaddr_in*>(&result.where);
  auto* v6 = reinterpret_cast<sockaddr_in6*>(&result.where);
  if (::inet_pton(AF_INET, address.c_str(), &v4->sin_addr) == 1) {
    v4->sin_family = AF_INET;
    v4->sin_port = port;
    result.size = sizeof *v4;
  } else {
    ::inet_pton(AF_INET6, address.c_str(), &v6->sin6_addr);
    v6->sin6_family = AF_INET6;
    v6->sin6_port = port;
    result.size = sizeof *v6;
  }
  return result;
}

/// Whether what listens there answers as a TEdit server does; within a second or so.
bool is_tedit(const tcp_address& at) {
  const auto peer = tcp_socket(at.where.ss_family);
  const timeval patience{1, 0};
  for (const int what : {SO_RCVTIMEO, SO_SNDTIMEO})
    ::setsockopt(peer.get(), SOL_SOCKET, what, &patience, sizeof patience);
  const std::string question =
    "GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  if (::connect(peer.get(), at.get(), at.size) != 0 ||
      ::send(peer.get(), question.data(), question.size(), MSG_NOSIGNAL) < 0)
    return false;
  std::string answer;
  char piece[1024];
  for (ssize_t got = 1; got > 0 && answer.size() < 8192;) {
    got = ::recv(peer.get(), piece, sizeof piece, 0);
    if (got > 0)
      answer.append(piece, static_cast<std::size_t>(got));
  }
  return answer.find("tedit") != std::string::npos;
}

/// A server's own port for workers answers no question of a stranger: it is not told from another
/// program's.
check_row check_port(const std::string& what, const std::string& address, int port) {
  const auto name = address + ", port " + std::to_string(port);
  if (port == 0)
    return {what, true, address + ", any free port"};
  const auto at = address_of(address, port);
  const auto ours = tcp_socket(at.where.ss_family);
  const int yes = 1;
  ::setsockopt(ours.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(ours.get(), at.get(), at.size) == 0)
    return {what, true, name + " is free"};
  const int reason = errno;
  if (reason != EADDRINUSE)
    return failed(what, system_failure("cannot listen on " + name, reason).value());
  if (what == "node port")
    return {what, true, name + " is in use: by this server if it runs, else choose another"};
  if (is_tedit(at))
    return {what, true, name + " is a running TEdit server's"};
  return {what, false, name + " is in use by another program. Choose another with --port"};
}

}  // namespace

std::vector<check_row> check_server(const std::optional<fs::path>& config_file) {
  const auto config = load_config(config_file);
  if (!config)  // What it would say of the rest is not known.
    return {failed("configuration", config.error())};
  std::vector<check_row> rows{{"configuration", true, configuration_in_use(config_file)},
                              check_documents(*config),
                              check_token(*config),
                              check_certificate(*config),
                              check_port("port", config->address, config->port)};
  for (auto& row : check_node_port(*config))
    rows.push_back(std::move(row));
  if (!config->node_certificates.empty())
    rows.push_back(check_port("node port", config->node_address, config->node_port));
  return rows;
}

}  // namespace tedit::cli
