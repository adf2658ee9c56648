// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <caf/atom.hpp>
#include <caf/replies_to.hpp>
#include <caf/typed_actor.hpp>

#include "actors/messages.hpp"

/// What a node with an observer's certificate may ask and hears: documents that others edit. It
/// changes nothing. Pages of what it hears of are fetched from the `source` that each event names.
namespace tedit::actors {

using names_atom = caf::atom_constant<caf::atom("names")>;
using watch_atom = caf::atom_constant<caf::atom("watch")>;

/// A version that became the head of a document, or is it when the watching begins.
struct observed_version {
  std::string document;
  std::uint32_t number = 0;
  std::int64_t parent = -1;  ///< The number of the version that it was made of; -1: none.
  std::string cause;         ///< "import", "edit", "undo", "redo", "goto"; "head" at first.
  std::string operation;     ///< That made the version: "import", or an operation's.
  version_ref version;
  wire_value<load_case_list> load_cases;
  bool has_report = false;
  wire_value<edit_report> report;  ///< What an edit did that has just been made.
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, observed_version& x) {
  return f(caf::meta::type_name("observed_version"), x.document, x.number, x.parent, x.cause,
           x.operation, x.version, x.load_cases, x.has_report, x.report, x.source);
}

/// Load cases of the head that somebody changed.
struct observed_load_cases {
  std::string document;
  wire_value<load_case_list> load_cases;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, observed_load_cases& x) {
  return f(caf::meta::type_name("observed_load_cases"), x.document, x.load_cases);
}

/// The result of a solve that has ended, with the fields that clients are sent.
struct observed_result {
  std::string document;
  version_ref version;
  wire_value<solve_outcome> outcome;
  std::vector<field_ref> fields;
  caf::actor source;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, observed_result& x) {
  return f(caf::meta::type_name("observed_result"), x.document, x.version, x.outcome, x.fields,
           x.source);
}

/// A document is called otherwise from now on.
struct observed_name {
  std::string before;
  std::string document;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, observed_name& x) {
  return f(caf::meta::type_name("observed_name"), x.before, x.document);
}

/// Nothing more will be heard of a document.
struct observed_end {
  std::string document;
  std::string why;
};

template <class Inspector>
typename Inspector::result_type inspect(Inspector& f, observed_end& x) {
  return f(caf::meta::type_name("observed_end"), x.document, x.why);
}

/// Hears of documents, on the observer's node; each answer says that the event was taken. Who is
/// more than `most_unanswered` events behind is cut off.
using observer_actor = caf::typed_actor<
  caf::replies_to<observed_version>::with<bool>, caf::replies_to<observed_load_cases>::with<bool>,
  caf::replies_to<observed_result>::with<bool>, caf::replies_to<observed_name>::with<bool>,
  caf::replies_to<observed_end>::with<bool>>;

/// Events under way to one observer.
inline constexpr std::size_t most_unanswered = 64;

/// What an observer talks to.
using observation_actor = caf::typed_actor<
  // Documents that it may watch.
  caf::replies_to<names_atom>::with<std::vector<std::string>>,
  // Tells an observer of the same node all of a document from now on, its present head and result
  // first. The answer is the document's present name. Errors: `not_found`; `invalid_argument`.
  caf::replies_to<watch_atom, std::string, caf::actor>::with<std::string>>;

}  // namespace tedit::actors
