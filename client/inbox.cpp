// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/inbox.hpp"

#include <algorithm>
#include <utility>

namespace tedit::client {

namespace {

constexpr std::size_t max_open_streams = 256;
constexpr std::size_t max_kept_surfaces = 256;
constexpr std::size_t max_kept_fields = 4;

tl::unexpected<error> too_late(const std::string& what, const std::string& version_id,
                               std::chrono::milliseconds patience) {
  return fail(ec::timeout, what + " of version " + version_id + " did not arrive within " +
                             std::to_string(patience.count()) + " ms");
}

}  // namespace

// -- streams -------------------------------------------------------------------------

expected<void> inbox::take(const v1::SurfaceUpdate& message, std::size_t message_bytes) {
  if (!is_open(message.document()))
    return begin(message.stream(), message_bytes, std::monostate{});
  return begin(message.stream(), message_bytes, message);
}

expected<void> inbox::take(const v1::FieldUpdate& message, std::size_t message_bytes) {
  if (!is_open(message.document()))
    return begin(message.stream(), message_bytes, std::monostate{});
  return begin(message.stream(), message_bytes, message);
}

expected<void> inbox::take(const v1::Stream& stream, std::uint64_t request,
                           std::size_t message_bytes) {
  if (request == 0)
    return begin(stream, message_bytes, std::monostate{});
  return begin(stream, message_bytes, bulk_answer{request});
}

expected<void> inbox::begin(const v1::Stream& stream, std::size_t message_bytes,
                            decltype(arrival::purpose) purpose) {
  auto data = incoming_stream::begin(from_message(stream), message_bytes);
  if (!data)
    return fail(std::move(data.error()));
  if (std::holds_alternative<std::monostate>(purpose))
    data->discard();
  const bool complete = data->complete();
  {
    const std::lock_guard lock(mutex_);
    if (streams_.size() >= max_open_streams)
      return fail(ec::protocol_error, "the server sends more than " +
                                        std::to_string(max_open_streams) + " streams at once");
    if (streams_.contains(stream.stream()))
      return fail(ec::protocol_error, "the server announces stream " +
                                        std::to_string(stream.stream()) + " before it is done");
    if (std::holds_alternative<v1::SurfaceUpdate>(purpose))
      surface_order_.push_back(stream.stream());
    streams_.emplace(stream.stream(), arrival{std::move(*data), std::move(purpose)});
  }
  return complete ? finish(stream.stream()) : expected<void>{};
}

expected<void> inbox::take(const v1::Chunk& message, std::size_t message_bytes) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = streams_.find(message.stream());
    if (found == streams_.end())
      return fail(ec::protocol_error, "the server sends a piece of stream " +
                                        std::to_string(message.stream()) +
                                        ", which it has not announced");
    auto& data = found->second.data;
    if (auto ok = data.append(message.offset(), message.data(), message_bytes); !ok)
      return ok;
    if (!data.complete())
      return {};
  }
  return finish(message.stream());
}

expected<void> inbox::finish(std::uint64_t stream) {
  std::unique_lock lock(mutex_);
  const auto found = streams_.find(stream);
  if (std::holds_alternative<v1::SurfaceUpdate>(found->second.purpose)) {
    lock.unlock();
    return finish_surfaces();
  }
  arrival done = std::move(found->second);
  streams_.erase(found);
  lock.unlock();
  if (std::holds_alternative<v1::FieldUpdate>(done.purpose))
    return finish_field(done);
  if (std::holds_alternative<bulk_answer>(done.purpose))
    return finish_bulk(std::move(done));
  return {};
}

/// Takes over all surfaces that are complete up to the first one that is not: differences build on
/// each other in the order of their announcements.
expected<void> inbox::finish_surfaces() {
  while (true) {
    std::unique_lock lock(mutex_);
    if (surface_order_.empty() || !streams_.at(surface_order_.front()).data.complete())
      return {};
    const arrival done = std::move(streams_.at(surface_order_.front()));
    streams_.erase(surface_order_.front());
    surface_order_.pop_front();
    const auto update = read_surface(std::get<v1::SurfaceUpdate>(done.purpose), done.data);
    if (!update)
      return fail(update.error());
    const auto event = apply(*update, done.data.moved());
    lock.unlock();
    changed_.notify_all();
    if (event && handlers_.on_surface)
      handlers_.on_surface(*event);
  }
}

/// With the mutex held: makes the update the current surface; nothing, and the reason is kept, when
/// it does not fit.
std::optional<surface_event> inbox::apply(const surface_update& update, const traffic& moved) {
  auto applied = surface_.apply(update);
  if (!applied) {
    surface_error_ = std::move(applied.error());
    return std::nullopt;
  }
  surface_error_.reset();
  current_ =
    surface_event{update.version_id, update.base_version_id.empty(), moved,
                  update.facets.size() + update.removed_facets.size(), update.vertices.size()};
  surfaces_in_.push_back(*current_);
  if (surfaces_in_.size() > max_kept_surfaces)
    surfaces_in_.pop_front();
  return current_;
}

