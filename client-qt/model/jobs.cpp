// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/jobs.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tedit::desktop {

namespace {

struct jobs_phrases {
  Q_DECLARE_TR_FUNCTIONS(jobs)
};

}  // namespace

std::optional<double> remaining_ms(double since_first_ms, double first_fraction, double fraction) {
  const double done = fraction - first_fraction;
  if (since_first_ms < 1000 || done < 0.05 || fraction >= 1)
    return std::nullopt;
  return since_first_ms * (1 - fraction) / done;
}

QString roughly(std::optional<double> remaining) {
  if (!remaining)
    return {};
  const double seconds = *remaining / 1000;
  if (seconds < 3)
    return jobs_phrases::tr("nearly done");
  for (const int step : {5, 10, 15, 20, 30, 45})
    if (seconds <= step)
      return jobs_phrases::tr("about %1 s left").arg(step);
  return jobs_phrases::tr("about %1 min left")
    .arg(std::max(1, static_cast<int>(std::lround(seconds / 60))));
}

std::optional<double> job::remaining() const {
  if (moved_ms < 0)
    return std::nullopt;
  return remaining_ms(elapsed_ms() - static_cast<double>(moved_ms), first_fraction, fraction);
}

job* jobs::find(int id) {
  const auto found = std::ranges::find(all_, id, &job::id);
  return found == all_.end() ? nullptr : &*found;
}

int jobs::begin(const QString& title, std::function<void()> cancel) {
  job made;
  made.id = ++last_;
  made.title = title;
  made.cancel = std::move(cancel);
  made.since.start();
  all_.push_back(std::move(made));
  emit changed();
  return last_;
}

/// A fraction that goes back, as between two stages, begins the estimate anew.
void jobs::progress(int id, double fraction, const QString& stage) {
  auto* one = find(id);
  if (!one)
    return;
  if (one->moved_ms < 0 ? fraction > 0 : fraction < one->fraction) {
    one->moved_ms = one->since.elapsed();
    one->first_fraction = fraction;
  }
  one->fraction = fraction;
  one->stage = stage;
  emit changed();
}

void jobs::end(int id) {
  if (std::erase_if(all_, [id](const job& one) { return one.id == id; }) > 0)
    emit changed();
}

void jobs::leave(int id, const QString& document) {
  left_ = document;
  left_since_.start();
  end(id);
}

void jobs::forget_left() {
  left_.clear();
  left_since_.invalidate();
  emit changed();
}

void jobs::cancel(int id) {
  auto* one = find(id);
  if (!one || !one->cancel)
    return;
  one->stage = jobs_phrases::tr("cancelling");
  const auto call = std::exchange(one->cancel, nullptr);
  emit changed();
  call();
}

}  // namespace tedit::desktop
