// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace tedit::desktop {

/// Scrolls a form up and down where it has too little room, so that no field is squashed; asks for
/// the room of the whole form. Never sideways.
class tall_scroll : public QScrollArea {
public:
  explicit tall_scroll(QWidget* content, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  /// Wide enough for the form and the bar beside it.
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void keep_whole();
};

}  // namespace tedit::desktop
