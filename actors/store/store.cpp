// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/store.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <unordered_set>

#include "actors/errors.hpp"
#include "actors/store/adoption.hpp"
#include "actors/store/deletion.hpp"
#include "actors/store/library.hpp"
#include "actors/store/loading.hpp"
#include "base/metrics.hpp"
#include "base/stopwatch.hpp"
#include "protocol/forms.hpp"

namespace tedit::actors {

std::string stored_form(const load_case_list& load_cases) {
  const auto text = protocol::to_json(load_cases);
  const auto list = text.find('[');
  return list == std::string::npos ? "[]" : text.substr(list, text.size() - list - 1);
}

store::change change_of(const graph_node& node, const mesh_version* parent) {
  store::change change;
  std::unordered_set<hash128> there;
  if (parent) {
    const auto ids = parent->pages().page_ids();
    there.insert(ids.begin(), ids.end());
  }
  node.mesh->for_each_page([&](const page_ptr& p) {
    if (!there.contains(p->id()))
      change.new_pages.push_back(p);
  });
  store::version_row row;
  row.number = node.info.number;
  row.parent = node.info.parent;
  row.id = node.info.id;
  row.manifest = node.mesh->pages().to_bytes();
  row.operation = node.info.operation;
  row.load_cases = stored_form(*node.load_cases);
  row.report = node.report ? protocol::to_json(*node.report) : std::string();
  change.new_version = std::move(row);
  change.head = node.info.number;
  if (node.info.parent)
    change.redo.emplace_back(*node.info.parent, node.info.number);
  return change;
}

// -- disks ---------------------------------------------------------------------------------------

namespace {

/// Documents of a server that keep their descriptors, three each, between two uses. Those beyond
/// close them after each, so that many users at once do not use up the process's descriptors.
int most_connections() {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<int>(std::clamp<rlim_t>(limit.rlim_cur / 16, 1, 32));
}

/// A document without work for so long gives its descriptors back.
constexpr std::chrono::seconds idle_limit{5};

metrics::times& version_reads() {
  static auto& one =
    metrics::times_of("tedit_version_read_seconds", "Versions read that were not at hand.");
  return one;
}

caf::result<stored_document> open_and_load(document_file& file) {
  const std::lock_guard lock(file.in_use);
  auto opened = store::document::open(file.path);
  if (!opened)
    return to_caf(opened.error());
  static auto& total = metrics::count_of("tedit_documents_opened_total", "Documents opened.");
  total.add();
  static_cast<void>(version_reads());  // Shown from the first document on.
  auto contents = load_head(**opened);
  if (!contents)
    return to_caf(contents.error());
  file.document = std::move(*opened);
  return std::move(*contents);
}

caf::result<stored_version> load_one(document_file& file, const version_query& wanted) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  const stopwatch clock;
  auto found = load_version(*file.document, wanted);
  version_reads().note(std::chrono::duration<double, std::milli>(clock.milliseconds()));
  if (!found)
    return to_caf(found.error());
  return std::move(*found);
}

caf::result<stored_cad> load_cad(document_file& file, const cad_query& wanted) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  auto row = file.document->read_cad(wanted.number);
  if (!row)
    return to_caf(row.error());
  return stored_cad{*row ? std::make_shared<const store::cad_row>(std::move(**row)) : nullptr};
}

caf::result<acknowledged> write(document_file& file, const store::change& change) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  static auto& took =
    metrics::times_of("tedit_commit_seconds", "Changes of documents until they were durable.");
  static auto& failures =
    metrics::count_of("tedit_commit_failures_total", "Changes that could not be made durable.");
  const stopwatch clock;
  const auto done = file.document->commit(change);
  if (!done) {
    failures.add();
    return to_caf(done.error());
  }
  took.note(std::chrono::duration<double, std::milli>(clock.milliseconds()));
  return acknowledged{};
}

caf::result<exported> copy_of(document_file& file) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  const auto bytes = file.document->copy();
  if (!bytes)
    return to_caf(bytes.error());
  exported result{file.path.filename().string(), {}, bytes->size()};
  for (std::size_t at = 0; at < bytes->size(); at += max_page_bytes)
    result.pages.push_back(page::from_bytes(
      std::span(*bytes).subspan(at, std::min(max_page_bytes, bytes->size() - at))));
  return result;
}

caf::result<acknowledged> rename(document_file& file, const std::string& name) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  const auto file_name = name + ".tedit";
  if (const auto done = file.document->rename(file_name); !done)
    return to_caf(done.error());
  file.path.replace_filename(file_name);
  return acknowledged{};
}

caf::result<acknowledged> copy_to(document_file& file, const copy_order& order) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  auto target = file.path;
  target.replace_filename(order.name + ".tedit");
  const auto done = cancellable_copy(order.stop, [&] { return file.document->copy_to(target); });
  if (!done)
    return to_caf(done.error());
  return acknowledged{};
}

caf::result<acknowledged> erase(document_file& file) {
  const std::lock_guard lock(file.in_use);
  if (!file.document)
    return to_caf({ec::storage_error, "the document is not open", {}, {}});
  if (const auto done = file.document->erase(); !done)
    return to_caf(done.error());
  file.document.reset();
  return acknowledged{};
}

}  // namespace

