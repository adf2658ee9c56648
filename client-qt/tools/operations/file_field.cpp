// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/file_field.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>

#include "base/attachment.hpp"

namespace tedit::desktop {

file_field::file_field(QWidget* parent) : QWidget(parent), path_(new QLineEdit) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(path_);
  auto* choose = new QToolButton;
  choose->setText("…");
  choose->setToolTip(tr("Choose a file"));
  choose->setAccessibleName(tr("Choose a file"));
  row->addWidget(choose);
  path_->setPlaceholderText(tr("no file"));
  setFocusProxy(path_);
  connect(choose, &QToolButton::clicked, this, &file_field::ask);
  connect(path_, &QLineEdit::textEdited, this, [this] { given_.clear(); });
  connect(path_, &QLineEdit::textChanged, this, &file_field::changed);
}

std::string file_field::content() const {
  const auto path = path_->text().toStdString();
  if (!given_.empty() || path.empty())
    return given_;
  return attach_file(path).value_or(path);
}

void file_field::set_content(const std::string& text) {
  const auto file = read_attachment(text);
  given_ = file ? text : std::string{};
  path_->setText(QString::fromStdString(file ? file->name : text));
}

void file_field::ask() {
  auto* dialog = new QFileDialog(window(), tr("Choose a file"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    given_.clear();
    path_->setText(path);
  });
  dialog->open();
}

}  // namespace tedit::desktop
