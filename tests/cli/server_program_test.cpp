// SPDX-License-Identifier: AGPL-3.0-or-later
// What stands in the way of a server: `tedit doctor` finds it, `tedit serve` refuses to start.
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <thread>
#include <utility>

#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// A folder with a good configuration, token and documents, for each test anew.
class ServerProgram : public ::testing::Test {
protected:
  void SetUp() override {
    auto name = (fs::temp_directory_path() / "tedit-server-XXXXXX").string();
    folder = mkdtemp(name.data());
    fs::create_directory(documents());
    std::ofstream(token()) << std::string(64, 'a') << "\n";
    fs::permissions(token(), fs::perms::owner_read | fs::perms::owner_write);
    write_config();
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path documents() const { return folder / "documents"; }
  fs::path token() const { return folder / "token"; }
  fs::path config() const { return folder / "config.toml"; }

  void write_config(const std::string& more = {}, int port = 0) const {
    std::ofstream(config()) << "[server]\nport = " << port << "\ndocuments = \""
                            << documents().string() << "\"\ntoken_file = \"" << token().string()
                            << "\"\n"
                            << more;
  }

  /// The row of a check; empty when there is none.
  static json row(const outcome& result, const std::string& name) {
    const auto all = result.parsed();
    for (const auto& one : all["checks"])
      if (one["name"] == name)
        return one;
    return json::object();
  }

  /// The doctor finds this wrong, and that alone, of what concerns the server.
  void expect_fault(const std::string& name, const std::string& words) const {
    const auto result = run("doctor --json --config " + config().string());
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_FALSE(result.parsed()["ok"].get<bool>());
    const auto found = row(result, name);
    ASSERT_FALSE(found.empty()) << result.out;
    EXPECT_FALSE(found["ok"].get<bool>());
    EXPECT_THAT(found["text"].get<std::string>(), HasSubstr(words));
    for (const char* other : {"configuration", "documents", "token", "port"})
      EXPECT_TRUE(other == name || row(result, other).value("ok", true)) << row(result, other);
  }

  fs::path folder;
};

/// A port that somebody listens on; says nothing to who connects.
class taken_port {
public:
  taken_port() : handle_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    EXPECT_EQ(::bind(handle_, reinterpret_cast<sockaddr*>(&at), size), 0);
    EXPECT_EQ(::listen(handle_, 4), 0);
    EXPECT_EQ(::getsockname(handle_, reinterpret_cast<sockaddr*>(&at), &size), 0);
    number = ntohs(at.sin_port);
  }
  taken_port(const taken_port&) = delete;
  taken_port& operator=(const taken_port&) = delete;
  ~taken_port() { ::close(handle_); }

  int number = 0;

private:
  int handle_;
};

TEST_F(ServerProgram, TheDoctorIsContentWithAGoodConfigurationAndChangesNothing) {
  const auto result = run("doctor --json --config " + config().string());

  for (const char* name : {"configuration", "documents", "token", "port"})
    EXPECT_TRUE(row(result, name)["ok"].get<bool>()) << row(result, name);
  EXPECT_TRUE(fs::is_empty(documents()));
  fs::remove(documents());
  fs::remove(token());
  const auto fresh = run("doctor --json --config " + config().string());
  EXPECT_THAT(row(fresh, "documents")["text"].get<std::string>(), HasSubstr("made when"));
  EXPECT_THAT(row(fresh, "token")["text"].get<std::string>(), HasSubstr("made when"));
  EXPECT_FALSE(fs::exists(documents()));
  EXPECT_FALSE(fs::exists(token()));
}

TEST_F(ServerProgram, TheDoctorFindsAWrongConfiguration) {
  std::ofstream(config()) << "@%&? rubbish";
  expect_fault("configuration", "no TOML");
  write_config("documnets = \"/tmp\"\n");
  expect_fault("configuration", "Did you mean documents?");
  fs::remove(config());
  expect_fault("configuration", "cannot read");
}

TEST_F(ServerProgram, TheDoctorFindsAFolderThatCannotBeUsed) {
  fs::remove(documents());
  std::ofstream(documents()) << "a file in its place";
  expect_fault("documents", "is no folder");
}

TEST_F(ServerProgram, TheDoctorFindsATokenThatOthersMayReadOrThatIsNone) {
  fs::permissions(token(), fs::perms::others_read, fs::perm_options::add);
  expect_fault("token", "others may read");
  fs::permissions(token(), fs::perms::owner_read | fs::perms::owner_write);
  std::ofstream(token()) << "short";
  expect_fault("token", "too short");
}

