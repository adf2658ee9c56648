// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/dial.hpp"

#include <atomic>
#include <cerrno>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "actors/links/bridge.hpp"
#include "actors/links/link.hpp"
#include "actors/links/tls_io.hpp"
#include "base/logging/logging.hpp"
#include "certs/make.hpp"

namespace tedit::actors {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// What is wrong with this node's certificate, in the eyes of the server.
error refused_by_server(refusal why, const std::string& where, const tls_context& own) {
  const std::string mine =
    "this node's certificate (" + own.own().name + ", serial " + own.own().serial + ")";
  switch (why) {
    case refusal::revoked:
      return {ec::invalid_argument,
              where + " says that " + mine + " was revoked",
              "Ask its operator for another: tedit certs issue",
              {}};
    case refusal::ended:
      return {ec::invalid_argument,
              where + " says that " + mine + " has ended or not begun",
              "Compare the clocks of both machines; renew it: tedit certs renew",
              {}};
    case refusal::other_authority:
      return {ec::invalid_argument,
              where + " has another authority than " + mine,
              "Take a certificate that the server's authority issued",
              {}};
    case refusal::wrong_role:
      return {
        ec::invalid_argument,
        where + " does not admit nodes of role " + std::string(certs::role_name(own.own().what)),
        "Check the address, or issue a certificate of a role that is admitted there",
        {}};
    default:
      return {ec::service_unavailable, where + " did not want this node", "Its log says why", {}};
  }
}

/// What is wrong with who answered.
error refused_server(refusal why, const std::string& where, const dial_options& options,
                     const tls_context& own) {
  switch (why) {
    case refusal::silent:
      return {ec::timeout,
              where + " took the connection and did not say who it is in time",
              "Check that it is the door of a TEdit server, and that it is not overloaded",
              {}};
    case refusal::other_authority:
      return {ec::invalid_argument,
              "the certificate of " + where + " is not of this node's authority, \"" +
                own.authority() + "\"",
              "Check the address; else take this node's certificate from the server's authority",
              {}};
    case refusal::ended:
      return {ec::invalid_argument,
              "the certificate of " + where + " has ended or not begun",
              "Compare the clocks of both machines; renew the server's: tedit certs renew",
              {}};
    case refusal::revoked:
      return {ec::invalid_argument,
              "the certificate of " + where + " was revoked",
              "Check the address, and ask the server's operator",
              {}};
    case refusal::wrong_role:
      return {ec::invalid_argument,
              "the certificate of " + where + " is not one of a server",
              "Check the address; a server's is issued with --role server",
              {}};
    case refusal::wrong_host:
      return {ec::invalid_argument,
              "the certificate of " + where + " does not hold for \"" + options.host + "\"",
              "Dial a name that it was issued for, or issue it with --host " + options.host,
              {}};
    default:
      return {
        ec::service_unavailable,
        where + " is no node of TEdit, or takes nobody more: " + std::string(refusal_text(why)),
        "Check host and port; the server's log says whom it turned away",
        {}};
  }
}

}  // namespace

struct dial::impl {
  impl(dial_options given, tls_identity own)
      : options(std::move(given)),
        identity(std::move(own)),
        where(options.host + ":" + std::to_string(options.port)),
        resolver(io),
        socket(io),
        limit(io),
        next_look(io),
        until(std::chrono::steady_clock::now() + options.limit) {}

  void begin();
  void connect_to(std::size_t place);
  void shake_hands();
  void shaken_hands(tl::expected<link_peer, tls_failure> result);
  void look_later();
  void answer(expected<void> result);
  void shut();

  asio::io_context io{1};  ///< First: it goes after all that is bound to it.
  dial_options options;
  tls_identity identity;
  std::string where;
  tcp::resolver resolver;
  tcp::socket socket;
  asio::steady_timer limit;
  asio::steady_timer next_look;
  std::chrono::steady_clock::time_point until;
  std::vector<tcp::endpoint> places;
  std::shared_ptr<bridge> line;
  link_peer server;
  unique_fd link;
  std::atomic<bool> connected{false};
  bool answered = false;
  std::promise<expected<void>> outcome;
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  std::thread thread;
};

