// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/tall_scroll.hpp"

#include <QEvent>
#include <QLayout>

namespace tedit::desktop {

tall_scroll::tall_scroll(QWidget* content, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width());
  content->installEventFilter(this);
}

QSize tall_scroll::sizeHint() const {
  return widget() ? widget()->sizeHint().expandedTo(widget()->minimumSize())
                  : QScrollArea::sizeHint();
}

bool tall_scroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest)
    suit_height();
  return QScrollArea::eventFilter(watched, event);
}

void tall_scroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  suit_height();
}

void tall_scroll::suit_height() {
  const auto* layout = widget() ? widget()->layout() : nullptr;
  if (!layout)
    return;
  const int wide = viewport()->width();
  const int least = layout->hasHeightForWidth() ? layout->minimumHeightForWidth(wide)
                                                : layout->minimumSize().height();
  widget()->setMinimumHeight(least);
}

}  // namespace tedit::desktop
