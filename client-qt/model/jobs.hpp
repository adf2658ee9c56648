// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace tedit::desktop {

/// How much longer work takes that is done to a fraction, ms: as long for each part as since the
/// fraction was seen first. Nothing before the fraction has moved by a twentieth in a second.
[[nodiscard]] std::optional<double> remaining_ms(double since_first_ms, double first_fraction,
                                                 double fraction);

/// "about 10 s left": rounded as roughly as such an estimate is known; empty for nothing.
[[nodiscard]] QString roughly(std::optional<double> remaining_ms);

/// One piece of work that the server does for this window.
struct job {
  int id = 0;
  QString title;  ///< "Fill hole".
  QString stage;  ///< As the server says it.
  double fraction = 0;
  std::function<void()> cancel;  ///< Empty: it cannot be cancelled from here.
  QElapsedTimer since;
  qint64 moved_ms = -1;  ///< When the fraction was seen first; before that negative.
  double first_fraction = 0;

  [[nodiscard]] double elapsed_ms() const { return static_cast<double>(since.elapsed()); }
  [[nodiscard]] std::optional<double> remaining() const;
};

/// What runs now, in the order in which it began.
class jobs : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  /// Notes that something runs; the result names it.
  int begin(const QString& title, std::function<void()> cancel);
  void progress(int id, double fraction, const QString& stage);
  /// Another one than those that run does nothing.
  void end(int id);
  /// Ends it here, where its document is left; at the server it goes on for a while.
  void leave(int id, const QString& document);
  /// The document that was left while work for it ran; empty: none.
  [[nodiscard]] const QString& left() const noexcept { return left_; }
  [[nodiscard]] qint64 left_for_ms() const {
    return left_since_.isValid() ? left_since_.elapsed() : 0;
  }
  void forget_left();
  void cancel(int id);
  [[nodiscard]] const std::vector<job>& all() const noexcept { return all_; }

signals:
  void changed();

private:
  [[nodiscard]] job* find(int id);

  std::vector<job> all_;
  int last_ = 0;
  QString left_;
  QElapsedTimer left_since_;
};

}  // namespace tedit::desktop
