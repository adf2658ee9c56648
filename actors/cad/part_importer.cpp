// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/cad/part_importer.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>

#include "actors/cad/first_version.hpp"
#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/session/session.hpp"
#include "actors/versions.hpp"
#include "actors/worker/worker_jobs.hpp"
#include "base/named_error.hpp"
#include "cad/private_folder.hpp"
#include "mesh/io/file.hpp"
#include "scan/part_file.hpp"

namespace tedit::actors {

namespace {

namespace fs = std::filesystem;

using importer_pointer = part_importer_actor::stateful_pointer<part_importer_state>;

/// So often it is looked whether those that wait are still wanted.
constexpr std::chrono::milliseconds look_every{250};

error ended_early() {
  return {ec::cancelled, "the import was cancelled", {}, {}};
}

/// Letters of its suffix: some kinds of files are told by it.
std::string suffix_of(const std::string& file_name) {
  constexpr std::size_t longest = 8;
  auto suffix = fs::path(file_name).extension().string();
  const auto plain = [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; };
  if (suffix.empty() || suffix.size() > longest ||
      !std::all_of(suffix.begin() + 1, suffix.end(), plain))
    return {};
  return suffix;
}

expected<void> write_sent_file(const fs::path& file, const std::vector<page_ptr>& pages) {
  std::ofstream out(file, std::ios::binary);
  for (const auto& one : pages)
    out.write(reinterpret_cast<const char*>(one->bytes().data()),
              static_cast<std::streamsize>(one->bytes().size()));
  if (!out.flush())
    return fail(ec::io_error, "the server cannot write the file that was sent",
                "There must be room in the server's temporary folder");
  return {};
}

expected<part_document> make_document(const part_order& order, std::chrono::seconds limit,
                                      const fs::path& folder, const execution& run) {
  const auto file = folder / ("part" + suffix_of(order.file_name));
  if (auto written = write_sent_file(file, order.file); !written)
    return fail(std::move(written.error()));
  scan::part_file_request request{file, order.length_unit, order.size};
  for (const auto& one : order.local_sizes)
    request.local_sizes.push_back({one.surface, one.mm});
  request.limits.time = limit;
  auto made = scan::import_part_file(request, run.part(0, 0.95));
  if (!made)
    return fail(named_error(std::move(made.error()), file.string(), order.file_name));
  run.report(0.95, "writing the document");
  const auto document = folder / "part.tedit";
  return create_document(document, {made->part.version, made->model(), order.file_name,
                                    made->part.warnings, order.client_name})
    .and_then([&] { return read_file(document); })
    .map([&](const std::vector<char>& bytes) {
      return part_document{cut(bytes), std::move(made->part.warnings)};
    });
}

expected<part_document> carry_out(const part_order& order, std::chrono::seconds limit) {
  if (order.stop.cancelled())
    return fail(ended_early());
  const cad::private_folder folder("tedit-part-");
  if (folder.path().empty())
    return fail(cad::no_private_folder());
  const auto tell = [&order](double fraction, std::string_view stage) {
    caf::anon_send(order.client, request_progress{order.ticket, fraction, std::string(stage)});
  };
  return make_document(order, limit, folder.path(), make_execution(order.stop, tell));
}

void begin_tasks(importer_pointer self);

void start(importer_pointer self, part_importer_state::task task) {
  auto& state = self->state;
  const auto thread = state.free_threads.back();
  state.free_threads.pop_back();
  const auto token = state.running.insert(state.running.end(), task.order->stop);
  auto slot = std::make_shared<std::optional<expected<part_document>>>();
  job_task work{[slot, order = task.order, limit = state.limit] {
    *slot = guarded<part_document>([&] { return carry_out(*order, limit); });
  }};
  const auto finish = [=] {
    self->state.running.erase(token);
    self->state.free_threads.push_back(thread);
    begin_tasks(self);
  };
  self->request(thread, answer_limit, std::move(work))
    .then(
      [=](acknowledged) mutable {
        if ((*slot)->has_value())
          task.promise.deliver(std::move(***slot));
        else
          task.promise.deliver(to_caf((*slot)->error()));
        finish();
      },
      [=](const caf::error& e) mutable {
        task.promise.deliver(to_caf(from_caf(e, "the import")));
        finish();
      });
}

void begin_tasks(importer_pointer self) {
  auto& state = self->state;
  while (!state.waiting.empty() && !state.free_threads.empty()) {
    auto task = std::move(state.waiting.front());
    state.waiting.pop_front();
    start(self, std::move(task));
  }
}

void look_later(importer_pointer self) {
  self->state.looking = !self->state.waiting.empty();
  if (self->state.looking)
    self->delayed_send(self, look_every, rest_atom::value);
}

/// Those that nobody wants any more are answered at once: their turn may be far off.
void look(importer_pointer self) {
  auto& waiting = self->state.waiting;
  std::erase_if(waiting, [](part_importer_state::task& task) {
    if (!task.order->stop.cancelled())
      return false;
    task.promise.deliver(to_caf(ended_early()));
    return true;
  });
  look_later(self);
}

}  // namespace

part_importer_state::~part_importer_state() {
  for (const auto& token : running)
    token.cancel();
}

part_importer_actor::behavior_type make_part_importer(importer_pointer self,
                                                      std::vector<job_thread_actor> threads,
                                                      std::chrono::seconds limit) {
  heed_only_own_exits(self);
  for (const auto& one : threads)
    self->link_to(one);
  self->state.free_threads = std::move(threads);
  self->state.limit = limit;
  return {[=](const part_order& order) -> caf::result<part_document> {
            auto promise = self->make_response_promise<part_document>();
            auto& state = self->state;
            state.waiting.push_back({std::make_shared<const part_order>(order), promise});
            begin_tasks(self);
            if (!state.waiting.empty())
              caf::anon_send(order.client,
                             request_progress{order.ticket, 0, "waiting for another import"});
            if (!state.looking)
              look_later(self);
            return promise;
          },
          [=](rest_atom) { look(self); }};
}

}  // namespace tedit::actors
