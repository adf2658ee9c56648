// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/config.hpp"

#include <cstdlib>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

const std::filesystem::path shipped = TEDIT_SOURCE_DIR "/config/tedit.toml";

/// A folder of its own for each test; variables that a test sets are put back.
class Config : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / "tedit_config" / test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void TearDown() override {
    for (const auto& [name, value] : saved_)
      value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    std::filesystem::remove_all(folder_);
  }

  void set_variable(const std::string& name, const std::optional<std::string>& value) {
    const char* old = std::getenv(name.c_str());
    saved_.try_emplace(name, old ? std::optional<std::string>(old) : std::nullopt);
    value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    const auto file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file;
  }

  /// The error of a file with this text; its place must be the given line.
  error error_of(const std::string& text, int line) {
    const auto file = write("wrong.toml", text);
    const auto config = read_config(file);
    EXPECT_FALSE(config.has_value()) << text;
    if (config)
      return {};
    EXPECT_EQ(config.error().code, ec::bad_input) << text;
    EXPECT_EQ(config.error().where, file.string() + ":" + std::to_string(line)) << text;
    return config.error();
  }

  std::filesystem::path folder_;
  std::map<std::string, std::optional<std::string>> saved_;
};

TEST_F(Config, TheShippedFileHoldsExactlyTheDefaults) {
  const auto config = read_config(shipped);

  ASSERT_TRUE(config.has_value()) << render(config.error());
  EXPECT_EQ(*config, server_config{});
}

TEST_F(Config, TheShippedFileNamesEveryOption) {
  std::ifstream in(shipped);
  std::string table;
  std::vector<std::string> found;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("["))
      table = line.substr(1, line.find(']') - 1);
    else if (!line.empty() && !line.starts_with("#"))
      found.push_back(table + "." + line.substr(0, line.find(' ')));
  }

  EXPECT_EQ(found, config_keys());
}

TEST_F(Config, AnEmptyFileMeansTheDefaults) {
  const auto config = read_config(write("empty.toml", ""));

  ASSERT_TRUE(config.has_value()) << render(config.error());
  EXPECT_EQ(*config, server_config{});
}

