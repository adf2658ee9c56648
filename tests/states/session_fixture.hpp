// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "actors/pages/page_store.hpp"
#include "actors/session/session.hpp"
#include "actors/versions.hpp"
#include "tests/simulation/client.hpp"
#include "tests/simulation/server.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {

/// A piece of work, or a commit, that ends when a test says so.
struct open_task {
  std::string what;  ///< "import", "edit", "check", "file", "solve", "commit", "compare", ...
  std::uint64_t job = 0;
  std::string on;  ///< The version that it works on.
  std::function<void()> succeed;
  std::function<void(const error&)> fail;
};

/// All workers and the store of a session in one.
struct helper_state {
  std::deque<open_task> tasks;
  std::vector<std::uint64_t> cancelled;
  std::map<std::string, version_ptr> versions;  ///< Held, as workers hold theirs.
  std::shared_ptr<page_cache> cache;
  std::vector<std::shared_ptr<const store::change>> changes;  ///< That were asked for.
  std::vector<std::uint32_t> models;                          ///< Likewise, by their versions.
  std::function<void(solve_result&)> add_fields;              ///< To what solves yield.
  std::string mesh_only;  ///< Why the next edit is not made on the CAD model; empty: it is.
  int closed = 0;
  static inline const char* name = "helper";
};
using helper_actor = caf::stateful_actor<helper_state>;

inline version_ref hold(helper_state& state, const version_ptr& mesh) {
  state.versions[to_hex(mesh->id())] = mesh;
  state.cache->put(*mesh);
  return make_ref(mesh);
}

/// Answers `make()` once the test has it succeed.
template <class Result>
caf::result<Result> add_task(helper_actor* self, std::string what, job_id job, const hash128& on,
                             std::function<Result()> make) {
  auto promise = self->make_response_promise<Result>();
  self->state.tasks.push_back({std::move(what), job.value, to_hex(on),
                               [=]() mutable { promise.deliver(make()); },
                               [=](const error& e) mutable { promise.deliver(to_caf(e)); }});
  return promise;
}

inline caf::behavior make_helper(helper_actor* self, std::shared_ptr<page_cache> cache) {
  auto& state = self->state;
  state.cache = std::move(cache);
  return {
    [=](job_id job, const import_order&) {
      return add_task<import_result>(self, "import", job, {}, [self] {
        import_result result;
        result.version = hold(self->state, simulation::imported_part(1));
        return result;
      });
    },
    [=](job_id job, const edit_order& order) {
      const auto given = (*order.wanted.get())->parameters;
      const auto by = std::get<double>(given.at("by"));
      const auto vertex = given.contains("vertex") ? std::get<double>(given.at("vertex")) : 0;
      const auto base = order.version.id;
      return add_task<operation_result>(self, "edit", job, base, [=] {
        operation_result result;
        result.version =
          hold(self->state, simulation::nudged(self->state.versions.at(to_hex(base)),
                                               static_cast<std::int64_t>(vertex), by));
        return result;
      });
    },
    [=](job_id job, const check_order& order) {
      return add_task<check_result>(self, "check", job, order.before.id, [=] {
        edit_report report;
        report.operation = (*order.wanted.get())->operation;
        check_result result;
        result.version = order.candidate.version;
        result.load_cases = order.load_cases;
        result.report = wire_value(std::move(report));
        return result;
      });
    },
    [=](job_id job, const export_order& order) {
      return add_task<export_result>(self, "file", job, order.version.id,
                                     [] { return export_result{}; });
    },
    [=](job_id job, const solve_order& order) {
      return add_task<solve_result>(self, "solve", job, order.version.id, [=] {
        solve_outcome outcome;
        for (const auto& one : **order.load_cases.get())
          outcome.cases.push_back({.version_id = to_hex(order.version.id), .load_case = one.name});
        solve_result result;
        result.outcome = wire_value(std::move(outcome));
        if (self->state.add_fields)
          self->state.add_fields(result);
        return result;
      });
    },
    [=](const job_task& task) {
      return add_task<acknowledged>(self, "compare", {}, {}, [task] {
        task.run();
        return acknowledged{};
      });
    },
    [=](load_atom, const version_query& wanted) {
      return add_task<stored_version>(self, "load", {}, wanted.id, [=] {
        return stored_version{self->state.versions.at(to_hex(wanted.id)), 1000};
      });
    },
    [=](load_atom, const cad_query& wanted) {
      self->state.models.push_back(wanted.number);
      return add_task<stored_cad>(self, "model", {}, {}, [=] {
        auto row = std::make_shared<store::cad_row>();
        row->number = wanted.number;
        return stored_cad{std::move(row)};
      });
    },
    [=](job_id job, const cad_order& order) {
      return add_task<cad_outcome>(self, "cad", job, order.after->id(), [self] {
        auto row = std::make_shared<store::cad_row>();
        row->reason = std::exchange(self->state.mesh_only, {});
        row->status = row->reason.empty() ? "same" : "mesh_only";
        row->deviation = row->reason.empty() ? 2e-9 : 0;
        return cad_outcome{std::move(row)};
      });
    },
    [=](const stored_change& change) {
      self->state.changes.push_back(change.change);
      return add_task<acknowledged>(self, "commit", {}, {}, [] { return acknowledged{}; });
    },
    [=](copy_atom, const copy_order&) {
      return add_task<acknowledged>(self, "copy", {}, {}, [] { return acknowledged{}; });
    },
    [=](rename_atom, const std::string&) {
      return add_task<acknowledged>(self, "rename", {}, {}, [] { return acknowledged{}; });
    },
    [=](delete_atom) {
      return add_task<acknowledged>(self, "delete", {}, {}, [] { return acknowledged{}; });
    },
    [=](close_atom) {
      ++self->state.closed;
      return acknowledged{};
    },
    [](wake_atom) {},
    [=](cancel_atom, job_id job) { self->state.cancelled.push_back(job.value); },
    [](const doing& that) { that.what(); }};
}

