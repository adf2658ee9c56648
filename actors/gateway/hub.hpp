// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>  // Boost.Asio 1.74 uses it without including it.

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "actors/gateway/transport.hpp"
#include "tls/server_identity.hpp"
#include "tls/stream.hpp"

/// What the parts of the transport share; for its own .cpp files only.
namespace tedit::gateway {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

using boost::system::error_code;
using tcp = net::ip::tcp;
using io_executor = net::io_context::executor_type;
using strand = net::strand<io_executor>;
using tcp_socket = net::basic_stream_socket<tcp, strand>;
using tcp_stream = beast::basic_stream<tcp, strand>;
using net_stream = tls::stream<tcp_stream>;
using upgrade_request = http::request<http::empty_body>;
using acceptor = net::basic_socket_acceptor<tcp, io_executor>;

class slot;

/// Owns the io_context. Connections keep it alive, so that a handle may outlive the transport. All
/// but the atomics belongs to the I/O thread.
struct hub : std::enable_shared_from_this<hub> {
  explicit hub(transport_options o) : options(std::move(o)) {}

  void accept_next();
  void take(tcp_socket socket);
  void shut();
  /// Whether another client of this address may be let in.
  [[nodiscard]] bool has_place(const std::string& address) const;
  void make_room();
  /// Reads the certificate's files again where they changed.
  void look_at_certificate();

  net::io_context io{1};
  transport_options options;
  std::vector<std::string> hosts;  ///< Names besides the loopback ones and the certificate's.
  std::optional<tls::server_identity> identity;  ///< None: without TLS.
  std::string fingerprint;                       ///< Of the certificate that was shown first.
  std::uint16_t port = 0;
  bool stopping = false;
  acceptor listener{io};
  net::steady_timer retry{io};
  std::set<slot*> slots;
  std::list<slot*> strangers;                ///< Those that are not authenticated, as they came.
  std::map<std::string, std::size_t> known;  ///< Authenticated connections by address.
  std::size_t all_known = 0;
  std::atomic<std::size_t> open_websockets{0};
};

/// Why a connection is ended from outside.
enum class ending { server_stops, gives_way };

/// Counts one socket for as long as it lives, as a stranger's until it is `promote`d, and says how
/// to end it.
class slot {
public:
  slot(std::shared_ptr<hub> owner, std::string address)
      : hub_(std::move(owner)), address_(std::move(address)) {
    hub_->slots.insert(this);
    place_ = hub_->strangers.insert(hub_->strangers.end(), this);
  }
  slot(const slot&) = delete;
  slot& operator=(const slot&) = delete;
  ~slot() {
    hub_->slots.erase(this);
    leave_strangers();
    if (!known_)
      return;
    const auto count = hub_->known.find(address_);
    if (--count->second == 0)
      hub_->known.erase(count);
    --hub_->all_known;
  }

  /// Takes a client's place instead of a stranger's; false when none is left.
  [[nodiscard]] bool promote() {
    if (known_)
      return true;
    if (!hub_->has_place(address_))
      return false;
    leave_strangers();
    known_ = true;
    ++hub_->known[address_];
    ++hub_->all_known;
    return true;
  }

  /// Ends it for a newcomer.
  void give_way() {
    leave_strangers();
    if (end)
      end(ending::gives_way);
  }

  [[nodiscard]] const std::string& address() const { return address_; }

  std::function<void(ending)> end;

private:
  void leave_strangers() {
    if (place_)
      hub_->strangers.erase(*place_);
    place_.reset();
  }

  std::shared_ptr<hub> hub_;
  std::string address_;
  std::optional<std::list<slot*>::iterator> place_;  ///< Among the strangers.
  bool known_ = false;
};

/// "address:port", an IPv6 address in brackets.
[[nodiscard]] std::string address_text(const tcp::endpoint& e);

/// Answers one request on a fresh socket; `refused`: with a 503, whatever it is.
void serve_http(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
                bool refused);

/// Completes the handshake of a request that was found good and serves the connection.
void serve_websocket(std::shared_ptr<hub> owner, net_stream stream, std::unique_ptr<slot> place,
                     upgrade_request request);

}  // namespace tedit::gateway
