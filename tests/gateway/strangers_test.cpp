// SPDX-License-Identifier: AGPL-3.0-or-later
// Connections that never say who they are take no place of those that do.
#include <algorithm>
#include <span>

#include "tests/gateway/transport_fixture.hpp"

namespace tedit::gateway::test {
namespace {

class transport_strangers : public transport_fixture {};

/// Whether the server has ended this connection, which the other side only looks at.
bool is_over(client& c) {
  auto& socket = beast::get_lowest_layer(c.stream()).socket();
  char byte = 0;
  const auto got = ::recv(socket.native_handle(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return got == 0 || (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK);
}

TEST_P(transport_strangers, unfinished_handshakes_take_no_clients_place) {
  options.limits.max_strangers = 6;
  options.limits.max_per_address = 4;
  options.limits.handshake_timeout = options.limits.hello_timeout = patience;
  start();
  const auto good = connect_known();
  std::vector<std::unique_ptr<client>> halves;
  for (int i = 0; i < 30; ++i) {
    auto half = std::make_unique<client>(server->port(), 0, trusted());
    if (i % 3 == 1)
      half->run([&](auto done) {
        net::async_write(half->stream().next_layer(), net::buffer("GET /v1 HTTP/1.1\r\nHost: ", 24),
                         std::move(done));
      });
    if (i % 3 == 2)
      half->upgrade(host);  // And no hello.
    halves.push_back(std::move(half));
    EXPECT_EQ(connect_known()->round_trip("in"), "in") << i;
  }
  EXPECT_EQ(good->round_trip("still here"), "still here");
  // The oldest had to go, the newest are waited for.
  EXPECT_TRUE(eventually([&] {
    return std::ranges::all_of(std::span(halves).first(24), [](auto& c) { return is_over(*c); });
  }));
  EXPECT_FALSE(is_over(*halves.back()));
}

TEST_P(transport_strangers, who_proves_himself_when_all_places_are_taken_is_told) {
  options.limits.max_connections = 2;
  start();
  const auto first = connect();
  const auto second = connect();
  const auto third = connect();
  EXPECT_EQ(first->round_trip("hello"), "hello");
  EXPECT_EQ(second->round_trip("hello"), "hello");
  third->write("hello");
  EXPECT_EQ(third->close_code(), 1013);
  EXPECT_EQ(first->round_trip("still here"), "still here");
}

INSTANTIATE_TEST_SUITE_P(with, transport_strangers, ::testing::Bool(), with_or_without);

}  // namespace
}  // namespace tedit::gateway::test
