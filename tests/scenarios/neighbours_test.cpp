// SPDX-License-Identifier: AGPL-3.0-or-later
// Other users of the machine, who know no token: what they can reach, and what it does.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <optional>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "base/unique_fd.hpp"
#include "tests/scenarios/http.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The process and all that descend from it.
std::vector<pid_t> family_of(pid_t head) {
  std::vector<pid_t> all{head};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto tasks = "/proc/" + std::to_string(all[i]) + "/task";
    for (const auto& task : std::filesystem::directory_iterator(tasks)) {
      std::ifstream in(task.path() / "children");
      for (pid_t child = 0; in >> child;)
        all.push_back(child);
    }
  }
  return all;
}

/// The inodes of the sockets that the processes hold.
std::set<std::string> sockets_of(const std::vector<pid_t>& processes) {
  std::set<std::string> inodes;
  for (const auto pid : processes)
    for (const auto& file :
         std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/fd")) {
      std::error_code gone;
      const auto target = std::filesystem::read_symlink(file, gone).string();
      if (target.starts_with("socket:["))
        inodes.insert(target.substr(8, target.size() - 9));
    }
  return inodes;
}

/// The TCP ports that the processes listen on.
std::set<int> ports_of(const std::vector<pid_t>& processes) {
  const auto mine = sockets_of(processes);
  std::set<int> ports;
  for (const char* table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    std::ifstream in(table);
    std::string line;
    while (std::getline(in, line)) {
      std::istringstream words(line);
      const std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
      if (word.size() > 9 && word[3] == "0A" && mine.contains(word[9]))
        ports.insert(std::stoi(word[1].substr(word[1].find(':') + 1), nullptr, 16));
    }
  }
  return ports;
}

/// The names of the local sockets that the processes listen on.
std::vector<std::string> local_names_of(const std::vector<pid_t>& processes) {
  const auto mine = sockets_of(processes);
  std::vector<std::string> names;
  std::ifstream in("/proc/net/unix");
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    const std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
    if (word.size() > 7 && mine.contains(word[6]))
      names.push_back(word[7]);
  }
  return names;
}

std::string health_of(int port) {
  return get(port, "/healthz");
}

/// Waits until the server's health has these words; the last that it said.
std::string wait_for_health(int port, const std::string& words) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  auto said = health_of(port);
  while (said.find(words) == std::string::npos && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    said = health_of(port);
  }
  return said;
}

