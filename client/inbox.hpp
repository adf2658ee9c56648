// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/messages.hpp"

namespace tedit::client {

/// What arrives for the open document without being an answer: streams, and from them the surface,
/// fields and files. Fed by the I/O thread, read by all. Internal to the client.
class inbox {
public:
  /// `on_bulk` gets each complete file with the request that it answers, on the I/O thread.
  inbox(const events& handlers,
        std::function<void(std::uint64_t request, incoming_stream data)> on_bulk)
      : handlers_(handlers), on_bulk_(std::move(on_bulk)) {}

  // -- from the I/O thread. Errors: `protocol_error`, after which the server cannot be followed --

  [[nodiscard]] expected<void> take(const v1::SurfaceUpdate& message, std::size_t message_bytes);
  [[nodiscard]] expected<void> take(const v1::FieldUpdate& message, std::size_t message_bytes);
  [[nodiscard]] expected<void> take(const v1::Stream& stream, std::uint64_t request,
                                    std::size_t message_bytes);
  [[nodiscard]] expected<void> take(const v1::Chunk& message, std::size_t message_bytes);

  /// An event of this version that came earlier does not count for the waits to come.
  void head_moved(const std::string& version_id);

  /// The document has another name; whether it is the open one.
  [[nodiscard]] bool renamed(const std::string& before, const std::string& document);

  /// Whether an event of this document is for us.
  [[nodiscard]] bool is_open(const std::string& document) const;

  void closed(const error& reason);

  // -- from callers -----------------------------------------------------------------------

  /// Forgets the document before; empty: any name is taken until `opened`. What is sent may build
  /// on `held`.
  void open(const std::string& document, const surface_model& held);
  void opened(const std::string& document);
  [[nodiscard]] std::string document() const;

  /// Throws a file's stream away that nobody waits for any more.
  void drop_bulk(std::uint64_t request);

  /// Fields that came earlier do not count for the waits to come.
  void forget_fields();

  [[nodiscard]] surface_model surface() const;
  [[nodiscard]] expected<surface_event> wait_surface(const std::string& version_id,
                                                     std::chrono::milliseconds patience);

  using shared_field = std::shared_ptr<const field_event>;
  /// All fields of one solve, in the order of their arrival.
  using solved_fields = std::vector<shared_field>;

  /// `solve` 0: of any.
  [[nodiscard]] expected<solved_fields> wait_fields(const std::string& version_id,
                                                    std::uint64_t solve,
                                                    std::chrono::milliseconds patience);

private:
  struct bulk_answer {
    std::uint64_t request = 0;
  };

  /// A stream on its way and what it is for; nothing for what is not for the open document.
  struct arrival {
    incoming_stream data;
    std::variant<std::monostate, v1::SurfaceUpdate, v1::FieldUpdate, bulk_answer> purpose;
  };

  [[nodiscard]] expected<void> begin(const v1::Stream& stream, std::size_t message_bytes,
                                     decltype(arrival::purpose) purpose);
  [[nodiscard]] expected<void> finish(std::uint64_t stream);
  [[nodiscard]] expected<void> finish_surfaces();
  [[nodiscard]] std::optional<surface_event> apply(const surface_update& update,
                                                   const traffic& moved);
  [[nodiscard]] expected<void> finish_field(const arrival& done);
  void keep_field(const shared_field& field);
  [[nodiscard]] expected<void> finish_bulk(arrival done);
  [[nodiscard]] std::optional<expected<surface_event>> find_surface(const std::string& version_id);

  const events& handlers_;
  std::function<void(std::uint64_t, incoming_stream)> on_bulk_;

  mutable std::mutex mutex_;  ///< Guards all below.
  std::condition_variable changed_;
  std::optional<error> closed_;
  std::string document_;
  std::map<std::uint64_t, arrival> streams_;
  std::deque<std::uint64_t> surface_order_;  ///< Streams of surfaces, as they were announced.
  surface_model surface_;
  std::optional<error> surface_error_;     ///< Why `surface_` cannot follow the head.
  std::deque<surface_event> surfaces_in_;  ///< Complete and not waited for, oldest first.
  std::optional<surface_event> current_;   ///< The event that made `surface_`.
  solved_fields fields_begun_;             ///< Of a solve whose others still come.
  std::deque<solved_fields> fields_in_;    ///< The latest complete ones; none is empty.
};

}  // namespace tedit::client
