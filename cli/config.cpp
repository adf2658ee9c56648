// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/config.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>

// toml++ 3.3 asserts of a file's text what it goes on to check ("[#a]"): bad input must not end the
// program.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

#include "ops/loader/catalogue.hpp"

namespace tedit::cli {

namespace {

constexpr auto manual = "config/tedit.toml explains every option";

/// Puts a value into the options; says what it must be instead when it does not fit.
using setter = std::function<std::string(const toml::node&, server_config&)>;

/// The value as the file would have it.
using shower = std::function<std::string(const server_config&)>;

struct accessor {
  setter set;
  shower show;
};

struct option {
  std::string table;
  std::string key;
  accessor value;
};

std::string quoted(const std::string& text) {
  std::ostringstream out;
  const toml::value<std::string> value(text);
  out << toml::toml_formatter(value, toml::format_flags::none);
  return out.str();
}

/// Empty when a text is fine, else what it must be.
using text_rule = std::string (*)(const std::string&);

accessor text(std::string server_config::*member, text_rule rule) {
  return {[=](const toml::node& given, server_config& config) -> std::string {
            const auto value = given.value_exact<std::string>();
            if (!value)
              return "must be a text";
            config.*member = *value;
            return rule(*value);
          },
          [=](const server_config& config) { return quoted(config.*member); }};
}

std::string number(double value) {
  std::ostringstream out;
  out << std::setprecision(12) << value;
  return out.str();
}

std::string range(double least, double most) {
  return number(least) + " to " + number(most);
}

accessor whole(int server_config::*member, int least, int most) {
  return {[=](const toml::node& given, server_config& config) -> std::string {
            const auto value = given.value_exact<std::int64_t>();
            if (!value)
              return "must be a whole number, " + range(least, most);
            if (*value < least || *value > most)
              return "must be " + range(least, most) + ", not " + std::to_string(*value);
            config.*member = static_cast<int>(*value);
            return {};
          },
          [=](const server_config& config) { return std::to_string(config.*member); }};
}

accessor bytes(std::int64_t server_config::*member) {
  constexpr std::int64_t least = std::int64_t{1} << 20;
  constexpr std::int64_t most = std::int64_t{1} << 50;
  return {[=](const toml::node& given, server_config& config) -> std::string {
            const auto value = given.value_exact<std::int64_t>();
            const auto range = std::to_string(least) + " to " + std::to_string(most);
            if (!value)
              return "must be a whole number of bytes, " + range;
            if (*value < least || *value > most)
              return "must be " + range + " bytes, not " + std::to_string(*value);
            config.*member = *value;
            return {};
          },
          [=](const server_config& config) { return std::to_string(config.*member); }};
}

accessor yes_no(bool server_config::*member) {
  return {[=](const toml::node& given, server_config& config) -> std::string {
            const auto value = given.value_exact<bool>();
            if (!value)
              return "must be true or false";
            config.*member = *value;
            return {};
          },
          [=](const server_config& config) { return config.*member ? "true" : "false"; }};
}

accessor seconds(double server_config::*member) {
  constexpr double least = 0.1;
  constexpr double most = 7 * 24 * 3600;
  return {[=](const toml::node& given, server_config& config) -> std::string {
            if (!given.is_number())
              return "must be a number of seconds, " + range(least, most);
            const double value = given.value<double>().value_or(0);
            if (!(value >= least && value <= most))  // false for nan, too
              return "must be " + range(least, most) + " seconds, not " + number(value);
            config.*member = value;
            return {};
          },
          [=](const server_config& config) { return number(config.*member); }};
}

std::string address_fault(const std::string& text) {
  in6_addr scratch{};
  if (inet_pton(AF_INET, text.c_str(), &scratch) == 1 ||
      inet_pton(AF_INET6, text.c_str(), &scratch) == 1)
    return {};
  return "must be an IPv4 or IPv6 address in numbers such as \"127.0.0.1\", not \"" + text + "\"";
}

std::string path_fault(const std::string& text) {
  if (text.empty() || text.front() == '/')
    return {};
  return "must be an absolute path or empty, not \"" + text + "\"";
}

std::string device_fault(const std::string& text) {
  return text.empty() ? "must be \"auto\", \"cpu\" or part of a device's name" : "";
}

std::string sandbox_fault(const std::string& text) {
  return text == "auto" || text == "on" || text == "off"
           ? ""
           : R"(must be "auto", "on" or "off", not ")" + text + "\"";
}

std::string level_fault(const std::string& text) {
  static const std::vector<std::string> levels{"trace", "debug",    "info", "warning",
                                               "error", "critical", "off"};
  if (std::ranges::find(levels, text) != levels.end())
    return {};
  std::string list;
  for (const auto& level : levels)
    list += (list.empty() ? "\"" : ", \"") + level + "\"";
  const auto near = ops::nearest_name(text, levels);
  return "must be one of " + list + ", not \"" + text + "\"" +
         (near.empty() ? "" : "; did you mean \"" + near + "\"?");
}

/// scheme://host[:port], as a browser sends it.
bool is_origin(const std::string& text) {
  const auto colon = text.find("://");
  if (colon == std::string::npos || colon == 0)
    return false;
  const auto host = text.substr(colon + 3);
  return !host.empty() && host.find_first_of("/?#@* \t") == std::string::npos;
}

/// A name or an address (IPv6 in brackets), and a port when it is another than the server's.
bool is_host(const std::string& text) {
  in6_addr scratch{};
  const auto close = text.find(']');
  const bool v6 = text.starts_with('[') && close != std::string::npos &&
                  inet_pton(AF_INET6, text.substr(1, close - 1).c_str(), &scratch) == 1;
  const auto end = v6 ? close + 1
                      : text.find_first_not_of(
                          "abcdefghijklmnopqrstuvwxyz"
                          "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._");
  if (end == std::string::npos || end == text.size())
    return !text.empty();
  const auto port = text.substr(end + 1);
  return end > 0 && text[end] == ':' && !port.empty() && port.size() <= 5 &&
         port.find_first_not_of("0123456789") == std::string::npos;
}

/// A list of texts that keep a rule; `wanted` says it: "must list ... such as ...".
accessor texts(std::vector<std::string> server_config::*member, bool (*fits)(const std::string&),
               const std::string& wanted) {
  return {[=](const toml::node& given, server_config& config) -> std::string {
            const auto* list = given.as_array();
            if (!list)
              return "must be a list of texts";
            std::vector<std::string> found;
            for (const auto& item : *list) {
              const auto one = item.value_exact<std::string>();
              if (!one)
                return "must list texts only";
              if (!fits(*one))
                return wanted + ", not \"" + *one + "\"";
              found.push_back(*one);
            }
            config.*member = std::move(found);
            return {};
          },
          [=](const server_config& config) {
            std::string list;
            for (const auto& one : config.*member)
              list += (list.empty() ? "" : ", ") + quoted(one);
            return "[" + list + "]";
          }};
}

/// All that a file may hold, in the order of config/tedit.toml.
const std::vector<option>& options() {
  using c = server_config;
  static const std::vector<option> list{
    {"server", "address", text(&c::address, address_fault)},
    {"server", "port", whole(&c::port, 0, 65535)},
    {"server", "allowed_origins",
     texts(&c::allowed_origins, is_origin,
           "must list origins such as \"http://localhost:5173\" (scheme, host and port, no path)")},
    {"server", "allowed_hosts",
     texts(&c::allowed_hosts, is_host,
           "must list hosts such as \"mesh.example.org\" or \"mesh.example.org:8443\"")},
    {"server", "certificates", text(&c::certificates, path_fault)},
    {"server", "unencrypted_behind_proxy", yes_no(&c::unencrypted_behind_proxy)},
    {"server", "token_file", text(&c::token_file, path_fault)},
    {"server", "users_file", text(&c::users_file, path_fault)},
    {"server", "documents", text(&c::documents, path_fault)},
    {"nodes", "certificates", text(&c::node_certificates, path_fault)},
    {"nodes", "address", text(&c::node_address, address_fault)},
    {"nodes", "port", whole(&c::node_port, 0, 65535)},
    {"work", "device", text(&c::device, device_fault)},
    {"work", "modeling_workers", whole(&c::modeling_workers, 0, 64)},
    {"work", "optimizer_workers", whole(&c::optimizer_workers, 0, 64)},
    {"work", "solver_workers", whole(&c::solver_workers, 0, 64)},
    {"work", "cad_jobs", whole(&c::cad_jobs, 0, 64)},
    {"work", "import_jobs", whole(&c::import_jobs, 0, 64)},
    {"work", "sandbox", text(&c::sandbox, sandbox_fault)},
    {"plugins", "safe_mode", yes_no(&c::safe_mode)},
    {"plugins", "quarantine_after", whole(&c::quarantine_after, 0, 1000)},
    {"limits", "edit_timeout_s", seconds(&c::edit_timeout_s)},
    {"limits", "import_timeout_s", seconds(&c::import_timeout_s)},
    {"limits", "solve_timeout_s", seconds(&c::solve_timeout_s)},
    {"limits", "close_unused_after_s", seconds(&c::close_unused_after_s)},
    {"limits", "keep_unnamed_s", seconds(&c::keep_unnamed_s)},
    {"limits", "modeling_memory_mb", whole(&c::modeling_memory_mb, 0, 1 << 24)},
    {"limits", "upload_bytes", bytes(&c::upload_bytes)},
    {"limits", "all_upload_bytes", bytes(&c::all_upload_bytes)},
    {"limits", "result_bytes", bytes(&c::result_bytes)},
    {"limits", "version_bytes", bytes(&c::version_bytes)},
    {"log", "level", text(&c::log_level, level_fault)},
    {"log", "traces", text(&c::traces, path_fault)},
  };
  return list;
}

/// Goes through the tables of one file and stops at the first fault that it meets.
class config_reader {
public:
  explicit config_reader(const std::filesystem::path& file) : file_(file.string()) {}