TEST_F(ServerProgram, TheDoctorFindsAPortThatIsTaken) {
  const taken_port port;
  write_config({}, port.number);
  expect_fault("port", "in use by another program");
}

/// The port is taken: a server that does not mind the folder fails there and does not stay.
TEST_F(ServerProgram, AServerDoesNotStartWithAFolderThatItCannotWrite) {
  const taken_port port;
  const auto serve = [&](const fs::path& where) {
    return run("serve --json --in-process --config " + config().string() + " --port " +
               std::to_string(port.number) + " --documents " + where.string());
  };
  EXPECT_EQ(serve(documents()).parsed()["error"]["code"], "service_unavailable");
  std::ofstream(folder / "file") << "x";
  for (const fs::path& place : {folder / "file", folder / "file/below", fs::path("/proc")}) {
    const auto result = serve(place);
    const auto e = result.parsed()["error"];
    EXPECT_EQ(result.status, 65) << place;
    EXPECT_EQ(e["code"], "io_error") << place;
    EXPECT_THAT(e["remedy"].get<std::string>(), HasSubstr("--documents")) << place;
  }
}

/// Programs that root starts from here on may write only where a folder's mode lets them.
bool respects_modes() {
  return ::geteuid() != 0 || ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) == 0;
}

TEST_F(ServerProgram, AServerDoesNotStartWithAFolderThatItMayNotWrite) {
  ASSERT_TRUE(respects_modes());
  const taken_port port;
  fs::permissions(documents(), fs::perms::owner_read | fs::perms::owner_exec);
  const auto result = run("serve --json --in-process --config " + config().string() + " --port " +
                          std::to_string(port.number));
  EXPECT_EQ(result.parsed()["error"]["code"], "io_error");
  EXPECT_THAT(result.parsed()["error"]["message"].get<std::string>(),
              HasSubstr("Permission denied"));
  expect_fault("documents", "Permission denied");
  fs::permissions(documents(), fs::perms::owner_all);
}

