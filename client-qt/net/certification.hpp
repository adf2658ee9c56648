// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::desktop {

/// A load case that CalculiX solved, too. Differences are relative (`tedit certify --help`).
struct certified_case {
  QString name;
  bool agrees = false;
  double displacement = 0;
  double reaction = 0;  ///< The worse of the sum's and of a surface's.
  double compliance = 0;
  double stress = 0;        ///< With means at nodes taken alike.
  double shown_stress = 0;  ///< As each program shows it: half of the nodes differ by less.
  double our_stress_pa = 0;
  double their_stress_pa = 0;
};

/// What CalculiX makes of a part.
struct certificate {
  QString program;  ///< "CalculiX 2.20".
  quint32 version = 0;
  QString folder;  ///< Decks, results, our fields and the certificate.
  bool agrees = false;
  std::vector<certified_case> cases;
};

/// Has CalculiX solve all load cases of a document's current version by "tedit certify", on this
/// computer. `document`: its file's bytes. `folder`: a new one. It waits: for a thread of work.
/// Errors: those that the program says, `service_unavailable` where CalculiX is not installed;
/// `cancelled`.
[[nodiscard]] expected<certificate> certify(const std::vector<char>& document,
                                            const QString& folder, const execution& run);

}  // namespace tedit::desktop
