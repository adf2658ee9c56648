// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/tracing/tracing.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <random>
#include <unordered_map>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/hex.hpp"
#include "base/logging/logging.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::tracing {

namespace {

using json = nlohmann::ordered_json;

std::atomic<bool> recording{false};

json attribute(const std::string& key, json value) {
  json out;
  out["key"] = key;
  out["value"] = std::move(value);
  return out;
}

/// As the standard numbers them.
enum class span_kind { internal = 1, server = 2 };

/// The file, and how its lines begin.
class span_file {
public:
  expected<void> open(const std::filesystem::path& file, std::uint64_t most_bytes) {
    const std::lock_guard lock(mutex_);
    path_ = file;
    most_bytes_ = most_bytes;
    failed_ = false;
    return open_now();
  }

  void describe(const std::string& service, const std::string& version) {
    const std::lock_guard lock(mutex_);
    resource_ = json::object();
    resource_["attributes"] =
      json::array({attribute("service.name", {{"stringValue", service}}),
                   attribute("service.version", {{"stringValue", version}}),
                   attribute("process.pid", {{"intValue", std::to_string(getpid())}})});
  }

  void close() {
    const std::lock_guard lock(mutex_);
    file_.reset();
  }

  /// A line is one call to the system, so that lines of several processes do not mix.
  void write(json span) {
    const std::lock_guard lock(mutex_);
    if (!file_)
      return;
    json scope;
    scope["scope"]["name"] = "tedit";
    scope["spans"] = json::array({std::move(span)});
    json whole;
    whole["resource"] = resource_;
    whole["scopeSpans"] = json::array({std::move(scope)});
    json all;
    all["resourceSpans"] = json::array({std::move(whole)});
    const auto line = all.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
    if (bytes_ > 0 && bytes_ + line.size() > most_bytes_)
      turn_over();
    if (!file_)
      return;
    const auto written = ::write(file_.get(), line.data(), line.size());
    if (written != static_cast<ssize_t>(line.size()))
      return complain("cannot write spans to " + path_.string());
    bytes_ += line.size();
  }

private:
  expected<void> open_now() {
    file_.reset(::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
    if (!file_)
      return system_failure("cannot open " + path_.string() + " for spans", errno);
    struct stat found {};
    bytes_ = fstat(file_.get(), &found) == 0 ? static_cast<std::uint64_t>(found.st_size) : 0;
    return {};
  }

  void turn_over() {
    auto older = path_;
    older += ".1";
    std::error_code code;
    std::filesystem::rename(path_, older, code);
    if (code)
      return complain("cannot rename " + path_.string() + ": " + code.message());
    if (const auto ok = open_now(); !ok)
      complain(ok.error().message);
  }

  /// Once: a full disk must not fill the log, too.
  void complain(const std::string& what) {
    if (!std::exchange(failed_, true))
      logging::warn("{}", what);
  }

  std::mutex mutex_;
  std::filesystem::path path_;
  json resource_;
  unique_fd file_;
  std::uint64_t bytes_ = 0;
  std::uint64_t most_bytes_ = 0;
  bool failed_ = false;
};

/// Ends with the process: spans may end later than anything else.
span_file& file() {
  static auto* one = new span_file;
  return *one;
}

/// Of requests that run.
class bindings {
public:
  void put(std::uint64_t ticket, const context& here) {
    const std::lock_guard lock(mutex_);
    known_[ticket] = here;
  }
  void take(std::uint64_t ticket) {
    const std::lock_guard lock(mutex_);
    known_.erase(ticket);
  }
  [[nodiscard]] context find(std::uint64_t ticket) {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(ticket);
    return found == known_.end() ? context{} : found->second;
  }

private:
  std::mutex mutex_;
  std::unordered_map<std::uint64_t, context> known_;
};

bindings& requests() {
  static auto* one = new bindings;
  return *one;
}

/// Random as the standard asks: no secret, but never the same twice.
template <std::size_t Size>
std::array<unsigned char, Size> random_id() {
  thread_local std::mt19937_64 source{(std::uint64_t{std::random_device{}()} << 32) ^
                                      std::random_device{}()};
  std::array<unsigned char, Size> id{};
  do
    for (auto& byte : id)
      byte = static_cast<unsigned char>(source());
  while (id == std::array<unsigned char, Size>{});
  return id;
}

/// Small digits alone, as section 3.2.2.3 has it. False when there are others.
template <std::size_t Size>
bool read_hex(std::string_view text, std::array<unsigned char, Size>& out) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
  };
  if (text.size() != 2 * Size)
    return false;
  for (std::size_t i = 0; i < Size; ++i) {
    const int high = digit(text[2 * i]);
    const int low = digit(text[2 * i + 1]);
    if (high < 0 || low < 0)
      return false;
    out[i] = static_cast<unsigned char>(16 * high + low);
  }
  return true;
}

