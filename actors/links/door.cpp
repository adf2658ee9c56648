// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/door.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "actors/links/bridge.hpp"
#include "actors/links/link.hpp"
#include "actors/links/tls_io.hpp"
#include "base/logging/logging.hpp"
#include "base/utc.hpp"
#include "certs/make.hpp"

namespace tedit::actors {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Taken in one turn, so that those who are linked have theirs.
constexpr int guests_in_a_turn = 32;

/// Why there is no descriptor for the next guest; trying at once would only burn a core.
constexpr auto until_retry = std::chrono::milliseconds(100);

expected<void> listen_on(tcp::acceptor& listener, const tcp::endpoint& where) {
  auto socket = private_socket(where.protocol());
  error_code problem(socket ? 0 : errno, boost::system::system_category());
  if (!problem)
    listener.assign(where.protocol(), socket.get(), problem);
  if (!problem) {
    static_cast<void>(socket.release());
    listener.set_option(asio::socket_base::reuse_address(true), problem);
  }
  if (!problem)
    listener.bind(where, problem);
  if (!problem)
    listener.listen(asio::socket_base::max_listen_connections, problem);
  if (!problem)
    listener.native_non_blocking(true, problem);
  if (problem)
    return fail(ec::service_unavailable,
                "cannot listen on " + address_text(where) + ": " + problem.message(),
                "End the program that uses the port, or choose another address or port");
  return {};
}

}  // namespace

struct door::impl {
  /// Who has not said who it is.
  struct stranger {
    std::shared_ptr<bridge> line;
    std::string address;  ///< Without the port.
  };
  struct linked {
    std::shared_ptr<bridge> line;
    link_peer who;
  };

  impl(door_options given, tls_identity own)
      : options(std::move(given)),
        identity(std::move(own)),
        knocks(options.knocks),
        listener(io),
        retry(io),
        next_look(io) {}

  void wait_for_guests();
  void take_guests();
  void greet(tcp::socket socket);
  void note_knock(const std::string& owner, const tl::expected<link_peer, tls_failure>& result);
  void make_room();
  void shaken_hands(std::uint64_t number, tl::expected<link_peer, tls_failure> result);
  void make_link_of(std::uint64_t number, const std::shared_ptr<bridge>& line, link_peer who);
  void ended(std::uint64_t number);
  void turn_away(refusal why, const std::string& who);
  void look_at_files();
  void look_at_list();
  void look_later();
  void look_at_links();
  void shut();

  asio::io_context io{1};  ///< First: it goes after all that is bound to it.
  door_options options;
  tls_identity identity;
  knock_limits knocks;
  tcp::acceptor listener;
  asio::steady_timer retry;
  asio::steady_timer next_look;
  bool stopping = false;
  std::uint64_t last_number = 0;
  std::map<std::uint64_t, stranger> strangers;  ///< By number: the oldest is first.
  mutable std::mutex mutex;                     ///< Of `links`, where another thread could look.
  std::map<std::uint64_t, linked> links;
  std::array<std::atomic<std::uint64_t>, refusal_count> refused{};
  std::chrono::steady_clock::time_point next_line{};
  std::uint64_t unlogged = 0;
  std::int64_t said_overdue = 0;  ///< When the list was last called overdue, seconds since 1970.
  std::uint16_t port = 0;
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  std::thread thread;
};

// -- guests --------------------------------------------------------------------------------------

void door::impl::wait_for_guests() {
  listener.async_wait(tcp::acceptor::wait_read, [this](error_code problem) {
    if (!stopping && !problem)
      take_guests();
  });
}

