// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

#include "client-qt/model/document.hpp"
#include "client-qt/model/quantities.hpp"

/// How strong the part is: the figures of a version's solve as rows for people.
namespace tedit::desktop {

/// What a row says.
enum class figure {
  stress,        ///< The largest von Mises stress.
  sound_stress,  ///< The same apart from singular places.
  displacement,  ///< The largest one.
  safety,        ///< The least safety factor.
  reaction,      ///< Of one support.
  reaction_sum,  ///< Of all supports, against the loads.
  error,         ///< The estimated error of the stresses.
  mass
};

struct result_row {
  figure kind = figure::stress;
  QString title;           ///< "Largest von Mises stress".
  shown_quantity value;    ///< Never empty: what is not known has no row.
  QString where;           ///< "Bore wall"; of places only once `name_places` was there.
  QString note;            ///< A few more words; may be empty.
  QString warning;         ///< Why the value must not be taken for what it seems; mostly empty.
  std::optional<vec3> at;  ///< Where to look, m, not deformed,
  std::vector<surface_id> surfaces;  ///< or which surfaces.
  bool compares = false;             ///< Whether the version before has such a value, known or not.
  std::optional<shown_quantity> before;  ///< Of the version before, when it is known.
  QString change;                        ///< "+3.2 %"; empty when `before` is.

  friend bool operator==(const result_row&, const result_row&) = default;
};

/// The rows of one load case, of the envelope, or of the part as such.
struct result_section {
  QString title;
  std::string load_case;  ///< Empty for the envelope and the part.
  std::vector<result_row> rows;
  QStringList hints;  ///< What is missing, and what to do that it is there.

  friend bool operator==(const result_section&, const result_section&) = default;
};

struct results_summary {
  QString state;                         ///< "Version 3: final".
  QString missing;                       ///< Why there is no row, and what to do; else empty.
  std::optional<std::uint32_t> before;   ///< The version that is compared with.
  bool final = false;                    ///< No preview: converged, quadratic tets.
  std::vector<result_section> sections;  ///< Worst of all, each load case, the part.

  friend bool operator==(const results_summary&, const results_summary&) = default;
};

/// What a summary is made of.
struct summary_input {
  const version_record* version = nullptr;  ///< Null: there is no part.
  const version_record* parent = nullptr;   ///< Null: it has none.
  field_state state = field_state::none;
  QString failure;  ///< Why the solve failed; may be empty.
  std::function<QString(surface_id)> surface_name;
};

/// That of a document's head as it is now. It names surfaces as long as `part` lives.
[[nodiscard]] summary_input summary_input_of(const document& part);

/// The reports of the field that is shown: the converged ones, or those of a first field while the
/// solve runs; nothing when there are none, or none of the present loads.
[[nodiscard]] std::optional<solve_outcome> shown_outcome(const version_record& version,
                                                         field_state state);

/// The rows. Values that are 0 or not known have none. Cost: O(boundary vertices) where the largest
/// stress is at a singular place, else as many steps as there are numbers in the reports.
[[nodiscard]] results_summary summarise(const summary_input& from);

/// The places that rows are about, m.
[[nodiscard]] std::vector<vec3> points_of(const results_summary& summary);

/// Gives rows the words of their places.
void name_places(results_summary& summary, const std::function<QString(const vec3&)>& words);

/// A part of a whole in percent with two digits, for what is only estimated: "12".
[[nodiscard]] QString percent_words(double part);

/// What an estimated relative error in the energy norm means: "good: ...". See
/// docs/results.md for the limits.
[[nodiscard]] QString error_words(double relative_error);

/// The largest stress on the boundary that is known to be at no singular place, Pa, and where.
struct sound_stress {
  double von_mises_pa = 0;
  vec3 at;
};
/// Of a report whose largest stress is at a singular place; nothing when the report lists too few
/// of those places, or none that was looked at is left.
[[nodiscard]] std::optional<sound_stress> sound_maximum(const version_record& version,
                                                        const solve_report& report);

}  // namespace tedit::desktop