std::string nanoseconds(std::chrono::system_clock::time_point at) {
  return std::to_string(
    std::chrono::duration_cast<std::chrono::nanoseconds>(at.time_since_epoch()).count());
}

}  // namespace

std::optional<parent> from_text(std::string_view text) {
  constexpr std::size_t length = 55;  // Of version 00; later ones may have more behind it.
  parent found;
  std::array<unsigned char, 1> version{};
  std::array<unsigned char, 1> flags{};
  if (text.size() < length || text[2] != '-' || text[35] != '-' || text[52] != '-' ||
      !read_hex(text.substr(0, 2), version) || version[0] == 0xff ||
      (text.size() > length && (version[0] == 0 || text[length] != '-')) ||
      !read_hex(text.substr(3, 32), found.from.trace) ||
      !read_hex(text.substr(36, 16), found.from.span) || !read_hex(text.substr(53, 2), flags))
    return std::nullopt;
  if (!found.from.is_there() || found.from.span == std::array<unsigned char, 8>{})
    return std::nullopt;
  found.sampled = (flags[0] & 1) != 0;
  return found;
}

std::string to_text(const context& here) {
  return "00-" + to_hex(here.trace) + "-" + to_hex(here.span) + "-01";
}

expected<void> start(const std::filesystem::path& path, const std::string& service,
                     const std::string& version, std::uint64_t most_bytes) {
  file().describe(service, version);
  if (auto ok = file().open(path, most_bytes); !ok)
    return ok;
  recording = true;
  return {};
}

void stop() {
  recording = false;
  file().close();
}

bool is_on() noexcept {
  return recording.load(std::memory_order_relaxed);
}

struct span::facts {
  std::string name;
  span_kind kind = span_kind::internal;
  context here;
  std::array<unsigned char, 8> part_of{};  ///< Zeros: it is the first of its trace.
  std::chrono::system_clock::time_point began = std::chrono::system_clock::now();
  json notes = json::object();
  std::optional<std::string> failure;

  [[nodiscard]] json described(std::chrono::system_clock::time_point ended) const {
    json out{{"traceId", to_hex(here.trace)}, {"spanId", to_hex(here.span)}};
    if (part_of != std::array<unsigned char, 8>{})
      out["parentSpanId"] = to_hex(part_of);
    out["name"] = name;
    out["kind"] = static_cast<int>(kind);
    out["startTimeUnixNano"] = nanoseconds(began);
    out["endTimeUnixNano"] = nanoseconds(ended);
    out["attributes"] = json::array();
    for (const auto& [key, value] : notes.items())
      out["attributes"].push_back(attribute(key, value));
    if (failure)
      out["status"] = {{"code", 2}, {"message", *failure}};
    return out;
  }
};

span::span() = default;
span::span(std::unique_ptr<facts> of) : facts_(std::move(of)) {}
span::span(span&&) noexcept = default;

span& span::operator=(span&& other) noexcept {
  if (this != &other) {
    end();
    facts_ = std::move(other.facts_);
  }
  return *this;
}

span::~span() {
  end();
}

void span::note(const std::string& key, const std::string& value) {
  if (facts_)
    facts_->notes[key] = {{"stringValue", value}};
}

void span::note(const std::string& key, std::int64_t value) {
  if (facts_)
    facts_->notes[key] = {{"intValue", std::to_string(value)}};
}

void span::fail(const std::string& why) {
  if (facts_)
    facts_->failure = why;
}

void span::end() {
  if (const auto ended = std::move(facts_))
    file().write(ended->described(std::chrono::system_clock::now()));
}

context span::here() const {
  return facts_ ? facts_->here : context{};
}

span begin_request(const std::string& name, std::string_view traceparent) {
  if (!is_on())
    return {};
  const auto caller = from_text(traceparent);
  if (caller && !caller->sampled)
    return {};
  auto made = std::make_unique<span::facts>();
  made->name = name;
  made->kind = span_kind::server;
  made->here = {caller ? caller->from.trace : random_id<16>(), random_id<8>()};
  if (caller)
    made->part_of = caller->from.span;
  return span(std::move(made));
}

span begin_part(const std::string& name, const context& of) {
  if (!of.is_there() || !is_on())
    return {};
  auto made = std::make_unique<span::facts>();
  made->name = name;
  made->here = {of.trace, random_id<8>()};
  made->part_of = of.span;
  return span(std::move(made));
}

void bind(std::uint64_t ticket, const context& here) {
  if (here.is_there())
    requests().put(ticket, here);
}

void unbind(std::uint64_t ticket) {
  if (is_on())
    requests().take(ticket);
}

context of(std::uint64_t ticket) {
  return ticket != 0 && is_on() ? requests().find(ticket) : context{};
}

}  // namespace tedit::tracing