const disk& disk_set::least_busy(std::size_t from) const {
  return *std::min_element(
    disks_.begin() + static_cast<std::ptrdiff_t>(from), disks_.end(),
    [](const disk& a, const disk& b) { return a.jobs->load() < b.jobs->load(); });
}

disk_actor::behavior_type make_disk(disk_actor::stateful_pointer<disk_state> self,
                                    // NOLINTNEXTLINE(performance-unnecessary-value-param)
                                    std::shared_ptr<std::atomic<int>> jobs) {  // As CAF passes it.
  // The answer goes out before a connection too many is closed: that may take a checkpoint.
  const auto end_job = [=](const shared_file& file) {
    --*jobs;
    if (store::document::open_connections() > most_connections())
      self->send(self, rest_atom::value, file);
  };
  return {[=](load_atom, const shared_file& file) {
            auto result = open_and_load(*file);
            end_job(file);
            return result;
          },
          [=](load_atom, const shared_file& file, const version_query& wanted) {
            auto result = load_one(*file, wanted);
            end_job(file);
            return result;
          },
          [=](load_atom, const shared_file& file, const cad_query& wanted) {
            auto result = load_cad(*file, wanted);
            end_job(file);
            return result;
          },
          [=](const shared_file& file, const stored_change& change) {
            auto result = write(*file, *change.change);
            end_job(file);
            return result;
          },
          [=](copy_atom, const shared_file& file) {
            auto result = copy_of(*file);
            end_job(file);
            return result;
          },
          [=](const adoption& one) -> caf::result<acknowledged> {
            const auto done = adopt(one.file, one.bytes);
            --*jobs;
            if (!done)
              return to_caf(done.error());
            return acknowledged{};
          },
          [=](rename_atom, const shared_file& file, const std::string& name) {
            auto result = rename(*file, name);
            end_job(file);
            return result;
          },
          [=](copy_atom, const shared_file& file, const copy_order& order) {
            auto result = copy_to(*file, order);
            end_job(file);
            return result;
          },
          [=](const file_copy& wanted) -> caf::result<acknowledged> {
            const auto done = copy_sound_file(wanted);
            --*jobs;
            return done ? caf::result<acknowledged>(acknowledged{}) : to_caf(done.error());
          },
          [=](delete_atom, const shared_file& file) {
            auto result = erase(*file);
            end_job(file);
            return result;
          },
          [=](const deletion& wanted) -> caf::result<acknowledged> {
            const auto done = store::delete_document(wanted.file);
            --*jobs;
            return done ? caf::result<acknowledged>(acknowledged{}) : to_caf(done.error());
          },
          [=](const folder_query& wanted) {
            --*jobs;
            return list_folder(wanted.folder);
          },
          [=](close_atom, const shared_file& file) {
            const std::lock_guard lock(file->in_use);
            file->document.reset();
            --*jobs;
            return acknowledged{};
          },
          [=](wake_atom, const shared_file& file) {
            const std::lock_guard lock(file->in_use);
            if (file->document)
              (void)file->document->wake();  // Whatever is wrong, the commit says it.
            --*jobs;
          },
          [=](rest_atom, const shared_file& file) {
            const std::lock_guard lock(file->in_use);
            if (file->document)
              file->document->rest();
          }};
}

// -- the store -----------------------------------------------------------------------------------

store_actor::behavior_type make_store(store_actor::stateful_pointer<store_state> self,
                                      std::filesystem::path file, disk_set disks) {
  auto& state = self->state;
  state.file = std::make_shared<document_file>(std::move(file));
  state.disks = std::move(disks);
  const auto use = [=](const disk& by) {
    ++*by.jobs;
    self->delayed_send(self, idle_limit, rest_atom::value, ++self->state.uses);
    return by.actor;
  };
  return {
    [=](load_atom) {
      return self->delegate(use(self->state.disks.for_load()), load_atom::value, self->state.file);
    },
    [=](load_atom, const version_query& wanted) {
      return self->delegate(use(self->state.disks.for_load()), load_atom::value, self->state.file,
                            wanted);
    },
    [=](load_atom, const cad_query& wanted) {
      return self->delegate(use(self->state.disks.for_load()), load_atom::value, self->state.file,
                            wanted);
    },
    [=](const stored_change& change) {
      return self->delegate(use(self->state.disks.for_commit()), self->state.file, change);
    },
    [=](copy_atom) {
      return self->delegate(use(self->state.disks.for_load()), copy_atom::value, self->state.file);
    },
    [=](rename_atom, const std::string& name) {
      return self->delegate(use(self->state.disks.for_commit()), rename_atom::value,
                            self->state.file, name);
    },
    [=](copy_atom, const copy_order& order) {
      return self->delegate(use(self->state.disks.for_load()), copy_atom::value, self->state.file,
                            order);
    },
    [=](delete_atom) {
      return self->delegate(use(self->state.disks.for_commit()), delete_atom::value,
                            self->state.file);
    },
    [=](close_atom) {
      self->quit();  // The disk answers.
      return self->delegate(use(self->state.disks.for_commit()), close_atom::value,
                            self->state.file);
    },
    [=](wake_atom) {
      self->send(use(self->state.disks.for_commit()), wake_atom::value, self->state.file);
    },
    [=](rest_atom, std::uint64_t uses) {
      if (uses == self->state.uses)
        self->send(self->state.disks.for_commit().actor, rest_atom::value, self->state.file);
    }};
}

}  // namespace tedit::actors