  expected<server_config> read(const toml::table& root) {
    for (const auto& [name, node] : root) {
      const auto* table = node.as_table();
      if (!is_table(name.str()))
        return fail(unknown_top_level(name, table != nullptr));
      if (!table)
        return fail(fault(node.source(), std::string(name.str()) + " must be a table: [" +
                                           std::string(name.str()) + "]"));
      if (auto ok = read_table(std::string(name.str()), *table); !ok)
        return fail(ok.error());
    }
    return config_;
  }

  [[nodiscard]] const config_origins& origins() const { return origins_; }

  [[nodiscard]] error fault(const toml::source_region& at, std::string message,
                            std::string remedy = manual) const {
    return {ec::bad_input, std::move(message), std::move(remedy),
            file_ + ":" + std::to_string(at.begin.line)};
  }

private:
  static bool is_table(std::string_view name) {
    return std::ranges::any_of(options(), [&](const option& o) { return o.table == name; });
  }

  expected<void> read_table(const std::string& table, const toml::table& body) {
    for (const auto& [key, node] : body) {
      const auto same = [&](const option& o) { return o.table == table && o.key == key.str(); };
      const auto found = std::ranges::find_if(options(), same);
      if (found == options().end())
        return fail(unknown_key(table, key));
      const auto name = table + "." + found->key;
      origins_[name] = file_ + ":" + std::to_string(node.source().begin.line);
      if (const auto wrong = found->value.set(node, config_); !wrong.empty())
        return fail(fault(node.source(), name + " " + wrong));
    }
    return {};
  }