/// Who hears of a document.
struct listener_state {
  std::vector<head_moved> heads;
  std::vector<load_cases_changed> loads;
  std::vector<solve_note> solves;
  std::vector<solved> results;
  std::vector<version_info> cad;
  std::vector<participant_changed> participants;
  std::vector<request_progress> progress;
  static inline const char* name = "listener";
};
using listener_actor = caf::stateful_actor<listener_state>;

inline caf::behavior make_listener(listener_actor* self, int /*number*/) {
  return {[=](const head_moved& e) { self->state.heads.push_back(e); },
          [=](const load_cases_changed& e) { self->state.loads.push_back(e); },
          [=](const solve_note& e) { self->state.solves.push_back(e); },
          [=](const solved& e) { self->state.results.push_back(e); },
          [=](const cad_known& e) { self->state.cad.push_back(e.info); },
          [](const version_annotated&) {},
          [=](const participant_changed& e) { self->state.participants.push_back(e); },
          [](const document_renamed&) {},
          [=](const request_progress& e) { self->state.progress.push_back(e); }};
}

class Session : public States {
protected:
  explicit Session(std::uint64_t version_budget = version_bytes, const stored_document& stored = {})
      : session_versions_(std::make_shared<version_memory>(version_budget)) {
    helper_ = stage_.system().spawn(make_helper, cache_);
    for (const auto& node : stored.nodes) {
      helper().versions[to_hex(node.mesh->id())] = node.mesh;
      cache_->put(*node.mesh);
    }
    pages_ = stage_.system().spawn(make_page_store, cache_);
    hub_ = stage_.system().spawn(
      [this](int) {
        return caf::behavior{[this](end_atom, const session_actor&) { ++end_asked_; }};
      },
      0);
    session_parts parts;
    parts.document = "part";
    parts.store = caf::actor_cast<store_actor>(helper_);
    parts.pages = pages_;
    parts.cache = cache_;
    parts.workers = {caf::actor_cast<modeling_actor>(helper_),
                     caf::actor_cast<optimizer_actor>(helper_),
                     caf::actor_cast<solver_actor>(helper_)};
    parts.hub = hub_;
    parts.results = session_results_;
    parts.versions = session_versions_;
    parts.reader = caf::actor_cast<job_thread_actor>(helper_);
    parts.cad = caf::actor_cast<cad_editor_actor>(helper_);
    begin(std::move(parts), stored);
  }

  /// The document is opened, by two.
  void begin(session_parts parts, stored_document stored) {
    for (std::uint32_t n = 0; n < stored.nodes.size(); ++n)
      if (n != stored.head)
        stored.nodes[n].mesh.reset();  // As `load_head` has it.
    session_ = stage_.system().spawn(make_session, std::move(parts), std::move(stored));
    mine_ = listen();
    other_ = listen();
  }

