// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <caf/actor.hpp>
#include <caf/error.hpp>
#include <caf/meta/type_name.hpp>

#include "actors/wire_value.hpp"
#include "base/trace_context.hpp"
#include "edit/report.hpp"
#include "fem/load_case.hpp"
#include "fem/solve_report.hpp"
#include "mesh/features/select.hpp"
#include "mesh/field.hpp"
#include "mesh/version.hpp"
#include "protocol/operation_message.hpp"

/// What travels between nodes: small control messages. Mesh bytes travel only as `page_batch`.
namespace tedit {

using load_case_list = std::vector<fem::load_case>;

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, hash128& h) {
  return f(caf::meta::type_name("hash128"), h.high, h.low);
}

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, thorough_settings& x) {
  return f(caf::meta::type_name("thorough_settings"), x.target, x.insert_below, x.harmonic,
           x.tolerance.absolute, x.tolerance.relative, x.rounds);
}

}  // namespace tedit

namespace tedit::ops {

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, figure& x) {
  return f(caf::meta::type_name("figure"), x.id, x.value, x.unit, x.help);
}

/// All but the candidate.
template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, edit_result& x) {
  return f(caf::meta::type_name("edit_result"), x.touched, x.volume_change, x.improve, x.thorough,
           x.surfaces_used, x.notices, x.figures, x.quality_floor, x.bodies_added);
}

}  // namespace tedit::ops

namespace tedit::actors {

using hash_list = std::vector<hash128>;

/// Names one piece of work for its whole life: progress, cancel and answer carry it.
struct job_id {
  std::uint64_t value = 0;

  friend bool operator==(job_id, job_id) = default;
  friend auto operator<=>(job_id, job_id) = default;
};

/// A job that is done in several places has parts, which are jobs of their own.
inline constexpr int part_shift = 48;

[[nodiscard]] constexpr job_id part_of(job_id whole, std::size_t number) {
  return {whole.value | (static_cast<std::uint64_t>(number + 1) << part_shift)};
}

/// Whether two jobs are parts of one.
[[nodiscard]] constexpr bool are_parts_of_one(job_id a, job_id b) {
  constexpr auto whole = (std::uint64_t{1} << part_shift) - 1;
  return (a.value & whole) == (b.value & whole) && a.value > whole && b.value > whole;
}

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, job_id& x) {
  return f(caf::meta::type_name("job_id"), x.value);
}

/// A version without its pages: the list of them, whose hash is the id.
struct version_ref {
  hash128 id;
  std::shared_ptr<const manifest> pages;  ///< Null when it was damaged on its way.
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, version_ref& x) {
  std::vector<char> bytes;
  if constexpr (Inspector::reads_state) {
    if (x.pages) {
      const auto list = x.pages->to_bytes();
      bytes.resize(list.size());
      std::memcpy(bytes.data(), list.data(), list.size());
    }
    return f(caf::meta::type_name("version_ref"), x.id, bytes);
  } else {
    if (auto failed = f(caf::meta::type_name("version_ref"), x.id, bytes))
      return failed;
    const auto list = std::as_bytes(std::span(bytes));
    if (auto read = manifest::from_bytes(list); read && hash_bytes(list) == x.id)
      x.pages = std::make_shared<const manifest>(std::move(*read));
    return caf::none;
  }
}

/// Pages in the order in which they were asked for.
struct page_batch {
  std::vector<std::uint32_t> sizes;
  std::vector<char> bytes;
  bool packed = false;  ///< The bytes, not the sizes (actors/pages/page_batch.hpp).
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, page_batch& x) {
  return f(caf::meta::type_name("page_batch"), x.sizes, x.bytes, x.packed);
}

// -- orders to workers and what comes back -------------------------------------------------

/// Every order carries the page store that has its pages, and who hears of progress.
struct order_base {
  caf::actor source;
  caf::actor listener;
  /// Who asked, for the turns in a pool; 0: nobody. It does not travel: workers need not know.
  std::uint64_t client = 0;
  tracing::context trace = {};  ///< Of the request; it does not travel either.
};

/// A mesh file, cut into pages, to be read.
struct import_order {
  order_base base;
  hash_list file;
  std::uint64_t size = 0;
  std::string file_name;
  std::string length_unit;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, import_order& x) {
  return f(caf::meta::type_name("import_order"), x.base.source, x.base.listener, x.file, x.size,
           x.file_name, x.length_unit);
}

