// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/loads_panel.hpp"

#include "client-qt/model/load_words.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/view/theme.hpp"

namespace tedit::desktop {

loads_panel::loads_panel(document& part, QWidget* parent) : QTreeWidget(parent), part_(part) {
  setHeaderHidden(true);
  setAccessibleName(tr("Load cases"));
  connect(&part_, &document::load_cases_changed, this, &loads_panel::refresh);
  connect(&part_, &document::head_changed, this, &loads_panel::refresh);
  connect(&part_, &document::closed, this, &loads_panel::refresh);
  connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
    const auto list = row->data(0, Qt::UserRole).value<QList<qint64>>();
    if (!list.isEmpty())
      emit surfaces_wanted(list);
  });
}

void loads_panel::refresh() {
  clear();
  const QColor ink = palette().color(QPalette::WindowText);
  const auto add = [&](QTreeWidgetItem* parent, const char* drawing, const QString& text,
                       const std::vector<surface_id>& surfaces) {
    auto* row = new QTreeWidgetItem(parent, {text});
    row->setIcon(0, icon(drawing, ink));
    QList<qint64> ids(surfaces.begin(), surfaces.end());
    row->setData(0, Qt::UserRole, QVariant::fromValue(ids));
    if (!ids.isEmpty())
      row->setToolTip(0, tr("Surfaces: %1").arg(ids.size()));
  };
  for (const auto& one : part_.load_cases()) {
    auto* top = new QTreeWidgetItem(this, {QString::fromStdString(one.name)});
    top->setExpanded(true);
    for (const auto& m : one.materials)
      add(top, "material",
          QString::fromStdString(m.name) + ", E " + quantity(m.young_modulus_pa, "Pa"), {});
    for (const auto& held : one.constraints)
      add(top, "support", words(held), held.surfaces);
    for (const auto& acting : one.loads)
      add(top, "load", words(acting), acting.surfaces);
  }
}

}  // namespace tedit::desktop