void door::impl::take_guests() {
  for (int i = 0; i < guests_in_a_turn; ++i) {
    unique_fd guest(
      ::accept4(listener.native_handle(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!guest && (errno == EINTR || errno == ECONNABORTED))
      continue;
    if (!guest && errno != EAGAIN && errno != EWOULDBLOCK) {
      retry.expires_after(until_retry);
      retry.async_wait([this](error_code stopped) {
        if (!stopped && !stopping)
          take_guests();
      });
      return;
    }
    if (!guest)
      break;
    error_code problem;
    tcp::socket socket(io);
    socket.assign(listener.local_endpoint(problem).protocol(), guest.get(), problem);
    if (problem)
      continue;
    static_cast<void>(guest.release());
    greet(std::move(socket));
  }
  wait_for_guests();
}

void door::impl::greet(tcp::socket socket) {
  error_code gone;
  const auto peer = socket.remote_endpoint(gone);
  if (gone)
    return turn_away(refusal::gone, "somebody");
  if (links.size() >= options.most_links)
    return turn_away(refusal::full, address_text(peer));
  const auto owner = owner_part(peer.address().to_string());
  if (!knocks.admits(owner, std::chrono::steady_clock::now()))
    return turn_away(refusal::too_often, address_text(peer));
  look_at_files();  // A certificate that was revoked a moment ago is refused now.
  const auto number = ++last_number;
  strangers[number] = {nullptr, peer.address().to_string()};
  auto line = bridge::shake_hands(
    std::move(socket), identity.context(), {}, options.handshake_limit,
    [this, number, owner, from = address_text(peer)](tl::expected<link_peer, tls_failure> result) {
      note_knock(owner, result);
      if (!result)
        turn_away(result.error().by_peer ? refusal::refused_us : result.error().why, from);
      shaken_hands(number, std::move(result));
    });
  if (const auto own = strangers.find(number); own != strangers.end())
    own->second.line = std::move(line);
  make_room();
}

void door::impl::note_knock(const std::string& owner,
                            const tl::expected<link_peer, tls_failure>& result) {
  const auto now = std::chrono::steady_clock::now();
  if (result)
    return knocks.came_in(owner, now);
  const auto why = result.error().why;
  if (why != refusal::gone && why != refusal::silent && why != refusal::crowded)
    knocks.failed(owner, now);
}

void door::impl::make_room() {
  std::map<std::string, std::size_t> count;
  for (const auto& [number, one] : strangers)
    ++count[one.address];
  const auto by_count = [](const auto& a, const auto& b) { return a.second < b.second; };
  while (!strangers.empty()) {
    const auto most = std::ranges::max_element(count, by_count);
    if (strangers.size() <= options.most_handshakes &&
        most->second <= options.most_handshakes_per_address)
      return;
    const auto oldest = std::ranges::find_if(
      strangers, [&](const auto& one) { return one.second.address == most->first; });
    --most->second;
    // Its callback takes it out of the list.
    const auto line = oldest->second.line;
    line->cut(refusal::crowded);
  }
}

void door::impl::shaken_hands(std::uint64_t number, tl::expected<link_peer, tls_failure> result) {
  const auto known = strangers.extract(number);
  if (!result || known.empty() || stopping)
    return;
  if (links.size() < options.most_links)
    return make_link_of(number, known.mapped().line, std::move(*result));
  turn_away(refusal::full, result->address);
  known.mapped().line->cut(refusal::full);
}

void door::impl::make_link_of(std::uint64_t number, const std::shared_ptr<bridge>& line,
                              link_peer who) {
  auto ends = make_link();
  if (!ends) {
    logging::error("door: {} ({}): {}", who.name, who.address, render(ends.error()));
    return line->cut(refusal::full);
  }
  logging::info("door: {} is linked, {}, {}, serial {}", who.name, certs::role_name(who.what),
                who.address, who.serial);
  {
    const std::lock_guard lock(mutex);
    links[number] = {line, who};
  }
  line->carry(std::move(ends->ours), [this, number] { ended(number); });
  options.accept(std::move(ends->theirs), std::move(who));
}

void door::impl::ended(std::uint64_t number) {
  const std::lock_guard lock(mutex);
  const auto known = links.extract(number);
  if (!known.empty() && !stopping)
    logging::info("door: the link of {} ({}) has ended", known.mapped().who.name,
                  known.mapped().who.address);
}

void door::impl::turn_away(refusal why, const std::string& who) {
  if (stopping)
    return;
  ++refused[static_cast<std::size_t>(why)];
  ++unlogged;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_line)
    return;  // A flood must not fill the disk.
  logging::warn("door: {} was turned away: {}; {} since the last such line", who, refusal_text(why),
                std::exchange(unlogged, 0));
  next_line = now + std::chrono::seconds(1);
}

// -- looks ---------------------------------------------------------------------------------------

void door::impl::look_at_files() {
  if (const auto ok = identity.look(); !ok)
    logging::error("door: goes on with what it read before: {}", render(ok.error()));
}

/// A list that is overdue goes on holding: a server must not stop because nobody wrote it again. It
/// is said once a day.
void door::impl::look_at_list() {
  const auto& list = identity.context()->list();
  const auto now = certs::now_s();
  if (!list || !list->is_overdue(now) || now - said_overdue < certs::day.count())
    return;
  said_overdue = now;
  logging::warn(
    "door: the list of revoked certificates (number {}, of {}) should have been followed by a "
    "newer one at {}; who was revoked since is still let in. Copy the newest crl.pem of the "
    "authority",
    list->number, utc_text(list->from), utc_text(list->until));
}

void door::impl::look_later() {
  next_look.expires_after(options.look_every);
  next_look.async_wait([this](error_code stopped) {
    if (stopped || stopping)
      return;
    look_at_files();
    look_at_list();
    look_at_links();
    look_later();
  });
}

void door::impl::look_at_links() {
  const auto now = certs::now_s();
  const auto context = identity.context();
  const auto all = links;
  for (const auto& [number, one] : all) {
    const bool revoked = context->has_revoked(one.who.serial);
    if (!revoked && one.who.valid_until > now)
      continue;
    const auto why = revoked ? refusal::revoked : refusal::ended;
    logging::warn("door: the link of {} ({}) is cut: {}", one.who.name, one.who.address,
                  refusal_text(why));
    one.line->cut(why);
  }
}

void door::impl::shut() {
  stopping = true;
  error_code ignored;
  listener.close(ignored);
  retry.cancel();
  next_look.cancel();
  const auto guests = std::exchange(strangers, {});
  for (const auto& [number, one] : guests)
    if (one.line)
      one.line->cut(refusal::gone);
  const auto all = links;
  for (const auto& [number, one] : all)
    one.line->cut(refusal::gone);
}

// -- door ----------------------------------------------------------------------------------------

door::door(std::unique_ptr<impl> state) : impl_(std::move(state)) {}

door::~door() {
  asio::post(impl_->io, [state = impl_.get()] { state->shut(); });
  impl_->work.reset();
  impl_->thread.join();
}

expected<std::unique_ptr<door>> door::open(door_options options) {
  if (!options.accept)
    return fail(ec::invalid_argument, "the door has nobody to hand links to");
  error_code problem;
  const auto ip = asio::ip::make_address(options.address, problem);
  if (problem)
    return fail(ec::invalid_argument, "\"" + options.address + "\" is no IP address to listen on",
                "Give one of this machine's addresses, or 0.0.0.0 for all of them");
  auto identity =
    tls_identity::load(tls_side::door, options.roles, options.identity, options.revoked);
  if (!identity)
    return fail(identity.error());
  const tcp::endpoint where(ip, options.port);
  auto state = std::make_unique<impl>(std::move(options), std::move(*identity));
  if (auto ok = listen_on(state->listener, where); !ok)
    return fail(ok.error());
  state->port = state->listener.local_endpoint(problem).port();
  state->wait_for_guests();
  state->look_at_list();
  state->look_later();
  state->thread = std::thread([own = state.get()] { run_io(own->io); });
  return std::unique_ptr<door>(new door(std::move(state)));
}

std::uint16_t door::port() const {
  return impl_->port;
}

std::vector<link_peer> door::peers() const {
  const std::lock_guard lock(impl_->mutex);
  std::vector<link_peer> all;
  for (const auto& [number, one] : impl_->links)
    all.push_back(one.who);
  return all;
}

refusal_counts door::refusals() const {
  refusal_counts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i)
    counts[i] = impl_->refused[i];
  return counts;
}

}  // namespace tedit::actors
