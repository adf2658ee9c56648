// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

#include "client-qt/model/results_summary.hpp"

/// What is known of a part's strength, as a document for people who were not there.
namespace tedit::desktop {

/// A picture of the part.
struct report_picture {
  QString caption;
  QByteArray png;
  int width = 0;  ///< Pixels, of `png`.
  int height = 0;
};

/// One step of the history that led to the version.
struct report_step {
  std::uint32_t number = 0;
  QString made;  ///< "Import", "Fill hole", with the name that a person gave it.
  QString note;
  std::optional<double> volume_change_m3;  ///< Of edits.
  std::optional<double> mass_kg;           ///< When it was solved and densities are known.
  std::optional<double> stress_pa;         ///< The largest of all load cases, when it was solved.
  QStringList notices;                     ///< What its edit had to say of loads and the part.
};

/// All that a report is made of.
struct report_facts {
  QString title;     ///< What a person calls the document.
  QString document;  ///< Its name on the server.
  std::uint32_t version = 0;
  std::string version_id;
  std::uint64_t tets = 0;
  QDateTime when;
  QString program;  ///< "TEdit 0.1.0".
  results_summary figures;
  std::optional<solve_outcome> outcome;  ///< What the figures are of.
  std::vector<fem::load_case> load_cases;
  std::vector<report_step> history;  ///< The first version first.
  std::vector<report_picture> pictures;
  std::function<QString(surface_id)> surface_name;
  std::function<QString(const vec3&)> place_words;
};

/// The facts of a document's head, without pictures and words of places. `when`: now.
[[nodiscard]] report_facts facts_of(const document& part, const QDateTime& when);

/// The places that the report names, m: those of the figures and of singular places.
[[nodiscard]] std::vector<vec3> points_of(const report_facts& facts);

/// The whole as one HTML page. `source`: the address of the i-th picture, as HTML takes it.
[[nodiscard]] QString report_html(const report_facts& facts,
                                  const std::function<QString(std::size_t)>& source);

/// The same with the pictures inside: a file that needs no other.
[[nodiscard]] QString self_contained_html(const report_facts& facts);

}  // namespace tedit::desktop
