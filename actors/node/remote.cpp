// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/remote.hpp"

#include <charconv>
#include <chrono>
#include <optional>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/node/membership.hpp"
#include "actors/observation.hpp"
#include "actors/supervisor/solver_choice.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

std::optional<std::pair<int, int>> major_and_minor(std::string_view version) {
  std::pair<int, int> result;
  const char* const end = version.data() + version.size();
  const auto major = std::from_chars(version.data(), end, result.first);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.')
    return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, result.second);
  if (minor.ec != std::errc() || (minor.ptr != end && *minor.ptr != '.'))
    return std::nullopt;
  return result;
}

/// For a node to say what it is, once its certificate was seen.
constexpr std::chrono::seconds time_to_enlist{30};

node_answer refusal(bool later, std::string reason, std::string remedy) {
  return {false, later, std::move(reason), std::move(remedy)};
}

/// Why a node cannot be taken in, before its pool is asked.
std::optional<node_answer> objection(const node_enlistment& who, const node_peer& peer,
                                     const std::string& version) {
  const auto role = name_of(peer.role);
  if (who.role != role)
    return refusal(false,
                   "the certificate of " + peer.name + " is one of a " + role + " worker, not of " +
                     tidy(who.role),
                   "Start it with --role " + role + ", or issue it another certificate");
  if (!work_together(who.node.version, version))
    return refusal(true,
                   "the worker is TEdit " + tidy(who.node.version) + ", the server " + version,
                   "Install a version on both whose minor numbers are at most one apart");
  const auto& own = who.node.own_device;
  if (!own.empty() && (peer.role != worker_role::solver || !can_be_own_device(own)))
    return refusal(false, "\"" + tidy(own) + "\" cannot be the name of a solver of its own kind",
                   "Take up to 63 letters, digits, \".\", \"-\" and \"_\", not \"auto\", \"cpu\", "
                   "\"gpu\" or \"lavapipe\"");
  if (!who.worker)
    return refusal(false, "no worker was named", "Start it with \"tedit worker --join\"");
  return std::nullopt;
}

caf::error no_observer(const node_peer& peer) {
  return to_caf({ec::invalid_argument,
                 "the certificate of " + peer.name + " is one of a " + name_of(peer.role) +
                   " worker, not of an observer",
                 "Issue it another certificate with \"tedit certs issue --role observer\"",
                 {}});
}

caf::actor pool_of(const worker_set& pools, worker_role role) {
  caf::actor result;
  pools.for_each([&](worker_role one, const auto& pool) {
    if (one == role)
      result = caf::actor_cast<caf::actor>(pool);
  });
  return result;
}

struct enlister_state {
  caf::actor_addr worker;  ///< Once it was named; the connection has no other.
  bool enlisted = false;
  static inline const char* name = "node_enlister";
};

caf::behavior node_enlister(caf::stateful_actor<enlister_state>* self, const worker_set& pools,
                            const node_peer& peer, const std::string& version) {
  heed_only_own_exits(self);
  const auto pool = pool_of(pools, peer.role);
  // It ends with its worker; one that never names a worker must not keep the connection.
  self->set_down_handler([=](const caf::down_msg&) { self->quit(); });
  self->delayed_send(self, time_to_enlist, rest_atom::value);
  const auto enlist = [=](const node_enlistment& who) -> caf::result<node_answer> {
    auto why = objection(who, peer, version);
    // It speaks for itself alone: once, and for a worker of its own.
    const auto& asker = self->current_sender();
    if (!why && (self->state.worker || !asker || asker->node() != who.worker.node()))
      why = refusal(false, "it named a worker that is not its own, or a second one",
                    "Start each worker with a \"tedit worker --join\" of its own");
    if (why) {
      logging::warn("node {} ({}) was turned away: {}", peer.name, peer.address, why->reason);
      self->quit();  // Once it is answered.
      return *why;
    }
    self->state.worker = who.worker.address();
    self->monitor(who.worker);
    auto promise = self->make_response_promise<node_answer>();
    remote_worker guest{who.worker, who.node, peer.line};
    guest.node.name = peer.name;
    guest.node.address = peer.address;
    guest.node.device = tidy(std::move(guest.node.device));
    guest.node.version = tidy(std::move(guest.node.version));
    self->request(pool, std::chrono::seconds(5), guest)
      .then(
        [=](bool accepted) mutable {
          self->state.enlisted = accepted;
          promise.deliver(
            accepted ? node_answer{true, false, {}, {}}
                     : refusal(true, "the server is stopping, or takes no more kinds of solvers",
                               "Try again soon"));
        },
        [=](const caf::error& e) mutable {
          promise.deliver(refusal(true, from_caf(e, "the pool").message, "Try again soon"));
        });
    return promise;
  };
  return {enlist,
          [=](const retirement& note) {
            if (self->state.worker)
              self->send(pool, note, self->state.worker);
          },
          [=](about_atom) { return about_this_server(version); },
          [=](names_atom) -> caf::result<std::vector<std::string>> { return no_observer(peer); },
          [=](watch_atom, const std::string&, const caf::actor&) -> caf::result<std::string> {
            return no_observer(peer);
          },
          [=](rest_atom) {
            if (self->state.enlisted)
              return;
            peer.line->cut();
            self->quit();
          }};
}

}  // namespace

bool work_together(std::string_view a, std::string_view b) {
  const auto one = major_and_minor(a);
  const auto other = major_and_minor(b);
  return one && other && one->first == other->first && std::abs(one->second - other->second) <= 1;
}

caf::actor make_node_enlister(caf::actor_system& system, const worker_set& pools, node_peer peer,
                              const std::string& version) {
  return system.spawn(node_enlister, pools, std::move(peer), version);
}

void end_enlister(const caf::actor& enlister) {
  caf::anon_send_exit(enlister, caf::exit_reason::user_shutdown);
}

}  // namespace tedit::actors
