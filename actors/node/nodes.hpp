// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <caf/actor_system.hpp>

#include "actors/interfaces.hpp"
#include "base/error.hpp"

namespace tedit::actors {

struct node_options {
  std::filesystem::path certificates;  ///< What "tedit certs issue --role server" made.
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: any that is free.
  std::string version;     ///< Of this program.
};

/// To whom nodes come.
struct entrance_parts {
  worker_set pools;  ///< Workers.
  hub_actor hub;     ///< Observers.
  caf::actor pages;  ///< Observers, for what they hear of.
};

/// Where other machines come in: behind mutual TLS (actors/links/door.hpp), each as a worker of the
/// pool of its certificate's role, or as an observer.
class node_entrance {
public:
  /// Errors: those of `door::open`.
  [[nodiscard]] static expected<std::unique_ptr<node_entrance>> open(caf::actor_system& system,
                                                                     entrance_parts parts,
                                                                     const node_options& options);
  node_entrance(const node_entrance&) = delete;
  node_entrance& operator=(const node_entrance&) = delete;
  ~node_entrance();  ///< Cuts all connections.

  [[nodiscard]] std::uint16_t port() const;

  /// Brings how many were turned away, by reason, into the process's metrics. From any thread.
  void measure() const;

private:
  struct impl;
  explicit node_entrance(std::unique_ptr<impl> made);
  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::actors
