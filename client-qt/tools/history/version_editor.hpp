// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include "client/types.hpp"

class QLineEdit;
class QPlainTextEdit;

namespace tedit::desktop {

/// Name and note of a version in a small field beside it. A click elsewhere or Ctrl+Enter takes
/// them over, Enter in the name, too; Esc leaves them as they were. It deletes itself.
class version_editor : public QFrame {
  Q_OBJECT

public:
  explicit version_editor(const client::version_info& version, QWidget* parent = nullptr);

  /// `place`: of the version on the screen.
  void open_beside(const QRect& place);

signals:
  /// Only when they were changed.
  void accepted(std::uint32_t number, const QString& name, const QString& note);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void take();

  client::version_info version_;
  QLineEdit* name_;
  QPlainTextEdit* note_;
  bool done_ = false;
};

}  // namespace tedit::desktop
