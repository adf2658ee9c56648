// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/hub.hpp"

#include <algorithm>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <exception>
#include <optional>

#include "base/text.hpp"

namespace tedit::gateway {
namespace {

namespace websocket = beast::websocket;

using steady = std::chrono::steady_clock;
using ws_stream = websocket::stream<net_stream, false>;  // false: no permessage-deflate

/// Messages go out in pieces of this size, so that progress shows and a ping gets in between.
constexpr std::size_t write_piece = std::size_t{256} << 10;
constexpr std::size_t read_piece = std::size_t{256} << 10;

/// A read buffer larger than this is given back after the message.
constexpr std::size_t kept_buffer = std::size_t{1} << 20;

constexpr std::size_t longest_reason = 123;

class ws_session final : public connection, public std::enable_shared_from_this<ws_session> {
public:
  ws_session(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
             upgrade_request request)
      : hub_(std::move(owner)),
        ws_(std::move(stream)),
        timer_(ws_.get_executor()),
        slot_(std::move(place)),
        request_(std::move(request)) {
    error_code ignored;
    peer_ = address_text(beast::get_lowest_layer(ws_).socket().remote_endpoint(ignored));
  }

  void send(frame bytes) override;
  std::size_t queued_bytes() const override { return queued_; }
  void authenticated() override;
  void handled(std::size_t bytes) override;
  void close(std::uint16_t code, std::string reason) override;
  std::string peer() const override { return peer_; }

  void run();

private:
  const transport_limits& limits() const { return hub_->options.limits; }
  template <class Work>
  void on_strand(Work work);
  template <class Call>
  void call_handler(Call call);
  void on_upgraded(error_code problem);
  void read();
  void read_on();
  void resume();
  void on_read(error_code problem);
  void deliver();
  void enqueue(frame bytes);
  void write_next();
  void on_written(error_code problem, std::size_t bytes, bool last);
  void check_drained();
  void watch();
  void on_tick();
  void check_life(steady::time_point now);
  void check_queue(steady::time_point now);
  void warn_of_backlog();
  void end(ending why);
  void begin_close(std::uint16_t code, const std::string& reason, bool drop_queue);
  void send_close();
  void drop_queue();
  void finish(const std::string& reason);
  std::string describe(error_code problem) const;

