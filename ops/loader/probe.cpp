// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cxxabi.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <span>
#include <utility>

#include "base/child_process.hpp"
#include "base/hash.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::ops {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds probe_limit{10000};
constexpr std::size_t probe_memory = std::size_t{4} << 30;
constexpr std::string_view fine = "ok";

/// Empty where it is no file, or cannot be read.
std::string content_of(const fs::path& file) {
  std::error_code code;
  const auto size = fs::file_size(file, code);
  if (code)
    return {};
  std::string content(size, '\0');
  std::ifstream in(file, std::ios::binary);
  return in.read(content.data(), static_cast<std::streamsize>(size)) ? content : std::string();
}

/// Appears whole or not at all: other workers may ask at the same time.
void keep(const fs::path& cache, const std::string& verdict) {
  std::error_code code;
  fs::create_directories(cache.parent_path(), code);
  const fs::path draft = cache.string() + "." + std::to_string(getpid());
  std::ofstream(draft) << verdict;
  fs::rename(draft, cache, code);
  if (code)
    fs::remove(draft, code);  // A cache that cannot be written costs time only.
}

std::string demangled(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
    abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && text ? text.get() : symbol;
}

/// Has it loaded by another process. Where there is a cache, what came of it is kept.
plugin_report try_out(const fs::path& file, const fs::path& cache) {
  const auto said = run_child({helper_program("tedit-probe").string(), file.string()}, {},
                              {probe_limit, probe_memory, most_report_bytes}, {});
  if (said) {
    auto report = report_from_bytes(std::as_bytes(std::span(*said)));
    if (!report)
      return {"it breaks the process that loads it: tedit-probe " + report.error().message, {}};
    if (report->refusal.empty() && !cache.empty())
      keep(cache, std::string(fine));
    return std::move(*report);
  }
  const auto& e = said.error();
  if (e.code == ec::service_unavailable)
    return {"it could not be tried out: " + e.message, {}};
  auto verdict = e.code == ec::timeout ? "it hangs while it is loaded (tried for " +
                                           std::to_string(probe_limit.count() / 1000) + " s)"
                                       : "it breaks the process that loads it: " + e.message;
  if (cache.empty())
    return {std::move(verdict), {}};
  verdict += "; remove " + cache.string() + " to have it tried again";
  keep(cache, verdict);
  return {std::move(verdict), {}};
}

}  // namespace

fs::path probe_cache(const fs::path& file) {
  const auto content = content_of(file);
  fs::path folder;
  if (const char* given = std::getenv("XDG_CACHE_HOME"); given && *given == '/')
    folder = given;
  else if (const char* home = std::getenv("HOME"); home && *home)
    folder = fs::path(home) / ".cache";
  if (content.empty() || folder.empty())
    return {};
  // What another program version loads says nothing about this one.
  const auto key =
    content + compiler_tag + std::to_string(sdk_major) + "." + std::to_string(sdk_minor);
  return folder / "tedit/probes" / to_hex(hash_bytes(std::as_bytes(std::span(key))));
}

std::string kept_verdict(const fs::path& cache) {
  return cache.empty() ? std::string() : content_of(cache);
}

std::string probe_plugin(const fs::path& file) {
  const auto cache = probe_cache(file);
  if (const auto kept = kept_verdict(cache); !kept.empty())
    return kept == fine ? std::string() : kept;
  return try_out(file, cache).refusal;
}

plugin_report describe_plugin(const fs::path& file) {
  const auto cache = probe_cache(file);
  auto kept = kept_verdict(cache);
  const bool known = kept == fine;
  if (!kept.empty() && !known)
    return {std::move(kept), {}};
  // What was fine is not put away for one bad moment of the machine.
  return try_out(file, known ? fs::path() : cache);
}

std::string readable_dl_error(const char* message) {
  std::string text = message ? message : "it cannot be loaded";
  const auto colon = text.find(": ");
  const auto subject = fs::path(text.substr(0, colon)).filename().string();
  if (const auto at = text.find("undefined symbol: "); at != std::string::npos) {
    auto symbol = text.substr(at + 18);
    symbol = symbol.substr(0, symbol.find_first_of(" ,\t"));
    return "it uses " + demangled(symbol) +
           ", which neither it nor the libraries that it names have";
  }
  if (const auto at = text.find("version `"); at != std::string::npos)
    return "it was built on a newer system: " + text.substr(at);
  if (text.find("No such file") != std::string::npos)
    return subject.ends_with(".so") && text.find('/') < colon
             ? "there is no file " + text.substr(0, colon)
             : "it needs " + subject + ", which is not installed";
  if (text.find("invalid ELF header") != std::string::npos ||
      text.find("file too short") != std::string::npos)
    return "it is no shared library, or only a part of one";
  return text;
}

}  // namespace tedit::ops
