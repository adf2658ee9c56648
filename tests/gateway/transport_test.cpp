// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/transport.hpp"

#include "tests/gateway/transport_fixture.hpp"

namespace tedit::gateway::test {
namespace {

class transport_http : public transport_fixture {};
class transport_plain : public transport_fixture {};  // What it says, it says to TCP itself.
class transport_ws : public transport_fixture {};
class transport_limit : public transport_fixture {};
class transport_stop : public transport_fixture {};

TEST_P(transport_http, health) {
  start();
  EXPECT_THAT(ask("GET /healthz"), AllOf(HasSubstr("HTTP/1.1 200 "), HasSubstr("application/json"),
                                         EndsWith("\r\n\r\n{\"ok\":true}")));
  EXPECT_THAT(ask("HEAD /healthz"), AllOf(HasSubstr("HTTP/1.1 200 "), EndsWith("\r\n\r\n"),
                                          HasSubstr("Content-Length: 11")));
  well = false;
  EXPECT_THAT(ask("GET /healthz"), HasSubstr("HTTP/1.1 503 "));
}

TEST_P(transport_http, what_is_not_there) {
  start();
  EXPECT_THAT(ask("GET /"), HasSubstr("HTTP/1.1 404 "));
  EXPECT_THAT(ask("GET /v1/more"), HasSubstr("HTTP/1.1 404 "));
  EXPECT_THAT(ask("GET /v1"), HasSubstr("HTTP/1.1 426 "));
  EXPECT_THAT(ask("POST /healthz", "Content-Length: 3\r\n"), HasSubstr("HTTP/1.1 405 "));
  EXPECT_THAT(ask("OPTIONS /v1"), HasSubstr("HTTP/1.1 405 "));
  EXPECT_EQ(fresh().upgrade(host, "", "/v2"), 404);
}

TEST_P(transport_http, foreign_host_is_refused) {
  start();
  const std::string port = host.substr(host.find(':'));
  const std::string others[] = {"evil.example" + port, "localhost:1", "localhost.evil" + port};
  for (const std::string& bad : others) {
    EXPECT_EQ(fresh().upgrade(bad), 403) << bad;
    EXPECT_THAT(fresh().raw("GET /healthz HTTP/1.1\r\nHost: " + bad + "\r\n\r\n"),
                HasSubstr("HTTP/1.1 403 "));
  }
  EXPECT_THAT(fresh().raw("GET /healthz HTTP/1.1\r\n\r\n"), HasSubstr("HTTP/1.1 403 "));
  EXPECT_THAT(ask("GET /healthz", "Host: evil.example\r\n"), HasSubstr("HTTP/1.1 403 "));
}

TEST_P(transport_http, foreign_origin_is_refused) {
  options.allowed_origins = {"https://mesh.example"};
  start();
  EXPECT_EQ(fresh().upgrade(host, "https://evil.example"), 403);
  EXPECT_EQ(fresh().upgrade(host, "null"), 403);
  EXPECT_EQ(fresh().upgrade(host, "http://" + host + ".evil.example"), 403);
  EXPECT_EQ(fresh().upgrade(host, "http://" + host), 101);
  EXPECT_EQ(fresh().upgrade(host, "https://mesh.example"), 101);
  EXPECT_THAT(ask("GET /healthz", "Origin: https://evil.example\r\n"),
              HasSubstr("not allowed here"));
}

TEST_P(transport_http, an_endless_header_is_refused) {
  start();
  EXPECT_THAT(ask("GET /healthz", "X: " + std::string(20'000, 'x') + "\r\n"),
              HasSubstr("HTTP/1.1 431 "));
}

TEST_P(transport_plain, a_page_arrives_whole_on_a_slow_line) {
  options.limits.close_timeout = 50ms;
  const std::string page = noise(8 * mib);
  options.pages["/page"] = [&](const page_request&) { return page_answer{200, page, "x/y"}; };
  start();
  net::io_context io;
  tcp::socket slow(io, tcp::v4());
  slow.set_option(net::socket_base::receive_buffer_size(64 << 10));
  slow.connect({net::ip::address_v4::loopback(), server->port()});
  net::write(slow, net::buffer("GET /page HTTP/1.1\r\nHost: " + host + "\r\n\r\n"));
  std::this_thread::sleep_for(200ms);  // Longer than a close may take.
  std::string answer;
  error_code end;
  net::read(slow, net::dynamic_buffer(answer), end);
  EXPECT_EQ(end, net::error::eof);
  EXPECT_TRUE(answer.ends_with(page));
}

TEST_P(transport_ws, echo_small_and_large) {
  start();
  const auto c = connect_known();
  EXPECT_EQ(server->connections(), 1u);
  EXPECT_THAT(seen->wait(seen->opened)->peer(), HasSubstr("127.0.0.1:"));
  EXPECT_EQ(c->round_trip(""), "");
  const std::string large = noise(8 * mib);
  EXPECT_TRUE(c->round_trip(large) == large);
  EXPECT_TRUE(eventually([&] { return seen->wait(seen->opened)->queued_bytes() == 0; }));
}

TEST_P(transport_ws, the_clients_close_is_told) {
  start();
  const auto c = connect_known();
  c->run([&](auto done) {
    c->stream().async_close({websocket::close_code::normal, "bye"}, std::move(done));
  });
  EXPECT_THAT(seen->wait(seen->closed), HasSubstr("1000 bye"));
  EXPECT_TRUE(eventually([&] { return server->connections() == 0; }));
}

TEST_P(transport_ws, closes_after_what_is_queued) {
  start();
  const auto c = connect_known();
  const auto remote = seen->wait(seen->opened);
  for (int i = 0; i < 3; ++i)
    remote->send(make_frame(2 * mib, static_cast<char>('a' + i)));
  remote->close(4000, std::string(200, 'r'));
  remote->send(make_frame(9));
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(c->read() == std::string(2 * mib, static_cast<char>('a' + i)));
  EXPECT_EQ(c->close_code(), 4000);
  EXPECT_EQ(c->stream().reason().reason.size(), 123u);
  EXPECT_THAT(seen->wait(seen->closed), HasSubstr("4000 rrr"));
  EXPECT_EQ(remote->queued_bytes(), 0u);
}

TEST_P(transport_ws, tells_when_the_queue_has_drained) {
  start();
  const auto c = connect_known();
  for (int i = 0; i < 8; ++i)
    seen->wait(seen->opened)->send(make_frame(mib));
  for (int i = 0; i < 8; ++i)
    EXPECT_TRUE(c->read().has_value());
  EXPECT_EQ(seen->wait(seen->drained), 1);
}

TEST_P(transport_ws, text_and_exceptions_close) {
  start();
  const auto text = connect_known();
  text->stream().text(true);
  EXPECT_FALSE(text->write("words"));
  EXPECT_EQ(text->close_code(), 1003);
  const auto thrower = connect_known();
  thrower->write("throw");
  EXPECT_EQ(thrower->close_code(), 1011);
}

TEST_P(transport_limit, the_first_message_is_small) {
  start();
  const auto c = connect();
  c->write(std::string(4097, 'x'));
  EXPECT_EQ(c->close_code(), 1009);
  const auto stranger = connect();
  EXPECT_EQ(stranger->round_trip("stranger"), "stranger");
  stranger->write(std::string(4097, 'x'));
  EXPECT_EQ(stranger->close_code(), 1009);
  EXPECT_THAT(seen->wait(seen->closed), HasSubstr("4096"));
}

TEST_P(transport_limit, a_message_too_large_closes) {
  options.limits.max_message = mib;
  start();
  const auto c = connect_known();
  EXPECT_TRUE(c->round_trip(std::string(mib, 'x')).has_value());
  c->write(std::string(mib + 1, 'x'));
  EXPECT_EQ(c->close_code(), 1009);
}

TEST_P(transport_limit, no_hello_closes) {
  options.limits.hello_timeout = 500ms;
  start();
  const auto known = connect_known();
  const auto c = connect();
  EXPECT_EQ(c->close_code(), 1008);
  const auto stranger = connect();
  EXPECT_EQ(stranger->round_trip("stranger"), "stranger");
  EXPECT_EQ(stranger->close_code(), 1008);
  EXPECT_EQ(known->round_trip("x"), "x");
}

TEST_P(transport_limit, a_slow_reader_is_closed_and_others_go_on) {
  options.limits.max_queue = mib;
  options.limits.slow_client = 300ms;
  options.limits.close_timeout = 10s;
  start();
  const auto slow = connect_known(64 << 10);
  const auto other = connect_known();
  const auto remote = seen->wait(seen->opened);
  for (const auto& bytes : std::vector(32, make_frame(mib)))  // Making 32 may outlast slow_client.
    remote->send(bytes);
  EXPECT_GT(remote->queued_bytes(), 16 * mib);
  EXPECT_TRUE(eventually([&] {
    EXPECT_EQ(other->round_trip("ping"), "ping");
    return remote->queued_bytes() < mib;
  }));
  EXPECT_EQ(slow->close_code(), 1013);
  EXPECT_EQ(seen->wait(seen->closed), "1013 the client reads too slowly");
  EXPECT_EQ(remote->queued_bytes(), 0u);
}

TEST_P(transport_limit, who_falls_behind_is_told_before_what_waits) {
  options.limits.max_queue = mib;
  start();
  const auto slow = connect_known(64 << 10);
  const auto remote = seen->wait(seen->opened);
  for (const auto& bytes : std::vector(16, make_frame(mib)))
    remote->send(bytes);
  EXPECT_GT(seen->wait(seen->backlogs), mib);
  std::size_t before = 0;
  std::size_t after = 0;
  bool told = false;
  while (before + after < 16) {
    const auto got = slow->read();
    ASSERT_TRUE(got);
    if (*got == "more than 1048576 for 10000 ms")
      told = true;
    else
      ++(told ? after : before);
  }
  EXPECT_TRUE(told);
  EXPECT_LE(before, 4U) << "what was on its way already";
  EXPECT_EQ(slow->round_trip("ping"), "ping") << "it goes on";
}

TEST_P(transport_limit, a_reader_that_never_reads_is_cut_off) {
  options.limits.max_queue = mib;
  options.limits.slow_client = 100ms;
  options.limits.close_timeout = 100ms;
  start();
  const auto deaf = connect_known(64 << 10);
  for (int i = 0; i < 32; ++i)
    seen->wait(seen->opened)->send(make_frame(mib));
  EXPECT_THAT(seen->wait(seen->closed), HasSubstr("1013"));
  EXPECT_TRUE(eventually([&] { return seen->opened[0]->queued_bytes() == 0; }));
  EXPECT_EQ(server->connections(), 0u);
}

TEST_P(transport_limit, who_is_quicker_than_its_handler_waits) {
  options.limits.max_unhandled = 2 * mib;
  start();
  const auto quick = connect_known();
  const auto other = connect_known();
  const auto remote = seen->wait(seen->opened);
  constexpr std::size_t messages = 64;
  std::thread writer([&] {
    for (std::size_t i = 0; i < messages; ++i)
      quick->write("keep" + std::string(mib, 'x'));
  });
  seen->wait(seen->kept, 1);
  EXPECT_EQ(other->round_trip("ping"), "ping");
  std::this_thread::sleep_for(100ms);  // In which no more come, however quick the machine is.
  {
    const std::lock_guard lock(seen->mutex);
    EXPECT_EQ(seen->kept.size(), 2u);
  }
  for (std::size_t i = 0; i < messages; ++i)
    remote->handled(seen->wait(seen->kept, i));
  writer.join();
  EXPECT_EQ(quick->round_trip("still here"), "still here");
}

TEST_P(transport_limit, silence_is_pinged_and_then_dropped) {
  options.limits.ping_after = 50ms;
  options.limits.idle_timeout = 1s;
  start();
  const auto alive = connect_known();
  const auto silent = connect_known();  // Never reads, so never answers a ping.
  int pings = 0;
  alive->stream().control_callback([&](websocket::frame_type kind, beast::string_view) {
    pings += kind == websocket::frame_type::ping ? 1 : 0;
  });
  std::thread closer([&] {
    EXPECT_THAT(seen->wait(seen->closed), HasSubstr("no sign of life"));
    seen->wait(seen->opened)->send(std::make_shared<const std::string>("end"));
  });
  EXPECT_EQ(alive->read(), "end");
  closer.join();
  EXPECT_GT(pings, 0);
}

TEST_P(transport_limit, connections_are_counted) {
  for (const bool by_address : {false, true}) {
    options.limits.max_connections = by_address ? 100 : 2;
    options.limits.max_per_address = by_address ? 2 : 100;
    start();
    auto first = connect_known();
    const auto second = connect_known();
    EXPECT_EQ(fresh().upgrade(host), 503);
    EXPECT_THAT(ask("GET /healthz"), HasSubstr("HTTP/1.1 503 "));
    first.reset();
    EXPECT_TRUE(eventually([&] { return fresh().upgrade(host) == 101; }));
  }
}

TEST_P(transport_limit, garbage_and_half_handshakes_disturb_nobody) {
  options.limits.handshake_timeout = 500ms;
  start();
  const auto good = connect_known();
  EXPECT_EQ(fresh().raw("GET /v1 HTTP/1.1\r\nHost: loc"),
            "");  // Cut off after the timeout.
  EXPECT_EQ(fresh().raw(""), "");
  EXPECT_THAT(fresh().raw(noise(5000)), HasSubstr("HTTP/1.1 400 "));
  EXPECT_THAT(fresh().raw("\x16\x03\x01\x02\x00\x01\r\n\r\n"), HasSubstr("HTTP/1.1 400 "));
  const auto broken = connect_known();  // Random bytes where frames should be.
  broken->raw(noise(5000));
  { const auto gone = connect_known(); }  // Closes without a close frame.
  EXPECT_EQ(good->round_trip("still here"), "still here");
  EXPECT_TRUE(eventually([&] { return server->connections() == 1; }));
}

TEST_P(transport_stop, closes_all_in_time) {
  start();
  const auto polite = connect_known();
  const auto deaf = connect_known(64 << 10);  // Never reads; its queue is full.
  for (int i = 0; i < 32; ++i)
    seen->wait(seen->opened, 1)->send(make_frame(mib));
  const client half(server->port());
  const auto begin = std::chrono::steady_clock::now();
  std::thread stopper([&] { server->stop(); });
  EXPECT_EQ(polite->close_code(), 1001);
  stopper.join();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
  EXPECT_EQ(seen->closed.size(), 2u);
}

TEST_P(transport_stop, a_handle_may_outlive_the_transport) {
  options.limits.close_timeout = 100ms;
  start();
  const auto c = connect_known();
  const auto remote = seen->wait(seen->opened);
  server.reset();
  remote->send(make_frame(9));
  remote->authenticated();
  remote->close(1000, "");
  EXPECT_THAT(remote->peer(), HasSubstr("127.0.0.1"));
}

TEST_P(transport_stop, a_port_is_listened_on_once) {
  start();
  options.port = server->port();
  const error problem = transport::start(options).error();
  EXPECT_EQ(problem.code, ec::service_unavailable);
  EXPECT_THAT(problem.message, HasSubstr("127.0.0.1:" + std::to_string(options.port)));
  EXPECT_FALSE(problem.remedy.empty());
  server.reset();
  EXPECT_TRUE(transport::start(options));
}

TEST_P(transport_stop, bad_options_are_refused) {
  EXPECT_EQ(transport::start({}).error().code, ec::invalid_argument);
  options.accept = [](std::shared_ptr<connection>) { return nullptr; };
  options.address = "no.address";
  EXPECT_EQ(transport::start(options).error().code, ec::invalid_argument);
  options.address = "localhost";
  const auto refusing = transport::start(options).value();
  client c(refusing->port());
  EXPECT_EQ(c.upgrade("localhost"), 101);
  EXPECT_EQ(c.close_code(), 1013);
}

INSTANTIATE_TEST_SUITE_P(with, transport_http, ::testing::Bool(), with_or_without);
INSTANTIATE_TEST_SUITE_P(with, transport_plain, ::testing::Values(false), with_or_without);
INSTANTIATE_TEST_SUITE_P(with, transport_ws, ::testing::Bool(), with_or_without);
INSTANTIATE_TEST_SUITE_P(with, transport_limit, ::testing::Bool(), with_or_without);
INSTANTIATE_TEST_SUITE_P(with, transport_stop, ::testing::Bool(), with_or_without);

}  // namespace
}  // namespace tedit::gateway::test
