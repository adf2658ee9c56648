// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <string>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// What hinders printing the head, for as long as somebody wants to know. What is known is always
/// of the head: when that becomes another version it is forgotten and asked for anew.
class print_inspection : public QObject {
  Q_OBJECT

public:
  explicit print_inspection(document& part);

  /// Asks about the head, and from then on about each new one; instead of what was asked before.
  void look(const print_settings& settings);
  /// Ends that and forgets what is known.
  void stop();
  /// Ends the question that runs; the next head is asked about all the same.
  void cancel();

  /// Whether heads are asked about.
  [[nodiscard]] bool is_on() const noexcept { return wanted_.has_value(); }
  /// With which settings; nothing while it is off.
  [[nodiscard]] const std::optional<print_settings>& wanted() const noexcept { return wanted_; }
  [[nodiscard]] bool is_asking() const noexcept { return asking_; }
  /// Of the head; null: nothing is known.
  [[nodiscard]] const shared_print_check& known() const noexcept { return known_; }
  /// Why nothing is known of the head.
  [[nodiscard]] const std::optional<error>& refusal() const noexcept { return refusal_; }

signals:
  void changed();

private:
  void follow();
  void ask();
  void forget();
  void take(expected<shared_print_check> got);

  document& part_;
  std::optional<print_settings> wanted_;
  std::string asked_of_;  ///< Its version.
  bool asking_ = false;
  int question_ = 0;  ///< Answers to earlier ones are not for us.
  std::function<void()> end_question_;
  shared_print_check known_;
  std::optional<error> refusal_;
};

}  // namespace tedit::desktop