TEST_F(Config, EveryOptionIsRead) {
  const auto config = read_config(write("full.toml", R"([server]
address = "::1"
port = 0
allowed_origins = ["http://localhost:5173", "https://cad.example"]
allowed_hosts = ["mesh.example.org", "10.0.0.7:8443", "[fd00::7]", "[fd00::7]:1"]
certificates = "/etc/tedit/hall"
unencrypted_behind_proxy = true
token_file = "/run/tedit/token"
users_file = "/run/tedit/users"
documents = "/srv/tedit"
[nodes]
certificates = "/etc/tedit/hall"
address = "0.0.0.0"
port = 0
[work]
device = "H200"
modeling_workers = 2
optimizer_workers = 3
solver_workers = 64
cad_jobs = 0
import_jobs = 7
sandbox = "off"
[limits]
edit_timeout_s = 0.5
import_timeout_s = 60
solve_timeout_s = 604800
close_unused_after_s = 9.5
keep_unnamed_s = 60.5
upload_bytes = 1048576
all_upload_bytes = 17179869184
result_bytes = 2097152
version_bytes = 3145728
[log]
level = "debug"
)"));

  ASSERT_TRUE(config.has_value()) << render(config.error());
  EXPECT_EQ(config->address, "::1");
  EXPECT_EQ(config->port, 0);
  EXPECT_THAT(config->allowed_origins, ElementsAre("http://localhost:5173", "https://cad.example"));
  EXPECT_THAT(config->allowed_hosts,
              ElementsAre("mesh.example.org", "10.0.0.7:8443", "[fd00::7]", "[fd00::7]:1"));
  EXPECT_EQ(config->certificates, "/etc/tedit/hall");
  EXPECT_TRUE(config->unencrypted_behind_proxy);
  EXPECT_EQ(config->token_file, "/run/tedit/token");
  EXPECT_EQ(users_path(*config), std::filesystem::path("/run/tedit/users"));
  EXPECT_EQ(config->documents, "/srv/tedit");
  EXPECT_EQ(config->node_certificates, "/etc/tedit/hall");
  EXPECT_EQ(config->node_address, "0.0.0.0");
  EXPECT_EQ(config->node_port, 0);
  EXPECT_EQ(config->device, "H200");
  EXPECT_EQ(config->modeling_workers, 2);
  EXPECT_EQ(config->optimizer_workers, 3);
  EXPECT_EQ(config->solver_workers, 64);
  EXPECT_EQ(config->cad_jobs, 0);
  EXPECT_EQ(config->import_jobs, 7);
  EXPECT_EQ(config->sandbox, "off");
  EXPECT_EQ(config->edit_timeout_s, 0.5);
  EXPECT_EQ(config->import_timeout_s, 60);
  EXPECT_EQ(config->solve_timeout_s, 604800);
  EXPECT_EQ(config->close_unused_after_s, 9.5);
  EXPECT_EQ(config->keep_unnamed_s, 60.5);
  EXPECT_EQ(config->upload_bytes, 1 << 20);
  EXPECT_EQ(config->all_upload_bytes, std::int64_t{16} << 30);
  EXPECT_EQ(config->result_bytes, 2 << 20);
  EXPECT_EQ(config->version_bytes, 3 << 20);
  EXPECT_EQ(config->log_level, "debug");
}

TEST_F(Config, AnUnknownOptionNamesTheNearest) {
  const auto e = error_of("[server]\nport = 1\nadress = \"::1\"\n", 3);

  EXPECT_THAT(e.message, HasSubstr("[server] has no option \"adress\""));
  EXPECT_EQ(e.remedy, "Did you mean address?");
}

TEST_F(Config, AnOptionLikeNoOtherListsAll) {
  const auto e = error_of("[log]\nxyzxyzxyz = 1\n", 2);

  EXPECT_EQ(e.remedy, "[log] takes level, traces");
}

TEST_F(Config, AnOptionInTheWrongTableIsSentHome) {
  EXPECT_EQ(error_of("[work]\nport = 1\n", 2).remedy, "port belongs under [server]");
  EXPECT_EQ(error_of("\nport = 1\n", 2).remedy, "port belongs under [server]");
  EXPECT_EQ(error_of("devise = \"cpu\"\n", 1).remedy, "device belongs under [work]");
}

TEST_F(Config, AnUnknownTableNamesTheNearest) {
  const auto e = error_of("[log]\nlevel = \"info\"\n\n[limit]\nedit_timeout_s = 1\n", 4);

  EXPECT_THAT(e.message, HasSubstr("[limit]"));
  EXPECT_EQ(e.remedy, "Did you mean limits?");
}

TEST_F(Config, ATableMustBeOne) {
  EXPECT_THAT(error_of("server = 3\n", 1).message, HasSubstr("must be a table: [server]"));
  EXPECT_THAT(error_of("[[log]]\nlevel = \"off\"\n", 1).message, HasSubstr("must be a table"));
}

TEST_F(Config, AValueOfTheWrongTypeIsNamed) {
  const auto message = [&](const std::string& table, const std::string& line) {
    return error_of("[" + table + "]\n" + line + "\n", 2).message;
  };

  EXPECT_EQ(message("server", "address = 1"), "server.address must be a text");
  EXPECT_EQ(message("server", "port = \"7464\""), "server.port must be a whole number, 0 to 65535");
  EXPECT_THAT(message("server", "port = 7464.0"), HasSubstr("whole number"));
  EXPECT_THAT(message("server", "allowed_origins = \"http://a\""), HasSubstr("list of texts"));
  EXPECT_THAT(message("server", "allowed_origins = [1]"), HasSubstr("texts only"));
  EXPECT_THAT(message("work", "solver_workers = true"), HasSubstr("whole number, 0 to 64"));
  EXPECT_THAT(message("limits", "edit_timeout_s = \"2 min\""), HasSubstr("number of seconds"));
  EXPECT_THAT(message("limits", "upload_bytes = \"2 GiB\""), HasSubstr("whole number of bytes"));
  EXPECT_EQ(message("log", "level = 3"), "log.level must be a text");
}

TEST_F(Config, AValueOutOfRangeIsNamed) {
  const auto message = [&](const std::string& table, const std::string& line) {
    return error_of("[" + table + "]\n" + line + "\n", 2).message;
  };

  EXPECT_EQ(message("server", "port = 65536"), "server.port must be 0 to 65535, not 65536");
  EXPECT_THAT(message("server", "port = -1"), EndsWith("not -1"));
  EXPECT_THAT(message("server", "address = \"here\""), HasSubstr("IPv4 or IPv6"));
  EXPECT_THAT(message("server", "documents = \"~/parts\""), HasSubstr("absolute path"));
  EXPECT_THAT(message("server", "token_file = \"token\""), HasSubstr("absolute path"));
  EXPECT_THAT(message("server", "allowed_origins = [\"*\"]"), HasSubstr("origins"));
  EXPECT_THAT(message("server", "allowed_origins = [\"http://a/\"]"), HasSubstr("no path"));
  for (const auto* host : {"", "*.example.org", "https://a", "a/", "a:", "a:b", ":1", "[fd00::g]"})
    EXPECT_THAT(message("server", "allowed_hosts = [\"" + std::string(host) + "\"]"),
                HasSubstr("must list hosts"))
      << host;
  EXPECT_THAT(message("server", "certificates = \"hall\""), HasSubstr("absolute path"));
  EXPECT_EQ(message("server", "unencrypted_behind_proxy = 1"),
            "server.unencrypted_behind_proxy must be true or false");
  EXPECT_EQ(message("nodes", "port = 70000"), "nodes.port must be 0 to 65535, not 70000");
  EXPECT_THAT(message("nodes", "address = \"rack\""), HasSubstr("IPv4 or IPv6"));
  EXPECT_THAT(message("nodes", "certificates = \"hall\""), HasSubstr("absolute path"));
  EXPECT_THAT(message("work", "device = \"\""), HasSubstr("work.device must be"));
  EXPECT_EQ(message("work", "modeling_workers = 65"),
            "work.modeling_workers must be 0 to 64, not 65");
  EXPECT_EQ(message("work", "sandbox = \"maybe\""),
            "work.sandbox must be \"auto\", \"on\" or \"off\", not \"maybe\"");
  EXPECT_EQ(message("limits", "solve_timeout_s = 0"),
            "limits.solve_timeout_s must be 0.1 to 604800 seconds, not 0");
  EXPECT_THAT(message("limits", "all_upload_bytes = 1000"), HasSubstr("must be 1048576 to"));
  EXPECT_THAT(message("limits", "solve_timeout_s = nan"), HasSubstr("0.1 to 604800"));
  EXPECT_THAT(message("limits", "solve_timeout_s = inf"), HasSubstr("0.1 to 604800"));
  EXPECT_THAT(message("log", "level = \"warnign\""), HasSubstr("did you mean \"warning\"?"));
}

TEST_F(Config, BadTomlIsNamedWithItsLine) {
  EXPECT_THAT(error_of("[server]\nport = \n", 2).message, HasSubstr("this is no TOML"));
  EXPECT_THAT(error_of("[log]\nlevel = \"info\"\nlevel = \"off\"\n", 3).message,
              HasSubstr("this is no TOML"));
}

TEST_F(Config, AFileThatCannotBeReadIsAnError) {
  for (const auto& file : {folder_ / "none.toml", folder_}) {
    const auto config = read_config(file);

    ASSERT_FALSE(config.has_value());
    EXPECT_EQ(config.error().code, ec::io_error);
    EXPECT_THAT(config.error().message, HasSubstr(file.string()));
  }
}

TEST_F(Config, AnExplicitFileGoesBeforeTheUsersOwn) {
  write("home/tedit/config.toml", "[server]\nport = 1\n");
  const auto given = write("given.toml", "[server]\nport = 2\n");
  set_variable("XDG_CONFIG_HOME", (folder_ / "home").string());

  EXPECT_EQ(load_config(given)->port, 2);
  EXPECT_EQ(load_config(std::nullopt)->port, 1);
}

TEST_F(Config, AnExplicitFileMustBeThere) {
  write("home/tedit/config.toml", "[server]\nport = 1\n");
  set_variable("XDG_CONFIG_HOME", (folder_ / "home").string());

  const auto config = load_config(folder_ / "none.toml");

  ASSERT_FALSE(config.has_value());
  EXPECT_EQ(config.error().code, ec::io_error);
}

TEST_F(Config, AFaultInTheUsersOwnFileIsNotPassedOver) {
  write("home/tedit/config.toml", "[server]\nport = true\n");
  set_variable("XDG_CONFIG_HOME", (folder_ / "home").string());

  EXPECT_FALSE(load_config(std::nullopt).has_value());
}

TEST_F(Config, WithoutAFileTheDefaultsHold) {
  if (std::filesystem::exists("/etc/tedit/tedit.toml"))
    GTEST_SKIP() << "this machine has /etc/tedit/tedit.toml";
  set_variable("XDG_CONFIG_HOME", folder_.string());

  const auto config = load_config(std::nullopt);

  ASSERT_TRUE(config.has_value()) << render(config.error());
  EXPECT_EQ(*config, server_config{});
}

TEST_F(Config, TheUsersFileIsLookedForBeforeTheSystems) {
  set_variable("HOME", "/home/ada");
  set_variable("XDG_CONFIG_HOME", "/conf");
  EXPECT_THAT(config_files(), ElementsAre("/conf/tedit/config.toml", "/etc/tedit/tedit.toml"));

  // The XDG rule: a variable without an absolute path counts as not set.
  for (const auto& unset : {std::optional<std::string>("conf"), std::optional<std::string>("")}) {
    set_variable("XDG_CONFIG_HOME", unset);
    EXPECT_EQ(config_files().front(), "/home/ada/.config/tedit/config.toml");
  }
  set_variable("XDG_CONFIG_HOME", std::nullopt);
  EXPECT_EQ(config_files().front(), "/home/ada/.config/tedit/config.toml");
  set_variable("HOME", std::nullopt);
  EXPECT_THAT(config_files(), ElementsAre("/etc/tedit/tedit.toml"));
}

TEST_F(Config, DocumentsAndTokenLieInTheStateFolderUnlessNamed) {
  set_variable("HOME", "/home/ada");
  set_variable("XDG_STATE_HOME", "/state");
  EXPECT_EQ(*documents_folder({}), "/state/tedit/documents");
  EXPECT_EQ(*token_path({}), "/state/tedit/token");

  set_variable("XDG_STATE_HOME", std::nullopt);
  EXPECT_EQ(*documents_folder({}), "/home/ada/.local/state/tedit/documents");
  EXPECT_EQ(*token_path({}), "/home/ada/.local/state/tedit/token");

  server_config named;
  named.documents = "/srv/tedit";
  named.token_file = "/run/token";
  EXPECT_EQ(*documents_folder(named), "/srv/tedit");
  EXPECT_EQ(*token_path(named), "/run/token");
}

TEST_F(Config, WithoutAHomeTheOptionToSetIsNamed) {
  set_variable("HOME", std::nullopt);
  set_variable("XDG_STATE_HOME", std::nullopt);

  const auto documents = documents_folder({});

  ASSERT_FALSE(documents.has_value());
  EXPECT_THAT(documents.error().remedy, HasSubstr("server.documents"));
}

TEST_F(Config, ItsTextReadsBackAsTheSameConfiguration) {
  const auto file = write("some.toml",
                          "[server]\nallowed_hosts = [\"a.example:1\", \"[::1]\"]\n"
                          "[work]\ndevice = 'a \"quoted\" name'\n"
                          "[limits]\nedit_timeout_s = 0.25\nupload_bytes = 1048577\n"
                          "[plugins]\nsafe_mode = true\n");
  const auto config = read_config(file);
  ASSERT_TRUE(config) << render(config.error());
  std::string again;
  for (const auto& key : config_keys()) {
    again += key + " = " + config_text(*config, key) + "\n";
  }
  const auto read = read_config(write("again.toml", again));
  ASSERT_TRUE(read) << render(read.error()) << again;
  EXPECT_EQ(*read, *config);
  EXPECT_EQ(config_text(*config, "server.prot"), "");
}

TEST_F(Config, SaysWhereEachValueStands) {
  const auto file =
    write("some.toml", "# a comment\n[server]\nport = 1\n\n[log]\nlevel = \"off\"\n");
  config_origins origins;
  ASSERT_TRUE(load_config(file, &origins));
  EXPECT_THAT(origins, ElementsAre(std::pair(std::string("log.level"), file.string() + ":6"),
                                   std::pair(std::string("server.port"), file.string() + ":3")));
}

}  // namespace
}  // namespace tedit::cli
