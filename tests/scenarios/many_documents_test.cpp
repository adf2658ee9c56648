// SPDX-License-Identifier: AGPL-3.0-or-later
// Many open documents: what each costs while nothing is asked of it. A run with figures:
//   TEDIT_DOCUMENTS=500 build/release/bin/scenarios_tests --gtest_filter=ManyDocuments.*
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "base/process.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// `tedit serve` that may have so many files open.
class small_server {
public:
  small_server(const scratch_folder& folder, int descriptors, double close_after_s = 120)
      : ready_(folder.path() / "ready"), token_(folder.path() / "token") {
    const auto config = folder.path() / "config.toml";
    std::ofstream(config) << "[limits]\nclose_unused_after_s = " << close_after_s << "\n";
    const auto command = "ulimit -n " + std::to_string(descriptors) +
                         "; exec " TEDIT_BIN
                         "/tedit serve --quiet --port 0 --device cpu "
                         "--config " +
                         config.string() + " --documents " +
                         (folder.path() / "documents").string() + " --token-file " +
                         token_.string() + " --ready-file " + ready_.string();
    pid_ = value(spawn_process({"/bin/sh", "-c", command}));
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!fs::exists(ready_) && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  small_server(const small_server&) = delete;
  small_server& operator=(const small_server&) = delete;
  ~small_server() { kill_process(pid_); }

  std::unique_ptr<client::client> connect() const {
    client::connect_options options;
    std::ifstream in(ready_);
    options.url = nlohmann::json::parse(in)["url"];
    std::ifstream(token_) >> options.token;
    options.client_name = "test";
    return value(client::client::connect(options, {}));
  }

  /// Entries of a folder of /proc/PID: "fd", "task".
  [[nodiscard]] long count(const char* what) const {
    const auto folder = fs::path("/proc") / std::to_string(pid_) / what;
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  [[nodiscard]] long resident_kib() const {
    std::ifstream in("/proc/" + std::to_string(pid_) + "/status");
    for (std::string word; in >> word;)
      if (word == "VmRSS:") {
        in >> word;
        return std::stol(word);
      }
    return 0;
  }

  void print(const std::string& when) const {
    std::printf("  %-34s %4ld descriptors, %3ld threads, %7ld KiB\n", when.c_str(), count("fd"),
                count("task"), resident_kib());
  }

private:
  fs::path ready_;
  fs::path token_;
  pid_t pid_ = 0;
};

int number(const char* variable, int otherwise) {
  const char* given = std::getenv(variable);
  return given ? std::atoi(given) : otherwise;
}

TEST(ManyDocuments, AnIdleOneHasNoThreadAndNoDescriptor) {
  const scratch_folder folder;
  const small_server host(folder, number("TEDIT_NOFILE", 128));
  const auto user = host.connect();
  value(user->open("first", false, false));
  value(user->import_file(test::cube_mesh, "mm", {}));
  const auto threads = host.count("task");
  const auto descriptors = host.count("fd");
  host.print("1 document");

  const int documents = number("TEDIT_DOCUMENTS", 120);
  for (int i = 1; i < documents; ++i) {
    value(user->open("part-" + std::to_string(i), false, false));
    value(user->import_file(test::cube_mesh, "mm", {}));
  }
  host.print(std::to_string(documents) + " documents, just used");

  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (host.count("fd") > descriptors && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  host.print(std::to_string(documents) + " documents, idle");
  EXPECT_LE(host.count("fd"), descriptors);
  EXPECT_LE(host.count("task"), threads + 1);  // One may be about to end.
  value(user->open("first", false, false));
  EXPECT_EQ(value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {})).head.number, 1U);
  EXPECT_EQ(value(user->undo()).head.number, 0U);
}

// Sessions once lived until the server ended, with all versions of their documents.
TEST(ManyDocuments, ThoseThatNobodyHasOpenAreClosedAndTheirMemoryIsFree) {
  const scratch_folder folder;
  const small_server host(folder, number("TEDIT_NOFILE", 128), 0.5);
  const int documents = number("TEDIT_DOCUMENTS", 120);
  const auto open_all = [&](bool first_time) {
    const auto user = host.connect();
    for (int i = 0; i < documents; ++i) {
      const auto state = value(user->open("part-" + std::to_string(i), false, false));
      if (first_time)
        value(user->import_file(test::cube_mesh, "mm", {}));
      else
        EXPECT_EQ(state.head.value_or(client::version_info()).operation, "import") << i;
    }
  };
  const auto wait_until_closed = [&] {
    const auto user = host.connect();
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (value(user->status()).documents > 0 && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(value(user->status()).documents, 0U);
  };
  open_all(true);
  wait_until_closed();
  host.print(std::to_string(documents) + " documents made and closed");
  [[maybe_unused]] const auto resident = host.resident_kib();
  const auto descriptors = host.count("fd");
  for (int round = 0; round < 3; ++round)
    open_all(false);
  wait_until_closed();
  // The last one is not counted any more while its file is still being closed.
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (host.count("fd") > descriptors && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  host.print("the same three times more");
  EXPECT_LE(host.count("fd"), descriptors);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // They keep what was freed.
  EXPECT_LE(host.resident_kib(), resident + 8 * 1024);
#endif
}

}  // namespace
}  // namespace tedit::test
