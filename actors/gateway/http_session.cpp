// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/hub.hpp"

#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>

#include "actors/gateway/origin.hpp"

namespace tedit::gateway {
namespace {

namespace websocket = beast::websocket;

class http_session : public std::enable_shared_from_this<http_session> {
public:
  http_session(std::shared_ptr<hub> owner, tcp_socket socket, std::unique_ptr<slot> place,
               bool refused)
      : hub_(std::move(owner)),
        stream_(std::move(socket)),
        slot_(std::move(place)),
        refused_(refused) {
    parser_.header_limit(static_cast<std::uint32_t>(hub_->options.limits.max_header));
  }

  void run() {
    slot_->end = [weak = weak_from_this()](ending) {
      if (const auto self = weak.lock())
        self->stream_.close();
    };
    stream_.expires_after(hub_->options.limits.handshake_timeout);
    http::async_read_header(
      stream_, buffer_, parser_,
      [self = shared_from_this()](error_code e, std::size_t) { self->on_header(e); });
  }

private:
  void on_header(error_code problem);
  bool trusted(const upgrade_request& r) const;
  page_request asked_by(const upgrade_request& r);
  void route(const upgrade_request& r);
  void respond(http::status status, std::string body, const char* type = "text/plain");
  void drain();

  std::shared_ptr<hub> hub_;
  tcp_stream stream_;
  std::unique_ptr<slot> slot_;
  bool refused_;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
};

void http_session::on_header(error_code problem) {
  if (problem == http::error::header_limit)
    return respond(http::status::request_header_fields_too_large, "The header is too large.\n");
  if (problem && problem.category() == make_error_code(http::error::bad_method).category() &&
      problem != http::error::end_of_stream && problem != http::error::partial_message)
    return respond(http::status::bad_request, "This is no HTTP request.\n");
  if (problem)
    return;  // Gone or too slow: nobody to answer.
  route(parser_.get());
}

/// A header that comes twice is two opinions: neither is trusted.
bool http_session::trusted(const upgrade_request& r) const {
  if (r.count(http::field::host) != 1 || r.count(http::field::origin) > 1)
    return false;
  const auto view = [&](http::field f) { return std::string_view(r[f].data(), r[f].size()); };
  std::optional<std::string_view> origin;
  if (r.count(http::field::origin) == 1)
    origin = view(http::field::origin);
  return host_allowed(view(http::field::host), hub_->port, hub_->hosts) &&
         origin_allowed(origin, hub_->port, hub_->options.allowed_origins);
}

page_request http_session::asked_by(const upgrade_request& r) {
  page_request result;
  error_code problem;
  const auto peer = stream_.socket().remote_endpoint(problem);
  result.local = !problem && peer.address().is_loopback();
  constexpr std::string_view scheme = "Bearer ";
  const auto given = r[http::field::authorization];
  const std::string_view text(given.data(), given.size());
  if (r.count(http::field::authorization) == 1 && text.starts_with(scheme))
    result.bearer = text.substr(scheme.size());
  return result;
}

void http_session::route(const upgrade_request& r) {
  if (refused_)
    return respond(http::status::service_unavailable,
                   "There are too many connections. Close some or try later.\n");
  if (!trusted(r))
    return respond(http::status::forbidden,
                   "This Host or Origin is not allowed here. Name it in the server's list of "
                   "allowed hosts or origins.\n");
  if (r.method() != http::verb::get && r.method() != http::verb::head)
    return respond(http::status::method_not_allowed, "Only GET and HEAD are understood.\n");
  const auto path = r.target().substr(0, r.target().find('?'));
  const auto page = hub_->options.pages.find(std::string(path.data(), path.size()));
  if (page != hub_->options.pages.end()) {
    auto made = page->second(asked_by(r));
    return respond(static_cast<http::status>(made.status), std::move(made.body), made.type.c_str());
  }
  if (path != "/v1")
    return respond(http::status::not_found, "There is nothing here. WebSocket is at /v1.\n");
  if (!websocket::is_upgrade(r))
    return respond(http::status::upgrade_required, "This path speaks WebSocket only.\n");
  if (buffer_.size() != 0)
    return respond(http::status::bad_request, "Data came before the handshake was done.\n");
  if (!hub_->stopping)
    serve_websocket(hub_, std::move(stream_), std::move(slot_), parser_.release());
}

void http_session::respond(http::status status, std::string body, const char* type) {
  response_.result(status);
  response_.version(11);
  response_.keep_alive(false);
  response_.set(http::field::server, "tedit");
  response_.set(http::field::content_type, type);
  response_.set(http::field::cache_control, "no-store");
  response_.set("X-Content-Type-Options", "nosniff");
  if (status == http::status::method_not_allowed)
    response_.set(http::field::allow, "GET, HEAD");
  if (status == http::status::upgrade_required)
    response_.set(http::field::upgrade, "websocket");
  response_.body() = std::move(body);
  response_.prepare_payload();
  if (parser_.get().method() == http::verb::head)
    response_.body().clear();
  // A page of many bytes takes its time on a slow line.
  stream_.expires_after(hub_->options.limits.handshake_timeout);
  http::async_write(stream_, response_, [self = shared_from_this()](error_code e, std::size_t) {
    if (e)
      return;
    self->stream_.expires_after(self->hub_->options.limits.close_timeout);
    error_code ignored;
    self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    self->drain();
  });
}

/// Reads until the client closes: closing over unread bytes would reset the connection and could
/// take the response away from the client.
void http_session::drain() {
  buffer_.clear();
  stream_.async_read_some(buffer_.prepare(4096),
                          [self = shared_from_this()](error_code e, std::size_t) {
                            if (!e)
                              self->drain();
                          });
}

}  // namespace

void serve_http(std::shared_ptr<hub> owner, tcp_socket socket, std::unique_ptr<slot> place,
                bool refused) {
  std::make_shared<http_session>(std::move(owner), std::move(socket), std::move(place), refused)
    ->run();
}

}  // namespace tedit::gateway
