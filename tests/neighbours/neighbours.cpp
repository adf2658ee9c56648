// SPDX-License-Identifier: AGPL-3.0-or-later
// What an honest client notices of bad neighbours: how long its requests, edits and new connections
// take while others export without pause, never read, leave handshakes half open or guess the
// token.
//
// usage: neighbours [--tedit PROGRAM] [--mesh FILE] [--seconds S] [--check] [NEIGHBOUR...]
//
// --tedit: the server's program; --mesh: the part that the neighbours export; --check: fail when an
// honest connection is turned away or an edit is refused. Neighbours: none exports deaf handshakes
// tokens; without one all of them, each for S seconds (5) on a server of its own.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "base/process.hpp"
#include "base/stopwatch.hpp"
#include "tests/neighbours/bad_clients.hpp"

namespace tedit::test {
namespace {

using namespace std::chrono_literals;
using steady = std::chrono::steady_clock;

struct settings {
  std::string program = TEDIT_BIN "/tedit";
  std::filesystem::path mesh = TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh";
  double seconds = 5;
  bool check = false;
  std::vector<std::string> neighbours;
};

/// `tedit serve` with a folder of its own.
class served {
public:
  explicit served(const std::string& program) {
    auto name = (std::filesystem::temp_directory_path() / "tedit-neighbours-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    const auto ready = folder_ / "ready";
    pid_ = value(spawn_process(
      {"/bin/sh", "-c", "exec \"$0\" \"$@\" >/dev/null", program, "serve", "--quiet", "--port", "0",
       "--documents", (folder_ / "documents").string(), "--token-file",
       (folder_ / "token").string(), "--ready-file", ready.string(), "--device", "cpu"}));
    for (int i = 0; i < 3000 && !std::filesystem::exists(ready); ++i)
      std::this_thread::sleep_for(10ms);
    std::ifstream in(ready);
    options.url = nlohmann::json::parse(in)["url"];
    std::ifstream(folder_ / "token") >> options.token;
    options.client_name = "neighbours";
    options.timeout = 30s;
  }
  served(const served&) = delete;
  served& operator=(const served&) = delete;
  ~served() {
    kill_process(pid_);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::unique_ptr<client::client> connect() const {
    return value(client::client::connect(options, {}));
  }

  client::connect_options options;

private:
  std::filesystem::path folder_;
  pid_t pid_ = 0;
};

/// Times in ms, and what went wrong.
struct sample {
  std::vector<double> ms;
  int failures = 0;
  std::string why;

  void add(double time, const expected<void>& ok) {
    if (ok)
      return ms.push_back(time);
    ++failures;
    why = render(ok.error());
  }

  [[nodiscard]] double at(double part) {
    if (ms.empty())
      return 0;
    std::ranges::sort(ms);
    return ms[std::min(ms.size() - 1,
                       static_cast<std::size_t>(part * static_cast<double>(ms.size())))];
  }
};

struct report {
  sample requests, edits, connects;
};

/// Calls `work` again and again until the time is over.
template <class Work>
void measure(sample& into, steady::time_point end, std::chrono::milliseconds pause, Work work) {
  while (steady::now() < end) {
    const stopwatch clock;
    const expected<void> ok = work();
    into.add(clock.milliseconds(), ok);
    std::this_thread::sleep_for(pause);
  }
}

template <class T>
expected<void> only_errors(const expected<T>& got) {
  return got ? expected<void>() : expected<void>(fail(got.error()));
}

/// One client that edits a document of its own, one that asks small things.
struct honest {
  explicit honest(const served& server) : editor(server.connect()), asker(server.connect()) {
    value(editor->open("honest", false, false));
    value(editor->import_file(TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh", "mm", {}));
    wall = value(editor->select({feature_kind::holes, {}}, {})).back().surfaces;
  }

  std::unique_ptr<client::client> editor;
  std::unique_ptr<client::client> asker;
  std::vector<surface_id> wall;
};

/// An edit and its undo, small requests, new connections: all at once.
report honest_work(const served& server, honest& who, double seconds) {
  report result;
  const auto end = steady::now() + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
  std::thread edits([&] {
    measure(result.edits, end, 20ms, [&]() -> expected<void> {
      auto ok = only_errors(who.editor->edit("fill_hole", who.wall, {}, {}));
      return ok ? only_errors(who.editor->undo()) : ok;
    });
  });
  std::thread connects([&] {
    measure(result.connects, end, 20ms,
            [&] { return only_errors(client::client::connect(server.options, {})); });
  });
  measure(result.requests, end, 2ms, [&] { return only_errors(who.asker->status()); });
  edits.join();
  connects.join();
  return result;
}

std::unique_ptr<bad_client> make_neighbour(const std::string& name, const served& server,
                                           const settings& given) {
  if (name == "none")
    return std::make_unique<bad_client>();
  if (name == "handshakes")
    return make_half_open(server.options);
  if (name == "tokens")
    return make_guesser(server.options);
  auto owner = server.connect();
  value(owner->open("others", false, false));
  value(owner->import_file(given.mesh, "mm", {}));
  if (name == "exports")
    return make_exporter(server.options, "others", 64);
  if (name == "deaf")
    return make_deaf(server.options, "others", 300);
  throw std::runtime_error("there is no neighbour " + name);
}

bool run(const settings& given, const std::string& name) {
  const served server(given.program);
  honest who(server);
  const auto neighbour = make_neighbour(name, server, given);
  std::this_thread::sleep_for(300ms);  // Until it is in full swing.
  auto seen = honest_work(server, who, given.seconds);
  std::printf("%-11s", name.c_str());
  for (auto* s : {&seen.requests, &seen.edits, &seen.connects})
    std::printf(" | %6zu %7.2f %7.1f %7.1f", s->ms.size(), s->at(0.5), s->at(0.99), s->at(1));
  std::printf(" | %d of %zu connections turned away, %d edits refused; %s\n",
              seen.connects.failures, seen.connects.failures + seen.connects.ms.size(),
              seen.edits.failures, neighbour->deeds().c_str());
  for (const auto* s : {&seen.requests, &seen.edits, &seen.connects})
    if (s->failures > 0)
      std::printf("            the last failure: %s\n", s->why.c_str());
  std::fflush(stdout);
  return seen.requests.failures + seen.edits.failures + seen.connects.failures == 0 &&
         !seen.edits.ms.empty() && !seen.connects.ms.empty();
}

settings read(int argc, char** argv) {
  settings result;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--check")
      result.check = true;
    else if (word == "--tedit" && i + 1 < argc)
      result.program = argv[++i];
    else if (word == "--mesh" && i + 1 < argc)
      result.mesh = argv[++i];
    else if (word == "--seconds" && i + 1 < argc)
      result.seconds = std::stod(argv[++i]);
    else
      result.neighbours.push_back(word);
  }
  if (result.neighbours.empty())
    result.neighbours = {"none", "exports", "deaf", "handshakes", "tokens"};
  return result;
}

}  // namespace
}  // namespace tedit::test

int main(int argc, char** argv) try {
  const auto given = tedit::test::read(argc, argv);
  std::printf("ms: n, p50, p99, max  | requests%24s | edit and undo%19s | new connections\n", "",
              "");
  bool good = true;
  for (const auto& name : given.neighbours)
    good = tedit::test::run(given, name) && good;
  return given.check && !good ? 1 : 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "neighbours: %s\n", e.what());
  return 2;
}