  std::shared_ptr<hub> hub_;
  ws_stream ws_;
  net::steady_timer timer_;
  std::unique_ptr<slot> slot_;
  upgrade_request request_;
  std::string peer_;
  std::unique_ptr<connection_handler> handler_;
  beast::flat_buffer buffer_;
  std::deque<frame> queue_;
  std::size_t sent_of_front_ = 0;
  std::size_t in_flight_ = 0;
  std::atomic<std::size_t> queued_{0};
  std::atomic<std::size_t> unhandled_{0};
  std::atomic<bool> done_{false};
  bool open_ = false;
  bool known_ = false;   ///< `authenticated` was called.
  bool paused_ = false;  ///< Nothing is read until more is `handled`.
  bool writing_ = false;
  bool pinging_ = false;
  bool above_low_water_ = false;
  bool closing_ = false;  ///< A close was asked for ...
  bool dropped_ = false;  ///< ... and what was queued does not go out any more ...
  bool close_sent_ = false;
  std::uint16_t close_code_ = 0;
  std::string close_reason_;
  steady::time_point opened_;
  steady::time_point last_life_;
  steady::time_point last_ping_;
  std::optional<steady::time_point> over_since_;  ///< When the queue went above `max_queue`.
  std::optional<steady::time_point> force_at_;    ///< When the socket is closed come what may.
};

void ws_session::send(frame bytes) {
  if (!bytes || done_)
    return;
  queued_ += bytes->size();
  on_strand([bytes = std::move(bytes)](ws_session& self) { self.enqueue(bytes); });
}

void ws_session::authenticated() {
  // Dispatched, not posted: from within `on_message` it holds before the next message is read.
  net::dispatch(ws_.get_executor(), [weak = weak_from_this()] {
    const auto self = weak.lock();
    if (!self || self->done_)
      return;
    if (!self->slot_->promote())
      return self->begin_close(1013, "there are too many connections", true);
    self->known_ = true;
    self->ws_.read_message_max(self->limits().max_message);
  });
}

void ws_session::close(std::uint16_t code, std::string reason) {
  on_strand([code, reason = std::move(reason)](ws_session& self) {
    self.begin_close(code, reason, false);
  });
}

/// The work holds the connection weakly: work posted after the I/O thread's end must not keep
/// connection and io_context alive in a circle.
template <class Work>
void ws_session::on_strand(Work work) {
  net::post(ws_.get_executor(), [weak = weak_from_this(), work = std::move(work)] {
    if (const auto self = weak.lock())
      work(*self);
  });
}

template <class Call>
void ws_session::call_handler(Call call) {
  if (!handler_)
    return;
  try {
    call(*handler_);
  } catch (const std::exception&) {
    begin_close(1011, "internal error", true);
  }
}

void ws_session::run() {
  slot_->end = [weak = weak_from_this()](ending why) {
    if (const auto self = weak.lock())
      self->on_strand([why](ws_session& s) { s.end(why); });
  };
  beast::get_lowest_layer(ws_).expires_never();
  // The rules after the handshake are kept by `on_tick`.
  const auto none = websocket::stream_base::none();
  ws_.set_option(websocket::stream_base::timeout{limits().handshake_timeout, none, false});
  ws_.set_option(websocket::stream_base::decorator(
    [](websocket::response_type& r) { r.set(http::field::server, "tedit"); }));
  ws_.auto_fragment(false);
  ws_.binary(true);
  ws_.read_message_max(limits().max_first_message);
  ws_.control_callback(
    [this](websocket::frame_type, beast::string_view) { last_life_ = steady::now(); });
  ws_.async_accept(request_, [self = shared_from_this()](error_code e) { self->on_upgraded(e); });
}

void ws_session::on_upgraded(error_code problem) {
  if (done_)
    return;
  if (problem)
    return finish(problem.message());
  const auto none = websocket::stream_base::none();
  ws_.set_option(websocket::stream_base::timeout{none, none, false});
  open_ = true;
  ++hub_->open_websockets;
  opened_ = last_life_ = last_ping_ = steady::now();
  try {
    handler_ = hub_->options.accept(shared_from_this());
  } catch (const std::exception&) {
    handler_.reset();
  }
  if (!handler_)
    begin_close(1013, "the server takes no connections now", true);
  watch();
  if (!close_sent_)
    read();
}

// -- reading

void ws_session::read() {
  ws_.async_read_some(buffer_, read_piece,
                      [self = shared_from_this()](error_code e, std::size_t) { self->on_read(e); });
}

void ws_session::on_read(error_code problem) {
  if (done_)
    return;
  if (problem)
    return finish(describe(problem));
  last_life_ = steady::now();
  if (ws_.got_text())
    begin_close(1003, "only binary messages are understood", true);
  if (closing_)
    buffer_.consume(buffer_.size());
  else if (ws_.is_message_done())
    deliver();
  if (!close_sent_ && !done_)
    read_on();
}

void ws_session::read_on() {
  paused_ = unhandled_ > limits().max_unhandled;
  if (!paused_)
    read();
}

/// Posted work comes after a `read_on` that saw the old count, so that none waits for ever.
void ws_session::handled(std::size_t bytes) {
  const auto before = unhandled_.fetch_sub(bytes);
  const auto most = limits().max_unhandled;
  if (before > most && before - bytes <= most)
    on_strand([](ws_session& self) { self.resume(); });
}

void ws_session::resume() {
  if (paused_ && !close_sent_ && !done_)
    read_on();
}

void ws_session::deliver() {
  const auto data = buffer_.cdata();
  std::string bytes(static_cast<const char*>(data.data()), data.size());
  buffer_.consume(buffer_.size());
  if (buffer_.capacity() > kept_buffer)
    buffer_.shrink_to_fit();
  unhandled_ += bytes.size();
  call_handler([&](connection_handler& h) { h.on_message(std::move(bytes)); });
}

// -- writing

void ws_session::enqueue(frame bytes) {
  if (done_ || closing_) {
    queued_ -= bytes->size();
    return;
  }
  queue_.push_back(std::move(bytes));
  above_low_water_ = above_low_water_ || queued_ >= limits().low_water;
  check_queue(steady::now());
  write_next();
}

void ws_session::write_next() {
  if (writing_ || close_sent_)
    return;
  if (queue_.empty()) {
    if (closing_)
      send_close();
    return;
  }
  const frame& front = queue_.front();
  in_flight_ = std::min(write_piece, front->size() - sent_of_front_);
  const bool last = sent_of_front_ + in_flight_ == front->size();
  writing_ = true;
  ws_.async_write_some(last, net::buffer(front->data() + sent_of_front_, in_flight_),
                       [self = shared_from_this(), keep = front, n = in_flight_, last](
                         error_code e, std::size_t) { self->on_written(e, n, last); });
}

void ws_session::on_written(error_code problem, std::size_t bytes, bool last) {
  writing_ = false;
  in_flight_ = 0;
  queued_ -= bytes;
  if (!queue_.empty()) {  // Else it was dropped meanwhile.
    sent_of_front_ = last ? 0 : sent_of_front_ + bytes;
    if (last)
      queue_.pop_front();
  }
  if (done_)
    return;
  if (problem) {
    // When Beast closes by itself it stops writes; the read then ends the connection.
    if (ws_.is_open())
      finish(describe(problem));
    return;
  }
  const auto now = steady::now();
  last_life_ = now;
  if (closing_ && !dropped_)
    force_at_ = now + limits().slow_client;
  check_queue(now);
  write_next();
  check_drained();
}

void ws_session::check_drained() {
  if (!above_low_water_ || closing_ || queued_ >= limits().low_water)
    return;
  above_low_water_ = false;
  call_handler([](connection_handler& h) { h.on_drained(); });
}

// -- time

void ws_session::watch() {
  if (done_)
    return;
  using std::chrono::milliseconds;
  const auto& l = limits();
  // Who idles costs a wake-up a second.
  const bool calm = known_ && !closing_ && !force_at_ && !over_since_;
  const auto shortest = calm ? std::min({l.slow_client, l.ping_after, l.idle_timeout})
                             : std::min({l.hello_timeout, l.slow_client, l.close_timeout});
  timer_.expires_after(std::clamp(shortest / 4, milliseconds(5), milliseconds(calm ? 1000 : 250)));
  timer_.async_wait([self = shared_from_this()](error_code problem) {
    if (problem != net::error::operation_aborted)
      self->on_tick();
  });
}

void ws_session::on_tick() {
  if (done_)
    return;
  const auto now = steady::now();
  if (paused_)
    last_life_ = now;  // It is we who do not listen.
  // Beast answers a close or a broken rule of the client's by itself, but waits for ever.
  if (!force_at_ && !ws_.is_open())
    force_at_ = now + limits().close_timeout;
  if (force_at_ && now >= *force_at_)
    return finish("the client did not answer a close");
  if (now - last_life_ >= limits().idle_timeout)
    return finish("the client gave no sign of life");
  if (!known_ && now - opened_ >= limits().hello_timeout)
    begin_close(1008, "no valid hello in time", true);
  check_queue(now);
  check_life(now);
  watch();
}

void ws_session::check_life(steady::time_point now) {
  const auto wait = limits().ping_after;
  if (pinging_ || closing_ || now - last_life_ < wait || now - last_ping_ < wait)
    return;
  pinging_ = true;
  last_ping_ = now;
  ws_.async_ping({}, [self = shared_from_this()](error_code) { self->pinging_ = false; });
}

void ws_session::check_queue(steady::time_point now) {
  if (queued_ <= limits().max_queue)
    over_since_.reset();
  else if (!over_since_) {
    over_since_ = now;
    warn_of_backlog();
  } else if (now - *over_since_ > limits().slow_client)
    begin_close(1013, "the client reads too slowly", true);
}

/// Behind the message of which a piece may be out already.
void ws_session::warn_of_backlog() {
  if (closing_)
    return;
  frame notice;
  call_handler([&](connection_handler& h) {
    notice = h.on_backlog(queued_, limits().max_queue, limits().slow_client);
  });
  if (!notice || closing_)
    return;
  queued_ += notice->size();
  const bool begun = !queue_.empty() && (writing_ || sent_of_front_ > 0);
  queue_.insert(queue_.begin() + (begun ? 1 : 0), std::move(notice));
}

// -- the end

/// Who gives way is not waited for: its place is taken already.
void ws_session::end(ending why) {
  if (why == ending::gives_way)
    return finish("gave way to another connection before it said hello");
  begin_close(1001, "the server stops", true);
}

void ws_session::begin_close(std::uint16_t code, const std::string& reason, bool drop) {
  if (done_ || dropped_ || (closing_ && !drop))
    return;
  if (!open_)
    return finish("stopped during the handshake");
  closing_ = true;
  if (!close_sent_) {
    close_code_ = code;
    // Half a character in a close frame is a protocol error.
    close_reason_ = cut_text(to_utf8(reason), longest_reason);
  }
  if (drop) {
    dropped_ = true;
    drop_queue();
  }
  force_at_ = steady::now() + (drop ? limits().close_timeout : limits().slow_client);
  watch();
  write_next();
}

void ws_session::send_close() {
  close_sent_ = true;
  force_at_ = steady::now() + limits().close_timeout;
  websocket::close_reason reason;
  reason.code = close_code_;
  reason.reason = close_reason_;
  ws_.async_close(reason, [self = shared_from_this()](error_code) { self->finish(""); });
}

/// All but the piece that is being written, which `on_written` takes off.
void ws_session::drop_queue() {
  std::size_t bytes = 0;
  for (const frame& f : queue_)
    bytes += f->size();
  if (!queue_.empty())
    bytes -= sent_of_front_ + in_flight_;
  queued_ -= bytes;
  queue_.clear();
  sent_of_front_ = 0;
}

void ws_session::finish(const std::string& reason) {
  if (done_.exchange(true))
    return;
  timer_.cancel();
  drop_queue();
  beast::get_lowest_layer(ws_).close();
  slot_.reset();
  if (open_)
    --hub_->open_websockets;
  const std::unique_ptr<connection_handler> handler = std::move(handler_);
  if (!handler)
    return;
  try {
    handler->on_closed(closing_ ? std::to_string(close_code_) + " " + close_reason_ : reason);
  } catch (const std::exception&) {
    // Nothing is left to close.
  }
}

std::string ws_session::describe(error_code problem) const {
  if (problem == websocket::error::message_too_big)
    return "1009 a message is larger than " +
           std::to_string((known_ ? limits().max_message : limits().max_first_message)) + " bytes";
  if (problem != websocket::error::closed)
    return "the connection broke: " + problem.message();
  const auto& why = ws_.reason();
  return "the client closed it with " + std::to_string(why.code) + " " +
         std::string(why.reason.data(), why.reason.size());
}

}  // namespace

void serve_websocket(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
                     upgrade_request request) {
  std::make_shared<ws_session>(std::move(owner), std::move(stream), std::move(place),
                               std::move(request))
    ->run();
}

}  // namespace tedit::gateway
