// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace tedit::desktop {

/// How far two pictures are apart.
struct picture_difference {
  double mean = 0;  ///< Of 255, over all channels.
  double off = 0;   ///< Share of pixels of another colour.
};

constexpr int off_by = 40;  ///< Of 255: a pixel that is another colour.

/// Both are of one size and of `QImage::Format_RGB32`.
inline picture_difference compare(const QImage& a, const QImage& b) {
  double sum = 0;
  std::int64_t off = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const std::array by{std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                          std::abs(qBlue(p) - qBlue(q))};
      sum += by[0] + by[1] + by[2];
      off += *std::ranges::max_element(by) > off_by;
    }
  const double pixels = static_cast<double>(a.width()) * a.height();
  return {sum / (3 * pixels), static_cast<double>(off) / pixels};
}

}  // namespace tedit::desktop
