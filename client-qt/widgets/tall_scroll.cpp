// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/tall_scroll.hpp"

#include <QEvent>
#include <QScrollBar>

namespace tedit::desktop {

tall_scroll::tall_scroll(QWidget* content, QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidget(content);
}

QSize tall_scroll::sizeHint() const {
  if (!widget())
    return QScrollArea::sizeHint();
  const auto wide = widget()->sizeHint().expandedTo(widget()->minimumSizeHint());
  // With its words wrapped as they are: of its own accord a label asks for more lines than that.
  const bool wraps = isVisible() && widget()->hasHeightForWidth();
  return wraps ? QSize(wide.width(), widget()->heightForWidth(viewport()->width()))
               : wide.expandedTo(QSize(0, widget()->minimumHeight()));
}

QSize tall_scroll::minimumSizeHint() const {
  const int form = widget() ? widget()->minimumSizeHint().width() : 0;
  return {form + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
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
  if (watched == widget() && event->type() == QEvent::LayoutRequest) {
    keep_whole();
    updateGeometry();  // It may need another width, too.
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace tedit::desktop
