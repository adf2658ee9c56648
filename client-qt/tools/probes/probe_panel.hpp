// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "client-qt/model/probes.hpp"
#include "client-qt/view/viewport.hpp"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace tedit::desktop {

class field_panel;

/// The probes as numbered pins over the view. Lets the mouse through.
class probe_marks : public QWidget {
  Q_OBJECT

public:
  probe_marks(viewport& view, document& part, probes& all);

  void set_accent(const QColor& accent);

protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  [[nodiscard]] vec3 drawn_at(const probe_place& place) const;

  viewport& view_;
  document& part_;
  probes& all_;
  QColor accent_{200, 100, 28};
};

/// All probes with their values in every version whose field is held, and the distance of two.
class probe_panel : public QWidget {
  Q_OBJECT

public:
  probe_panel(document& part, probes& all, field_panel& fields, QWidget* parent = nullptr);

  /// The two that are chosen, else the last two; fewer when there are not so many.
  [[nodiscard]] std::vector<probe> pair() const;
  /// The numbers of those that are chosen in the list, ascending.
  [[nodiscard]] std::vector<int> chosen() const;
  void choose(const std::vector<int>& numbers);

signals:
  void pair_changed();
  void chosen_changed();

private:
  void refresh();
  void show_distance();

  document& part_;
  probes& all_;
  field_panel& fields_;
  QTreeWidget* list_;
  QLabel* distance_;
  QPushButton* remove_;
  QPushButton* clear_;
};

}  // namespace tedit::desktop
