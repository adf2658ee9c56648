// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/links/strangers.hpp"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include <openssl/err.h>
#include <openssl/ssl.h>

#include "certs/openssl.hpp"

namespace tedit::test {

namespace {

constexpr int patience_s = 20;

using context_ptr = std::unique_ptr<SSL_CTX, certs::openssl_end<SSL_CTX_free>>;
using tls_ptr = std::unique_ptr<SSL, certs::openssl_end<SSL_free>>;

void limit_waits(int fd) {
  const timeval limit{patience_s, 0};
  ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
  ::setsockopt(fd, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof(limit));
}

sockaddr_in this_machine(std::uint16_t port) {
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(port);
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return where;
}

int choose_any(SSL*, const unsigned char** chosen, unsigned char* size, const unsigned char*,
               unsigned, void* wanted) {
  const auto& text = *static_cast<const std::string*>(wanted);
  *chosen = reinterpret_cast<const unsigned char*>(text.data());
  *size = static_cast<unsigned char>(text.size());
  return text.empty() ? SSL_TLSEXT_ERR_NOACK : SSL_TLSEXT_ERR_OK;
}

context_ptr context_of(const tls_settings& settings) {
  context_ptr made(SSL_CTX_new(TLS_method()));
  SSL_CTX_set_min_proto_version(made.get(), settings.version);
  SSL_CTX_set_max_proto_version(made.get(), settings.version);
  SSL_CTX_set_verify(made.get(), SSL_VERIFY_NONE, nullptr);
  if (!settings.identity.empty() &&
      (SSL_CTX_use_certificate_file(made.get(), (settings.identity / "node.crt").c_str(),
                                    SSL_FILETYPE_PEM) != 1 ||
       SSL_CTX_use_PrivateKey_file(made.get(), (settings.identity / "node.key").c_str(),
                                   SSL_FILETYPE_PEM) != 1))
    throw std::runtime_error("no identity in " + settings.identity.string());
  const std::string offer = static_cast<char>(settings.protocol.size()) + settings.protocol;
  if (!settings.protocol.empty())
    SSL_CTX_set_alpn_protos(made.get(), reinterpret_cast<const unsigned char*>(offer.data()),
                            static_cast<unsigned>(offer.size()));
  SSL_CTX_set_alpn_select_cb(made.get(), choose_any, const_cast<std::string*>(&settings.protocol));
  return made;
}

}  // namespace

unique_fd plain_connection(std::uint16_t port) {
  unique_fd made(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto where = this_machine(port);
  limit_waits(made.get());
  if (::connect(made.get(), reinterpret_cast<const sockaddr*>(&where), sizeof(where)) != 0)
    made.reset();
  return made;
}

bool is_ended_by_peer(int fd) {
  std::array<char, 4096> buffer{};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
  while (std::chrono::steady_clock::now() < deadline) {
    pollfd wait{fd, POLLIN, 0};
    if (::poll(&wait, 1, 1000) > 0 && ::recv(fd, buffer.data(), buffer.size(), 0) <= 0)
      return true;
  }
  return false;
}

std::string first_words(std::uint16_t port, const tls_settings& settings) {
  const auto fd = plain_connection(port);
  const auto context = context_of(settings);
  const tls_ptr tls(SSL_new(context.get()));
  SSL_set_fd(tls.get(), fd.get());
  std::array<char, 64> words{};
  int size = 0;
  if (SSL_connect(tls.get()) == 1)
    size = SSL_read(tls.get(), words.data(), words.size());
  ERR_clear_error();
  return {words.data(), static_cast<std::size_t>(std::max(size, 0))};
}

silent_listener listen_silently() {
  silent_listener made{unique_fd(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), 0};
  auto where = this_machine(0);
  socklen_t size = sizeof(where);
  auto* address = reinterpret_cast<sockaddr*>(&where);
  if (::bind(made.socket.get(), address, size) != 0 || ::listen(made.socket.get(), 16) != 0 ||
      ::getsockname(made.socket.get(), address, &size) != 0)
    throw std::runtime_error("nothing to listen on");
  made.port = ntohs(where.sin_port);
  return made;
}

tls_stranger::tls_stranger(tls_settings settings, std::string words)
    : settings_(std::move(settings)), words_(std::move(words)) {
  auto made = listen_silently();
  listener_ = std::move(made.socket);
  port_ = made.port;
  thread_ = std::thread([this] { serve(); });
}

tls_stranger::~tls_stranger() {
  ends_ = true;
  thread_.join();
}

void tls_stranger::serve() {
  const auto context = context_of(settings_);
  while (!ends_) {
    pollfd wait{listener_.get(), POLLIN, 0};
    if (::poll(&wait, 1, 20) <= 0)
      continue;
    const unique_fd guest(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    limit_waits(guest.get());
    const tls_ptr tls(SSL_new(context.get()));
    SSL_set_fd(tls.get(), guest.get());
    char byte = 0;
    if (SSL_accept(tls.get()) == 1 &&
        SSL_write(tls.get(), words_.data(), static_cast<int>(words_.size())) > 0)
      SSL_read(tls.get(), &byte, 1);  // Until the other side leaves.
    ERR_clear_error();
  }
}

}  // namespace tedit::test
