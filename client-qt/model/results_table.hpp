// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "client-qt/model/results_summary.hpp"

/// A summary as a table that other programs take: numbers stand in cells of their own.
namespace tedit::desktop {

/// One line for each row, cells parted by tabs, the first line with titles. Load case, figure,
/// value, unit, place, note; with a version to compare with its value and the change.
[[nodiscard]] QString as_text_table(const results_summary& summary);

/// The same as HTML: one table.
[[nodiscard]] QString as_html_table(const results_summary& summary);

/// For people: a table for each section under its heading, with warnings and hints; values with
/// their units in one cell.
[[nodiscard]] QString as_html_sections(const results_summary& summary);

}  // namespace tedit::desktop
