// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/link.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <chrono>
#include <set>
#include <utility>

#include <caf/io/basp_broker.hpp>
#include <caf/io/middleman.hpp>
#include <caf/io/network/default_multiplexer.hpp>
#include <caf/io/network/scribe_impl.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/links/basp_guard.hpp"
#include "base/logging/logging.hpp"
#include "base/system_failure.hpp"

namespace tedit::actors {

namespace {

namespace net = caf::io::network;

/// For a process to start and speak, at the most: its pool waits less, and ends it.
constexpr auto time_to_join = std::chrono::minutes(1);

/// CAF's connection with a guard before it.
class guarded_scribe final : public net::scribe_impl {
public:
  guarded_scribe(net::default_multiplexer& by, net::native_socket fd, bool serves, reach within)
      : scribe_impl(by, fd), guard_(std::move(within)), early_(serves) {}

  void configure_read(caf::io::receive_policy::config config) override {
    scribe_impl::configure_read(config);
    if (!std::exchange(early_, false))
      return;
    // Else the link counts as silent from here on, while a process begins at the other end, and is
    // cut before a slow one has joined.
    auto& known = static_cast<caf::io::basp_broker&>(*parent()).ctx;
    if (const auto own = known.find(hdl()); own != known.end())
      own->second.last_seen += time_to_join;
  }

  bool consume(caf::execution_unit* context, const void* data, std::size_t size) override {
    if (guard_.admits({static_cast<const std::byte*>(data), size}))
      return net::scribe_impl::consume(context, data, size);
    logging::error("link: the other end broke the protocol between nodes; the link is cut");
    this->io_failure(context, net::operation::read);
    ::shutdown(stream_.fd(), SHUT_RDWR);
    return false;
  }

private:
  basp_guard guard_;
  bool early_;  ///< Served, and not listened to before.
};

caf::actor broker_of(caf::actor_system& system) {
  return system.middleman().named_broker<caf::io::basp_broker>(caf::atom("BASP"));
}

net::default_multiplexer& multiplexer_of(caf::actor_system& system) {
  return dynamic_cast<net::default_multiplexer&>(system.middleman().backend());
}

caf::io::scribe_ptr make_scribe(caf::actor_system& system, unique_fd end, bool serves,
                                reach within = {}) {
  return caf::make_counted<guarded_scribe>(multiplexer_of(system), end.release(), serves,
                                           std::move(within));
}

}  // namespace

expected<link_ends> make_link() {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return system_failure("no link to a worker can be made", errno);
  return link_ends{unique_fd(ends[0]), unique_fd(ends[1])};
}

void serve_link(caf::actor_system& system, unique_fd end, const caf::actor& enlister,
                reach others) {
  const reach within = [own = enlister.id(), others = std::move(others)](std::uint64_t actor) {
    return actor == own || others(actor);
  };
  // The broker wants a port for what it publishes. None is opened: the number only names the
  // enlister between here and the greeting that the same message sends, so all links share one.
  constexpr std::uint16_t slot = 1;
  caf::anon_send(broker_of(system), caf::publish_atom::value,
                 make_scribe(system, std::move(end), true, within), slot,
                 caf::actor_cast<caf::strong_actor_ptr>(enlister), std::set<std::string>{});
}

expected<caf::actor> join_link(caf::actor_system& system, unique_fd end, const cancel_token& stop) {
  const auto broker = broker_of(system);
  auto scribe = make_scribe(system, std::move(end), false);
  // Else the connection counts as silent since the epoch, and the first heartbeat ends it.
  multiplexer_of(system).post([broker, handle = scribe->hdl()] {
    auto* actor = caf::actor_cast<caf::abstract_actor*>(broker);
    static_cast<caf::io::basp_broker*>(actor)->set_context(handle);
  });
  caf::scoped_actor self(system);
  // Not a request: nothing looks at `stop` while one is waited for.
  self->send(broker, caf::connect_atom::value, std::move(scribe), std::uint16_t{0});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  caf::actor found;
  bool answered = false;
  while (!answered && !stop.cancelled() && std::chrono::steady_clock::now() < deadline)
    self->receive(
      [&](caf::node_id&, caf::strong_actor_ptr& enlister, std::set<std::string>&) {
        answered = true;
        if (enlister)
          found = caf::actor_cast<caf::actor>(enlister);
      },
      [&](caf::error&) { answered = true; }, caf::after(std::chrono::milliseconds(200)) >> [] {});
  if (found)
    return found;
  if (stop.cancelled())
    return fail(ec::cancelled, "joining the server was cancelled");
  return fail(ec::service_unavailable, "the server at the other end of the link does not answer",
              "Workers are started by \"tedit serve\"");
}

}  // namespace tedit::actors
