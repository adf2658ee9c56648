// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/remesh_form.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace tedit::desktop {

namespace {

constexpr int remesh_width = 420;
constexpr double longest_mm = 1e6;
constexpr qsizetype most_named = 6;

QLabel* paragraph(const QString& words) {
  auto* label = new QLabel(words);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setProperty("role", "faint");
  return label;
}

/// Some by their names, the others by their count.
QString listed(const std::map<std::string, QString>& names) {
  QStringList words;
  for (const auto& [id, name] : names)
    words << name;
  const auto more = words.size() - most_named;
  return more > 0
           ? remesh_form::tr("%1 and %2 more").arg(words.mid(0, most_named).join(", ")).arg(more)
           : words.join(", ");
}

}  // namespace

remesh_form::remesh_form(const imported_file& from, std::map<std::string, QString> names,
                         QWidget* parent)
    : QDialog(parent),
      from_(from),
      names_(std::move(names)),
      fineness_(new QComboBox),
      length_(new QDoubleSpinBox) {
  setObjectName("remesh");
  setWindowTitle(tr("Mesh anew with another size"));
  build();
}

void remesh_form::build() {
  fineness_->setObjectName("fineness");
  fineness_->addItem(tr("Coarse: one quadratic tet through a usual wall"), "coarse");
  fineness_->addItem(tr("Medium: two"), "medium");
  fineness_->addItem(tr("Fine: three"), "fine");
  fineness_->setCurrentIndex(fineness_->findData(from_.size));
  length_->setObjectName("local_size");
  length_->setRange(0, longest_mm);
  length_->setDecimals(3);
  length_->setSuffix(" mm");
  length_->setSpecialValueText(tr("as elsewhere"));
  length_->setEnabled(!names_.empty());
  if (const auto known = names_.empty() ? from_.local_sizes_mm.end()
                                        : from_.local_sizes_mm.find(names_.begin()->first);
      known != from_.local_sizes_mm.end())
    length_->setValue(known->second);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* take = buttons->addButton(tr("Mesh"), QDialogButtonBox::AcceptRole);
  take->setObjectName("remesh_take");
  take->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->addRow(tr("How fine"), fineness_);
  form->addRow(tr("Longest edge on what is picked"), length_);
  form->addRow(paragraph(names_.empty()
                           ? tr("Nothing is picked: pick walls of the part to give them a length "
                                "of their own.")
                           : tr("Picked: %1.").arg(listed(names_))));
  form->addRow(paragraph(tr("%1 is read once more, into a new document. Edits and loads of this "
                            "document stay in this one.")
                           .arg(QFileInfo(from_.mesh).fileName())));
  form->addRow(buttons);
  setMinimumWidth(remesh_width);
}

imported_file remesh_form::wanted() const {
  auto file = from_;
  file.size = fineness_->currentData().toString();
  for (const auto& [id, name] : names_) {
    file.local_sizes_mm.erase(id);
    if (length_->value() > 0)
      file.local_sizes_mm[id] = length_->value();
  }
  return file;
}

}  // namespace tedit::desktop
