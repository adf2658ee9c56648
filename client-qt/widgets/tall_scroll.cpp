// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {

tall_scroll::tall_scroll(QWidget* content, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width());
}

QSize tall_scroll::sizeHint() const {
  return widget() ? widget()->sizeHint().expandedTo(widget()->minimumSize())
                  : QScrollArea::sizeHint();
}

}  // namespace tedit::desktop
