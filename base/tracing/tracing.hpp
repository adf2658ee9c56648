// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/trace_context.hpp"

/// Where the time of a request goes, from its arrival to its answer, as OpenTelemetry has it: a
/// trace is a tree of spans, each with a beginning and an end. Spans of this process are appended
/// to a file, one line of OTLP's JSON each, which the OpenTelemetry Collector reads
/// (`otlpjsonfile`); https://opentelemetry.io/docs/specs/otel/protocol/file-exporter. Thread-safe.
/// As long as no file is open nothing is kept, and a span costs a comparison.
namespace tedit::tracing {

/// What a caller says about the trace that its request belongs to.
struct parent {
  context from;
  bool sampled = true;  ///< False: the caller does not record it, and so nobody does.
};

/// Reads the text "00-TRACE-SPAN-FLAGS" of the W3C's Trace Context, section 3.2
/// (https://www.w3.org/TR/trace-context); nothing for what is none, as the standard wants it.
[[nodiscard]] std::optional<parent> from_text(std::string_view traceparent);

/// That text, of a span that is recorded.
[[nodiscard]] std::string to_text(const context& here);

/// Begins to write spans to the end of a file, which only this user may read; `service` and
/// `version` stand with each. A file that has grown beyond `most_bytes` is called FILE.1 from then
/// on, in place of an earlier one, and a new one is begun. Errors: `io_error`.
[[nodiscard]] expected<void> start(const std::filesystem::path& file, const std::string& service,
                                   const std::string& version,
                                   std::uint64_t most_bytes = std::uint64_t{64} << 20);

/// Ends that; spans that have not ended are not written.
void stop();

[[nodiscard]] bool is_on() noexcept;

/// A part of a trace that lasts until it ends, at the latest with this object. Empty when it is not
/// recorded: then everything about it does nothing.
class span {
public:
  span();
  span(span&&) noexcept;
  span& operator=(span&& other) noexcept;
  ~span();

  /// What is recorded of it beside its times; later values replace earlier ones.
  void note(const std::string& key, const std::string& value);
  void note(const std::string& key, std::int64_t value);

  /// It did not do what it should; `why` is a sentence, or a code.
  void fail(const std::string& why);

  /// Writes it, once.
  void end();

  /// For its parts; not there when it is not recorded.
  [[nodiscard]] context here() const;

private:
  struct facts;
  explicit span(std::unique_ptr<facts> of);
  friend span begin_request(const std::string&, std::string_view);
  friend span begin_part(const std::string&, const context&);

  std::unique_ptr<facts> facts_;
};

/// A span of a request: part of the caller's where `traceparent` says so, else the first of a trace
/// of its own. Empty when the caller does not record.
[[nodiscard]] span begin_request(const std::string& name, std::string_view traceparent);

/// A part of `of`; empty when that is not there.
[[nodiscard]] span begin_part(const std::string& name, const context& of);

/// The span of a request that is known by a number of its own in this process; not there when none
/// is. `bind` it when it begins, `unbind` it with its end.
void bind(std::uint64_t ticket, const context& here);
void unbind(std::uint64_t ticket);
[[nodiscard]] context of(std::uint64_t ticket);

}  // namespace tedit::tracing
