// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/bulk.hpp"

#include <array>

#include "base/metrics.hpp"
#include "protocol/text_fields.hpp"

namespace tedit::gateway {

namespace {

constexpr std::size_t chunk_bytes = 256 * 1024;

/// Bytes that may wait in the connection; above its low-water mark, so that it reports back.
constexpr std::size_t ahead_bytes = 2 * 1024 * 1024;

constexpr std::size_t alignment = 8;

std::uint64_t bytes_of(const v1::ArrayInfo& array) {
  const auto value = [&]() -> std::uint64_t {
    switch (array.type()) {
      case v1::ArrayInfo::UINT8:
        return 1;
      case v1::ArrayInfo::UINT32:
      case v1::ArrayInfo::FLOAT32:
        return 4;
      default:
        return 8;
    }
  };
  return value() * array.components() * array.items();
}

/// Puts zeros before arrays that would not begin at a multiple of 8 bytes. Those of one stream are
/// one part, a file's pages are parts of a single array.
void align(bulk& data) {
  static constexpr std::array<std::byte, alignment> zeros{};
  if (data.stream->arrays_size() == 1)
    return data.stream->mutable_arrays(0)->set_offset(0);
  const auto whole = data.parts.empty() ? std::span<const std::byte>() : data.parts.front();
  data.parts.clear();
  std::uint64_t at = 0;
  std::size_t taken = 0;
  for (auto& array : *data.stream->mutable_arrays()) {
    const auto gap = (alignment - at % alignment) % alignment;
    const auto size = bytes_of(array);
    data.parts.push_back(std::span(zeros).first(gap));
    data.parts.push_back(whole.subspan(taken, size));
    array.set_offset(at + gap);
    at += gap + size;
    taken += size;
  }
  data.stream->set_bytes(at);
}

}  // namespace

/// All that goes out passes here. Names and error messages may come from files, in whatever
/// encoding; most languages refuse a whole message for one text that is no UTF-8.
void send(connection& to, const v1::ServerMessage& message) {
  static auto& messages = metrics::count_of("tedit_sent_messages_total", "Messages to clients.");
  static auto& total = metrics::count_of("tedit_sent_bytes_total", "Bytes of them.");
  std::string bytes;
  if (protocol::has_valid_text(message)) {
    bytes = message.SerializeAsString();
  } else {
    auto valid = message;
    protocol::make_text_valid(valid);
    bytes = valid.SerializeAsString();
  }
  messages.add();
  total.add(bytes.size());
  to.send(std::make_shared<const std::string>(std::move(bytes)));
}

void outbox::pump() {
  while (to_->queued_bytes() < ahead_bytes) {
    if (!current_ && !begin_next())
      return;
    send_chunk();
  }
}

std::uint64_t outbox::prepared() const {
  const auto rest = current_ ? current_->stream->bytes() - offset_ : 0;
  return held_ + rest + to_->queued_bytes();
}

bool outbox::begin_next() {
  while (!waiting_.empty()) {
    const auto next = std::move(waiting_.front());
    waiting_.pop_front();
    held_ -= next.holds;
    current_ = next.make();
    if (!current_)
      continue;
    current_->stream->set_stream(++last_stream_);
    align(*current_);
    offset_ = 0;
    part_ = 0;
    part_offset_ = 0;
    send(*to_, current_->header);
    if (current_->stream->bytes() > 0)
      return true;
    current_.reset();
  }
  return false;
}

void outbox::send_chunk() {
  v1::ServerMessage message;
  auto* chunk = message.mutable_chunk();
  chunk->set_stream(last_stream_);
  chunk->set_offset(offset_);
  auto* data = chunk->mutable_data();
  while (data->size() < chunk_bytes && part_ < current_->parts.size()) {
    const auto left = current_->parts[part_].subspan(part_offset_);
    const auto some = left.first(std::min(left.size(), chunk_bytes - data->size()));
    data->append(reinterpret_cast<const char*>(some.data()), some.size());
    part_offset_ += some.size();
    if (some.size() == left.size()) {
      ++part_;
      part_offset_ = 0;
    }
  }
  offset_ += data->size();
  const bool done = offset_ >= current_->stream->bytes();
  send(*to_, message);
  if (done)
    current_.reset();
}

}  // namespace tedit::gateway
