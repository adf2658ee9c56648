// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/model/live_preview.hpp"

class QCheckBox;
class QLabel;
class QPushButton;

namespace tedit::desktop {

/// In an operation's form: whether its preview follows, what it shows in numbers, or why it cannot
/// be.
class preview_box : public QWidget {
  Q_OBJECT

public:
  explicit preview_box(live_preview& preview, QWidget* parent = nullptr);

  /// What has to be seen beside the button that applies: the figures, how far the preview is, or
  /// why it cannot be. To be put anywhere.
  [[nodiscard]] QWidget& verdict() const { return *verdict_; }

signals:
  /// The surfaces of a fault were clicked.
  void place_wanted(const std::vector<tedit::surface_id>& surfaces);

private:
  void refresh();
  [[nodiscard]] QString state() const;

  live_preview& preview_;
  QWidget* verdict_;
  QCheckBox* follows_;
  QPushButton* now_;
  QLabel* state_;
  QLabel* figures_;
  QLabel* more_;
  QLabel* fault_;
  QPushButton* place_;
  QPushButton* most_;
};

/// What an edit would make, as a few rows: volume, tets, the worst of them.
[[nodiscard]] QString preview_figures(const client::edit_preview& made);
/// What the operation measured besides, and what becomes of loads.
[[nodiscard]] QString preview_details(const client::edit_preview& made);

/// The surfaces that an error names.
[[nodiscard]] std::vector<surface_id> places_of(const error& reason);

}  // namespace tedit::desktop
