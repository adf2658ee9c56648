// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/child_operation.hpp"

#include <utility>

#include "base/byte_stream.hpp"
#include "base/forked_call.hpp"
#include "base/memory.hpp"
#include "base/misdeed.hpp"
#include "base/stopwatch.hpp"
#include "ops/loader/confinement.hpp"
#include "ops/loader/edit_answer.hpp"

namespace tedit::ops {

namespace {

enum message_kind : std::uint32_t { progress_message, log_message, answer_message };

/// What the operation says goes to the caller; progress not more often than a person can follow.
context context_in_child(const context& callers, const caller_line& line) {
  context ctx;
  ctx.host = callers.host;
  ctx.search_s = callers.search_s;
  ctx.log = [&line](std::string_view text) {
    line.send(log_message, std::as_bytes(std::span(text)));
  };
  if (callers.run.progress)
    ctx.run.progress = [&line, since_last = stopwatch(), first = true](
                         double fraction, std::string_view stage) mutable {
      if (!std::exchange(first, false) && since_last.milliseconds() < 20)
        return;
      since_last.restart();
      byte_writer out;
      out.number(fraction);
      out.text(stage);
      line.send(progress_message, out.bytes);
    };
  return ctx;
}

/// Hands on what came while the operation runs; the answer is kept for its end.
void take(std::uint32_t kind, std::span<const std::byte> bytes, const context& ctx,
          std::vector<std::byte>& answer) {
  byte_reader in(bytes);
  if (kind == progress_message) {
    const auto fraction = in.number<double>();
    ctx.run.report(fraction, in.text());
  } else if (kind == log_message) {
    if (ctx.log)
      ctx.log({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } else {
    answer.assign(bytes.begin(), bytes.end());
  }
}

/// What became of a child that gave no answer, with its names.
error named(error e, const catalogue::entry& entry) {
  if (e.code == ec::service_unavailable || e.code == ec::cancelled)
    return e;
  const bool misdeed = is_misdeed(e.message);
  e.message = "the operation \"" + entry.description.id + "\" of the plugin " + entry.plugin + " " +
              e.message;
  e.remedy = "The part is unchanged. \"tedit plugin test " +
             entry.file.lexically_normal().string() +
             "\" looks for such faults; report this to the plugin's author";
  if (misdeed)
    e.remedy = misdeed_remedy;
  else if (e.code == ec::timeout)  // Long work is no fault.
    e.remedy =
      "The part is unchanged. Take fewer surfaces or other values, or give it more time with "
      "--time-limit";
  return e;
}

/// The copy needs what its plugin needs, and those that it asks for others; its answer goes through
/// a file in memory.
forked_limits limits_of(const operation_limits& given, const catalogue& plugins) {
  forked_limits limits;
  limits.time = given.time;
  limits.memory_bytes = available_memory().bytes;
  if (!sandbox::is_wanted())
    return limits;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : plugins.entries())
    files.push_back(entry.file);
  auto reach = reach_of_plugins(files);
  reach.file_bytes = limits.memory_bytes;
  limits.confine = [reach] { return confine_to(reach); };
  limits.programs = given.programs;
  return limits;
}

}  // namespace

expected<edit_result> run_operation_in_child(const catalogue& plugins, const std::string& id,
                                             const version_ptr& mesh, const selection& picked,
                                             const parameters& given, const context& ctx,
                                             const operation_limits& limits) {
  const auto found = plugins.find(id);
  if (!found)
    return fail(found.error());
  if (sandbox::is_wanted())
    if (auto can = sandbox::check(); !can)
      return fail(can.error());
  std::vector<std::byte> bytes;
  const auto done = call_forked(
    [&](const caller_line& line) {
      auto in_child = context_in_child(ctx, line);
      line.send(answer_message,
                to_bytes(run_operation(plugins, id, mesh, picked, given, in_child), *mesh));
    },
    limits_of(limits, plugins), ctx.run,
    [&](std::uint32_t kind, std::span<const std::byte> message) {
      take(kind, message, ctx, bytes);
    });
  if (!done)
    return fail(named(done.error(), **found));
  auto answer = answer_from_bytes(bytes, *mesh);
  if (!answer && answer.error().code == ec::protocol_error)
    return fail(named(answer.error(), **found));
  return answer;
}

}  // namespace tedit::ops
