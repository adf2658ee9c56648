// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/file_field.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <QToolButton>

#include "base/attachment.hpp"

namespace tedit::desktop {

namespace {

/// "SVG, DXF (*.svg *.dxf)", and all files beside it; none where no ending is named. An ending that
/// is more than letters and digits would say something else to the dialog.
QStringList filters_of(const std::vector<std::string>& endings) {
  QStringList names;
  QStringList patterns;
  for (const auto& ending : endings) {
    const auto text = QString::fromStdString(ending);
    static const QRegularExpression plain("^[A-Za-z0-9]{1,16}$");
    if (!plain.match(text).hasMatch())
      continue;
    names << text.toUpper();
    patterns << "*." + text << "*." + text.toUpper();
  }
  if (names.isEmpty())
    return {};
  return {names.join(", ") + " (" + patterns.join(' ') + ")", file_field::tr("All files (*)")};
}

}  // namespace

file_field::file_field(const std::vector<std::string>& endings, QWidget* parent)
    : QWidget(parent), path_(new QLineEdit), filters_(filters_of(endings)) {
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
  if (!filters_.isEmpty())
    dialog->setNameFilters(filters_);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    given_.clear();
    path_->setText(path);
  });
  dialog->open();
}

}  // namespace tedit::desktop