struct import_result {
  version_ref version;
  std::vector<std::string> warnings;
  caf::actor source;  ///< The page store that has the version's pages.
  double import_ms = 0;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, import_result& x) {
  return f(caf::meta::type_name("import_result"), x.version, x.warnings, x.source, x.import_ms);
}

/// An operation to apply.
struct edit_order {
  order_base base;
  version_ref version;
  wire_value<edit_request> wanted;
  bool preview = false;   ///< Gives way to all other work.
  bool find_most = true;  ///< Where it is refused, look for the most that works.
  bool draft = false;     ///< Only what is seen of it (`ops::make_draft_services`).
  /// Whose edit this is, for the quarantine. They do not travel: workers need not know.
  std::string document;
  std::string client;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, edit_order& x) {
  return f(caf::meta::type_name("edit_order"), x.base.source, x.base.listener, x.version, x.wanted,
           x.preview, x.find_most, x.draft);
}

/// What an operation made and what it says about it; nothing of it is trusted before the checks.
struct operation_result {
  version_ref version;
  ops::edit_result said;  ///< Without the candidate, which is `version`.
  double operation_ms = 0;
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, operation_result& x) {
  return f(caf::meta::type_name("operation_result"), x.version, x.said, x.operation_ms, x.source);
}

/// A candidate to improve and to check.
struct check_order {
  order_base base;
  version_ref before;
  operation_result candidate;
  wire_value<edit_request> wanted;
  wire_value<load_case_list> load_cases;  ///< Carried over by surface ids.
  bool preview = false;                   ///< Gives way to all other work.
  bool draft = false;                     ///< Nothing is improved or checked.
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, check_order& x) {
  return f(caf::meta::type_name("check_order"), x.base.source, x.base.listener, x.before,
           x.candidate, x.wanted, x.load_cases, x.preview, x.draft);
}

/// A version that passed every postcondition.
struct check_result {
  version_ref version;
  wire_value<load_case_list> load_cases;
  wire_value<edit_report> report;  ///< Without `total_ms`.
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, check_result& x) {
  return f(caf::meta::type_name("check_result"), x.version, x.load_cases, x.report, x.source);
}

struct solve_order {
  order_base base;
  version_ref version;
  wire_value<load_case_list> load_cases;  ///< Several are solved together.
  std::string device;
  double tolerance = 1e-6;
  double energy_tolerance = 0;  ///< 0: none.
  std::int32_t element_order = 2;
  /// Its load cases are some of several that are solved in different places: arrays are named
  /// after their case also where there is one.
  bool of_several = false;
  /// All load cases in one place, as their files are to come from there. It does not travel.
  bool in_one_place = false;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, solve_order& x) {
  return f(caf::meta::type_name("solve_order"), x.base.source, x.base.listener, x.version,
           x.load_cases, x.device, x.tolerance, x.energy_tolerance, x.element_order, x.of_several);
}

/// A field without its pages.
struct field_ref {
  std::string name;
  bool on_vertices = true;
  std::int32_t components = 1;
  std::uint64_t size = 0;  ///< Values.
  hash_list pages;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, field_ref& x) {
  return f(caf::meta::type_name("field_ref"), x.name, x.on_vertices, x.components, x.size, x.pages);
}

struct solve_result {
  wire_value<solve_outcome> outcome;
  std::vector<field_ref> fields;
  std::vector<field_ref> more;  ///< That only files have; they stay where they are until asked for.
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, solve_result& x) {
  return f(caf::meta::type_name("solve_result"), x.outcome, x.fields, x.more, x.source);
}

/// A version, with fields when there are any, to write as a file.
struct export_order {
  order_base base;
  version_ref version;
  std::vector<field_ref> fields;      ///< To go into the file; none where the format keeps none.
  wire_value<solve_outcome> outcome;  ///< Of the fields; none without them.
  std::string format;                 ///< A name in mesh/formats.hpp.
  std::string length_unit;
  /// The load case of a deck that another solver runs; none of a mesh alone.
  wire_value<load_case_list> loads = wire_value<load_case_list>(load_case_list{});
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, export_order& x) {
  return f(caf::meta::type_name("export_order"), x.base.source, x.base.listener, x.version,
           x.fields, x.outcome, x.format, x.length_unit, x.loads);
}

/// A file's bytes, cut into pages.
struct export_result {
  hash_list pages;
  std::uint64_t size = 0;
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, export_result& x) {
  return f(caf::meta::type_name("export_result"), x.pages, x.size, x.source);
}