/// As on a kernel, or in a container, that has no Landlock.
outcome run_without_landlock(const fs::path& folder, const std::string& arguments) {
  const auto answer = folder / "answer";
  const pid_t child = fork();
  if (child == 0) {
    std::array<sock_filter, 4> steps{
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_landlock_create_ruleset, 0, 1),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
    const sock_fprog rules{steps.size(), steps.data()};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &rules);
    const auto result = run(arguments);
    std::ofstream(answer) << result.out;
    _exit(result.status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  std::ifstream in(answer);
  return {WEXITSTATUS(status), {std::istreambuf_iterator<char>(in), {}}};
}

TEST_F(ServerProgram, WhereWorkersCannotBeConfinedAPersonDecides) {
  const auto with_config = " --json --config " + config().string();
  const auto warned = run_without_landlock(folder, "doctor" + with_config);
  EXPECT_TRUE(row(warned, "sandbox").value("ok", false)) << warned.out;
  EXPECT_THAT(row(warned, "sandbox").value("text", ""),
              HasSubstr("the server starts with plugins that are not confined: "));

  write_config("[work]\nsandbox = \"on\"\n");
  const auto refused = run_without_landlock(folder, "serve" + with_config);
  EXPECT_EQ(refused.status, 69);
  const auto e = refused.parsed()["error"];
  EXPECT_THAT(e.value("message", ""), HasSubstr("workers cannot be confined here: this kernel, or "
                                                "the container, has no Landlock"));
  EXPECT_THAT(e.value("remedy", ""), HasSubstr("sandbox = \"off\" under [work]"));
  const auto doctor = run_without_landlock(folder, "doctor" + with_config);
  EXPECT_FALSE(row(doctor, "sandbox").value("ok", true)) << doctor.out;

  write_config("[work]\nsandbox = \"off\"\n");
  const auto off = run_without_landlock(folder, "doctor" + with_config);
  EXPECT_TRUE(row(off, "sandbox").value("ok", false)) << off.out;
  EXPECT_THAT(row(off, "sandbox").value("text", ""), HasSubstr("off (work.sandbox)"));
}

TEST_F(ServerProgram, AnEditThatMustBeConfinedAndCannotIsNotBegun) {
  const std::string edit = "edit --json " TEDIT_EXAMPLES
                           "/ctc01_plate/ctc01_plate.coarse.msh --op fill_hole --surfaces 1,2";
  setenv("TEDIT_SANDBOX", "on", 1);
  const auto refused = run_without_landlock(folder, edit);
  EXPECT_EQ(refused.status, 69);
  EXPECT_THAT(refused.parsed()["error"].value("message", ""), HasSubstr("cannot be confined"));

  unsetenv("TEDIT_SANDBOX");
  EXPECT_EQ(run_without_landlock(folder, edit).status, 0);
}

/// A server of that configuration, ready.
class ready_server {
public:
  /// @param mode an option that it gets.
  ready_server(const fs::path& folder, const fs::path& config, const char* mode = "--in-process")
      : ready_(folder / "ready.json") {
    child_ = fork();
    if (child_ == 0) {
      (void)freopen("/dev/null", "w", stdout);
      (void)freopen("/dev/null", "w", stderr);
      execl(program.c_str(), "tedit", "serve", mode, "--config", config.c_str(), "--ready-file",
            ready_.c_str(), nullptr);
      _exit(127);
    }
    for (int i = 0; i < 6000 && !fs::exists(ready_); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ready_server(const ready_server&) = delete;
  ready_server& operator=(const ready_server&) = delete;
  ~ready_server() {
    if (child_ > 0)
      end(1);
  }

  [[nodiscard]] std::string url() const { return state().value("url", ""); }
  [[nodiscard]] json state() const {
    std::ifstream in(ready_);
    return json::parse(in, nullptr, false);
  }

  /// Its status after so many signals at once.
  int end(int signals) {
    for (int i = 0; i < signals; ++i)
      kill(child_, SIGTERM);
    int status = 0;
    waitpid(std::exchange(child_, -1), &status, 0);
    return status;
  }

private:
  fs::path ready_;
  pid_t child_ = -1;
};

/// As timeout(1) does it: the process, then its group.
TEST_F(ServerProgram, TwoSignalsAtOnceEndItAsOneDoes) {
  ready_server server(folder, config());
  ASSERT_NE(server.url(), "");
  const int status = server.end(2);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST_F(ServerProgram, TheServiceManagerHearsWhenItIsReadyAndWhenItStops) {
  const auto place = (folder / "notices").string();
  const int heard = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  place.copy(at.sun_path, sizeof(at.sun_path) - 1);
  ASSERT_EQ(::bind(heard, reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  const timeval patience{60, 0};
  ::setsockopt(heard, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  const auto next = [&] {
    std::array<char, 64> text{};
    const auto size = ::recv(heard, text.data(), text.size(), 0);
    return std::string(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  };
  setenv("NOTIFY_SOCKET", place.c_str(), 1);
  ready_server server(folder, config());
  unsetenv("NOTIFY_SOCKET");
  EXPECT_EQ(next(), "READY=1");
  server.end(1);
  EXPECT_EQ(next(), "STOPPING=1");
  ::close(heard);
}

TEST_F(ServerProgram, TheStatusSaysHowItIsAndWhatTakesUpItsMemory) {
  write_config("[limits]\nresult_bytes = 2097152\n");
  const ready_server server(folder, config());
  const auto arguments = " --token-file " + token().string() + " --server " + server.url();
  const auto said = run("status --json" + arguments);
  const auto all = said.parsed();
  ASSERT_EQ(said.status, 0) << said.out;
  EXPECT_EQ(all["documents"], 0);
  EXPECT_EQ(all["connections"], 1);
  ASSERT_EQ(all["workers"].size(), 3U);
  std::vector<std::string> kinds;
  for (const auto& row : all["memory"])
    kinds.push_back(row["what"]);
  EXPECT_EQ(kinds, (std::vector<std::string>{"documents", "recent pages", "versions", "results",
                                             "uploads"}));
  EXPECT_EQ(all["memory"][3]["budget_bytes"], 2097152);
  EXPECT_THAT(run("status" + arguments).out, HasSubstr("results       0.0 MiB of 2.0 MiB"));
}

TEST_F(ServerProgram, TheStatusOfAServerThatIsNotThereSaysHowToStartOne) {
  const auto said =
    run("status --json --server ws://127.0.0.1:1/v1 --token-file " + token().string());
  EXPECT_EQ(said.status, 69);
  EXPECT_NE(said.parsed()["error"]["remedy"], "") << said.out;
}

TEST_F(ServerProgram, ConfigShowSaysWhereEachValueComesFrom) {
  write_config("[limits]\nedit_timeout_s = 7\n");
  const auto result =
    run("config show --json --origin --port 9 --safe-mode --config " + config().string());
  ASSERT_EQ(result.status, 0) << result.out;
  std::map<std::string, std::pair<std::string, std::string>> found;
  const auto parsed = result.parsed();
  for (const auto& one : parsed["options"])
    found[one["option"]] = {one["value"], one["from"]};
  using shown = std::pair<std::string, std::string>;
  EXPECT_EQ(found["server.port"], shown("9", "--port"));
  EXPECT_EQ(found["plugins.safe_mode"], shown("true", "--safe-mode"));
  EXPECT_EQ(found["limits.edit_timeout_s"], shown("7", config().string() + ":6"));
  EXPECT_EQ(found["server.token_file"],
            shown("\"" + token().string() + "\"", config().string() + ":4"));
  EXPECT_EQ(found["log.level"], shown("\"info\"", "default"));
  EXPECT_EQ(found["server.users_file"].second, "beside server.token_file");
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr(std::string(64, 'a')))) << "the token's text";
}

TEST_F(ServerProgram, ConfigShowPrintsAFileThatServeWouldTake) {
  const auto shown = run("config show --port 0 --config " + config().string());
  ASSERT_EQ(shown.status, 0) << shown.out;
  std::ofstream(folder / "shown.toml") << shown.out;
  const auto again = run("config show --config " + (folder / "shown.toml").string());
  EXPECT_EQ(again.out, shown.out);
}

TEST_F(ServerProgram, TheDoctorLooksAtThePortForNodes) {
  const auto ca = (folder / "ca").string();
  const auto hall = (folder / "hall").string();
  ASSERT_EQ(run("certs init " + ca).status, 0);
  ASSERT_EQ(run("certs issue " + ca + " --role server --name hall -o " + hall).status, 0);
  write_config("[nodes]\ncertificates = \"" + hall + "\"\nport = 0\n");
  const auto good = run("doctor --json --config " + config().string());
  EXPECT_TRUE(row(good, "nodes").value("ok", false)) << good.out;
  EXPECT_THAT(row(good, "nodes")["text"].get<std::string>(), HasSubstr("hall of TEdit"));
  EXPECT_THAT(row(good, "revoked certificates")["text"].get<std::string>(), HasSubstr("number 1"));
  EXPECT_TRUE(row(good, "clock").value("ok", false)) << good.out;
  fs::remove(fs::path(hall) / "crl.pem");
  expect_fault("nodes", "crl.pem");
}

TEST_F(ServerProgram, TheDoctorGoesAWorkersWayToItsServer) {
  const auto at = [&](const std::string& name) { return (folder / name).string(); };
  ASSERT_EQ(run("certs init " + at("ca")).status, 0);
  for (const auto& [name, role] : {std::pair<std::string, std::string>("hall", "server"),
                                   {"rack", "solver"},
                                   {"pat", "client"}})
    ASSERT_EQ(run("certs issue " + at("ca") + " --role " + role + " --name " + name +
                  " --host 127.0.0.1 -o " + at(name))
                .status,
              0);
  write_config("[nodes]\ncertificates = \"" + at("hall") + "\"\nport = 0\n" +
               "[work]\nsolver_workers = 0\nmodeling_workers = 0\noptimizer_workers = 0\n");
  // With workers in its own process it takes none of other machines.
  const ready_server server(folder, config(), "--safe-mode");
  const auto place = "127.0.0.1:" + std::to_string(server.state().value("node_port", 0));
  const auto good = run("doctor --json --join " + place + " --certificates " + at("rack"));
  for (const char* name : {"certificate", "server", "version", "clocks"})
    EXPECT_TRUE(row(good, name).value("ok", false)) << name << good.out;
  EXPECT_THAT(row(good, "clocks")["text"].get<std::string>(), HasSubstr("less than a second"));
  EXPECT_TRUE(row(good, "token").empty()) << "what a server needs is not asked of a worker";
  const auto stranger = run("doctor --json --join " + place + " --certificates " + at("pat"));
  EXPECT_EQ(stranger.status, 1);
  EXPECT_THAT(row(stranger, "server")["text"].get<std::string>(), HasSubstr("role"));
  const auto none = run("doctor --json --join 127.0.0.1:1 --certificates " + at("rack"));
  EXPECT_FALSE(row(none, "server").value("ok", true)) << none.out;
}

}  // namespace
}  // namespace tedit::test
