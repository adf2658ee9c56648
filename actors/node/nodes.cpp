// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/nodes.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <mutex>
#include <utility>
#include <vector>

#include "actors/links/door.hpp"
#include "actors/links/link.hpp"
#include "actors/node/observing.hpp"
#include "actors/node/remote.hpp"
#include "base/logging/logging.hpp"
#include "base/metrics.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

namespace {

/// A second descriptor of our end of the link: CAF has the first.
class node_line final : public lifeline {
public:
  node_line(unique_fd watched, std::string name)
      : fd_(std::move(watched)), name_(std::move(name)) {}

  std::optional<std::string> ended() override {
    pollfd look{fd_.get(), POLLRDHUP, 0};
    while (::poll(&look, 1, 0) < 0 && errno == EINTR) {
    }
    if ((look.revents & (POLLRDHUP | POLLHUP | POLLERR | POLLNVAL)) != 0)
      return "lost its connection";
    return std::nullopt;
  }

  void cut() override { ::shutdown(fd_.get(), SHUT_RDWR); }

  [[nodiscard]] std::string name() const override { return name_; }

private:
  unique_fd fd_;
  std::string name_;
};

/// Those that were made, which must end before their system does. Thread-safe.
class enlisters {
public:
  void add(const caf::actor& one) {
    const std::lock_guard lock(mutex_);
    std::erase_if(all_, [](const caf::actor_addr& was) {
      return !caf::actor_cast<caf::strong_actor_ptr>(was);
    });
    all_.push_back(one.address());
  }

  void end() {
    const std::lock_guard lock(mutex_);
    for (const auto& one : std::exchange(all_, {}))
      if (const auto there = caf::actor_cast<caf::actor>(one))
        end_enlister(there);
  }

private:
  std::mutex mutex_;
  std::vector<caf::actor_addr> all_;
};

/// What a connection becomes.
struct reception {
  caf::actor_system& system;
  entrance_parts parts;
  std::string version;
  std::shared_ptr<enlisters> made = std::make_shared<enlisters>();

  /// What a node of this kind may talk to; null for one that is neither worker nor observer.
  [[nodiscard]] caf::actor host_for(const link_peer& who, std::shared_ptr<lifeline> line) const {
    if (who.what == certs::role::observer)
      return caf::actor_cast<caf::actor>(
        make_observing(system, {parts.hub, parts.pages, who.name, std::move(line)}));
    if (const auto role = role_named(certs::role_name(who.what)))
      return make_node_enlister(system, parts.pools,
                                {who.name, who.address, *role, std::move(line)}, version);
    return nullptr;
  }

  void take_in(unique_fd end, const link_peer& who) const {
    unique_fd watched(::fcntl(end.get(), F_DUPFD_CLOEXEC, 0));
    if (watched.get() < 0) {
      logging::error("node {} ({}): no descriptor is left for its connection", who.name,
                     who.address);
      return;  // Closing `end` ends the connection.
    }
    const auto host =
      host_for(who, std::make_shared<node_line>(std::move(watched),
                                                "node " + who.name + " (" + who.address + ")"));
    if (!host)
      return;  // The door admits no other roles.
    made->add(host);
    serve_link(system, std::move(end), host,
               who.what == certs::role::observer ? reach_of({parts.pages}) : reach_of_workers());
  }
};

}  // namespace

struct node_entrance::impl {
  std::shared_ptr<enlisters> made;
  std::unique_ptr<door> entrance;
};

node_entrance::node_entrance(std::unique_ptr<impl> made) : impl_(std::move(made)) {}

node_entrance::~node_entrance() {
  impl_->entrance.reset();
  impl_->made->end();
}

expected<std::unique_ptr<node_entrance>> node_entrance::open(caf::actor_system& system,
                                                             entrance_parts parts,
                                                             const node_options& options) {
  door_options wanted;
  wanted.identity = options.certificates;
  wanted.address = options.address;
  wanted.port = options.port;
  const reception desk{system, std::move(parts), options.version};
  wanted.accept = [desk](unique_fd end, const link_peer& who) {
    desk.take_in(std::move(end), who);
  };
  auto opened = door::open(std::move(wanted));
  if (!opened)
    return fail(opened.error());
  auto made = std::make_unique<impl>();
  made->made = desk.made;
  made->entrance = std::move(*opened);
  return std::unique_ptr<node_entrance>(new node_entrance(std::move(made)));
}

void node_entrance::measure() const {
  const auto counts = impl_->entrance->refusals();
  for (std::size_t i = 0; i < counts.size(); ++i)
    metrics::count_of("tedit_nodes_refused_total",
                      "Connections of nodes that came to nothing, by reason.",
                      {{"reason", std::string(refusal_text(static_cast<refusal>(i)))}})
      .set(counts[i]);
  metrics::level_of("tedit_node_links", "Connections of nodes that have shown their certificate.")
    .set(static_cast<double>(impl_->entrance->peers().size()));
}

std::uint16_t node_entrance::port() const {
  return impl_->entrance->port();
}

}  // namespace tedit::actors
