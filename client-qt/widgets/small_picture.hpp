// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>

namespace tedit::desktop {

/// The part in a frame of the view, as large as `size` lets it be. The view's ground is left out,
/// so that the picture fits where it is shown, in light and dark. A picture that was made so before
/// is made to fit only; a frame in which no ground is seen fills the size.
[[nodiscard]] QImage small_picture(const QImage& frame, const QSize& size);

}  // namespace tedit::desktop
