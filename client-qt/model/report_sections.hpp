// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "client-qt/model/report_document.hpp"

/// The parts of a report, as HTML. A part that has nothing to say is empty.
namespace tedit::desktop {

/// What the part is made of, how it is held and loaded.
[[nodiscard]] QString load_cases_html(const report_facts& facts);

/// The edits that led here.
[[nodiscard]] QString history_html(const report_facts& facts);

/// What of the figures is to be trusted, and what is not.
[[nodiscard]] QString trust_html(const report_facts& facts);

}  // namespace tedit::desktop
