// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QStatusBar>

#include "client-qt/model/document.hpp"
#include "client-qt/widgets/theme.hpp"

class QLabel;
class QToolButton;

namespace tedit::desktop {

/// What is true of the picture: preview or final, residual, estimated error, size, times; and how
/// the server is reached. While the solver runs a button stops it; once stopped, it goes on again.
class truth_line : public QStatusBar {
  Q_OBJECT

public:
  truth_line(document& part, remote& link, QWidget* parent = nullptr);

  void set_theme(const theme& look);
  /// Puts a widget of a tool before what is said of the server.
  void add(QWidget* widget);
  /// Says that what is seen is only the preview of an edit.
  void set_candidate(bool on);
  /// "preview", "final", "solving ...": also for the legend and pictures.
  [[nodiscard]] QString verdict() const;
  /// The whole line as text.
  [[nodiscard]] QString text() const;

private:
  void refresh();
  void keep_height();
  [[nodiscard]] QString facts() const;
  [[nodiscard]] QString server() const;
  void refresh_others();
  [[nodiscard]] QColor ink_of(const QString& verdict) const;

  document& part_;
  remote& link_;
  theme look_;
  bool candidate_ = false;
  QLabel* verdict_;
  QToolButton* stop_;
  QLabel* facts_;
  QLabel* others_;
  QLabel* server_;
};

}  // namespace tedit::desktop
