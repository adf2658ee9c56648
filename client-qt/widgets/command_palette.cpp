// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/command_palette.hpp"

#include <QListWidget>

namespace tedit::desktop {

namespace {

constexpr int most_rows = 40;

}  // namespace

command_palette::command_palette(commands& all, QWidget* parent)
    : finder_popup("palette", tr("Search commands and operations"), parent), all_(all) {}

void command_palette::search(const QString& letters) {
  hits_->clear();
  for (const auto* one : all_.search(letters)) {
    if (hits_->count() == most_rows)
      break;
    auto* row = new QListWidgetItem(one->group + QString::fromUtf8("  \u203a  ") + one->title +
                                    (one->shortcut.isEmpty() ? "" : "    " + one->shortcut));
    row->setData(Qt::UserRole, one->id);
    const bool on = all_.is_enabled(*one);
    row->setToolTip(on || one->why_off.isEmpty() ? one->help : one->why_off);
    if (!on)
      row->setFlags(row->flags() & ~Qt::ItemIsEnabled);
    hits_->addItem(row);
  }
  hits_->setCurrentRow(0);
}

void command_palette::take(int row) {
  const auto* taken = hits_->item(row);
  if (taken && (taken->flags() & Qt::ItemIsEnabled))
    all_.trigger(taken->data(Qt::UserRole).toString());
}

}  // namespace tedit::desktop
