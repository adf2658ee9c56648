// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/unit_question.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

#include "client-qt/model/document.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

constexpr int edge_margin = 12;

struct length_unit {
  const char* id;
  const char* words;
};
constexpr length_unit units[] = {{"mm", QT_TRANSLATE_NOOP("unit_question", "Millimetres")},
                                 {"m", QT_TRANSLATE_NOOP("unit_question", "Metres")},
                                 {"in", QT_TRANSLATE_NOOP("unit_question", "Inches")}};

}  // namespace

unit_question::unit_question(document& part, viewport& view)
    : QFrame(&view), part_(part), view_(view), words_(new QLabel) {
  setObjectName("unit_question");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 6, 10, 6);
  row->addWidget(words_);
  for (const auto& unit : units) {
    auto* button = new QPushButton(QCoreApplication::translate("unit_question", unit.words));
    button->setObjectName(QString("unit_") + unit.id);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, id = QString(unit.id)] {
      hide();
      if (from_ && id != from_->unit)
        part_.files().import_anew(*from_, id);
    });
  }
  hide();
  view_.installEventFilter(this);
  connect(&part_, &document::begun, this, [this] {
    from_.reset();
    looked_ = true;
    hide();
  });
  connect(&part_.files(), &file_requests::imported, this, [this](const imported_file& from) {
    from_ = from;
    looked_ = false;
    look();
  });
  connect(&part_, &document::surface_changed, this, &unit_question::look);
}

/// Once the part's surface is there, whichever comes first.
void unit_question::look() {
  const auto* head = part_.head();
  if (looked_ || !head || !head->surface)
    return;
  looked_ = true;
  if (const auto size = size_of(*head->surface); size.is_odd())
    ask(size);
}

void unit_question::ask(const part_size& size) {
  words_->setText(tr("The part is %1 large, read as %2. Its file says no unit: was it written in")
                    .arg(size.words(), from_->unit));
  for (auto* button : findChildren<QPushButton*>())
    button->setDefault(button->objectName() == "unit_" + from_->unit);
  show();
  raise();
  place();
}

void unit_question::place() {
  adjustSize();
  resize(std::min(width(), view_.width() - 2 * edge_margin), height());
  move((view_.width() - width()) / 2, view_.height() - height() - edge_margin);
}

bool unit_question::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &view_ && event->type() == QEvent::Resize && isVisible())
    place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace tedit::desktop
