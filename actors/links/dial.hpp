// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "actors/links/refusal.hpp"
#include "base/error.hpp"
#include "base/execution.hpp"
#include "base/unique_fd.hpp"

namespace tedit::actors {

struct dial_options {
  std::filesystem::path identity;  ///< What "tedit certs issue" made for this node.
  std::string host;                ///< Name or IP address; the server's certificate must have it.
  std::uint16_t port = 0;
  std::chrono::milliseconds limit = std::chrono::seconds(10);  ///< Until the link stands.
  /// How often it is looked whether the server's certificate still holds.
  std::chrono::milliseconds look_every = std::chrono::minutes(1);
};

/// This node's connection to a server's door, and the link over it. It has one thread, for all that
/// happens on it, and cuts the link at its end.
class dial {
public:
  /// Errors, each with what can be done: `service_unavailable` when the host is not found, does not
  /// answer, is no node of TEdit or takes nobody more, `timeout` when `limit` is over: trying again
  /// later may help. `io_error`, `bad_input` and `invalid_argument` for this node's files,
  /// `invalid_argument` where a certificate stands in the way (of another authority, ended,
  /// revoked, not a server's, not for this host, or a role that is not admitted), on whichever
  /// side: a person must act first. `cancelled` by `stop`, which is looked at twenty times a
  /// second. A name server that does not answer can hold the call up beyond its limit.
  [[nodiscard]] static expected<std::unique_ptr<dial>> connect(dial_options options,
                                                               const cancel_token& stop = {});

  dial(const dial&) = delete;
  dial& operator=(const dial&) = delete;
  ~dial();

  /// The end for `join_link`; once.
  [[nodiscard]] unique_fd take_link();
  [[nodiscard]] const link_peer& server() const;
  /// Until either side ended. From any thread.
  [[nodiscard]] bool connected() const;

private:
  struct impl;
  explicit dial(std::unique_ptr<impl> state);
  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::actors
