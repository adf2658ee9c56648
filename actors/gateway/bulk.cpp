// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/bulk.hpp"

namespace tedit::gateway {

namespace {

constexpr std::size_t chunk_bytes = 256 * 1024;

/// Bytes that may wait in the connection; above its low-water mark, so that it reports back.
constexpr std::size_t ahead_bytes = 2 * 1024 * 1024;

}  // namespace

void send(connection& to, const v1::ServerMessage& message) {
  to.send(std::make_shared<const std::string>(message.SerializeAsString()));
}

void outbox::pump() {
  while (to_->queued_bytes() < ahead_bytes) {
    if (!current_ && !begin_next())
      return;
    send_chunk();
  }
}

bool outbox::begin_next() {
  while (!waiting_.empty()) {
    const auto make = std::move(waiting_.front());
    waiting_.pop_front();
    current_ = make();
    if (!current_)
      continue;
    current_->stream->set_stream(++last_stream_);
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
