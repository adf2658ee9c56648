// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/tour/tour_card.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace tedit::desktop {

namespace {

constexpr int card_width = 320;
constexpr int beside_it = 112;  // The view cube, and the room around both.

}  // namespace

tour_card::tour_card(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel),
      words_(new QLabel),
      place_(new QLabel),
      show_me_(new QPushButton(tr("Show me"))),
      skip_(new QPushButton(tr("Skip"))),
      close_(new QPushButton(tr("End the tour"))) {
  setObjectName("tour_card");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  auto* head = new QHBoxLayout;
  title_->setObjectName("tour_title");
  title_->setStyleSheet("font-weight: 600;");
  place_->setProperty("role", "faint");
  head->addWidget(title_, 1);
  head->addWidget(place_);
  column->addLayout(head);
  words_->setObjectName("tour_words");
  words_->setWordWrap(true);
  column->addWidget(words_);
  auto* row = new QHBoxLayout;
  for (auto* button : {show_me_, skip_, close_}) {
    button->setFocusPolicy(Qt::TabFocus);  // A click takes no keys from the part.
    row->addWidget(button);
  }
  column->addLayout(row);
  connect(show_me_, &QPushButton::clicked, this, &tour_card::show_me_wanted);
  connect(skip_, &QPushButton::clicked, this, &tour_card::skip_wanted);
  connect(close_, &QPushButton::clicked, this, &tour_card::close_wanted);
  hide();
}

void tour_card::show_step(const QString& title, const QString& words, int step, int of) {
  title_->setText(title);
  words_->setText(words);
  place_->setText(tr("%1 of %2").arg(step).arg(of));
  for (auto* button : {show_me_, skip_})
    button->setVisible(step < of);
  close_->setText(step < of ? tr("End the tour") : tr("Close"));
  layout()->activate();
  const int room = std::min(card_width, parentWidget()->width() - beside_it);
  const int wide = std::max(room, layout()->totalMinimumSize().width());
  setFixedSize(wide, layout()->totalHeightForWidth(wide));
  show();
  raise();
}

}  // namespace tedit::desktop
