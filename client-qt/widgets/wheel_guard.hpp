// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QWidget;

namespace tedit::desktop {

/// The wheel over a form scrolls it: a number, a choice or a slider takes it only after it was
/// clicked, and as long as it has the focus then. For all widgets of the program that it filters.
class wheel_guard : public QObject {
public:
  using QObject::QObject;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QPointer<QWidget> clicked_;
};

}  // namespace tedit::desktop
