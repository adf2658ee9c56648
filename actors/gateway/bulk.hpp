// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "actors/gateway/transport.hpp"
#include "mesh/page.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::gateway {

/// Bulk data on its way: the message that announces it, and its bytes in parts.
struct bulk {
  v1::ServerMessage header;      ///< Its Stream is complete but for the number.
  v1::Stream* stream = nullptr;  ///< Inside `header`.
  std::vector<std::span<const std::byte>> parts;
  std::shared_ptr<const void> owner;  ///< Keeps the parts' memory.
};

/// Collects arrays of plain values for a stream, in the order of their bytes.
class bulk_builder {
public:
  template <class T>
  void add(v1::Stream* stream, const std::string& name, v1::ArrayInfo::Type type,
           unsigned components, const std::vector<T>& values) {
    auto* info = stream->add_arrays();
    info->set_name(name);
    info->set_type(type);
    info->set_components(components);
    info->set_items(values.size() / components);
    const auto* first = reinterpret_cast<const char*>(values.data());
    bytes_->insert(bytes_->end(), first, first + values.size() * sizeof(T));
    stream->set_bytes(bytes_->size());
  }

  /// Hands all over to `target`.
  void finish(bulk& target) {
    target.parts = {std::as_bytes(std::span(*bytes_))};
    target.owner = bytes_;
  }

private:
  std::shared_ptr<std::vector<char>> bytes_ = std::make_shared<std::vector<char>>();
};

/// Sends bulk data piece by piece, never more than a little ahead of what the client takes, so that
/// answers and events overtake it. What is waiting is made only when its turn comes: a slow client
/// skips what has become old by then.
class outbox {
public:
  /// Makes the data, or nothing when it is not wanted any more.
  using producer = std::function<std::optional<bulk>()>;

  explicit outbox(std::shared_ptr<connection> to) : to_(std::move(to)) {}

  /// `holds`: bytes that the producer keeps in memory until its turn.
  void add(producer make, std::uint64_t holds = 0) {
    waiting_.push_back({std::move(make), holds});
    held_ += holds;
  }

  /// Bytes that are kept in memory for this client: prepared, on their way, or in the connection.
  [[nodiscard]] std::uint64_t prepared() const;

  /// Sends until the client has enough to take; call it after `add` and when the queue has drained.
  void pump();

private:
  struct item {
    producer make;
    std::uint64_t holds = 0;
  };

  bool begin_next();
  void send_chunk();

  std::shared_ptr<connection> to_;
  std::deque<item> waiting_;
  std::uint64_t held_ = 0;  ///< By those that wait.
  std::optional<bulk> current_;
  std::uint64_t last_stream_ = 0;
  std::uint64_t offset_ = 0;
  std::size_t part_ = 0;
  std::size_t part_offset_ = 0;
};

/// Queues one message.
void send(connection& to, const v1::ServerMessage& message);

}  // namespace tedit::gateway
