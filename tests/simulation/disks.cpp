// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/disks.hpp"

#include <algorithm>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/store/loading.hpp"

namespace tedit::simulation {

namespace {

struct queue_state {
  std::deque<std::function<void()>> waiting;
  static inline const char* name = "slow_disk";
};

/// What lies in a file that nobody has open.
std::optional<stored_document> look_into(const std::filesystem::path& file) {
  const auto opened = store::document::open(file);
  auto found = opened ? load(**opened) : expected<stored_document>(fail(opened.error()));
  return found ? std::optional(std::move(*found)) : std::nullopt;
}

std::optional<stored_document> look_into(const document_file& file) {
  auto found = file.document ? load(*file.document)
                             : expected<stored_document>(fail(ec::storage_error, "not open"));
  return found ? std::optional(std::move(*found)) : std::nullopt;
}

/// A document keeps all that it once had.
bool is_earlier(const stored_document& before, const stored_document& now) {
  const auto same_node = [](const graph_node& a, const graph_node& b) {
    return a.info.id == b.info.id && a.info.parent == b.info.parent;
  };
  const auto same_row = [](const store::log_row& a, const store::log_row& b) {
    return a.sequence == b.sequence && a.what == b.what && a.details == b.details;
  };
  return before.nodes.size() <= now.nodes.size() && before.log.size() <= now.log.size() &&
         std::equal(before.nodes.begin(), before.nodes.end(), now.nodes.begin(), same_node) &&
         std::equal(before.log.begin(), before.log.end(), now.log.begin(), same_row);
}

void note_copy(document_record& record, const std::optional<stored_document>& source,
               const std::filesystem::path& target) {
  ++record.copied[target.stem().string()];
  const auto copy = look_into(target);
  if (!copy || !source || !is_earlier(*copy, *source))
    record.faults.push_back("the copy " + target.string() + " is not what was copied");
}

void note_deletion(document_record& record, std::optional<stored_document> before,
                   const std::filesystem::path& file) {
  for (const auto* with : {"", "-wal", "-shm", "-journal"})
    if (std::filesystem::exists(file.string() + with))
      record.faults.push_back(file.string() + with + " is there after the document was deleted");
  if (before)
    record.deleted.emplace_back(file.stem().string(), std::move(*before));
  else
    record.faults.push_back(file.string() + " could not be read before it was deleted");
}

using queue_pointer = caf::stateful_actor<queue_state>*;

/// Before a real disk: one request after the other, each after its time.
caf::behavior make_slow_disk(queue_pointer self, const disk_actor& real,
                             const std::shared_ptr<simulated_disks::mood>& mood,
                             const std::shared_ptr<std::atomic<int>>& jobs) {
  const auto begin = [=] {
    auto& random = mood->time->random;
    const bool slow = mood->time->now() < mood->slow_until;
    self->delayed_send(self, milliseconds(slow ? 1000 + random.below(4000) : random.below(8)),
                       tick_atom::value);
  };
  const auto add = [=](std::function<void()> work) {
    self->state.waiting.push_back(std::move(work));
    if (self->state.waiting.size() == 1)
      begin();
  };
  // `before` is called when its turn has come; what it returns, when that is done.
  const auto watched = [=](std::function<std::function<void()>()> before, auto... args) {
    auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
      self->make_response_promise<acknowledged>());
    add([=] {
      const auto after = before();
      self->request(real, caf::infinite, args...)
        .then(
          [=](acknowledged) {
            after();
            promise->deliver(acknowledged{});
          },
          [=](caf::error& e) { promise->deliver(std::move(e)); });
    });
    return *promise;
  };
  const auto forward = [=]<class Result, class... Args>(std::in_place_type_t<Result>,
                                                        Args... args) {
    auto promise =
      std::make_shared<caf::typed_response_promise<Result>>(self->make_response_promise<Result>());
    add([=] {
      self->request(real, caf::infinite, args...)
        .then([=](Result& result) { promise->deliver(std::move(result)); },
              [=](caf::error& e) { promise->deliver(std::move(e)); });
    });
    return *promise;
  };
  return {
    [=](load_atom atom, const shared_file& file) {
      return forward(std::in_place_type<stored_document>, atom, file);
    },
    [=](load_atom atom, const shared_file& file, const version_query& wanted) {
      return forward(std::in_place_type<stored_version>, atom, file, wanted);
    },
    [=](load_atom atom, const shared_file& file, const cad_query& wanted) {
      return forward(std::in_place_type<stored_cad>, atom, file, wanted);
    },
    [=](const shared_file& file, const stored_change& change) -> caf::result<acknowledged> {
      if (mood->failing > 0) {
        --mood->failing;
        --*jobs;
        return to_caf({ec::storage_error, "the disk is full", "Make room", {}});
      }
      return forward(std::in_place_type<acknowledged>, file, change);
    },
    [=](copy_atom atom, const shared_file& file) {
      return forward(std::in_place_type<exported>, atom, file);
    },
    [=](const adoption& one) { return forward(std::in_place_type<acknowledged>, one); },
    [=](rename_atom atom, const shared_file& file, const std::string& name) {
      return forward(std::in_place_type<acknowledged>, atom, file, name);
    },
    [=](copy_atom atom, const shared_file& file, const copy_order& order) {
      const auto note = [=] {
        const auto target =
          std::filesystem::path(file->path).replace_filename(order.name + ".tedit");
        return [=] { note_copy(*mood->record, look_into(*file), target); };
      };
      return watched(note, atom, file, order);
    },
    [=](const file_copy& wanted) {
      const auto note = [=] {
        return [=] { note_copy(*mood->record, look_into(wanted.from), wanted.to); };
      };
      return watched(note, wanted);
    },
    [=](delete_atom atom, const shared_file& file) {
      const auto note = [=] {
        return [=, path = file->path, before = look_into(*file)] {
          note_deletion(*mood->record, before, path);
        };
      };
      return watched(note, atom, file);
    },
    [=](const deletion& wanted) {
      const auto note = [=] {
        return [=, before = look_into(wanted.file)] {
          note_deletion(*mood->record, before, wanted.file);
        };
      };
      return watched(note, wanted);
    },
    [=](const folder_query& wanted) { return forward(std::in_place_type<document_list>, wanted); },
    [=](close_atom atom, const shared_file& file) {
      return forward(std::in_place_type<acknowledged>, atom, file);
    },
    [=](wake_atom atom, const shared_file& file) { add([=] { self->send(real, atom, file); }); },
    [=](rest_atom atom, const shared_file& file) { add([=] { self->send(real, atom, file); }); },
    [=](tick_atom) {
      const auto work = std::move(self->state.waiting.front());
      self->state.waiting.pop_front();
      if (!self->state.waiting.empty())
        begin();
      work();
    }};
}

}  // namespace

simulated_disks::simulated_disks(timeline& time, caf::actor_system& system,
                                 std::shared_ptr<document_record> record) {
  mood_->time = &time;
  mood_->record = std::move(record);
  std::vector<disk> made(2);
  for (auto& one : made) {
    const auto real = system.spawn(make_disk, one.jobs);
    const auto slow = system.spawn(make_slow_disk, real, mood_, one.jobs);
    one.actor = caf::actor_cast<disk_actor>(slow);
    all_.push_back(slow);
    all_.push_back(caf::actor_cast<caf::actor>(real));
  }
  disks_ = disk_set(std::move(made));
}

void simulated_disks::stop() {
  for (const auto& one : all_)
    cut_off(one);
}

}  // namespace tedit::simulation
