// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

namespace tedit::desktop {

/// A row of two columns in a table of rich text.
inline QString table_row(const QString& left, const QString& right) {
  return "<tr><td>" + left + "&nbsp;&nbsp;</td><td>" + right + "</td></tr>";
}

}  // namespace tedit::desktop
