// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/operations/number_fields.hpp"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

#include "client-qt/model/quantities.hpp"
#include "client-qt/model/typed_quantity.hpp"
#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {

namespace {

constexpr int lines_shown = 4;

/// The words between semicolons, commas with blanks, or blanks.
QStringList words_typed(const QString& typed) {
  static const QRegularExpression comma_blank(",\\s+");
  static const QRegularExpression blanks("\\s+");
  if (typed.contains(';'))
    return typed.split(';');
  QString plain = typed.trimmed();
  plain.replace(comma_blank, " ");
  return plain.split(blanks, Qt::SkipEmptyParts);
}

/// In SI and with commas; nothing where one is no quantity of that unit.
std::optional<QString> in_si(const QStringList& words, const QString& si_unit) {
  QStringList numbers;
  for (const auto& word : words) {
    const auto si = read_quantity(word, si_unit);
    if (!si)
      return std::nullopt;
    numbers.append(QString::number(*si, 'g', 15));
  }
  return numbers.join(", ");
}

std::string read_words(const QStringList& words, const QString& typed, const QString& si_unit) {
  return in_si(words, si_unit).value_or(typed.trimmed()).toStdString();
}

/// "; " where both are there: what is picked is both in one.
std::string joined(const std::string& first, const std::string& second) {
  return second.empty() ? first : first + "; " + second;
}

}  // namespace

std::string read_vector(const QString& typed, const QString& si_unit) {
  auto words = words_typed(typed);
  if (words.size() != 3 && typed.count(',') == 2)
    words = typed.split(',');
  return words.size() == 3 ? read_words(words, typed, si_unit) : typed.trimmed().toStdString();
}

std::string read_list(const QString& typed, const QString& si_unit) {
  auto words = words_typed(typed);
  if (words.size() == 1 && typed.count(',') >= 2)
    words = typed.split(',');
  return read_words(words, typed, si_unit);
}

QString numbers_shown(const std::string& host, const QString& si_unit) {
  QString text = QString::fromStdString(host);
  const double scale = shown_as(si_unit).scale;
  QLocale plain;
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  QStringList words;
  for (const auto& number : text.split(',', Qt::SkipEmptyParts)) {
    bool ok = false;
    const double value = number.trimmed().toDouble(&ok);
    if (!ok)
      return text;
    words.append(plain.toString(scale * value, 'g', 10));
  }
  return words.join("; ");
}

bool picked_field::picks() const {
  return pick_ && pick_->isChecked();
}

void picked_field::stop_picking() {
  pick_->setChecked(false);
}

QToolButton* picked_field::make_pick(const QString& help) {
  pick_ = new QToolButton;
  pick_->setIcon(icon("pick", palette().color(QPalette::ButtonText)));
  pick_->setCheckable(true);
  pick_->setToolTip(help);
  pick_->setAccessibleName(help);
  connect(pick_, &QToolButton::toggled, this, [this](bool on) {
    if (on)
      emit pick_wanted();
  });
  return pick_;
}

axis_field::axis_field(ops::parameter_type type, QString si_unit, QWidget* parent)
    : picked_field(parent),
      si_unit_(std::move(si_unit)),
      point_(new QLineEdit),
      direction_(new QLineEdit) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  row->addLayout(column);
  row->addWidget(make_pick(tr("Click a wall or an edge of the part that has it")));
  const bool is_axis = type == ops::parameter_type::axis;
  point_->setPlaceholderText(tr("through x; y; z in %1").arg(shown_as(si_unit_).name));
  point_->setAccessibleName(is_axis ? tr("A point of the axis") : tr("A point of the plane"));
  direction_->setPlaceholderText(is_axis ? tr("along x; y; z") : tr("normal x; y; z"));
  direction_->setAccessibleName(is_axis ? tr("Direction of the axis") : tr("Normal of the plane"));
  for (auto* field : {point_, direction_}) {
    column->addWidget(field);
    connect(field, &QLineEdit::textChanged, this, &axis_field::changed);
  }
  setFocusProxy(point_);
}

std::string axis_field::value() const {
  return joined(read_vector(point_->text(), si_unit_), read_vector(direction_->text(), {}));
}

void axis_field::set_value(const std::string& host) {
  const auto split = std::min(host.find(';'), host.size());
  {
    const QSignalBlocker both_at_once(this);
    point_->setText(numbers_shown(host.substr(0, split), si_unit_));
    direction_->setText(numbers_shown(split < host.size() ? host.substr(split + 1) : "", {}));
  }
  emit changed();
}

polyline_field::polyline_field(QString si_unit, QWidget* parent)
    : picked_field(parent), si_unit_(std::move(si_unit)), points_(new QPlainTextEdit) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(points_);
  row->addWidget(make_pick(tr("Click an edge of the part to go along")));
  points_->setPlaceholderText(
    tr("x; y; z in %1, a line for each point").arg(shown_as(si_unit_).name));
  points_->setAccessibleName(tr("Points"));
  points_->setTabChangesFocus(true);
  points_->setLineWrapMode(QPlainTextEdit::NoWrap);
  points_->setFixedHeight(lines_shown * points_->fontMetrics().lineSpacing() +
                          2 * (points_->frameWidth() + 4));
  setFocusProxy(points_);
  connect(points_, &QPlainTextEdit::textChanged, this, &polyline_field::changed);
}

std::string polyline_field::value() const {
  std::string result;
  for (const auto& line : points_->toPlainText().split('\n'))
    if (const auto point = read_vector(line, si_unit_); !point.empty())
      result += (result.empty() ? "" : "; ") + point;
  return result;
}

void polyline_field::set_value(const std::string& host) {
  QStringList lines;
  for (const auto& point : QString::fromStdString(host).split(';', Qt::SkipEmptyParts))
    lines.append(numbers_shown(point.trimmed().toStdString(), si_unit_));
  points_->setPlainText(lines.join('\n'));
}

}  // namespace tedit::desktop
