// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results/deformation_row.hpp"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>
#include <numbers>

namespace tedit::desktop {

namespace {

constexpr double share_of_size = 0.05;
constexpr int beats = 40;  // Of one swing there and back,
constexpr int beat_ms = 50;

QToolButton* toggle(const QString& face, const QString& words, const char* name,
                    const QString& help) {
  auto* made = new QToolButton;
  made->setText(face);
  made->setAccessibleName(words);
  made->setObjectName(name);
  made->setCheckable(true);
  made->setToolTip(help);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

}  // namespace

double readable_deformation(double largest, double size) {
  const double most = share_of_size * size / largest;
  if (!(largest > 0) || !(size > 0) || !std::isfinite(most))
    return 0;
  if (most <= 1)
    return 1;
  const double power = std::pow(10, std::floor(std::log10(most)));
  const double rest = most / power;
  return power * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
}

deformation_row::deformation_row(QWidget* parent) : QWidget(parent) {
  factor_ = new QDoubleSpinBox;
  factor_->setObjectName("deform");
  factor_->setRange(0, 1e9);
  factor_->setDecimals(0);
  factor_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  factor_->setPrefix(QString::fromUtf8("\u00d7 "));
  factor_->setSpecialValueText(tr("not deformed"));
  factor_->setAccessibleName(tr("Deformation"));
  automatic_ = toggle(tr("Auto"), tr("Automatic deformation"), "deform_automatic",
                      tr("So large that the deformation is seen, for each load case"));
  swings_ = toggle(QString::fromUtf8("\u25b6"), tr("Animate the deformation"), "deform_animate",
                   tr("Swings between the part without load and the deformed one"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(factor_, 1);
  row->addWidget(automatic_);
  row->addWidget(swings_);
  clock_.setInterval(beat_ms);
  connect(&clock_, &QTimer::timeout, this, [this] {
    beat_ = (beat_ + 1) % beats;
    emit swung();
  });
  connect(factor_, &QDoubleSpinBox::valueChanged, this, [this] {
    automatic_->setChecked(false);  // What is typed holds.
    emit changed();
  });
  connect(automatic_, &QToolButton::toggled, this, [this](bool on) {
    if (on)
      follow();
  });
  connect(swings_, &QToolButton::toggled, this, &deformation_row::swing);
}

double deformation_row::factor() const {
  return factor_->value();
}

double deformation_row::shown_factor() const {
  if (!swings())
    return factor();
  return factor() * (1 - std::cos(2 * std::numbers::pi * beat_ / beats)) / 2;
}

void deformation_row::set_factor(double factor) {
  factor_->setValue(factor);
}

bool deformation_row::is_automatic() const {
  return automatic_->isChecked();
}

bool deformation_row::swings() const {
  return swings_->isChecked();
}

void deformation_row::set_swinging(bool on) {
  swings_->setChecked(on);
}

void deformation_row::take(double largest, double size) {
  largest_ = largest;
  size_ = size;
  if (is_automatic())
    follow();
}

void deformation_row::follow() {
  const double wanted = readable_deformation(largest_, size_);
  if (wanted == factor_->value())
    return;
  const QSignalBlocker quiet(factor_);
  factor_->setValue(wanted);
  emit changed();
}

/// A part that is not deformed has nothing to swing to.
void deformation_row::swing() {
  if (swings() && factor() == 0)
    automatic_->setChecked(true);
  beat_ = beats / 2;  // From the shape that is seen.
  if (swings())
    clock_.start();
  else
    clock_.stop();
  emit swung();
}

}  // namespace tedit::desktop
