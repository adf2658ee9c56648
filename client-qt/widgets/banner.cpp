// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/banner.hpp"

#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBoundaryFinder>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr int news_ms = 8000;
constexpr int warning_ms = 30000;
constexpr int least_line = 100;  // Pixels.

}  // namespace

QList<qint64> surfaces_in(const QString& text) {
  static const QRegularExpression named("surfaces?\\s+((?:-?\\d+(?:,\\s*|\\s+and\\s+)?)+)",
                                        QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression number("-?\\d+");
  QList<qint64> result;
  for (auto at = named.globalMatch(text); at.hasNext();)
    for (auto n = number.globalMatch(at.next().captured(1)); n.hasNext();)
      result << n.next().captured().toLongLong();
  return result;
}

QString explained(const error& reason) {
  QString text = sentence_of(reason.message);
  if (!reason.where.empty())
    text += "\n" + banner::tr("Where: %1").arg(words_of(reason.where));
  if (!reason.remedy.empty())
    text += "\n" + sentence_of(reason.remedy);
  return text;
}

QString fitted(const QString& words, const QFontMetrics& by, int width) {
  const QString dots(QChar(0x2026));
  const QString joiner(QChar(0x2060));  // Else a line may end behind the dots.
  QString result;
  QTextBoundaryFinder breaks(QTextBoundaryFinder::Line, words);
  for (qsizetype from = 0, to = breaks.toNextBoundary(); to >= 0;
       from = to, to = breaks.toNextBoundary()) {
    const QString piece = words.mid(from, to - from);
    const QString bare = piece.trimmed();
    result += by.horizontalAdvance(bare) > width
                ? by.elidedText(bare, Qt::ElideMiddle, width).replace(dots, dots + joiner) +
                    piece.mid(bare.size())
                : piece;
  }
  return result;
}

banner::banner(QWidget* parent) : QFrame(parent) {
  setObjectName("banner");
  setFrameShape(QFrame::NoFrame);
  auto* row = new QHBoxLayout(this);
  auto* column = new QVBoxLayout;
  standing_ = new QLabel;
  standing_->setProperty("role", "section");
  standing_->setWordWrap(true);
  standing_->hide();
  column->addWidget(standing_);
  title_ = new QLabel;
  title_->setProperty("role", "section");
  title_->setWordWrap(true);
  body_ = new QLabel;
  body_->setWordWrap(true);
  body_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(title_);
  column->addWidget(body_);
  row->addLayout(column, 1);
  place_ = new QPushButton(tr("Show the place"));
  connect(place_, &QPushButton::clicked, this, [this] { emit place_wanted(surfaces_); });
  auto* close = new QPushButton(tr("Close"));
  close->setObjectName("close");
  connect(close, &QPushButton::clicked, this, [this] {
    if (has_message())
      drop_message();
    else
      hide();
  });
  row->addWidget(place_, 0, Qt::AlignTop);
  row->addWidget(close, 0, Qt::AlignTop);
  away_.setSingleShot(true);
  connect(&away_, &QTimer::timeout, this, &banner::drop_message);
  hide();
}

void banner::set_theme(const theme& look) {
  look_ = look;
  paint_bar();
}

QString banner::text() const {
  if (isHidden())
    return {};
  return QStringList{standing_->text(), title_words_, body_words_}.join("\n").trimmed();
}

bool banner::has_message() const {
  return !title_words_.isEmpty() || !body_words_.isEmpty();
}

void banner::present(const QString& title, const QString& body, const QColor& bar) {
  title_words_ = title;
  body_words_ = body;
  title_->setVisible(!title.isEmpty());
  body_->setVisible(!body.isEmpty());
  fit_words();
  place_->setVisible(!surfaces_.isEmpty());
  bar_ = bar;
  paint_bar();
  show();
  emit changed();
}

/// Paths may be longer than a line; all of them stands in the hint and in the log.
void banner::fit_words() {
  for (const auto& [label, words] :
       {std::pair(title_, &title_words_), std::pair(body_, &body_words_)}) {
    const QString shown =
      fitted(*words, label->fontMetrics(), std::max(least_line, label->contentsRect().width()));
    if (label->text() != shown)
      label->setText(shown);
    label->setToolTip(shown == *words ? QString() : *words);
  }
}

/// Fonts of words that are shown for the first time are known later than the words.
bool banner::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
    fit_words();
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Hide)
    emit changed();
  return done;
}

void banner::paint_bar() {
  const QString ground = look_.palette.color(QPalette::Base).name();
  setStyleSheet(
    QString("#banner { background: %1; border: 1px solid %2; border-left: 4px solid %2; "
            "border-radius: 4px; }")
      .arg(ground, bar_.isValid() ? bar_.name() : ground));
}

void banner::show_error(const QString& what, const error& reason) {
  surfaces_ = surfaces_in(QString::fromStdString(reason.message + " " + reason.where));
  away_.stop();
  present(tr("%1 did not work").arg(what), explained(reason), look_.error);
}

void banner::add_to_error(const QString& text) {
  if (isHidden() || away_.isActive() || !has_message())
    return show_news(text);
  present(title_words_, body_words_ + "\n" + text, look_.error);
}

void banner::show_news(const QString& text) {
  show_for(news_ms, text, look_.good);
}

void banner::show_warning(const QString& text) {
  show_for(warning_ms, text, look_.warning);
}

void banner::show_for(int ms, const QString& text, const QColor& bar) {
  if (!isHidden() && (stands_ || (has_message() && !away_.isActive())))
    return;  // An error or a lost connection says more.
  surfaces_.clear();
  present({}, text, bar);
  away_.start(ms);
}

void banner::show_standing(const QString& text) {
  if (away_.isActive())
    drop_message();  // News: what comes now says more.
  stands_ = true;
  standing_->setText(text);
  standing_->show();
  present(title_words_, body_words_, has_message() ? look_.error : look_.warning);
}

void banner::clear_standing() {
  if (!std::exchange(stands_, false))
    return;
  standing_->clear();
  standing_->hide();
  setVisible(!isHidden() && has_message());
  emit changed();
}

void banner::clear_message() {
  if (has_message())
    drop_message();
}

/// What stands stays.
void banner::drop_message() {
  away_.stop();
  surfaces_.clear();
  present({}, {}, look_.warning);
  setVisible(stands_);
}

}  // namespace tedit::desktop
