// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTextBrowser>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// What the edit that made the head did: figures, surfaces, and what became of every load and
/// support. A surface is a link to its place.
class receipt_panel : public QTextBrowser {
  Q_OBJECT

public:
  explicit receipt_panel(desktop::document& part, QWidget* parent = nullptr);

signals:
  void surface_wanted(qint64 surface);

private:
  void refresh();

  desktop::document& part_;
};

/// The report as HTML. Loads first: what was dropped or reduced matters most.
[[nodiscard]] QString receipt_html(const edit_report& report);

/// How many loads and supports are not as they were.
[[nodiscard]] int changed_loads(const edit_report& report);
/// How many of them lost surfaces.
[[nodiscard]] int lost_loads(const edit_report& report);

}  // namespace tedit::desktop
