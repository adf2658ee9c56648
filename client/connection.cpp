// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/connection.hpp"

#include <algorithm>

#include "protocol/version.hpp"

namespace tedit::client {

namespace {

constexpr std::size_t max_queued = std::size_t{4} << 20;
constexpr std::chrono::milliseconds cancel_poll{20};
/// How long a cancelled request may take to end.
constexpr std::chrono::seconds cancel_patience{30};

tl::unexpected<error> too_slow(std::chrono::milliseconds limit) {
  return fail(ec::timeout,
              "the server gave no answer within " + std::to_string(limit.count()) + " ms");
}

}  // namespace

connection::connection(events handlers)
    : handlers_(std::move(handlers)),
      inbox_(handlers_,
             [this](std::uint64_t id, incoming_stream data) { bulk_came(id, std::move(data)); }),
      socket_({[this](std::string_view payload) { received(payload); },
               [this](const error& reason) { closed(reason); }}) {}

connection::~connection() {
  socket_.close();
}

expected<void> connection::start(const connect_options& options) {
  traceparent_ = options.traceparent;
  if (auto ok = socket_.connect(options.url, options.timeout, options.trust); !ok)
    return ok;
  return hello(options);
}

expected<void> connection::hello(const connect_options& options) {
  v1::ClientMessage request;
  auto* hello = request.mutable_hello();
  hello->set_protocol_major(protocol::major_version);
  hello->set_protocol_minor(protocol::minor_version);
  hello->set_client(options.client_name);
  hello->set_token(options.token);
  auto got = ask(std::move(request), v1::ServerMessage::kWelcome, options.timeout, {});
  if (!got)
    return fail(std::move(got.error()));
  const auto& welcome = got->message.welcome();
  if (welcome.max_message_bytes() != 0)
    max_message_ = welcome.max_message_bytes();
  server_ = welcome.server();
  access_ = {welcome.user(), welcome.role()};
  for (const auto& format : welcome.formats())
    formats_.push_back(from_message(format));
  return {};
}

// -- requests ------------------------------------------------------------------------

expected<connection::shared_pending> connection::add(std::uint64_t first, std::uint64_t last) {
  const std::lock_guard lock(mutex_);
  if (closed_)
    return fail(*closed_);
  auto request = std::make_shared<pending>();
  request->first = first;
  pending_[last] = request;
  return request;
}

void connection::remove(std::uint64_t id) {
  const std::lock_guard lock(mutex_);
  const auto found = pending_.lower_bound(id);
  if (found != pending_.end() && found->second->first <= id)
    pending_.erase(found);
}

expected<void> connection::send(const v1::ClientMessage& message) {
  std::string bytes;
  if (!message.SerializeToString(&bytes))
    return fail(ec::internal, "a request cannot be encoded");
  if (bytes.size() > max_message_)
    return fail(ec::invalid_argument, "the request has " + std::to_string(bytes.size()) +
                                        " bytes, the server takes " +
                                        std::to_string(max_message_.load()));
  if (socket_.send(std::move(bytes)))
    return {};
  const std::lock_guard lock(mutex_);
  return fail(closed_.value_or(error{
    ec::service_unavailable, "the connection to the server is closed", "Connect again.", {}}));
}

std::uint64_t connection::number(v1::ClientMessage& request) {
  const auto id = next_id_++;
  request.set_request_id(id);
  if (traceparent_)
    request.set_traceparent(traceparent_());
  return id;
}

void connection::send_cancel(std::uint64_t id) {
  v1::ClientMessage message;
  message.set_request_id(next_id_++);
  message.mutable_cancel()->set_request_id(id);
  (void)send(message);  // When it cannot be sent, the request fails by itself.
}

expected<connection::answer> connection::ask(v1::ClientMessage request,
                                             v1::ServerMessage::BodyCase wanted,
                                             std::chrono::milliseconds limit,
                                             const execution& run) {
  if (on_io_thread())
    return fail(ec::internal, "a blocking call from one of the client's own events");
  const auto id = number(request);
  auto entry = add(id, id);
  if (!entry)
    return fail(std::move(entry.error()));
  auto status = send(request);
  if (status)
    status = wait(id, **entry, limit, run);
  remove(id);
  if (!status) {
    inbox_.drop_bulk(id);
    return fail(std::move(status.error()));
  }
  answer& result = (*entry)->result;
  if (result.message.body_case() != wanted)
    return fail(ec::protocol_error, "the server gave an answer of the wrong kind (field " +
                                      std::to_string(result.message.body_case()) + ")");
  return std::move(result);
}

expected<void> connection::wait(std::uint64_t id, pending& request, std::chrono::milliseconds limit,
                                const execution& run) {
  auto deadline = clock::now() + limit;
  bool cancelling = false;
  double reported = 0;
  std::unique_lock lock(mutex_);
  while (!request.done) {
    const auto now = clock::now();
    if (now >= deadline) {
      lock.unlock();
      send_cancel(id);
      return cancelling ? fail(ec::cancelled, "cancelled, but the server did not confirm it")
                        : too_slow(limit);
    }
    if (!cancelling && run.cancel.cancelled()) {
      const auto& begun = request.result.message;
      if (begun.has_file_ready() || begun.has_edit_preview() || begun.has_version_surface())
        return fail(ec::cancelled, "the transfer was cancelled");
      cancelling = true;
      deadline = std::min(deadline, now + cancel_patience);
      lock.unlock();
      send_cancel(id);
      lock.lock();
    } else if (request.progressed) {
      report_progress(lock, request, run, reported);
    } else {
      changed_.wait_until(lock, std::min(deadline, now + cancel_poll));
    }
  }
  if (request.failure)
    return fail(*request.failure);
  return {};
}

void connection::report_progress(std::unique_lock<std::mutex>& lock, pending& request,
                                 const execution& run, double& reported) {
  request.progressed = false;
  reported = std::clamp(request.fraction, reported, 1.0);
  const std::string stage = request.stage;
  lock.unlock();
  run.report(reported, stage);
  lock.lock();
}

// -- messages without an answer --------------------------------------------------------

std::uint64_t connection::begin_unanswered(std::uint64_t count) {
  const auto first = next_id_.fetch_add(count);
  (void)add(first, first + count - 1);  // On a closed connection the sends fail.
  return first;
}

expected<void> connection::send_unanswered(std::uint64_t first, std::uint64_t id,
                                           v1::ClientMessage message,
                                           std::chrono::milliseconds limit, const execution& run) {
  if (on_io_thread())
    return fail(ec::internal, "a blocking call from one of the client's own events");
  const auto deadline = clock::now() + limit;
  do {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the upload was cancelled");
    if (const auto request = find(first)) {
      const std::lock_guard lock(mutex_);
      if (request->failure)
        return fail(*request->failure);
    }
    if (socket_.wait_queue(max_queued, cancel_poll)) {
      message.set_request_id(id);
      return send(message);
    }
  } while (clock::now() < deadline);
  return too_slow(limit);
}

std::optional<error> connection::end_unanswered(std::uint64_t first) {
  const auto request = find(first);
  remove(first);
  if (!request)
    return std::nullopt;
  const std::lock_guard lock(mutex_);
  return request->failure;
}

// -- the I/O thread --------------------------------------------------------------------

void connection::received(std::string_view payload) {
  v1::ServerMessage message;
  expected<void> status;
  if (!message.ParseFromArray(payload.data(), static_cast<int>(payload.size())))
    status = fail(ec::protocol_error, "the server sent " + std::to_string(payload.size()) +
                                        " bytes that are no message of the protocol");
  else
    status = dispatch(message, payload.size());
  if (!status)
    socket_.abort(std::move(status.error()));
}

expected<void> connection::dispatch(v1::ServerMessage& message, std::size_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    last_error_.reset();  // It explains the end of the connection only as the last word.
  }
  using body = v1::ServerMessage;
  switch (message.body_case()) {
    case body::kError:
      error_came(message.request_id(), message.error());
      return {};
    case body::kProgress:
      progress_came(message.request_id(), message.progress());
      return {};
    case body::kFileReady:
      return dispatch_bulk(message, message.file_ready().stream(), bytes);
    case body::kSectionReady:
      return dispatch_bulk(message, message.section_ready().stream(), bytes);
    case body::kVersionSurface:
      return dispatch_bulk(message, message.version_surface().surface().stream(), bytes);
    case body::kVersionsCompared:
      return dispatch_bulk(message, message.versions_compared().stream(), bytes);
    case body::kPrintChecked:
      return dispatch_bulk(message, message.print_checked().stream(), bytes);
    case body::kEditPreview:
      return dispatch_bulk(message, message.edit_preview().surface().stream(), bytes);
    case body::kCommitted:
      committed_came(message);
      return {};
    case body::kSolved:
      solved_came(message);
      return {};
    case body::kDocumentState:
      if (find(message.request_id()))
        inbox_.opened(message.document_state().document());
      answer_came(message);
      return {};
    case body::kSolveStatus:
    case body::kLoadCasesChanged:
    case body::kVersionAnnotated:
    case body::kCadStateChanged:
    case body::kParticipantChanged:
    case body::kBacklogNotice:
    case body::kDocumentRenamed:
    case body::kSurfaceUpdate:
    case body::kFieldUpdate:
    case body::kChunk:
      return dispatch_event(message, bytes);
    default:  // Other answers, and kinds that a newer server knows.
      answer_came(message);
      return {};
  }
}

