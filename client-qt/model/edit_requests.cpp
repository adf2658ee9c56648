// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/edit_requests.hpp"

#include <atomic>
#include <utility>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

edit_requests::edit_requests(document& part, const version_store& versions, remote& link)
    : part_(part), versions_(versions), link_(link), queue_(part) {
  connect(&link_, &remote::state_changed, this, &edit_requests::connection_changed);
}

void edit_requests::take(bool can_undo, bool can_redo) {
  can_undo_ = can_undo;
  can_redo_ = can_redo;
}

void edit_requests::forget() {
  unanswered_.reset();
  can_undo_ = can_redo_ = false;
}

/// When the connection breaks before the answer, it is asked for again once the document is open
/// again: the edit id sees to it that it is made once.
void edit_requests::ask(const QString& title, const remote::work<client::committed>& call) {
  auto broke = std::make_shared<std::atomic<bool>>(false);
  const auto watched = [call, broke](client::client& c, const execution& run) {
    auto result = call(c, run);
    *broke = !result && !c.connected() && !run.cancel.cancelled();
    return result;
  };
  part_.foreground().ask<client::committed>(
    title, watched,
    [this, title, call, broke, mine = part_.opening()](const expected<client::committed>& got) {
      if (mine != part_.opening())
        return;
      if (got && got->repeated)
        take_repeated(*got);
      else if (got)
        return;  // The document has heard of it as of everybody's commits.
      else if (*broke)
        unanswered_ = unanswered_change{title, call, got.error()};
      else
        fail_with(title, got.error());
    });
}

void edit_requests::fail_with(const QString& title, const error& why) {
  emit part_.failed(title, why);
  queue_.abandon();
}

/// It was made before the connection broke; others may have gone on since.
void edit_requests::take_repeated(const client::committed& what) {
  if (versions_.head_number() == what.head.number)
    part_.take(what);
  else
    part_.refresh_history();
}

void edit_requests::ask_again() {
  const auto left = std::exchange(unanswered_, std::nullopt);
  if (!left)
    return;
  ask(left->title, [=](client::client& c, const execution& run) { return left->call(c, run); });
}

void edit_requests::connection_changed() {
  if (link_.current() == remote::state::offline)  // It does not come back by itself.
    if (const auto left = std::exchange(unanswered_, std::nullopt))
      fail_with(left->title, left->why);
}

void edit_requests::apply(const edit_wish& wish) {
  const auto* offered = part_.operations().find(wish.operation);
  const QString title = offered ? QString::fromStdString(offered->about.name) : wish.operation;
  const auto* now = part_.head();
  const std::string expected_version = now ? now->info.version_id : std::string();
  emit applied(wish);
  ask(title, [=, id = wish.operation.toStdString(), once = client::make_edit_id()](
               client::client& c, const execution& run) {
    return c.edit(id, wish.surfaces, wish.values, run, expected_version, wish.loads, once, true);
  });
}

void edit_requests::undo() {
  ask(tr("Undo"), [once = client::make_edit_id()](client::client& c, const execution&) {
    return c.undo({{}, once});
  });
}

void edit_requests::redo() {
  ask(tr("Redo"), [once = client::make_edit_id()](client::client& c, const execution&) {
    return c.redo({{}, once});
  });
}

void edit_requests::go_to(std::uint32_t number) {
  ask(tr("Go to version %1").arg(number),
      [number, once = client::make_edit_id()](client::client& c, const execution&) {
        return c.go_to(number, {{}, once});
      });
}

void edit_requests::annotate(std::uint32_t number, const QString& name, const QString& note) {
  link_.run<void>([number, name = name.toStdString(), note = note.toStdString()](
                    client::client& c, const execution&) { return c.annotate(number, name, note); },
                  [this](const expected<void>& ok) {  // What it is called now comes as an event.
                    if (!ok)
                      emit part_.failed(tr("Name the version"), ok.error());
                  });
}

}  // namespace tedit::desktop
