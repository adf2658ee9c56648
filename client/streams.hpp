// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "client/types.hpp"

namespace tedit::client {

/// The numbers of `tedit.v1.ArrayInfo.Type`.
enum class array_type { unspecified = 0, u8 = 1, u32 = 2, i64 = 3, f32 = 4, f64 = 5 };

/// One array of a stream (message `tedit.v1.ArrayInfo`).
struct stream_array {
  std::string name;
  array_type type = array_type::unspecified;
  std::uint32_t components = 1;  ///< Values per item.
  std::uint64_t items = 0;
  /// Where it begins in the stream, bytes; when it is not said (older servers) where the one before
  /// ends.
  std::optional<std::uint64_t> offset;
};

/// What a server announces (message `tedit.v1.Stream`).
struct stream_header {
  std::uint64_t stream = 0;
  std::uint64_t bytes = 0;
  std::vector<stream_array> arrays;
};

/// The largest stream that is received, bytes.
inline constexpr std::uint64_t max_stream_bytes = std::uint64_t{4} << 30;

/// Bulk data on its way in: filled by chunks, then read as arrays. Not thread-safe.
class incoming_stream {
public:
  /// `message_bytes`: the WebSocket payload of the message that announced the stream.
  /// Errors: `protocol_error` when the sizes do not add up, arrays overlap, one is of no known type
  /// or the stream is larger than `max_stream_bytes`.
  [[nodiscard]] static expected<incoming_stream> begin(stream_header header,
                                                       std::size_t message_bytes);

  /// Takes the next piece. Errors: `protocol_error` when it is not the next one or too long.
  [[nodiscard]] expected<void> append(std::uint64_t offset, std::string_view data,
                                      std::size_t message_bytes);

  [[nodiscard]] bool complete() const noexcept { return received_ == header_.bytes; }

  /// Throws the data away, those to come too; the pieces are still checked.
  void discard();

  /// What was received up to now.
  [[nodiscard]] const traffic& moved() const noexcept { return moved_; }

  // -- arrays of a complete stream; one that was not announced is empty -------------------
  // Errors: `protocol_error` when the array has another type or number of components.

  [[nodiscard]] expected<std::vector<std::uint32_t>> u32(std::string_view name,
                                                         std::uint32_t components) const;
  [[nodiscard]] expected<std::vector<std::int64_t>> i64(std::string_view name,
                                                        std::uint32_t components) const;
  [[nodiscard]] expected<std::vector<float>> f32(std::string_view name,
                                                 std::uint32_t components) const;
  [[nodiscard]] expected<std::vector<double>> f64(std::string_view name,
                                                  std::uint32_t components) const;
  [[nodiscard]] expected<std::vector<char>> bytes(std::string_view name) const;

private:
  template <class T>
  [[nodiscard]] expected<std::vector<T>> read(std::string_view name, array_type type,
                                              std::uint32_t components) const;

  stream_header header_;
  std::vector<char> data_;
  std::uint64_t received_ = 0;
  bool discarded_ = false;
  traffic moved_;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace tedit::client
