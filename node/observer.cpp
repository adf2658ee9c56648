// SPDX-License-Identifier: AGPL-3.0-or-later
#include <atomic>
#include <utility>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/versions.hpp"
#include "actors/worker/job_thread.hpp"
#include "node/joined.hpp"

namespace tedit::node {

namespace {

using namespace actors;

/// Pages of an event are at hand for as long as the server waits for its answer.
constexpr std::chrono::minutes fetch_limit{1};

/// What went wrong on the observer's own side, for whoever waits for it.
struct trouble {
  std::mutex mutex;
  std::optional<error> first;

  void note(const error& e) {
    const std::lock_guard lock(mutex);
    if (!first)
      first = e;
  }
  [[nodiscard]] std::optional<error> get() {
    const std::lock_guard lock(mutex);
    return first;
  }
};

struct listener_state {
  observer told;
  page_store_actor pages;
  job_thread_actor thread;
  std::shared_ptr<trouble> failed;
  /// Events are worked off one after the other, as they came: pages of the next are fetched once
  /// the one before was told.
  std::deque<std::function<void()>> waiting;
  bool busy = false;

  static inline const char* name = "observer";
};

using listener_pointer = observer_actor::stateful_pointer<listener_state>;
using taken = caf::typed_response_promise<bool>;

void next(listener_pointer self) {
  auto& state = self->state;
  if (state.busy || state.waiting.empty())
    return;
  state.busy = true;
  const auto begin = std::move(state.waiting.front());
  state.waiting.pop_front();
  begin();
}

void finish(listener_pointer self, taken promise, const std::optional<error>& why = {}) {
  if (why)
    self->state.failed->note(*why);
  promise.deliver(!why);
  self->state.busy = false;
  next(self);
}

/// Calls `tell` on the observer's thread.
void tell_on_thread(listener_pointer self, const taken& promise,
                    const std::function<std::optional<error>()>& tell) {
  auto outcome = std::make_shared<std::optional<error>>();
  job_task task{[=] {
    try {
      *outcome = tell();
    } catch (const std::exception& e) {
      *outcome = error{ec::internal, std::string("the observer threw: ") + e.what(), {}, {}};
    }
  }};
  self->request(self->state.thread, std::chrono::minutes(24 * 60), std::move(task))
    .then([=](acknowledged) { finish(self, promise, *outcome); },
          [=](const caf::error& e) { finish(self, promise, from_caf(e, "the observer")); });
}

/// Fetches first what `tell` needs.
void tell_with_pages(listener_pointer self, const taken& promise, const caf::actor& source,
                     const hash_list& ids,
                     const std::function<std::optional<error>(const page_set&)>& tell) {
  self->request(self->state.pages, fetch_limit, fetch_atom::value, source, ids)
    .then(
      [=](const page_set& pages) { tell_on_thread(self, promise, [=] { return tell(pages); }); },
      [=](const caf::error& e) { finish(self, promise, from_caf(e, "fetching a version")); });
}

/// Takes an event in: `work` begins when its turn is.
caf::result<bool> take(listener_pointer self, const std::function<void(taken)>& work) {
  auto promise = self->make_response_promise<bool>();
  self->state.waiting.emplace_back([=] { work(promise); });
  next(self);
  return promise;
}

std::optional<error> tell_version(const observer& told, const observed_version& event,
                                  const page_set& pages) {
  auto mesh = open_version(event.version, pages);
  if (!mesh)
    return mesh.error();
  const auto load_cases = event.load_cases.get();
  if (!load_cases)
    return load_cases.error();
  version_event now{event.document,  event.number, {},          event.cause,
                    event.operation, *mesh,        *load_cases, nullptr};
  if (event.parent >= 0)
    now.parent = static_cast<std::uint32_t>(event.parent);
  if (event.has_report) {
    const auto report = event.report.get();
    if (!report)
      return report.error();
    now.report = *report;
  }
  told.on_version(now);
  return std::nullopt;
}

std::optional<error> tell_result(const observer& told, const observed_result& event,
                                 const page_set& pages) {
  auto mesh = open_version(event.version, pages);
  if (!mesh)
    return mesh.error();
  const auto outcome = event.outcome.get();
  if (!outcome)
    return outcome.error();
  result_event now{event.document, *mesh, *outcome, {}};
  for (const auto& ref : event.fields) {
    auto one = open_field(ref, pages);
    if (!one)
      return one.error();
    now.fields.push_back(std::move(*one));
  }
  told.on_result(now);
  return std::nullopt;
}

caf::result<bool> take_version(listener_pointer self, const observed_version& event) {
  return take(self, [=](const taken& promise) {
    const auto& told = self->state.told;
    const auto ids = pages_of(event.version);
    if (!told.on_version || !ids)
      return finish(self, promise, ids ? std::nullopt : std::optional(ids.error()));
    tell_with_pages(self, promise, event.source, *ids,
                    [=](const page_set& pages) { return tell_version(told, event, pages); });
  });
}

caf::result<bool> take_result(listener_pointer self, const observed_result& event) {
  return take(self, [=](const taken& promise) {
    const auto& told = self->state.told;
    auto ids = pages_of(event.version);
    if (!told.on_result || !ids)
      return finish(self, promise, ids ? std::nullopt : std::optional(ids.error()));
    const auto of_fields = pages_of(event.fields);
    ids->insert(ids->end(), of_fields.begin(), of_fields.end());
    tell_with_pages(self, promise, event.source, *ids,
                    [=](const page_set& pages) { return tell_result(told, event, pages); });
  });
}

/// An event that is all there.
template <class Tell>
caf::result<bool> take_note(listener_pointer self, bool wanted, const Tell& tell) {
  return take(self, [=](const taken& promise) {
    if (!wanted)
      return finish(self, promise);
    tell_on_thread(self, promise, tell);
  });
}

observer_actor::behavior_type listener(listener_pointer self, const observer& told,
                                       const page_store_actor& pages,
                                       std::shared_ptr<trouble> failed) {
  self->state.told = told;
  self->state.pages = pages;
  self->state.failed = std::move(failed);
  self->state.thread = self->spawn<job_thread, caf::linked + caf::detached>();
  return {[=](const observed_version& event) { return take_version(self, event); },
          [=](const observed_load_cases& event) {
            return take_note(self, bool(told.on_load_cases), [=]() -> std::optional<error> {
              const auto load_cases = event.load_cases.get();
              if (!load_cases)
                return load_cases.error();
              told.on_load_cases(event.document, **load_cases);
              return std::nullopt;
            });
          },
          [=](const observed_result& event) { return take_result(self, event); },
          [=](const observed_name& event) {
            return take_note(self, bool(told.on_name), [=]() -> std::optional<error> {
              told.on_name(event.before, event.document);
              return std::nullopt;
            });
          },
          [=](const observed_end& event) {
            return take_note(self, bool(told.on_end), [=]() -> std::optional<error> {
              told.on_end(event.document, event.why);
              return std::nullopt;
            });
          }};
}

expected<void> watch(membership& node, const std::string& document, const caf::actor& hears) {
  expected<void> result;
  node.self()
    ->request(node.entrance(), std::chrono::minutes(1), watch_atom::value, document, hears)
    .receive([](const std::string&) {},
             [&](const caf::error& e) { result = fail(from_caf(e, "watching " + document)); });
  return result;
}

}  // namespace

expected<std::vector<std::string>> documents(const place& where, const cancel_token& stop) {
  auto joined = join(where, stop);
  if (!joined)
    return fail(joined.error());
  expected<std::vector<std::string>> result;
  (*joined)
    ->self()
    ->request((*joined)->entrance(), std::chrono::minutes(1), names_atom::value)
    .receive([&](std::vector<std::string>& names) { result = std::move(names); },
             [&](const caf::error& e) { result = fail(from_caf(e, "listing documents")); });
  return result;
}

expected<void> observe(const place& where, const std::vector<std::string>& documents,
                       const observer& told, const cancel_token& stop) {
  auto joined = join(where, stop);
  if (!joined)
    return unless_stopped(joined.error(), stop);
  auto& node = **joined;
  const auto failed = std::make_shared<trouble>();
  const auto hears =
    caf::actor_cast<caf::actor>(node.system().spawn(listener, told, node.pages(), failed));
  node.own(hears);
  for (const auto& document : documents)
    if (auto ok = watch(node, document, hears); !ok)
      return unless_stopped(ok.error(), stop);
  while (!stop.cancelled()) {
    const bool there = node.stays(std::chrono::milliseconds(100));
    if (const auto why = failed->get())
      return unless_stopped(*why, stop);
    if (!there)
      return unless_stopped(gone(), stop);
  }
  return {};
}

}  // namespace tedit::node
