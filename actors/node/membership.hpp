// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <caf/actor_system.hpp>
#include <caf/scoped_actor.hpp>

#include "actors/interfaces.hpp"
#include "base/error.hpp"
#include "base/execution.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

/// A server on another machine.
struct join_place {
  std::string host;  ///< Name or IP address; the server's certificate must have it.
  std::uint16_t port = 0;
  std::filesystem::path certificates;  ///< What "tedit certs issue" made for this node.
  std::string version;                 ///< Of this program.
};

/// This process as a node of a server: its connection, its actor system, its pages. Its end cuts
/// the connection and ends the actors, which takes as long as work that they have on threads.
class membership {
public:
  /// Errors: those of `dial::connect`; `service_unavailable` when the server does not go on.
  [[nodiscard]] static expected<std::unique_ptr<membership>> join(const join_place& where,
                                                                  const cancel_token& stop);
  /// Over the end of a link whose other end is the pool's that started this process.
  [[nodiscard]] static expected<std::unique_ptr<membership>> join(unique_fd link,
                                                                  const cancel_token& stop);

  membership(const membership&) = delete;
  membership& operator=(const membership&) = delete;
  ~membership();

  [[nodiscard]] caf::actor_system& system();
  /// What the server lets this node talk to, by its certificate.
  [[nodiscard]] const caf::actor& entrance() const;
  [[nodiscard]] const page_store_actor& pages() const;
  [[nodiscard]] const std::shared_ptr<page_cache>& cache() const;
  /// For requests from outside of actors.
  [[nodiscard]] caf::scoped_actor& self();

  /// The actor ends with the membership.
  void own(const caf::actor& one);

  /// Waits until the server or an actor of this node is gone, or for so long; whether all are
  /// there still.
  [[nodiscard]] bool stays(std::chrono::milliseconds time);

private:
  struct impl;
  explicit membership(std::unique_ptr<impl> made);
  static expected<std::unique_ptr<membership>> join(std::unique_ptr<impl> made, unique_fd link,
                                                    const cancel_token& stop);
  std::unique_ptr<impl> impl_;
};

/// What this machine says of itself; the name and address are the server's to say.
[[nodiscard]] node_facts facts_of_this_machine(std::string device, const std::string& version);

/// Asks the server behind `enlister` to take a worker in. Errors: `service_unavailable` with the
/// server's reason, or when it does not answer within ten seconds; `invalid_argument` when asking
/// again would come to the same.
[[nodiscard]] expected<void> enlist_at(caf::scoped_actor& self, const caf::actor& enlister,
                                       node_enlistment who);

/// Asks a server what it is; a worker may before it enlists.
using about_atom = caf::atom_constant<caf::atom("about")>;

struct server_facts {
  std::string version;  ///< "0.1.0".
  double time_s = 0;    ///< What its clock said, seconds since 1970.
};

/// What the server behind `enlister` says of itself. Errors: `service_unavailable` when it does not
/// answer within ten seconds, or is of a version that does not know the question.
[[nodiscard]] expected<server_facts> ask_about(caf::scoped_actor& self, const caf::actor& enlister);

/// As the server answers it.
[[nodiscard]] std::vector<std::string> about_this_server(const std::string& version);

/// Text from another machine as logs and status may have it: printable, valid and not endless.
[[nodiscard]] std::string tidy(std::string text);

}  // namespace tedit::actors
