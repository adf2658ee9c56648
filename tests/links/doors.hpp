// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include <caf/event_based_actor.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/exits.hpp"
#include "actors/links/dial.hpp"
#include "actors/links/door.hpp"
#include "actors/links/link.hpp"
#include "actors/node/system_config.hpp"
#include "base/logging/logging.hpp"
#include "tests/certs/authority_fixture.hpp"

namespace tedit::test {

using actors::dial;
using actors::door;
using actors::link_peer;
using actors::refusal;
using certs::role;
using clock_type = std::chrono::steady_clock;

/// For what must come, however busy the machine is.
inline constexpr auto long_wait = std::chrono::seconds(30);

/// Whether it becomes true.
inline bool eventually(const std::function<bool()>& holds) {
  const auto deadline = clock_type::now() + long_wait;
  while (clock_type::now() < deadline) {
    if (holds())
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return holds();
}

inline std::uint64_t total(const actors::refusal_counts& counts) {
  std::uint64_t sum = 0;
  for (const auto one : counts)
    sum += one;
  return sum;
}

/// How many a door has turned away for this reason; it says so to them before it counts.
inline std::uint64_t count_of(const door& open, refusal why) {
  return open.refusals()[static_cast<std::size_t>(why)];
}

/// A node of CAF of its own.
struct caf_node {
  actors::system_config config{true};
  caf::actor_system system{config};
};

/// Answers with what it is asked; watches whom it is given and counts their ends.
inline caf::behavior echo(caf::event_based_actor* self, std::shared_ptr<std::atomic<int>> ends) {
  actors::heed_only_own_exits(self);
  self->set_down_handler([ends](const caf::down_msg&) { ++*ends; });
  return {[](const std::string& text) { return text; }, [](int x) { return x + 1; },
          [self](const caf::actor& whom) {
            self->monitor(whom);
            return true;
          }};
}

/// A node that has dialled and joined.
struct joined_node {
  std::unique_ptr<dial> line;
  caf_node node;
  caf::actor found;

  /// The answer to a number, one higher; 0 when there is none.
  [[nodiscard]] int ask(int x) {
    int answer = 0;
    caf::scoped_actor self(node.system);
    self->request(found, long_wait, x)
      .receive([&](int y) { answer = y; }, [](const caf::error&) {});
    return answer;
  }
};

/// A server with a door on this machine: certificate "hall", all links served with an echo.
class Doors : public Authority {
protected:
  Doors() { logging::set_level("off"); }
  ~Doors() override {
    caf::anon_send_exit(enlister, caf::exit_reason::user_shutdown);
    logging::set_level("info");
  }

  void SetUp() override {
    Authority::SetUp();
    issued({role::server, "hall", {"127.0.0.1", "localhost"}});
  }

  [[nodiscard]] actors::door_options options() {
    actors::door_options made;
    made.identity = at("hall");
    made.revoked = ca() / "crl.pem";
    made.accept = [this](unique_fd end, link_peer who) {
      actors::serve_link(host.system, std::move(end), enlister);
      const std::lock_guard lock(mutex);
      came.push_back(std::move(who));
    };
    return made;
  }

  /// One whose links' ends the test has itself.
  [[nodiscard]] actors::door_options options_of_bare_links() {
    auto made = options();
    made.accept = [this](unique_fd end, link_peer who) {
      const std::lock_guard lock(mutex);
      ends.push_back(std::move(end));
      came.push_back(std::move(who));
    };
    return made;
  }

  [[nodiscard]] expected<std::unique_ptr<dial>> dialled(
    const std::string& name, std::uint16_t port,
    std::chrono::milliseconds limit = long_wait) const {
    return dial::connect({at(name), "127.0.0.1", port, limit});
  }

  [[nodiscard]] std::unique_ptr<joined_node> join(const std::string& name,
                                                  std::uint16_t port) const {
    auto made = std::make_unique<joined_node>();
    made->line = value(dialled(name, port));
    made->found = value(actors::join_link(made->node.system, made->line->take_link()));
    return made;
  }

  [[nodiscard]] std::size_t count_came() {
    const std::lock_guard lock(mutex);
    return came.size();
  }

  caf_node host;
  std::shared_ptr<std::atomic<int>> seen_ends = std::make_shared<std::atomic<int>>(0);
  caf::actor enlister = host.system.spawn(echo, seen_ends);
  std::mutex mutex;
  std::vector<link_peer> came;
  std::vector<unique_fd> ends;
};

}  // namespace tedit::test
