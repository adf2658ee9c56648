// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <utility>

#include "client-qt/model/jobs.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

/// What the user waits for.
struct activity {
  QString title;  ///< "Fill hole".
  QString stage;  ///< As the server says it.
  double fraction = 0;
  bool can_cancel = true;
};

/// The request that a person waits for, one at a time, and beside it all else that runs.
class foreground_work : public QObject {
  Q_OBJECT

public:
  explicit foreground_work(remote& link) : link_(link) {}

  [[nodiscard]] const std::optional<activity>& current() const { return activity_; }
  /// All that runs for this window, what `current` shows included.
  [[nodiscard]] jobs& all() { return all_; }
  /// Ends what `current` shows.
  void cancel();

  /// Asks for something that a person waits for.
  template <class T>
  void ask(const QString& title, remote::work<T> call, remote::reply<T> done) {
    begin(title);
    running_ = link_.run<T>(
      std::move(call),
      [this, done = std::move(done)](expected<T> result) {
        end();
        done(std::move(result));
      },
      [this](double fraction, const QString& stage) { progressed(fraction, stage); });
  }

signals:
  void changed();

private:
  void begin(const QString& title);
  void end();
  void progressed(double fraction, const QString& stage);

  remote& link_;
  std::optional<activity> activity_;
  jobs all_;
  int job_ = 0;
  ticket running_;
};

}  // namespace tedit::desktop
