// SPDX-License-Identifier: AGPL-3.0-or-later
// What a message between two nodes costs over an inherited pair of sockets and over TLS on this
// machine. Both take turns. usage: bench_links [ROUNDS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <caf/event_based_actor.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/exits.hpp"
#include "actors/links/dial.hpp"
#include "actors/links/door.hpp"
#include "actors/links/link.hpp"
#include "actors/node/system_config.hpp"
#include "base/logging/logging.hpp"
#include "certs/authority.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using clock_type = std::chrono::steady_clock;

constexpr int small_messages = 300;
constexpr std::size_t most_bytes = std::size_t{16} << 20;

struct caf_node {
  actors::system_config config{true};
  caf::actor_system system{config};
};

caf::behavior echo(caf::event_based_actor* self, int) {
  actors::heed_only_own_exits(self);
  return {[](const std::string& text) { return text; }};
}

double seconds_of(caf::scoped_actor& self, const caf::actor& whom, const std::string& text) {
  const auto start = clock_type::now();
  bool good = false;
  self->request(whom, std::chrono::seconds(60), text)
    .receive([&](const std::string& back) { good = back.size() == text.size(); },
             [](const caf::error&) {});
  if (!good)
    throw std::runtime_error("no echo");
  return std::chrono::duration<double>(clock_type::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// A link with a node at its end, and its figures.
struct contender {
  const char* name;
  caf_node node;
  std::unique_ptr<actors::dial> line;
  caf::actor found;
  std::vector<double> round_trip, one_mb, sixteen_mb;

  void measure() {
    caf::scoped_actor self(node.system);
    for (int i = 0; i < small_messages; ++i)
      round_trip.push_back(seconds_of(self, found, "x"));
    for (int i = 0; i < 8; ++i)
      one_mb.push_back(seconds_of(self, found, std::string(1'000'000, 'x')));
    for (int i = 0; i < 2; ++i)
      sixteen_mb.push_back(seconds_of(self, found, std::string(most_bytes, 'x')));
  }

  void report() const {
    std::printf("| %s | %.0f | %.0f | %.0f |\n", name, 1e6 * median(round_trip), 1 / median(one_mb),
                most_bytes / 1e6 / median(sixteen_mb));
  }
};

void run(int rounds) {
  const test::scratch_folder folder;
  const auto at = [&](const char* name) { return folder.path() / name; };
  test::value(certs::init(at("ca")));
  test::value(certs::issue(at("ca"), {certs::role::server, "server", {"127.0.0.1"}}, at("s")));
  test::value(certs::issue(at("ca"), {certs::role::solver, "worker"}, at("w")));
  caf_node host;
  const auto enlister = host.system.spawn(echo, 0);
  actors::door_options options;
  options.identity = at("s");
  options.accept = [&](unique_fd end, const actors::link_peer&) {
    actors::serve_link(host.system, std::move(end), enlister);
  };
  const auto door = test::value(actors::door::open(std::move(options)));

  contender pair{"inherited pair", {}, {}, {}, {}, {}, {}};
  auto ends = test::value(actors::make_link());
  actors::serve_link(host.system, std::move(ends.ours), enlister);
  pair.found = test::value(actors::join_link(pair.node.system, std::move(ends.theirs)));
  contender tls{"TLS, two bridges", {}, {}, {}, {}, {}, {}};
  const auto start = clock_type::now();
  tls.line = test::value(actors::dial::connect({at("w"), "127.0.0.1", door->port()}));
  const auto dialled = std::chrono::duration<double>(clock_type::now() - start).count();
  tls.found = test::value(actors::join_link(tls.node.system, tls.line->take_link()));

  for (int i = 0; i < rounds; ++i) {
    pair.measure();
    tls.measure();
  }
  std::printf("dialled in %.1f ms\n", 1e3 * dialled);
  std::printf("| link | round trip us | 1 MB echo, MB/s each way | 16 MiB |\n|---|---|---|---|\n");
  pair.report();
  tls.report();
  caf::anon_send_exit(enlister, caf::exit_reason::user_shutdown);
}

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) {
  tedit::logging::set_level("warn");
  try {
    tedit::run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 10);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_links: %s\n", e.what());
    return 1;
  }
  return 0;
}