expected<void> connection::dispatch_bulk(v1::ServerMessage& message, const v1::Stream& stream,
                                         std::size_t bytes) {
  const auto id = message.request_id();
  const auto request = find(id);
  if (request) {
    const std::lock_guard lock(mutex_);
    if (!request->done)
      request->result.message = message;  // Done with the last chunk.
  }
  return inbox_.take(stream, request ? id : 0, bytes);
}

expected<void> connection::dispatch_event(v1::ServerMessage& message, std::size_t bytes) {
  if (message.has_surface_update())
    return inbox_.take(message.surface_update(), bytes);
  if (message.has_field_update())
    return inbox_.take(message.field_update(), bytes);
  if (message.has_chunk())
    return inbox_.take(message.chunk(), bytes);
  if (message.has_load_cases_changed()) {
    const auto& what = message.load_cases_changed();
    if (handlers_.on_load_cases && inbox_.is_open(what.document()))
      handlers_.on_load_cases(from_message(what));
    return {};
  }
  if (message.has_version_annotated()) {
    const auto& what = message.version_annotated();
    if (handlers_.on_annotated && inbox_.is_open(what.document()))
      handlers_.on_annotated(from_message(what.version()));
    return {};
  }
  if (message.has_cad_state_changed()) {
    const auto& what = message.cad_state_changed();
    if (handlers_.on_cad && inbox_.is_open(what.document()))
      handlers_.on_cad(from_message(what.version()));
    return {};
  }
  if (message.has_participant_changed()) {
    const auto& what = message.participant_changed();
    if (handlers_.on_participant && inbox_.is_open(what.document()))
      handlers_.on_participant(from_message(what.participant()), what.gone());
    return {};
  }
  if (message.has_backlog_notice()) {
    const auto& what = message.backlog_notice();
    if (handlers_.on_backlog)
      handlers_.on_backlog({what.waiting_bytes(), what.most_bytes(), what.closes_after_s()});
    return {};
  }
  if (message.has_document_renamed()) {
    const auto& what = message.document_renamed();
    if (inbox_.renamed(what.before(), what.document()) && handlers_.on_renamed)
      handlers_.on_renamed(what.document());
    return {};
  }
  if (handlers_.on_solve_status && inbox_.is_open(message.solve_status().document()))
    handlers_.on_solve_status(from_message(message.solve_status()));
  return {};
}

