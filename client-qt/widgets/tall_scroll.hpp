// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace tedit::desktop {

/// Scrolls a form up and down. Nothing in it gets less than its own height: words that need several
/// lines are counted by their lines, which a plain scroll area does not do.
class tall_scroll : public QScrollArea {
public:
  explicit tall_scroll(QWidget* content, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void suit_height();
};

}  // namespace tedit::desktop
