// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/hub.hpp"

#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>

#include <openssl/err.h>
#include <openssl/ssl.h>

#include "actors/gateway/origin.hpp"
#include "base/metrics.hpp"

namespace tedit::gateway {
namespace {

namespace websocket = beast::websocket;

class http_session : public std::enable_shared_from_this<http_session> {
public:
  http_session(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
               bool refused)
      : hub_(std::move(owner)),
        stream_(std::move(stream)),
        slot_(std::move(place)),
        refused_(refused) {
    parser_.header_limit(static_cast<std::uint32_t>(hub_->options.limits.max_header));
  }

  void run() {
    slot_->end = [weak = weak_from_this()](ending) {
      if (const auto self = weak.lock())
        self->line().close();
    };
    line().expires_after(hub_->options.limits.handshake_timeout);
    if (stream_.tls() == nullptr)
      return read_header();
    stream_.async_handshake(net::ssl::stream_base::server,
                            [self = shared_from_this()](error_code e) { self->on_shaken(e); });
  }

private:
  [[nodiscard]] tcp_stream& line() { return stream_.next_layer(); }
  void on_shaken(error_code problem);
  void read_header();
  void on_header(error_code problem);
  bool trusted(const upgrade_request& r) const;
  page_request asked_by(const upgrade_request& r);
  void route(const upgrade_request& r);
  void respond(http::status status, std::string body, const char* type = "text/plain");
  void end_sending();
  void drain();

  std::shared_ptr<hub> hub_;
  net_stream stream_;
  std::unique_ptr<slot> slot_;
  bool refused_;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
};

/// What a failed handshake is counted as. Many words would let strangers fill the memory.
const char* refusal_of(error_code problem) {
  if (problem.category() != net::error::get_ssl_category())
    return problem == beast::error::timeout ? "silent" : "gone";
  switch (ERR_GET_REASON(static_cast<unsigned>(problem.value()))) {
    case SSL_R_UNSUPPORTED_PROTOCOL:
    case SSL_R_VERSION_TOO_LOW:
      return "old_tls";
    case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN:
    case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
      return "not_trusted";
    default:
      return "not_tls";
  }
}

void http_session::on_shaken(error_code problem) {
  if (!problem)
    return read_header();
  const bool tls = problem.category() == net::error::get_ssl_category();
  metrics::count_of("tedit_tls_refused_total", "TLS handshakes of clients that failed.",
                    {{"reason", refusal_of(problem)}})
    .add();
  if (!tls || ERR_GET_REASON(static_cast<unsigned>(problem.value())) != SSL_R_HTTP_REQUEST)
    return;
  stream_.give_up_tls();  // It speaks HTTP where TLS is spoken: so it is answered.
  respond(http::status::bad_request, "This port speaks TLS: use wss:// or https://.\n");
}

void http_session::read_header() {
  http::async_read_header(
    stream_, buffer_, parser_,
    [self = shared_from_this()](error_code e, std::size_t) { self->on_header(e); });
}

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
  const auto host = view(http::field::host);
  const bool known = host_allowed(host, hub_->port, hub_->hosts) ||
                     (hub_->identity && host_allowed(host, hub_->port, hub_->identity->hosts()));
  return known && origin_allowed(origin, hub_->port, hub_->options.allowed_origins);
}

page_request http_session::asked_by(const upgrade_request& r) {
  page_request result;
  error_code problem;
  const auto peer = line().socket().remote_endpoint(problem);
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
  line().expires_after(hub_->options.limits.handshake_timeout);
  if (status >= http::status::bad_request)
    metrics::count_of("tedit_http_refused_total", "HTTP requests that were refused, by status.",
                      {{"status", std::to_string(response_.result_int())}})
      .add();
  http::async_write(stream_, response_, [self = shared_from_this()](error_code e, std::size_t) {
    if (!e)
      self->end_sending();
  });
}

/// By TLS's own end, too: without it the other side could not tell that nothing was cut off.
void http_session::end_sending() {
  line().expires_after(hub_->options.limits.close_timeout);
  const auto then = [self = shared_from_this()](error_code) {
    error_code ignored;
    self->line().socket().shutdown(tcp::socket::shutdown_send, ignored);
    self->drain();
  };
  if (stream_.tls() != nullptr)
    stream_.async_shutdown(then);
  else
    then({});
}

/// Reads until the client closes: closing over unread bytes would reset the connection and could
/// take the response away from the client.
void http_session::drain() {
  buffer_.clear();
  line().async_read_some(buffer_.prepare(4096),
                         [self = shared_from_this()](error_code e, std::size_t) {
                           if (!e)
                             self->drain();
                         });
}

}  // namespace

void serve_http(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
                bool refused) {
  std::make_shared<http_session>(std::move(owner), std::move(stream), std::move(place), refused)
    ->run();
}

}  // namespace tedit::gateway
