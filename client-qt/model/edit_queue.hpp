// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <deque>
#include <functional>

namespace tedit::desktop {

class document;

/// Changes that a person asked for while another was on its way: made one after the other, each
/// once the head of the one before is there. What comes after one that failed was meant for another
/// part, so it is not made.
class edit_queue : public QObject {
  Q_OBJECT

public:
  static constexpr std::size_t most = 50;

  explicit edit_queue(document& part, QObject* parent = nullptr);

  /// Calls it at once when nothing runs and nothing waits, else in its turn. Beyond `most` it is
  /// not taken.
  bool add(const QString& title, std::function<void()> change);
  /// What waits, the next one first.
  [[nodiscard]] QStringList waiting() const;
  void clear();
  /// The change that was on its way failed.
  void abandon();

signals:
  void changed();
  /// These were not made, since the one before them failed.
  void abandoned(const QStringList& changes);

private:
  struct waiting_change {
    QString title;
    std::function<void()> make;
  };

  void next();

  document& part_;
  std::deque<waiting_change> waiting_;
};

}  // namespace tedit::desktop