/// The answer to a request tells of the new head as the event does that all others get.
void connection::committed_came(v1::ServerMessage& message) {
  const auto& what = message.committed();
  if (inbox_.is_open(what.document()) && !what.repeated()) {
    inbox_.head_moved(what.head().version_id());
    if (handlers_.on_committed)
      handlers_.on_committed(from_message(what));
  }
  if (message.request_id() != 0)
    answer_came(message);
}

void connection::solved_came(v1::ServerMessage& message) {
  if (handlers_.on_solved && inbox_.is_open(message.solved().document()))
    handlers_.on_solved(protocol::from_message(message.solved()));
  if (message.request_id() != 0)
    answer_came(message);
}

connection::shared_pending connection::find(std::uint64_t id) {
  const std::lock_guard lock(mutex_);
  const auto found = pending_.lower_bound(id);
  return found != pending_.end() && found->second->first <= id ? found->second : nullptr;
}

void connection::progress_came(std::uint64_t id, const v1::Progress& progress) {
  if (const auto request = find(id)) {
    {
      const std::lock_guard lock(mutex_);
      request->fraction = std::max(request->fraction, progress.fraction());
      request->stage = progress.stage();
      request->progressed = true;
    }
    changed_.notify_all();
  }
}

void connection::error_came(std::uint64_t id, const v1::Error& message) {
  if (const auto request = find(id)) {
    {
      const std::lock_guard lock(mutex_);
      if (!request->done)
        request->failure = from_message(message);
      request->done = true;
    }
    changed_.notify_all();
  } else if (id == 0) {
    const std::lock_guard lock(mutex_);
    last_error_ = from_message(message);
  }
}

void connection::answer_came(v1::ServerMessage& message) {
  if (const auto request = find(message.request_id())) {
    {
      const std::lock_guard lock(mutex_);
      if (!request->done)
        request->result.message = std::move(message);
      request->done = true;
    }
    changed_.notify_all();
  }
}

void connection::bulk_came(std::uint64_t id, incoming_stream data) {
  if (const auto request = find(id)) {
    {
      const std::lock_guard lock(mutex_);
      if (!request->done)
        request->result.bulk = std::move(data);
      request->done = true;
    }
    changed_.notify_all();
  }
}

void connection::closed(const error& reason) {
  error why = reason;
  {
    const std::lock_guard lock(mutex_);
    if (last_error_ && reason.code == ec::service_unavailable)
      why = *last_error_;
    closed_ = why;
    for (auto& [last, request] : pending_) {
      if (!request->done)
        request->failure = why;
      request->done = true;
    }
  }
  changed_.notify_all();
  inbox_.closed(why);
}

}  // namespace tedit::client