void dial::impl::begin() {
  limit.expires_at(until);
  limit.async_wait([this](error_code stopped) {
    if (stopped)
      return;
    answer(fail(ec::timeout, where + " does not answer",
                "Check host and port, and whether a firewall stands between"));
    shut();
  });
  error_code problem;
  if (const auto ip = asio::ip::make_address(options.host, problem); !problem) {
    places = {tcp::endpoint(ip, options.port)};
    return connect_to(0);
  }
  resolver.async_resolve(
    options.host, std::to_string(options.port),
    [this](error_code failed, const tcp::resolver::results_type& found) {
      if (failed)
        return answer(fail(ec::service_unavailable,
                           "cannot find the host " + options.host + ": " + failed.message(),
                           "Check the name, or give its IP address"));
      for (const auto& one : found)
        places.push_back(one.endpoint());
      connect_to(0);
    });
}

void dial::impl::connect_to(std::size_t place) {
  if (answered)
    return;
  auto fresh = private_socket(places[place].protocol());
  error_code problem(fresh ? 0 : errno, boost::system::system_category());
  if (!problem) {
    socket.close(problem);
    socket.assign(places[place].protocol(), fresh.get(), problem);
  }
  if (problem)
    return answer(fail(ec::io_error, "cannot make a connection: " + problem.message(),
                       "Check how many files this process may open (ulimit -n)"));
  static_cast<void>(fresh.release());
  socket.async_connect(places[place], [this, place](error_code failed) {
    if (!failed)
      return shake_hands();
    if (place + 1 < places.size())
      return connect_to(place + 1);
    answer(fail(ec::service_unavailable, "cannot connect to " + where + ": " + failed.message(),
                "Check host and port, and that the server runs and has a door there"));
  });
}

void dial::impl::shake_hands() {
  limit.cancel();  // The bridge has the rest of the time.
  const auto left =
    std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
  line = bridge::shake_hands(
    std::move(socket), identity.context(), options.host, left,
    [this](tl::expected<link_peer, tls_failure> result) { shaken_hands(std::move(result)); });
}

void dial::impl::shaken_hands(tl::expected<link_peer, tls_failure> result) {
  if (!result) {
    const auto [why, by_peer] = result.error();
    const auto& own = *identity.context();
    return answer(fail(by_peer ? refused_by_server(why, where, own)
                               : refused_server(why, where, options, own)));
  }
  auto ends = make_link();
  if (!ends)
    return answer(fail(ends.error()));
  server = std::move(*result);
  link = std::move(ends->theirs);
  connected = true;
  line->carry(std::move(ends->ours), [this] {
    connected = false;
    next_look.cancel();
  });
  look_later();
  answer({});
}

void dial::impl::look_later() {
  next_look.expires_after(options.look_every);
  next_look.async_wait([this](error_code stopped) {
    if (stopped || !connected)
      return;
    if (const auto ok = identity.look(); !ok)
      logging::error("link: goes on with what it read before: {}", render(ok.error()));
    const bool revoked = identity.context()->has_revoked(server.serial);
    if (!revoked && server.valid_until > certs::now_s())
      return look_later();
    const auto why = revoked ? refusal::revoked : refusal::ended;
    logging::warn("link: {} ({}) is cut: {}", server.name, where, refusal_text(why));
    line->cut(why);
  });
}

void dial::impl::answer(expected<void> result) {
  if (!std::exchange(answered, true))
    outcome.set_value(std::move(result));
}

void dial::impl::shut() {
  answered = true;  // Nobody waits any more.
  error_code ignored;
  limit.cancel();
  next_look.cancel();
  resolver.cancel();
  socket.close(ignored);
  if (line)
    line->cut(refusal::gone);
}

dial::dial(std::unique_ptr<impl> state) : impl_(std::move(state)) {}

dial::~dial() {
  asio::post(impl_->io, [state = impl_.get()] { state->shut(); });
  impl_->work.reset();
  impl_->thread.join();
}

expected<std::unique_ptr<dial>> dial::connect(dial_options options, const cancel_token& stop) {
  auto identity = tls_identity::load(tls_side::dial, {certs::role::server}, options.identity);
  if (!identity)
    return fail(identity.error());
  std::unique_ptr<dial> made(
    new dial(std::make_unique<impl>(std::move(options), std::move(*identity))));
  auto& state = *made->impl_;
  auto outcome = state.outcome.get_future();
  asio::post(state.io, [&state] { state.begin(); });
  state.thread = std::thread([&state] { run_io(state.io); });
  while (outcome.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
    if (stop.cancelled())
      return fail(ec::cancelled, "connecting to " + state.where + " was cancelled");
  if (auto result = outcome.get(); !result)
    return fail(result.error());
  return made;
}

unique_fd dial::take_link() {
  return std::move(impl_->link);
}

const link_peer& dial::server() const {
  return impl_->server;
}

bool dial::connected() const {
  return impl_->connected;
}

}  // namespace tedit::actors
