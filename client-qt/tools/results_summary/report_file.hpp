// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "base/error.hpp"
#include "client-qt/model/report_document.hpp"

namespace tedit::desktop {

/// Writes a report by the suffix of `path`: .pdf (A4, page numbers), .html or .htm (one file with
/// its pictures). Errors: `invalid_argument` for another suffix, `io_error` when the file cannot be
/// written; what was there before is then as it was. Not on other threads than the window's.
[[nodiscard]] expected<void> write_report_file(const report_facts& facts, const QString& path);

}  // namespace tedit::desktop