/// Runs `work` in a process of another user, if this one may become one.
void as_a_stranger(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (getuid() == 0 && (setgid(nobody) != 0 || setuid(nobody) != 0))
      _exit(2);
    work();
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

int from_environment(const char* name, int otherwise) {
  const char* given = std::getenv(name);
  return given ? std::atoi(given) : otherwise;
}

class Neighbours : public ::testing::Test {
protected:
  scratch_folder folder;
  served host{folder};

  void SetUp() override {
    EXPECT_THAT(wait_for_health(port_of(host.url()), R"("status":"ok")"), HasSubstr("200 OK"));
  }

  void expect_a_whole_server() {
    auto user = host.connect();
    value(user->open("plate", false, false));
    value(user->import_file(plate_mesh, "mm", {}));
    value(user->edit("fill_hole", {1, 2}, {}, {}));
  }
};

TEST_F(Neighbours, NothingListensButThePortForClients) {
  const auto family = family_of(host.pid());
  EXPECT_GE(family.size(), 4U);
  EXPECT_THAT(ports_of(family), ElementsAre(port_of(host.url())));
  EXPECT_THAT(local_names_of(family), IsEmpty());
}

TEST_F(Neighbours, TheBytesThatEndCafsPortsEndNothing) {
  const auto ports = ports_of(family_of(host.pid()));
  as_a_stranger([&] {
    for (const int port : ports) {
      const auto fd = connect_to(port);
      say(fd.get(), std::string(1, '\1') + std::string(31, '\0'));
      char answer = 0;
      recv(fd.get(), &answer, 1, 0);
    }
  });
  EXPECT_THAT(health_of(port_of(host.url())), HasSubstr("200 OK"));
  expect_a_whole_server();
}

/// A connection's first bytes with some of them changed: HTTP, WebSocket and BASP.
/// TEDIT_MUTATED_CONNECTIONS=10000 is the long run.
TEST_F(Neighbours, MutatedConnectionsEndNothing) {
  const auto before = family_of(host.pid());
  const auto ports = ports_of(before);
  const int rounds = from_environment("TEDIT_MUTATED_CONNECTIONS", 200);
  const std::array starts{
    std::string(
      "GET /v1 HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n") +
      std::string("\x82\x85\1\2\3\4\x09\x0f\x15\x04\x05", 11),
    std::string("GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"),
    std::string(1, '\1') + std::string(6, '\0') + std::string(57, '\x20')};
  as_a_stranger([&] {
    std::mt19937 random(11);
    const auto below = [&](std::size_t n) { return random() % n; };
    for (int round = 0; round < rounds; ++round) {
      auto bytes = starts[below(starts.size())];
      for (auto changes = below(6); changes > 0; --changes)
        bytes[below(bytes.size())] = static_cast<char>(random());
      if (below(3) == 0)
        bytes.resize(1 + below(bytes.size()));
      for (const int port : ports) {
        const auto fd = connect_to(port);
        say(fd.get(), bytes);
      }
    }
  });
  EXPECT_THAT(wait_for_health(port_of(host.url()), R"("status":"ok")"), HasSubstr("200 OK"));
  EXPECT_EQ(family_of(host.pid()), before) << "some process was replaced";
  expect_a_whole_server();
}

/// A WebSocket connection that is written byte by byte.
class raw_socket {
public:
  explicit raw_socket(int port) : fd_(connect_to(port)) {
    say(fd_.get(),
        "GET /v1 HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n");
    std::array<char, 1024> answer{};
    recv(fd_.get(), answer.data(), answer.size(), 0);
  }

  /// False once the server has ended the connection.
  bool send_frame(unsigned first_byte, const std::string& body) {
    std::string bytes{static_cast<char>(first_byte)};
    if (body.size() < 126) {
      bytes += static_cast<char>(0x80 | body.size());
    } else {
      bytes += static_cast<char>(0x80 | 126);
      bytes += static_cast<char>(body.size() >> 8);
      bytes += static_cast<char>(body.size() & 0xff);
    }
    bytes += std::string(4, '\0');  // The mask: none.
    bytes += body;
    std::array<char, 65536> said{};
    while (recv(fd_.get(), said.data(), said.size(), MSG_DONTWAIT) > 0) {
    }
    return send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(bytes.size());
  }

private:
  unique_fd fd_;
};

/// Frames that are no messages, before Hello and after it, with the right token.
/// TEDIT_HOSTILE_FRAMES=100000 is the long run.
TEST_F(Neighbours, HostileFramesEndNothing) {
  const auto before = family_of(host.pid());
  const int port = port_of(host.url());
  const int wanted = from_environment("TEDIT_HOSTILE_FRAMES", 2000);
  const auto hello = host.hello();
  std::mt19937 random(5);
  const auto below = [&](std::size_t n) { return random() % n; };
  std::optional<raw_socket> line;
  for (int frame = 0; frame < wanted; ++frame) {
    if (!line) {
      line.emplace(port);
      if (below(4) != 0)
        line->send_frame(0x82, hello);
    }
    auto body = below(2) == 0 ? hello : std::string(1 + below(300), '\0');
    for (auto& c : body)
      if (body != hello || below(8) == 0)
        c = static_cast<char>(random());
    // Mostly whole binary messages; else any operation, reserved bits and pieces.
    const bool sent = line->send_frame(below(8) != 0 ? 0x82U : random() & 0xffU, body);
    if (!sent || below(20) == 0)
      line.reset();
  }
  line.reset();
  EXPECT_THAT(wait_for_health(port, R"("status":"ok")"), HasSubstr("200 OK"));
  EXPECT_EQ(family_of(host.pid()), before) << "some process was replaced";
  expect_a_whole_server();
}

TEST_F(Neighbours, HealthSaysThatARoleIsDegraded) {
  const auto port = port_of(host.url());
  ASSERT_THAT(wait_for_health(port, R"("status":"ok")"), HasSubstr("200 OK"))
    << "the other roles' workers take a moment to start";
  auto user = host.connect();
  const auto optimizer = [&] {
    const auto workers = value(user->status()).workers;
    return *std::ranges::find(workers, "optimizer", &client::worker_status::role);
  };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  pid_t last = 0;
  for (auto now = optimizer(); now.state != "degraded"; now = optimizer()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    if (now.pid != 0 && static_cast<pid_t>(now.pid) != last)
      ::kill(last = static_cast<pid_t>(now.pid), SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto said = wait_for_health(port, "degraded");
  EXPECT_THAT(said, AllOf(HasSubstr("503 Service Unavailable"),
                          HasSubstr(R"("workers":{"modeling":"ready","optimizer":"degraded")")));
}

}  // namespace
}  // namespace tedit::test