  /// A name that stands in another table is shown with that table.
  static std::optional<std::string> home_of(std::string_view key) {
    const auto found = std::ranges::find(options(), key, &option::key);
    if (found == options().end())
      return std::nullopt;
    return found->key + " belongs under [" + found->table + "]";
  }

  [[nodiscard]] error unknown_key(const std::string& table, const toml::key& key) const {
    const std::string name(key.str());
    std::vector<std::string> known;
    for (const auto& o : options())
      if (o.table == table)
        known.push_back(o.key);
    auto remedy = home_of(name).value_or(suggestion(name, known, "[" + table + "]"));
    return fault(key.source(), "[" + table + "] has no option \"" + name + "\"", remedy);
  }

  [[nodiscard]] error unknown_top_level(const toml::key& key, bool table) const {
    const std::string name(key.str());
    std::vector<std::string> known;
    for (const auto& o : options())
      if (known.empty() || known.back() != o.table)
        known.push_back(o.table);
    if (table)
      return fault(key.source(), "there is no table [" + name + "]",
                   suggestion(name, known, "the file"));
    for (const auto& o : options())
      known.push_back(o.key);
    const auto near = ops::nearest_name(name, known);
    const auto home = home_of(near);
    return fault(key.source(), "there is no option \"" + name + "\" outside the tables",
                 home ? *home : suggestion(name, known, "the file"));
  }

