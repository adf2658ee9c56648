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
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "actors/gateway/transport.hpp"

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

  net::io_context io{1};
  transport_options options;
  std::vector<std::string> hosts;  ///< Names besides the loopback ones.
  std::uint16_t port = 0;
  bool stopping = false;
  acceptor listener{io};
  net::steady_timer retry{io};
  std::set<slot*> slots;
  std::map<std::string, std::size_t> per_address;
  std::atomic<std::size_t> open_websockets{0};
};

/// Counts one socket for as long as it lives, and says how to end it when the transport stops.
class slot {
public:
  slot(std::shared_ptr<hub> owner, std::string address)
      : hub_(std::move(owner)), address_(std::move(address)) {
    hub_->slots.insert(this);
    ++hub_->per_address[address_];
  }
  slot(const slot&) = delete;
  slot& operator=(const slot&) = delete;
  ~slot() {
    hub_->slots.erase(this);
    const auto count = hub_->per_address.find(address_);
    if (--count->second == 0)
      hub_->per_address.erase(count);
  }

  std::function<void()> end;

private:
  std::shared_ptr<hub> hub_;
  std::string address_;
};

/// "address:port", an IPv6 address in brackets.
[[nodiscard]] std::string address_text(const tcp::endpoint& e);

/// Answers one request on a fresh socket; `refused`: with a 503, whatever it is.
void serve_http(std::shared_ptr<hub> owner, tcp_socket socket, std::unique_ptr<slot> place,
                bool refused);

/// Completes the handshake of a request that was found good and serves the connection.
void serve_websocket(std::shared_ptr<hub> owner, tcp_stream stream, std::unique_ptr<slot> place,
                     upgrade_request request);

}  // namespace tedit::gateway
