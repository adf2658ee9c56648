// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/connection/trust_dialog.hpp"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace tedit::desktop {

namespace {

/// Four pairs in a group, four groups in a line: so people compare.
QString grouped(const std::string& fingerprint) {
  constexpr int pairs_in_group = 4;
  constexpr int pairs_in_line = 16;
  const auto pairs = QString::fromStdString(fingerprint).split(':');
  QString text;
  for (qsizetype i = 0; i < pairs.size(); ++i) {
    if (i > 0)
      text += i % pairs_in_line == 0 ? "\n" : i % pairs_in_group == 0 ? "  " : ":";
    text += pairs[i];
  }
  return text;
}

QLabel* fingerprint_label(const std::string& fingerprint, const char* name) {
  auto* label = new QLabel(grouped(fingerprint));
  label->setObjectName(name);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QLabel* words(const QString& text) {
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

trust_dialog::trust_dialog(const untrusted_server& what, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Is this the right server?"));
  auto* column = new QVBoxLayout(this);
  const auto place = QString::fromStdString(what.place);
  const auto until = QLocale().toString(
    QDateTime::fromSecsSinceEpoch(what.certificate.until).date(), QLocale::ShortFormat);
  if (what.known.empty()) {
    column->addWidget(
      words(tr("The server at %1 is not known here, and no authority that this computer trusts "
               "vouches for it. Its certificate ends on %2 and has the fingerprint (SHA-256):")
              .arg(place, until)));
  } else {
    column->addWidget(
      words(tr("The server at %1 shows another certificate than the one that you trust. Either it "
               "was exchanged, or somebody stands between you and the server. You trust:")
              .arg(place)));
    column->addWidget(fingerprint_label(what.known, "known_fingerprint"));
    column->addWidget(words(tr("It shows one that ends on %1:").arg(until)));
  }
  column->addWidget(fingerprint_label(what.certificate.fingerprint, "fingerprint"));
  column->addWidget(
    words(tr("Trust it only if the operator of the server says the same one; "
             "\"tedit serve\" prints it. It is then known on this computer.")));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* trust = buttons->addButton(tr("Trust this server"), QDialogButtonBox::AcceptRole);
  trust->setObjectName("trust");
  trust->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Cancel)->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

}  // namespace tedit::desktop