  static std::string suggestion(const std::string& name, const std::vector<std::string>& known,
                                const std::string& place) {
    if (const auto near = ops::nearest_name(name, known); !near.empty())
      return "Did you mean " + near + "?";
    std::string list;
    for (const auto& candidate : known)
      list += (list.empty() ? "" : ", ") + candidate;
    return place + " takes " + list;
  }

  std::string file_;
  server_config config_;
  config_origins origins_;
};

/// The content of a file; nothing when it cannot be read (a folder opens, but does not read).
std::optional<std::string> content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in.is_open() && in.peek() != std::ifstream::traits_type::eof())
    text << in.rdbuf();
  if (!in.is_open() || in.bad() || text.bad() || text.fail())
    return std::nullopt;
  return text.str();
}

/// $variable when it is an absolute path (the XDG rule), else `below` in $HOME; empty without one.
std::filesystem::path xdg_folder(const char* variable, const char* below) {
  if (const char* given = std::getenv(variable); given && *given == '/')
    return given;
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / below;
  return {};
}

expected<std::filesystem::path> state_path(const std::string& given, const char* option_name,
                                           const char* below) {
  if (!given.empty())
    return std::filesystem::path(given);
  const auto state = xdg_folder("XDG_STATE_HOME", ".local/state");
  if (state.empty())
    return fail(ec::invalid_argument, "neither XDG_STATE_HOME nor HOME is set",
                std::string("Set server.") + option_name + " in the configuration");
  return state / "tedit" / below;
}

}  // namespace

expected<server_config> read_config(const std::filesystem::path& file, config_origins* origins) {
  const auto content = content_of(file);
  if (!content)
    return fail(ec::io_error, "cannot read the configuration " + file.string(),
                "Check the path and its permissions");
  config_reader reader(file);
  try {
    auto config = reader.read(toml::parse(*content, file.string()));
    if (config && origins)
      *origins = reader.origins();
    return config;
  } catch (const toml::parse_error& e) {
    return fail(reader.fault(e.source(), "this is no TOML: " + std::string(e.description())));
  }
}

expected<server_config> load_config(const std::optional<std::filesystem::path>& explicit_file,
                                    config_origins* origins) {
  if (explicit_file)
    return read_config(*explicit_file, origins);
  for (const auto& file : config_files()) {
    std::error_code code;  // A place that may not be looked into holds no file.
    if (std::filesystem::exists(file, code))
      return read_config(file, origins);
  }
  return server_config{};
}

std::vector<std::filesystem::path> config_files() {
  std::vector<std::filesystem::path> result;
  if (const auto folder = xdg_folder("XDG_CONFIG_HOME", ".config"); !folder.empty())
    result.push_back(folder / "tedit/config.toml");
  result.emplace_back("/etc/tedit/tedit.toml");
  return result;
}

std::vector<std::string> config_keys() {
  std::vector<std::string> result;
  for (const auto& o : options())
    result.push_back(o.table + "." + o.key);
  return result;
}

std::string config_text(const server_config& config, const std::string& key) {
  for (const auto& o : options())
    if (o.table + "." + o.key == key)
      return o.value.show(config);
  return {};
}

expected<std::filesystem::path> documents_folder(const server_config& config) {
  return state_path(config.documents, "documents", "documents");
}

expected<std::filesystem::path> token_path(const server_config& config) {
  return state_path(config.token_file, "token_file", "token");
}

expected<std::filesystem::path> users_path(const server_config& config) {
  if (!config.users_file.empty())
    return std::filesystem::path(config.users_file);
  return token_path(config).map(
    [](const std::filesystem::path& token) { return token.parent_path() / "users.sqlite"; });
}

}  // namespace tedit::cli
