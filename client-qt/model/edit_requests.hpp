// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>
#include <vector>

#include "client-qt/model/edit_queue.hpp"
#include "client-qt/model/head_questions.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;
class version_store;

/// Changes of the head: operations, undo, redo, another version. One at a time is what a person
/// waits for; `document::edited` or `document::failed` follows each.
class edit_requests : public QObject {
  Q_OBJECT

public:
  edit_requests(document& part, const version_store& versions, remote& link);

  [[nodiscard]] bool can_undo() const noexcept { return can_undo_; }
  [[nodiscard]] bool can_redo() const noexcept { return can_redo_; }
  void apply(const edit_wish& wish);
  /// For what is wanted while another change is on its way.
  [[nodiscard]] edit_queue& queue() noexcept { return queue_; }
  /// The connection broke before the answer to a change: it will be asked for again.
  [[nodiscard]] bool awaits_answer() const noexcept { return unanswered_.has_value(); }
  void undo();
  void redo();
  /// Makes any version the head.
  void go_to(std::uint32_t number);
  /// Gives a version another name and note. No edit: nobody waits for it.
  void annotate(std::uint32_t number, const QString& name, const QString& note);

  // -- for the document ----------------------------------------------------------------

  void take(bool can_undo, bool can_redo);
  /// Asks again for what the connection took the answer of, once the document is open again.
  void ask_again();
  void forget();

signals:
  /// An operation was asked for.
  void applied(const tedit::desktop::edit_wish& wish);

private:
  /// A change whose answer the connection took with it when it broke.
  struct unanswered_change {
    QString title;
    remote::work<client::committed> call;
    error why;
  };

  void ask(const QString& title, const remote::work<client::committed>& call);
  void fail_with(const QString& title, const error& why);
  void take_repeated(const client::committed& what);
  void connection_changed();

  document& part_;
  const version_store& versions_;
  remote& link_;
  bool can_undo_ = false;
  bool can_redo_ = false;
  std::optional<unanswered_change> unanswered_;
  edit_queue queue_;
};

}  // namespace tedit::desktop
