// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/foreground_work.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

void foreground_work::begin(const QString& title) {
  activity_ = activity{title, {}, 0, true};
  all_.end(job_);
  job_ = all_.begin(title, [this] { cancel(); });
  emit changed();
}

void foreground_work::end() {
  activity_.reset();
  all_.end(job_);
  emit changed();
}

void foreground_work::progressed(double fraction, const QString& stage) {
  if (!activity_)
    return;
  activity_->fraction = fraction;
  activity_->stage = words_of(stage.toStdString());
  all_.progress(job_, fraction, activity_->stage);
  emit changed();
}

void foreground_work::cancel() {
  if (!activity_)
    return;
  running_.cancel();
  activity_->stage = tr("cancelling");
  activity_->can_cancel = false;
  emit changed();
}

}  // namespace tedit::desktop
