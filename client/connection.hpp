// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "client/inbox.hpp"
#include "client/messages.hpp"
#include "client/socket.hpp"

namespace tedit::client {

/// Requests and their answers on one socket. Thread-safe. Internal to the client.
class connection {
public:
  /// What came for one request.
  struct answer {
    v1::ServerMessage message;
    std::optional<incoming_stream>
      bulk;  ///< For those that announce a stream, complete: FileReady, SectionReady, ...
  };

  explicit connection(events handlers);
  ~connection();
  connection(const connection&) = delete;
  connection& operator=(const connection&) = delete;

  /// Connects and exchanges Hello and Welcome. Errors: as `client::connect`.
  [[nodiscard]] expected<void> start(const connect_options& options);

  /// Sends a request and waits for its answer, which must be of the kind `wanted`. Polls
  /// `run.cancel` every 20 ms and reports progress from the calling thread.
  /// Errors: what the server says; `timeout` after `limit` (the request is cancelled then);
  /// `service_unavailable` when the connection breaks; `protocol_error` for another answer;
  /// `internal` on the I/O thread.
  [[nodiscard]] expected<answer> ask(v1::ClientMessage request, v1::ServerMessage::BodyCase wanted,
                                     std::chrono::milliseconds limit, const execution& run);

  // -- messages that are not answered, except by an Error -----------------------------------

  /// Takes `count` (> 0) request ids in a row, the first of which is returned; an Error for any of
  /// them is kept.
  [[nodiscard]] std::uint64_t begin_unanswered(std::uint64_t count);

  /// The id must be one of those. Waits while more than 4 MiB are queued; errors as `ask`, also the
  /// kept Error of an earlier one, and `cancelled`.
  [[nodiscard]] expected<void> send_unanswered(std::uint64_t first, std::uint64_t id,
                                               v1::ClientMessage message,
                                               std::chrono::milliseconds limit,
                                               const execution& run);

  /// Gives the ids back; the first Error that came for them, or nothing.
  [[nodiscard]] std::optional<error> end_unanswered(std::uint64_t first);

  /// Ends the connection at once; what waits fails with `service_unavailable`.
  void abort() { socket_.abort({ec::service_unavailable, "the connection was ended", {}, {}}); }

  [[nodiscard]] bool connected() const noexcept { return socket_.connected(); }
  [[nodiscard]] bool on_io_thread() const noexcept { return socket_.on_io_thread(); }
  [[nodiscard]] inbox& arrivals() noexcept { return inbox_; }

  /// The largest message that the server takes, bytes.
  [[nodiscard]] std::uint64_t max_message() const noexcept { return max_message_; }
  /// Those of mesh files that the server reads and writes.
  [[nodiscard]] const std::vector<offered_format>& formats() const noexcept { return formats_; }
  [[nodiscard]] const std::string& server() const noexcept { return server_; }

  /// Whom the token names, and what it allows.
  [[nodiscard]] const own_access& access() const noexcept { return access_; }

private:
  using clock = std::chrono::steady_clock;

  /// A request without an answer yet; guarded by the mutex. Once it is `done`, who asked reads the
  /// result without it: nothing that the server may still send changes it then.
  struct pending {
    std::uint64_t first = 0;  ///< The ids from here to the key of `pending_` belong to it.
    bool done = false;
    std::optional<error> failure;
    answer result;
    double fraction = 0;
    std::string stage;
    bool progressed = false;
  };

  using shared_pending = std::shared_ptr<pending>;

  [[nodiscard]] expected<void> hello(const connect_options& options);
  /// The next id, and what the request is a part of.
  std::uint64_t number(v1::ClientMessage& request);
  [[nodiscard]] expected<shared_pending> add(std::uint64_t first, std::uint64_t last);
  void remove(std::uint64_t id);
  [[nodiscard]] expected<void> send(const v1::ClientMessage& message);
  void send_cancel(std::uint64_t id);
  [[nodiscard]] expected<void> wait(std::uint64_t id, pending& request,
                                    std::chrono::milliseconds limit, const execution& run);
  void report_progress(std::unique_lock<std::mutex>& lock, pending& request, const execution& run,
                       double& reported);

  // -- on the I/O thread --
  void received(std::string_view payload);
  [[nodiscard]] expected<void> dispatch(v1::ServerMessage& message, std::size_t bytes);
  [[nodiscard]] expected<void> dispatch_bulk(v1::ServerMessage& message, const v1::Stream& stream,
                                             std::size_t bytes);
  [[nodiscard]] expected<void> dispatch_event(v1::ServerMessage& message, std::size_t bytes);
  void committed_came(v1::ServerMessage& message);
  void solved_came(v1::ServerMessage& message);
  void progress_came(std::uint64_t id, const v1::Progress& progress);
  void error_came(std::uint64_t id, const v1::Error& message);
  void answer_came(v1::ServerMessage& message);
  void bulk_came(std::uint64_t id, incoming_stream data);
  void closed(const error& reason);
  [[nodiscard]] shared_pending find(std::uint64_t id);

  const events handlers_;
  inbox inbox_;
  std::atomic<std::uint64_t> next_id_{1};
  std::atomic<std::uint64_t> max_message_{std::uint64_t{1} << 20};
  own_access access_;                    ///< As `formats_`.
  std::vector<offered_format> formats_;  ///< Not changed once `start` is done.
  std::string server_;                   ///< The same.
  std::function<std::string()> traceparent_;

  std::mutex mutex_;  ///< Guards the three below and all `pending`.
  std::condition_variable changed_;
  std::map<std::uint64_t, shared_pending> pending_;  ///< By the last id.
  std::optional<error> closed_;
  std::optional<error> last_error_;  ///< An Error for no request: why the server will close.

  socket socket_;  ///< Last: its thread ends before the rest goes.
};

}  // namespace tedit::client