expected<void> inbox::finish_field(const arrival& done) {
  auto field = read_field(std::get<v1::FieldUpdate>(done.purpose), done.data);
  if (!field)
    return fail(std::move(field.error()));
  const auto kept = std::make_shared<const field_event>(std::move(*field));
  {
    const std::lock_guard lock(mutex_);
    keep_field(kept);
  }
  changed_.notify_all();
  if (handlers_.on_field)
    handlers_.on_field(*kept);
  return {};
}

/// With the mutex held.
void inbox::keep_field(const shared_field& field) {
  if (field->interim())
    return;  // Who waits for a field waits for the converged one.
  // A newer solve may come before all of the last one have: those are never sent then.
  const bool next = !fields_begun_.empty() &&
                    fields_begun_.back()->version_id() == field->version_id() &&
                    fields_begun_.back()->remaining == field->remaining + 1;
  if (!next)
    fields_begun_.clear();
  fields_begun_.push_back(field);
  if (field->remaining > 0)
    return;
  fields_in_.push_back(std::exchange(fields_begun_, {}));
  if (fields_in_.size() > max_kept_fields)
    fields_in_.pop_front();
}

expected<void> inbox::finish_bulk(arrival done) {
  on_bulk_(std::get<bulk_answer>(done.purpose).request, std::move(done.data));
  return {};
}

// -- the document --------------------------------------------------------------------

bool inbox::is_open(const std::string& document) const {
  const std::lock_guard lock(mutex_);
  return document_.empty() || document_ == document;
}

bool inbox::renamed(const std::string& before, const std::string& document) {
  const std::lock_guard lock(mutex_);
  if (document_ != before)
    return false;
  document_ = document;
  return true;
}

std::string inbox::document() const {
  const std::lock_guard lock(mutex_);
  return document_;
}

void inbox::open(const std::string& document, const surface_model& held) {
  const std::lock_guard lock(mutex_);
  document_ = document;
  for (auto& [number, stream] : streams_)
    if (!std::holds_alternative<bulk_answer>(stream.purpose)) {
      stream.purpose = std::monostate{};
      stream.data.discard();
    }
  surface_order_.clear();
  surface_ = held;
  surface_error_.reset();
  surfaces_in_.clear();
  current_.reset();
  fields_begun_.clear();
  fields_in_.clear();
}

void inbox::opened(const std::string& document) {
  const std::lock_guard lock(mutex_);
  document_ = document;
  surface_error_.reset();  // From a difference to what was held before; the whole surface comes.
}

void inbox::head_moved(const std::string& version_id) {
  const std::lock_guard lock(mutex_);
  std::erase_if(fields_in_, [&](const auto& f) { return f.back()->version_id() == version_id; });
  if (!fields_begun_.empty() && fields_begun_.back()->version_id() == version_id)
    fields_begun_.clear();
  if (surface_.version_id() != version_id)
    std::erase_if(surfaces_in_, [&](const auto& e) { return e.version_id == version_id; });
}

void inbox::drop_bulk(std::uint64_t request) {
  const std::lock_guard lock(mutex_);
  for (auto& [number, stream] : streams_) {
    const auto* answer = std::get_if<bulk_answer>(&stream.purpose);
    if (!answer || answer->request != request)
      continue;
    stream.purpose = std::monostate{};
    stream.data.discard();
  }
}

void inbox::forget_fields() {
  const std::lock_guard lock(mutex_);
  fields_begun_.clear();
  fields_in_.clear();
}

void inbox::closed(const error& reason) {
  {
    const std::lock_guard lock(mutex_);
    closed_ = reason;
  }
  changed_.notify_all();
}

// -- waiting -------------------------------------------------------------------------

surface_model inbox::surface() const {
  const std::lock_guard lock(mutex_);
  return surface_;
}

/// The event of the version, or why it cannot come; nothing while it may come. An event that is no
/// longer the current one is handed out once: a version may become the head again.
std::optional<expected<surface_event>> inbox::find_surface(const std::string& version_id) {
  if (current_ && current_->version_id == version_id)
    return *current_;
  const auto found = std::find_if(surfaces_in_.begin(), surfaces_in_.end(),
                                  [&](const auto& e) { return e.version_id == version_id; });
  if (found != surfaces_in_.end()) {
    surface_event event = std::move(*found);
    surfaces_in_.erase(found);
    return event;
  }
  if (surface_error_)
    return fail(*surface_error_);
  if (closed_)
    return fail(*closed_);
  return std::nullopt;
}

expected<surface_event> inbox::wait_surface(const std::string& version_id,
                                            std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  std::optional<expected<surface_event>> found;
  changed_.wait_for(lock, patience, [&] {
    found = find_surface(version_id);
    return found.has_value();
  });
  if (!found)
    return too_late("the surface", version_id, patience);
  return std::move(*found);
}

expected<inbox::solved_fields> inbox::wait_fields(const std::string& version_id,
                                                  std::uint64_t solve,
                                                  std::chrono::milliseconds patience) {
  solved_fields found;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] {
    for (const auto& fields : fields_in_)
      if (fields.back()->version_id() == version_id &&
          (solve == 0 || fields.back()->solve == solve))
        found = fields;
    return !found.empty() || closed_;
  });
  if (found.empty() && closed_)
    return fail(*closed_);
  if (found.empty())
    return too_late("the fields", version_id, patience);
  return found;
}

}  // namespace tedit::client
