// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// Shows what an edit would make while its values move: asks once they have rested for a moment,
/// the newest question ends the one before. Nothing of it is in the document. When the head moves
/// it is over until the values move again.
class live_preview : public QObject {
  Q_OBJECT

public:
  static constexpr int quiet_ms = 150;
  static constexpr double slow_ms = 3000;

  explicit live_preview(document& part, QObject* parent = nullptr);

  /// The edit to show from now on. The same again asks nothing.
  void want(const edit_wish& what);
  /// While something is dragged: nothing waits for rest, and drafts are asked for, which are
  /// answered several times sooner. What runs of those is let go on, so that each answer is seen;
  /// then the newest wish is asked for, and those between never. When it rests or the drag ends the
  /// whole preview is asked for.
  void set_dragged(bool on);
  /// Asks at once, also when it is off or slow.
  void ask_now() { ask(kind::whole); }
  /// Asks once more what was refused: `found_most` follows where there is a value that works.
  void find_most() { ask(kind::whole_or_most); }
  /// Back to the head.
  void leave();
  void set_on(bool on);
  /// Operations whose last preview took longer are not asked for by themselves.
  void set_slow_ms(double ms) { slow_ms_ = ms; }

  [[nodiscard]] bool is_on() const noexcept { return on_; }
  [[nodiscard]] bool has_wish() const noexcept { return wish_.has_value(); }
  /// Whether `find_most` was asked for what is refused now.
  [[nodiscard]] bool has_looked() const noexcept {
    return (running_ && asked_ == kind::whole_or_most) || has_looked_;
  }
  /// The last preview of the wanted operation took too long to follow every move.
  [[nodiscard]] bool is_slow() const;
  /// A question is on its way, or will be in a moment.
  [[nodiscard]] bool is_busy() const { return running_ || newer_ || quiet_.isActive(); }
  /// What is to be seen instead of the head; null: the head. During a drag a draft.
  [[nodiscard]] const shared_preview& shown() const noexcept { return shown_; }
  /// Why there is nothing to be seen.
  [[nodiscard]] const std::optional<error>& refusal() const noexcept { return refusal_; }
  [[nodiscard]] const QString& stage() const noexcept { return stage_; }
  /// How long ago what is shown was wished for, ms.
  [[nodiscard]] double wished_ms() const;
  /// From the question to the answer, ms; of the one that is shown.
  [[nodiscard]] double took_ms() const noexcept { return took_ms_; }

signals:
  void changed();
  void found_most(const tedit::most_that_works& value);

private:
  using kind = client::preview_kind;

  void ask(kind what);
  void ask_dragged();
  void want_dragged();
  void take_in_passing(const expected<shared_preview>& result);
  void take_draft(const expected<shared_preview>& result);
  [[nodiscard]] bool shows_draft() const noexcept { return shown_ && shown_->made.draft; }
  void stop();
  void take(const expected<shared_preview>& result);
  void activity_changed();

  document& part_;
  bool on_ = true;
  double slow_ms_ = slow_ms;
  std::optional<edit_wish> wish_;
  QTimer quiet_;
  QElapsedTimer clock_;
  ticket ticket_;
  QElapsedTimer wished_;        ///< Since the newest wish,
  QElapsedTimer asked_wished_;  ///< since the one that is asked for,
  QElapsedTimer shown_wished_;  ///< and since the one that is shown.
  bool dragged_ = false;
  bool newer_ = false;  ///< The wish is newer than the question that runs.
  bool running_ = false;
  kind asked_ = kind::whole;  ///< What runs.
  bool no_drafts_ = false;    ///< None could be made during this drag.
  bool has_looked_ = false;   ///< The refusal is of a question for the most that works.
  int question_ = 0;          ///< Answers to earlier ones are not for us.
  int retries_ = 0;
  std::map<QString, double> last_ms_;  ///< By operation, of whole ones.
  shared_preview shown_;
  std::optional<error> refusal_;
  QString stage_;
  double took_ms_ = 0;
};

}  // namespace tedit::desktop
