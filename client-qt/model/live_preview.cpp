// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/live_preview.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr int most_retries = 3;  // After other work went before it.

}  // namespace

live_preview::live_preview(document& part, QObject* parent) : QObject(parent), part_(part) {
  quiet_.setSingleShot(true);
  quiet_.setInterval(quiet_ms);
  connect(&quiet_, &QTimer::timeout, this, &live_preview::ask_now);
  connect(&part_, &document::head_changed, this, &live_preview::leave);
  connect(&part_, &document::begun, this, &live_preview::leave);
  connect(&part_.foreground(), &foreground_work::changed, this, &live_preview::activity_changed);
  // What becomes of loads is part of the answer.
  connect(&part_.loads(), &load_requests::changed, this, [this] {
    if (wish_ && on_ && !is_slow())
      quiet_.start();
  });
}

bool live_preview::is_slow() const {
  const auto found = wish_ ? last_ms_.find(wish_->operation) : last_ms_.end();
  return found != last_ms_.end() && found->second > slow_ms_;
}

void live_preview::want(const edit_wish& what) {
  if (wish_ == what)
    return;
  const bool other = !wish_ || wish_->operation != what.operation;
  if (dragged_ && !other && on_ && (!no_drafts_ || !is_slow())) {
    wish_ = what;
    return want_dragged();
  }
  stop();
  wish_ = what;
  wished_.start();
  const bool follows = on_ && !is_slow();
  if (follows)
    quiet_.start();
  if (other || !follows)
    shown_.reset();  // Else the last one stays until the next comes.
  refusal_.reset();
  has_looked_ = false;
  emit changed();
}

/// Most moves change nothing that anybody sees of the preview: they are not told. What runs and is
/// no draft is of a rest that is over.
void live_preview::want_dragged() {
  wished_.start();
  has_looked_ = false;
  if (part_.foreground().current())
    return;
  if (running_ && (asked_ == kind::draft || (no_drafts_ && asked_ == kind::whole))) {
    newer_ = true;
    return;
  }
  ask_dragged();
}

void live_preview::ask_dragged() {
  ask(no_drafts_ ? kind::whole : kind::draft);
}

void live_preview::set_dragged(bool on) {
  if (std::exchange(dragged_, on) == on)
    return;
  if (on) {
    no_drafts_ = false;
    return;
  }
  const bool comes = running_ && asked_ != kind::draft && !newer_;
  if (comes || !(running_ || shows_draft()))
    return;
  if (!is_slow())
    ask(kind::whole);
  else if (newer_)
    ask_dragged();
}

double live_preview::wished_ms() const {
  return shown_wished_.isValid() ? static_cast<double>(shown_wished_.nsecsElapsed()) * 1e-6 : 0;
}

void live_preview::ask(kind what) {
  stop();
  if (!wish_ || part_.foreground().current())
    return;
  asked_ = what;
  const int mine = question_;
  running_ = true;
  clock_.start();
  asked_wished_ = wished_;
  ticket_ = part_.questions().preview(
    *wish_, what,
    [this, mine](const expected<shared_preview>& result) {
      if (mine == question_)
        take(result);
    },
    [this, mine](double, const QString& stage) {
      if (mine != question_)
        return;
      stage_ = words_of(stage.toStdString());
      emit changed();
    });
  emit changed();
}

/// The wish has moved on: the answer is shown where it is one, and the next question is asked.
void live_preview::take_in_passing(const expected<shared_preview>& result) {
  took_ms_ = static_cast<double>(clock_.elapsed());
  if (asked_ == kind::whole)
    last_ms_[wish_->operation] = took_ms_;
  if (result) {
    shown_ = *result;
    shown_wished_ = asked_wished_;
    refusal_.reset();
  } else if (asked_ == kind::draft && result.error().code == ec::mesher_failed) {
    no_drafts_ = true;
  }
  if (asked_ == kind::draft || !is_slow())
    return ask_dragged();
  if (!result)
    shown_.reset();
  emit changed();
}

/// The whole one follows: at once where there is nothing to be seen, or when the pointer rests.
void live_preview::take_draft(const expected<shared_preview>& result) {
  if (result) {
    took_ms_ = static_cast<double>(clock_.elapsed());
    shown_ = *result;
    shown_wished_ = asked_wished_;
    refusal_.reset();
  } else if (!is_slow()) {
    return ask(kind::whole);
  } else {
    shown_.reset();
    refusal_ = result.error();
  }
  if (!is_slow())
    quiet_.start();
  emit changed();
}

void live_preview::take(const expected<shared_preview>& result) {
  running_ = false;
  stage_.clear();
  if (std::exchange(newer_, false))
    return take_in_passing(result);
  if (!result && result.error().code == ec::superseded && retries_ < most_retries) {
    ++retries_;
    quiet_.start();
    return;
  }
  retries_ = 0;
  if (asked_ == kind::draft)
    return take_draft(result);
  took_ms_ = static_cast<double>(clock_.elapsed());
  if (asked_ == kind::whole)  // What looks for long says nothing about the next preview.
    last_ms_[wish_->operation] = took_ms_;
  shown_ = result ? *result : nullptr;
  shown_wished_ = asked_wished_;
  refusal_ = result ? std::nullopt : std::optional(result.error());
  has_looked_ = asked_ == kind::whole_or_most;
  const auto most = refusal_ && has_looked_ ? refusal_->most : std::nullopt;
  emit changed();
  if (most)
    emit found_most(*most);
}

/// Ends what is on its way.
void live_preview::stop() {
  quiet_.stop();
  ++question_;
  newer_ = false;
  stage_.clear();
  if (!std::exchange(running_, false))
    return;
  ticket_.cancel();
  if (asked_ == kind::whole && wish_ && static_cast<double>(clock_.elapsed()) > slow_ms_)
    last_ms_[wish_->operation] = static_cast<double>(clock_.elapsed());
}

void live_preview::leave() {
  stop();
  const bool showed = wish_ || shown_ || refusal_;
  wish_.reset();
  shown_.reset();
  refusal_.reset();
  retries_ = 0;
  if (showed)
    emit changed();
}

void live_preview::set_on(bool on) {
  on_ = on;
  const auto what = wish_;
  leave();
  if (what)
    want(*what);
  emit changed();
}

/// While the edit is applied its preview stays to be seen: it is what comes. Were it refused, the
/// head is shown again; when it was done, the head has moved by then.
void live_preview::activity_changed() {
  if (part_.foreground().current()) {
    const bool busy = is_busy();
    stop();
    if (busy)
      emit changed();
    return;
  }
  QTimer::singleShot(0, this, [this] {
    if (!part_.foreground().current() && shown_)
      leave();
  });
}

}  // namespace tedit::desktop
