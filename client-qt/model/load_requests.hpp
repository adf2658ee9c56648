// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <functional>
#include <vector>

#include "client-qt/model/load_history.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;
class version_store;

/// The load cases of the head, and changing them.
class load_requests : public QObject {
  Q_OBJECT

public:
  load_requests(document& part, version_store& versions, remote& link);

  [[nodiscard]] const std::vector<fem::load_case>& all() const;
  /// What holds or loads some of these surfaces: "fixed in ctc01_plate static".
  [[nodiscard]] QStringList acting_on(const std::vector<surface_id>& surfaces) const;
  /// Whether a change is on its way to the server.
  [[nodiscard]] bool is_changing() const noexcept { return requests_ > 0; }
  void set(const fem::load_case& loads);
  /// One after the other, then the solve of them all.
  void send(std::vector<fem::load_case> loads, std::function<void()> then = {});
  /// Takes a load case from the head, and solves what is left.
  void remove(const std::string& name);
  /// Gives a load case the name that `renamed` has: the head is never without it. One request, so
  /// that nothing comes between.
  void rename(const std::string& before, const fem::load_case& renamed);
  /// Takes back the last change that was made here, where nothing else happened to the head since;
  /// `redo` makes it again. Solves what there is then.
  void undo();
  void redo();
  [[nodiscard]] bool can_undo() const { return past_to(&load_history::to_undo) != nullptr; }
  [[nodiscard]] bool can_redo() const { return past_to(&load_history::to_redo) != nullptr; }
  /// The document heard of them. Fields of other loads are forgotten.
  void take(const std::vector<fem::load_case>& loads);

  void forget() { past_.clear(); }

signals:
  void changed();
  /// A load case that was asked for from here is the head's, or is gone from it.
  void was_set(const tedit::fem::load_case& loads);
  void was_removed(const std::string& name);

private:
  using step_to = const std::vector<fem::load_case>* (
    load_history::*)(std::uint32_t, const std::vector<fem::load_case>&) const;
  void ask(const QString& title, remote::work<void> call, std::function<void()> done);
  void change(const QString& title, remote::work<void> call, std::function<void()> done);
  void replace(const QString& title, std::vector<fem::load_case> wanted,
               std::function<void(std::uint32_t)> done);
  [[nodiscard]] const std::vector<fem::load_case>* past_to(step_to which) const;

  document& part_;
  version_store& versions_;
  remote& link_;
  load_history past_;
  int requests_ = 0;  ///< Without an answer.
};

}  // namespace tedit::desktop