/// A question about which surfaces of a version belong together.
struct select_order {
  order_base base;
  version_ref version;
  wire_value<selection_query> query;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, select_order& x) {
  return f(caf::meta::type_name("select_order"), x.base.source, x.base.listener, x.version,
           x.query);
}

struct select_result {
  wire_value<std::vector<found_feature>> features;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, select_result& x) {
  return f(caf::meta::type_name("select_result"), x.features);
}

/// The operations there are.
using shared_catalogue = wire_value<operation_catalogue>;

// -- notes on the way ------------------------------------------------------------------------

struct job_progress {
  job_id job;
  double fraction = 0;
  std::string stage;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, job_progress& x) {
  return f(caf::meta::type_name("job_progress"), x.job, x.fraction, x.stage);
}

/// A solve that converges. Of several load cases: the most iterations, the largest residual.
struct job_frame {
  job_id job;
  std::int32_t iterations = 0;
  double residual = 1;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, job_frame& x) {
  return f(caf::meta::type_name("job_frame"), x.job, x.iterations, x.residual);
}

/// The field of a solve that still runs.
struct job_preview {
  job_id job;
  solve_result result;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, job_preview& x) {
  return f(caf::meta::type_name("job_preview"), x.job, x.result);
}

/// A worker process that says that it is there. That the supervisor started it is known by the link
/// over which it says so.
struct enlistment {
  std::int32_t pid = 0;
  caf::actor worker;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, enlistment& x) {
  return f(caf::meta::type_name("enlistment"), x.pid, x.worker);
}

/// What a worker on another machine says of itself.
struct node_facts {
  std::string name;     ///< As its certificate has it; the server puts that in.
  std::string address;  ///< Where its connection comes from; the server puts that in.
  std::string version;  ///< Of TEdit: "0.9.1".
  std::string device;   ///< What it computes on, for people.
  /// A solver of its own kind: solves what asks for a device of this name, and nothing else.
  std::string own_device;
  std::uint32_t threads = 0;
  std::uint64_t memory_bytes = 0;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, node_facts& x) {
  return f(caf::meta::type_name("node_facts"), x.name, x.address, x.version, x.device, x.own_device,
           x.threads, x.memory_bytes);
}

/// A worker on another machine that wants to work here. Its role is the certificate's.
struct node_enlistment {
  std::string role;
  node_facts node;
  caf::actor worker;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, node_enlistment& x) {
  return f(caf::meta::type_name("node_enlistment"), x.role, x.node, x.worker);
}

/// Whether it may; else why not and what helps.
struct node_answer {
  bool accepted = false;
  bool later = false;  ///< Asking again may come to something else.
  std::string reason;
  std::string remedy;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, node_answer& x) {
  return f(caf::meta::type_name("node_answer"), x.accepted, x.later, x.reason, x.remedy);
}

/// A worker that wants no more work, sent to its pool before the answer to its last job.
struct retirement {
  std::string why;  ///< "it left 213 files open".
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, retirement& x) {
  return f(caf::meta::type_name("retirement"), x.why);
}

/// A worker on another machine, as its pool sees it.
struct node_status {
  std::string name;
  std::string address;
  std::string role;
  std::string state;  ///< "idle", "working", "leaving", "lost".
  std::string device;
  std::string version;
  std::uint32_t threads = 0;
  std::uint64_t memory_bytes = 0;
  double connected_s = 0;
  std::uint64_t jobs_done = 0;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, node_status& x) {
  return f(caf::meta::type_name("node_status"), x.name, x.address, x.role, x.state, x.device,
           x.version, x.threads, x.memory_bytes, x.connected_s, x.jobs_done);
}

/// How a worker, or the pool that stands for several, is.
struct worker_status {
  std::string role;
  std::string state;  ///< "ready", "starting", "degraded".
  std::int32_t pid = 0;
  std::uint32_t restarts = 0;
  std::uint32_t jobs = 0;
  std::string detail;
  std::vector<node_status> nodes;   ///< Of a pool: those that joined from other machines.
  std::uint32_t free_machines = 0;  ///< Of a pool: those with a worker that has nothing to do.
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, worker_status& x) {
  return f(caf::meta::type_name("worker_status"), x.role, x.state, x.pid, x.restarts, x.jobs,
           x.detail, x.nodes, x.free_machines);
}

}  // namespace tedit::actors