  /// As it looks after itself for ever, nothing would end it.
  ~Session() override { simulation::cut_off(caf::actor_cast<caf::actor>(session_)); }

  caf::actor listen(const std::string& name = {}) {
    const auto who = stage_.system().spawn(make_listener, 0);
    const auto got = ask<session_snapshot>(session_, attach_request{who, false, name});
    pass(milliseconds(1));
    EXPECT_TRUE(got.is_success());
    return who;
  }
  static listener_state& heard(const caf::actor& who) {
    return simulation::state_of<listener_state>(who);
  }
  helper_state& helper() { return simulation::state_of<helper_state>(helper_); }
  session_state& state() { return simulation::state_of<session_state>(session_); }

  template <class Result, class Request>
  answer<Result> request(const Request& wanted) {
    auto result = ask<Result>(session_, wanted);
    pass(milliseconds(1));
    return result;
  }

  answer<head_moved> import() {
    import_request wanted;
    wanted.ticket = ++tickets_;
    wanted.client = mine_;
    return request<head_moved>(wanted);
  }

  /// With an answer to everything that it needs.
  void import_all() {
    const auto got = import();
    finish({"import", "commit"});
    ASSERT_TRUE(got.is_success());
  }

  apply_request edit_by(double by, const change_terms& terms = {}) {
    apply_request wanted;
    wanted.ticket = ++tickets_;
    wanted.client = mine_;
    wanted.wanted.operation = "nudge";
    wanted.wanted.parameters["by"] = by;
    wanted.terms = terms;
    return wanted;
  }
  answer<head_moved> edit(double by, const change_terms& terms = {}) {
    return request<head_moved>(edit_by(by, terms));
  }
  /// Of another vertex than the first.
  answer<head_moved> edit_at(int vertex, const change_terms& terms,
                             const std::vector<surface_id>& selected = {}) {
    auto wanted = edit_by(.1, terms);
    wanted.wanted.parameters["vertex"] = double(vertex);
    wanted.wanted.surfaces = selected;
    return request<head_moved>(wanted);
  }
  answer<head_moved> move(move_kind kind, std::uint32_t number = 0) {
    return request<head_moved>(move_request{kind, number, {}, mine_});
  }
  answer<previewed> preview(double by) {
    return request<previewed>(preview_request{edit_by(by), false});
  }
  answer<acknowledged> set_load(const std::string& name, double newtons) {
    auto got = request<acknowledged>(
      note_request{set_load_case{simulation::made_up_load_case(name, newtons)}, {}});
    finish({"commit"});
    return got;
  }
  answer<solved> solve(const caf::actor& client) {
    solve_request wanted;
    wanted.ticket = ++tickets_;
    wanted.client = client;
    return request<solved>(wanted);
  }
  void cancel(std::uint64_t ticket) {
    caf::anon_send(session_, cancel_atom::value, ticket);
    pass(milliseconds(1));
  }

  /// The oldest task of a kind.
  open_task take(const std::string& what) {
    const auto found = std::ranges::find(helper().tasks, what, &open_task::what);
    if (found == helper().tasks.end()) {
      ADD_FAILURE() << "no " << what << " is asked for";
      return {what, 0, {}, [] {}, [](const error&) {}};
    }
    auto first = std::move(*found);
    helper().tasks.erase(found);
    return first;
  }
  void finish(const std::vector<std::string>& kinds) {
    for (const auto& what : kinds)
      within(helper_, take(what).succeed);
  }
  void refuse(const std::string& what, const error& why) {
    within(helper_, [task = take(what), why] { task.fail(why); });
  }
  std::vector<std::string> tasks() {
    std::vector<std::string> kinds;
    for (const auto& one : helper().tasks)
      kinds.push_back(one.what);
    return kinds;
  }
  std::string head() { return to_hex(state().graph.head()->info.id); }

  std::shared_ptr<page_cache> cache_ = std::make_shared<page_cache>(std::size_t{0});
  std::shared_ptr<result_memory> session_results_ = std::make_shared<result_memory>(1000);
  std::shared_ptr<version_memory> session_versions_;
  caf::actor helper_, hub_, mine_, other_;
  page_store_actor pages_;
  session_actor session_;
  std::uint64_t tickets_ = 0;
  int end_asked_ = 0;
};

}  // namespace tedit::actors
