// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/transport.hpp"

#include <fcntl.h>

#include "actors/gateway/hub.hpp"
#include "base/logging/logging.hpp"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <thread>

#include "base/metrics.hpp"

namespace tedit::gateway {
namespace {

/// Worker processes started from here must not inherit sockets.
void keep_from_children(int descriptor) {
  ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

error_code listen(hub& h, const tcp::endpoint& where) {
  error_code problem;
  h.listener.open(where.protocol(), problem);
  if (problem)
    return problem;
  keep_from_children(h.listener.native_handle());
  h.listener.set_option(net::socket_base::reuse_address(true), problem);
  h.listener.bind(where, problem);
  if (problem)
    return problem;
  h.listener.listen(net::socket_base::max_listen_connections, problem);
  if (!problem)
    h.port = h.listener.local_endpoint(problem).port();
  return problem;
}

/// An exception that got past the sessions costs its connection, never the server.
void run_io(net::io_context& io) {
  for (;;) {
    try {
      io.run();
      return;
    } catch (const std::exception&) {
      // The handler that threw is gone; the others go on.
    }
  }
}

}  // namespace

std::string address_text(const tcp::endpoint& e) {
  const bool v6 = e.address().is_v6();
  return (v6 ? "[" : "") + e.address().to_string() + (v6 ? "]:" : ":") + std::to_string(e.port());
}

void hub::accept_next() {
  const auto taken = [self = shared_from_this()](error_code problem, tcp_socket socket) {
    if (self->stopping)
      return;
    if (!problem) {
      self->take(std::move(socket));
      return self->accept_next();
    }
    // Out of descriptors, most likely: trying again at once would only burn a core.
    self->retry.expires_after(std::chrono::milliseconds(100));
    self->retry.async_wait([self](error_code) {
      if (!self->stopping)
        self->accept_next();
    });
  };
  listener.async_accept(net::make_strand(io), taken);
}

void hub::take(tcp_socket socket) {
  error_code problem;
  const auto peer = socket.remote_endpoint(problem);
  if (problem)
    return;
  const std::string address = peer.address().to_string();
  keep_from_children(socket.native_handle());
  socket.set_option(tcp::no_delay(true), problem);
  const bool refused = !has_place(address);
  auto place = std::make_unique<slot>(shared_from_this(), address);
  net_stream stream{tcp_stream(std::move(socket))};
  if (identity) {
    look_at_certificate();
    stream.secure(*identity->how());
  }
  serve_http(shared_from_this(), std::move(stream), std::move(place), refused);
  make_room();
}

void hub::look_at_certificate() {
  if (const auto ok = identity->look(); !ok)
    logging::error("clients' port: goes on with the certificate that it read before: {}",
                   render(ok.error()));
  metrics::level_of("tedit_certificate_end_seconds",
                    "When the certificate of the clients' port ends, as seconds since 1970.")
    .set(static_cast<double>(identity->until()));
}

bool hub::has_place(const std::string& address) const {
  const auto same = known.find(address);
  return all_known < options.limits.max_connections &&
         (same == known.end() || same->second < options.limits.max_per_address);
}

/// Whoever opens many connections and finishes none loses his own first. All local users have one
/// address: there the oldest goes, and a flood would have to be quicker than a handshake.
void hub::make_room() {
  while (strangers.size() > options.limits.max_strangers) {
    std::map<std::string, std::size_t> count;
    for (const slot* s : strangers)
      ++count[s->address()];
    const auto by_count = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto& most = std::ranges::max_element(count, by_count)->first;
    const auto oldest =
      std::ranges::find_if(strangers, [&](const slot* s) { return s->address() == most; });
    (*oldest)->give_way();
  }
}

void hub::shut() {
  stopping = true;
  error_code ignored;
  listener.close(ignored);
  retry.cancel();
  std::vector<std::function<void(ending)>> ends;
  for (const slot* s : slots)
    ends.push_back(s->end);
  for (const auto& end : ends)
    end(ending::server_stops);
}

// -- transport --------------------------------------------------------------------------------

struct transport::impl {
  explicit impl(std::shared_ptr<hub> h) : shared(std::move(h)), work(shared->io.get_executor()) {}

  std::shared_ptr<hub> shared;
  net::executor_work_guard<io_executor> work;
  std::thread thread;
  std::once_flag stopped;
};

transport::transport(std::unique_ptr<impl> state) : impl_(std::move(state)) {}

transport::~transport() {
  stop();
}

expected<std::unique_ptr<transport>> transport::start(transport_options options) {
  if (!options.accept)
    return fail(ec::invalid_argument, "the transport has nobody to hand connections to");
  error_code problem;
  const std::string address = options.address == "localhost" ? "127.0.0.1" : options.address;
  const auto ip = net::ip::make_address(address, problem);
  if (problem)
    return fail(ec::invalid_argument, "\"" + options.address + "\" is no IP address to listen on",
                "Give one of this machine's addresses, for example 127.0.0.1.");
  const tcp::endpoint where(ip, options.port);
  auto shared = std::make_shared<hub>(std::move(options));
  if (!shared->options.certificates.empty()) {
    auto identity = tls::server_identity::load(shared->options.certificates);
    if (!identity)
      return fail(identity.error());
    shared->fingerprint = identity->fingerprint();
    shared->identity = *std::move(identity);
  }
  shared->hosts = shared->options.allowed_hosts;
  if (!ip.is_unspecified())
    shared->hosts.push_back(ip.is_v6() ? "[" + ip.to_string() + "]" : ip.to_string());
  if (const error_code refusal = listen(*shared, where))
    return fail(ec::service_unavailable,
                "cannot listen on " + address_text(where) + ": " + refusal.message(),
                "End the program that uses the port, or choose another address or port.");
  auto state = std::make_unique<impl>(shared);
  shared->accept_next();
  state->thread = std::thread([shared] { run_io(shared->io); });
  return std::unique_ptr<transport>(new transport(std::move(state)));
}

std::uint16_t transport::port() const {
  return impl_->shared->port;
}

std::string transport::fingerprint() const {
  return impl_->shared->fingerprint;
}

std::size_t transport::connections() const {
  return impl_->shared->open_websockets;
}

void transport::stop() {
  std::call_once(impl_->stopped, [this] {
    hub& shared = *impl_->shared;
    net::post(shared.io, [&shared] { shared.shut(); });
    impl_->work.reset();
    impl_->thread.join();
    // Connection handles may keep the hub alive, but not what the callbacks hold on to.
    shared.options.accept = nullptr;
    shared.options.pages.clear();
  });
}

}  // namespace tedit::gateway
