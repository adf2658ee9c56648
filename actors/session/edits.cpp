// SPDX-License-Identifier: AGPL-3.0-or-later
#include <span>

#include <nlohmann/json.hpp>

#include "actors/errors.hpp"
#include "actors/session/candidate.hpp"
#include "actors/session/numbers.hpp"
#include "actors/store/loading.hpp"
#include "actors/store/store.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"
#include "base/text.hpp"
#include "mesh/edit_overlap.hpp"
#include "mesh/formats.hpp"
#include "ops/loader/picks.hpp"
#include "protocol/forms.hpp"

namespace tedit::actors {

namespace {

/// Which file, whatever it is called.
asked_change asked_by(const import_request& request) {
  std::string ids;
  for (const auto& p : request.file)
    ids += to_hex(p->id());
  const nlohmann::json how{{"file", request.file_name},
                           {"length_unit", request.length_unit},
                           {"content", to_hex(hash_bytes(std::as_bytes(std::span(ids))))}};
  return {"import", how.dump()};
}

/// Read and written again for the order of its keys: protobuf keeps none for parameters, and the
/// same request, sent twice, must give the same text.
asked_change asked_by(const apply_request& request) {
  const auto how = nlohmann::json::parse(protocol::to_json(request.wanted), nullptr, false);
  return {"edit", how.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

asked_change asked_by(const move_request& request) {
  if (request.kind == move_kind::go_to)
    return {"goto", nlohmann::json{{"number", request.number}}.dump()};
  return {request.kind == move_kind::undo ? "undo" : "redo", "{}"};
}

/// "surfaces 3, 17": as many as a sentence has room for.
std::string words_of(const std::vector<surface_id>& surfaces) {
  constexpr std::size_t most = 8;
  const auto first = std::span(surfaces).first(std::min(surfaces.size(), most));
  return (surfaces.size() == 1 ? "surface " : "surfaces ") + list_of(first) +
         (surfaces.size() > most ? ", ..." : "");
}

/// All surfaces that a request names: those of its selection, and those by which its places are
/// given.
std::vector<surface_id> surfaces_named_by(const edit_request& wanted) {
  auto all = wanted.surfaces;
  for (const auto& [id, value] : wanted.parameters)
    if (const auto* text = std::get_if<std::string>(&value)) {
      const auto more = ops::surfaces_of_picks(*text);
      all.insert(all.end(), more.begin(), more.end());
    }
  return all;
}

/// What an edit that is carried over met, as the end of a sentence about the head.
std::string words_of(const edit_overlap& met) {
  if (!met.reshaped.empty())
    return "; since then " + words_of(met.reshaped) + " that the edit names " +
           (met.reshaped.size() == 1 ? "was" : "were") + " changed";
  return "; since then " + std::to_string(met.tets) + " of the tets that the edit would change " +
         (met.tets == 1 ? "was" : "were") + " changed" +
         (met.surfaces.empty() ? std::string() : ", at " + words_of(met.surfaces));
}

bool keeps_fields(const std::string& format) {
  const auto* row = find_format(format);
  return row && row->keeps.fields;
}

}  // namespace

struct session_state::import_run {
  import_request request;
  asked_change asked;
  caf::typed_response_promise<head_moved> promise;
  int retries = 0;
};

struct session_state::edit_run {
  apply_request request;
  version_ptr seen;  ///< The version that it was made for, where that is not the head.
  std::uint32_t seen_number = 0;
  asked_change asked;
  caf::typed_response_promise<head_moved> promise;
  stopwatch total;
};

// -- import ----------------------------------------------------------------------------------

caf::result<head_moved> session_state::import(const import_request& request) {
  auto run = std::make_shared<import_run>();
  run->request = request;
  run->asked = asked_by(request);
  run->promise = self->make_response_promise<head_moved>();
  enqueue({request.ticket, request.client, [=, this] { begin_import(run); },
           [=](const error& e) { run->promise.deliver(to_caf(e)); }});
  return run->promise;
}

void session_state::begin_import(const std::shared_ptr<import_run>& run) {
  const auto& request = run->request;
  if (is_settled(request.terms, run->asked, run->promise))
    return finish_command();
  const auto job = new_job(request.ticket, request.client);
  const auto fail_import = [=, this](const error& e) {
    progress_of.erase(job);
    if (worth_a_retry(e) && !running->cancelled && run->retries++ < most_retries)
      return begin_import(run);
    run->promise.deliver(to_caf(e));
    finish_command();
  };
  self->send(parts.store, wake_atom::value);
  import_order order{base_order(job), {}, request.size, request.file_name, request.length_unit};
  for (const auto& p : request.file) {
    parts.cache->put(p);
    order.file.push_back(p->id());
  }
  running->cancel_job = [=, this] {
    caf::anon_send(parts.workers.modeling, cancel_atom::value, job);
  };
  const auto accept = [=, this](const import_result& result, const page_set& pages) {
    auto mesh = open_version(result.version, pages);
    if (!mesh)
      return fail_import(mesh.error());
    progress_of.erase(job);
    auto node = graph.draft();
    node.info.operation = "import";
    describe_mesh(node, *mesh);
    auto made = begin_change(run->request.terms, run->asked);
    made.warnings = result.warnings;
    commit_node(std::move(node), std::move(made), run->asked.how,
                {run->request.client, run->promise});
  };
  self->request(parts.workers.modeling, answer_limit, job, std::move(order))
    .then(
      [=, this](const import_result& result) {
        const auto ids = pages_of(result.version);
        if (!ids)
          return fail_import(ids.error());
        pull(
          result.source, *ids, [=](const page_set& pages) { accept(result, pages); }, fail_import);
      },
      [=](const caf::error& e) { fail_import(from_caf(e, "the import")); });
}

// -- edit --------------------------------------------------------------------------------------

caf::result<head_moved> session_state::edit(const apply_request& request) {
  auto run = std::make_shared<edit_run>();
  run->request = request;
  run->asked = asked_by(request);
  run->promise = self->make_response_promise<head_moved>();
  enqueue({request.ticket, request.client, [=, this] { begin_edit(run); },
           [=](const error& e) { run->promise.deliver(to_caf(e)); }});
  return run->promise;
}

void session_state::begin_edit(const std::shared_ptr<edit_run>& run) {
  const auto& request = run->request;
  if (is_settled(request.terms, run->asked, run->promise))
    return finish_command();
  if (!graph.head())
    return refuse_edit(run, empty_document());
  const auto* seen = carried_from(request.terms);
  if (!seen)
    return make_edit(run);
  run->seen_number = seen->info.number;
  with_mesh(
    run->seen_number,
    [=, this](const version_ptr& mesh) {
      if (running->cancelled)
        return refuse_edit(run, {ec::cancelled, "the edit was cancelled", {}, {}});
      run->seen = mesh;
      make_edit(run);
    },
    [=, this](const error& e) { refuse_edit(run, e); });
}

/// What was previewed is not made again.
void session_state::make_edit(const std::shared_ptr<edit_run>& run) {
  const auto& request = run->request;
  const auto* head = graph.head();
  if (last_preview && last_preview->serves(request, *head))
    return commit_edit(run, *last_preview->made);
  auto work = std::make_shared<candidate_run>();
  work->request = request;
  work->base = head->mesh;
  work->load_cases = head->load_cases;
  work->done = [=, this](const std::shared_ptr<const checked_candidate>& made) {
    commit_edit(run, *made);
  };
  work->refuse = [=, this](const error& e) { refuse_edit(run, e); };
  running->cancel_job = [=] { work->cancel(); };
  self->send(parts.store, wake_atom::value);
  make_candidate(work);
}

void session_state::refuse_edit(const std::shared_ptr<edit_run>& run, const error& e) {
  auto said = e;
  if (run->seen && e.code != ec::cancelled)
    said.message += " (on version " + std::to_string(graph.head()->info.number) +
                    ", the head; the edit was made for version " +
                    std::to_string(run->seen_number) + ")";
  run->promise.deliver(to_caf(said));
  finish_command();
}

void session_state::commit_edit(const std::shared_ptr<edit_run>& run,
                                const checked_candidate& made) {
  const auto& request = run->request;
  if (run->seen) {
    const auto met =
      overlap_of(*run->seen, *graph.head()->mesh, *made.mesh, surfaces_named_by(request.wanted));
    if (!met.none()) {
      numbers::carried_over(false).add();
      run->promise.deliver(other_head(request.terms, words_of(met)));
      return finish_command();
    }
    numbers::carried_over(true).add();
  }
  auto node = graph.draft();
  node.info.operation = request.wanted.operation;
  node.info.load_cases = names_of(*made.load_cases);
  node.load_cases = made.load_cases;
  auto report = *made.timed_report(run->total.milliseconds());
  if (run->seen)
    report.notices.push_back("carried over from version " + std::to_string(run->seen_number) +
                             ": what was changed since then is elsewhere");
  node.report = std::make_shared<const edit_report>(std::move(report));
  describe_mesh(node, made.mesh);
  node.info.cad = cad_of_child(node);
  auto made_now = begin_change(request.terms, run->asked);
  made_now.operation = request.wanted.operation;
  const auto number = node.info.number;
  commit_node(std::move(node), std::move(made_now), run->asked.how, {request.client, run->promise},
              [=, this] { add_to_cad(number, run->request.wanted); });
}

// -- the head moves ------------------------------------------------------------------------------

void session_state::commit_node(graph_node node, past_change made, const std::string& how,
                                head_waiter asked_by, const std::function<void()>& then) {
  const auto* head = graph.head();
  node.info.made_by = made.client;
  node.info.made_at = made.time;
  auto change = change_of(node, head ? head->mesh.get() : nullptr);
  made.version = node.info.number;
  change.what = made.what;
  change.details = made.to_details(how);
  parts.cache->put(*node.mesh);
  std::uint64_t bytes = 0;
  for (const auto& p : change.new_pages)
    bytes += p->bytes().size();
  auto shared = std::make_shared<graph_node>(std::move(node));
  commit(
    std::move(change),
    [=, this](double ms) mutable {
      leave_head();
      nearby[shared->info.number].bytes = bytes;
      graph.add(std::move(*shared));
      show_head(made, ms, std::move(asked_by));
      if (then)
        then();
    },
    [=, this](const error& e) mutable {
      asked_by.promise.deliver(to_caf(e));
      finish_command();
    });
}

/// What follows once a change that moved the head is durable.
void session_state::show_head(const past_change& made, double commit_ms, head_waiter asked_by) {
  numbers::heads_moved(made.what).add();
  past.add(made);
  last_preview.reset();
  head_trace = running ? tracing::of(running->ticket) : tracing::context{};
  auto moved = describe(*graph.head(), made.what);
  moved.commit_ms = commit_ms;
  moved.warnings = made.warnings;
  broadcast(moved, {asked_by.client});
  asked_by.promise.deliver(std::move(moved));
  follow_head();
  finish_command();
}

head_moved session_state::describe(const graph_node& node, const std::string& cause) const {
  head_moved moved;
  moved.document = parts.document;
  moved.head = node.info;
  moved.version = node.mesh;
  moved.load_cases = node.load_cases;
  moved.cause = cause;
  if (cause == "edit")
    moved.report = node.report;
  moved.can_undo = node.info.parent.has_value();
  moved.can_redo = node.redo.has_value();
  return moved;
}

caf::result<head_moved> session_state::move(const move_request& request) {
  auto promise = self->make_response_promise<head_moved>();
  enqueue({request.ticket, request.client, [=, this] { begin_move(request, promise); },
           [=](const error& e) mutable { promise.deliver(to_caf(e)); }});
  return promise;
}

void session_state::begin_move(const move_request& request,
                               caf::typed_response_promise<head_moved> promise) {
  const auto asked = asked_by(request);
  if (is_settled(request.terms, asked, promise))
    return finish_command();
  const auto target = graph.target_of(request);
  if (!target) {
    promise.deliver(to_caf(target.error()));
    return finish_command();
  }
  with_mesh(
    target->number,
    [=, this, target = *target](const version_ptr& mesh) {
      commit_move(request, target, mesh, promise);
    },
    [=, this](const error& e) mutable {
      promise.deliver(to_caf(e));
      finish_command();
    });
}

void session_state::commit_move(const move_request& request, const version_graph::target& target,
                                const version_ptr& mesh,
                                caf::typed_response_promise<head_moved> promise) {
  const auto asked = asked_by(request);
  auto made = begin_change(request.terms, asked);
  made.version = target.number;
  store::change change;
  change.head = target.number;
  change.what = made.what;
  change.details = made.to_details(asked.how);
  change.redo.assign(target.redo.begin(), target.redo.end());
  commit(
    std::move(change),
    [=, this](double ms) mutable {
      for (const auto& [number, child] : target.redo)
        graph.set_redo(number, child);
      leave_head();
      graph.move_to(target.number, mesh);
      nearby[target.number].kept.reset();
      show_head(made, ms, {request.client, std::move(promise)});
    },
    [=, this](const error& e) mutable {
      promise.deliver(to_caf(e));
      finish_command();
    });
}

// -- files ------------------------------------------------------------------------------------

caf::result<exported> session_state::write_file(const export_request& request) {
  if (request.format == document_format)
    return self->delegate(parts.store, copy_atom::value);
  const auto* node = request.version.empty() ? graph.head() : graph.find(request.version);
  if (!node)
    return to_caf(request.version.empty()
                    ? empty_document()
                    : error{ec::not_found, "there is no version " + request.version, {}, {}});
  const auto promise = std::make_shared<caf::typed_response_promise<exported>>(
    self->make_response_promise<exported>());
  const auto number = node->info.number;
  with_mesh(
    number,
    [=, this](const version_ptr& mesh) {
      write_version(request, graph.nodes()[number], mesh, promise);
    },
    [=](const error& e) { promise->deliver(to_caf(e)); });
  return *promise;
}

void session_state::write_version(
  const export_request& request, const graph_node& node, const version_ptr& mesh,
  const std::shared_ptr<caf::typed_response_promise<exported>>& promise) {
  load_case_list loads;
  if (!request.load_case.empty()) {
    auto chosen = cases_named(node, {request.load_case});
    if (!chosen) {
      promise->deliver(to_caf(chosen.error()));
      return;
    }
    loads = std::move(*chosen);
  }
  const auto job = new_job(request.ticket, request.client);
  export_order order{base_order(job),
                     make_ref(mesh),
                     {},
                     {},
                     request.format,
                     request.length_unit,
                     wire_value(std::move(loads))};
  const auto file_name =
    parts.document + "_v" + std::to_string(node.info.number) + "." + request.format;
  const auto* result = result_of(node);
  if (!result || !keeps_fields(request.format))
    return send_export(job, order, file_name, promise, mesh);
  fetch_all_fields(
    *result, mesh, order.base,
    [=, this](const solve_result& fields, const page_set& pages) mutable {
      order.fields = fields.fields;
      order.fields.insert(order.fields.end(), fields.more.begin(), fields.more.end());
      order.outcome = fields.outcome;
      send_export(job, order, file_name, promise, mesh, pages);
    },
    [=, this](const error& e) {
      progress_of.erase(job);
      promise->deliver(to_caf(e));
    });
}

void session_state::send_export(
  job_id job, const export_order& order, const std::string& file_name,
  const std::shared_ptr<caf::typed_response_promise<exported>>& promise, const version_ptr& mesh,
  const page_set& held, int retries) {
  const auto refuse = [=, this](const error& e) {
    progress_of.erase(job);
    promise->deliver(to_caf(e));
  };
  // The order names the pages of both: they are held here until the worker has read them.
  self->request(parts.workers.modeling, answer_limit, job, order)
    .then(
      [=, this, mesh = mesh, until_now = held](const export_result& result) {
        pull(
          result.source, result.pages,
          [=, this](const page_set& pages) {
            exported file{file_name, {}, result.size};
            for (const auto& id : result.pages)
              file.pages.push_back(pages.find(id));
            progress_of.erase(job);
            promise->deliver(std::move(file));
          },
          [=, this](const error& e) {  // The worker may have died after it answered.
            if (!worth_a_retry(e) || retries >= most_retries)
              return refuse(e);
            send_export(job, order, file_name, promise, mesh, until_now, retries + 1);
          });
      },
      [=](const caf::error& e) { refuse(from_caf(e, "writing the file")); });
}

caf::result<selected> session_state::select(const select_request& request) {
  const auto* head = graph.head();
  if (!head)
    return to_caf(empty_document());
  const auto promise = std::make_shared<caf::typed_response_promise<selected>>(
    self->make_response_promise<selected>());
  const auto job = new_job(request.ticket, request.client);
  const auto version = to_hex(head->info.id);
  self
    ->request(parts.workers.modeling, answer_limit, job,
              select_order{base_order(job), make_ref(head->mesh), wire_value(request.query)})
    .then(
      [=, this](const select_result& result) {
        progress_of.erase(job);
        if (const auto features = result.features.get())
          promise->deliver(selected{parts.document, version, *features});
        else
          promise->deliver(
            to_caf({ec::internal,
                    "the answer to the selection cannot be read: " + features.error().message,
                    "Use a server and workers of one release",
                    {}}));
      },
      [=, this](const caf::error& e) {
        progress_of.erase(job);
        promise->deliver(to_caf(from_caf(e, "the selection")));
      });
  return *promise;
}

}  // namespace tedit::actors
