// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/tall_scroll.hpp"

#include <QEvent>

namespace tedit::desktop {

tall_scroll::tall_scroll(QWidget* content, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width());
}

QSize tall_scroll::sizeHint() const {
  return widget() ? QSize(widget()->sizeHint().expandedTo(widget()->minimumSizeHint()))
                  : QScrollArea::sizeHint();
}

/// Forms in forms let their fields be squashed below what these ask for.
void tall_scroll::keep_whole() {
  auto* content = widget();
  if (!content)
    return;
  const int wanted = content->hasHeightForWidth() ? content->heightForWidth(viewport()->width())
                                                  : content->sizeHint().height();
  content->setMinimumHeight(wanted);
}

void tall_scroll::resizeEvent(QResizeEvent* event) {
  keep_whole();
  QScrollArea::resizeEvent(event);
}

bool tall_scroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest)
    keep_whole();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace tedit::desktop
