// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/small_picture.hpp"

#include <QPainter>

#include <cstdlib>

namespace tedit::desktop {

namespace {

/// Whether two colours are one to who draws them by interpolation.
bool is_near(QRgb a, QRgb b) {
  constexpr int rounding = 3;
  return std::abs(qRed(a) - qRed(b)) <= rounding && std::abs(qGreen(a) - qGreen(b)) <= rounding &&
         std::abs(qBlue(a) - qBlue(b)) <= rounding;
}

QRgb mixed(QRgb a, QRgb b, double share) {
  const auto mix = [share](int x, int y) { return qRound(x + share * (y - x)); };
  return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

/// The view's ground is one colour at its top, another at its foot, and goes over from one to the
/// other: where a frame has it there is nothing. A part that reaches into a corner hides what the
/// ground is; the frame stays as it is then.
QImage without_ground(const QImage& frame) {
  QImage result = frame.convertToFormat(QImage::Format_ARGB32);
  if (result.isNull() || frame.hasAlphaChannel())
    return result;
  const int right = result.width() - 1;
  const int foot = result.height() - 1;
  const QRgb high = result.pixel(0, 0);
  const QRgb low = result.pixel(0, foot);
  if (!is_near(high, result.pixel(right, 0)) || !is_near(low, result.pixel(right, foot)))
    return result;
  for (int y = 0; y <= foot; ++y) {
    const QRgb ground = mixed(high, low, foot > 0 ? static_cast<double>(y) / foot : 0);
    auto* row = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x <= right; ++x)
      if (is_near(row[x], ground))
        row[x] = 0;
  }
  return result;
}

/// Around what is seen of a picture; all of it where nothing is.
QRect seen_of(const QImage& picture) {
  QRect seen;
  for (int y = 0; y < picture.height(); ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    int first = 0;
    int last = picture.width() - 1;
    while (first <= last && qAlpha(row[first]) == 0)
      ++first;
    while (last >= first && qAlpha(row[last]) == 0)
      --last;
    if (first <= last)
      seen |= QRect(QPoint(first, y), QPoint(last, y));
  }
  return seen.isEmpty() ? picture.rect() : seen;
}

}  // namespace

QImage small_picture(const QImage& frame, const QSize& size) {
  constexpr int enough = 4;  // Pixels for one: what is larger is only slower.
  const QSize most = enough * size;
  const bool large = frame.width() > most.width() && frame.height() > most.height();
  // Not smoothed: the part's edges are not to take the ground's colour.
  const QImage clear = without_ground(
    large ? frame.scaled(most, Qt::KeepAspectRatioByExpanding, Qt::FastTransformation) : frame);
  const QRect seen = seen_of(clear);
  const bool whole = seen == clear.rect();
  const QSize room = whole ? size : size * 0.94;
  const QImage part = clear.copy(seen).scaled(
    room, whole ? Qt::KeepAspectRatioByExpanding : Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QImage result(size, QImage::Format_ARGB32);
  result.fill(Qt::transparent);
  QPainter(&result).drawImage(
    QPoint((size.width() - part.width()) / 2, (size.height() - part.height()) / 2), part);
  return result;
}

}  // namespace tedit::desktop
