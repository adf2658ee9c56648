// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_requests.hpp"

#include <algorithm>
#include <utility>

#include "client-qt/model/document.hpp"
#include "client-qt/model/load_words.hpp"

namespace tedit::desktop {

load_requests::load_requests(document& part, version_store& versions, remote& link)
    : part_(part), versions_(versions), link_(link) {
  // nop
}

const std::vector<fem::load_case>& load_requests::all() const {
  static const std::vector<fem::load_case> none;
  const auto* now = versions_.head();
  return now ? now->load_cases : none;
}

QStringList load_requests::acting_on(const std::vector<surface_id>& surfaces) const {
  QStringList result;
  const auto touches = [&](const auto& item) {
    return std::ranges::any_of(item.surfaces, [&](surface_id id) {
      return std::ranges::find(surfaces, id) != surfaces.end();
    });
  };
  for (const auto& one : all()) {
    const QString in = tr(" in %1").arg(QString::fromStdString(one.name));
    for (const auto& held : one.constraints)
      if (touches(held))
        result << words(held) + in;
    for (const auto& acting : one.loads)
      if (touches(acting))
        result << words(acting) + in;
  }
  return result;
}

void load_requests::take(const std::vector<fem::load_case>& loads) {
  auto* row = versions_.head();
  const bool others = row && std::exchange(row->load_cases, loads) != loads;
  if (others && !row->fields.empty())
    part_.forget_fields();
  emit changed();
}

/// One request; `done` when it was granted and the document is still the one that asked.
void load_requests::ask(const QString& title, remote::work<void> call, std::function<void()> done) {
  ++requests_;
  link_.run<void>(std::move(call), [this, title, done = std::move(done),
                                    mine = part_.opening()](const expected<void>& ok) {
    --requests_;
    if (mine != part_.opening())
      return;
    if (ok)
      done();
    else
      emit part_.failed(title, ok.error());
  });
}

/// The server tells what they are now before it answers.
void load_requests::change(const QString& title, remote::work<void> call,
                           std::function<void()> done) {
  const auto version = versions_.head_number();
  ask(title, std::move(call), [this, version, before = all(), done = std::move(done)] {
    if (version && version == versions_.head_number())
      past_.changed(*version, before, all());
    done();
  });
}

const std::vector<fem::load_case>* load_requests::past_to(step_to which) const {
  const auto version = versions_.head_number();
  return version && !is_changing() ? (past_.*which)(*version, all()) : nullptr;
}

void load_requests::undo() {
  if (const auto* wanted = past_to(&load_history::to_undo))
    replace(tr("Undo"), *wanted, [this](std::uint32_t version) { past_.undone(version); });
}

void load_requests::redo() {
  if (const auto* wanted = past_to(&load_history::to_redo))
    replace(tr("Redo"), *wanted, [this](std::uint32_t version) { past_.redone(version); });
}

/// Those that are there already stay as they are.
void load_requests::replace(const QString& title, std::vector<fem::load_case> wanted,
                            std::function<void(std::uint32_t)> done) {
  std::vector<fem::load_case> sent;
  std::vector<std::string> gone;
  for (const auto& one : wanted)
    if (std::ranges::find(all(), one) == all().end())
      sent.push_back(one);
  for (const auto& one : all())
    if (std::ranges::find(wanted, one.name, &fem::load_case::name) == wanted.end())
      gone.push_back(one.name);
  ask(
    title,
    [sent, gone](client::client& c, const execution&) {
      expected<void> ok;
      for (auto i = sent.begin(); ok && i != sent.end(); ++i)
        ok = c.set_load_case(*i);
      for (auto i = gone.begin(); ok && i != gone.end(); ++i)
        ok = c.remove_load_case(*i);
      return ok;
    },
    [this, sent, gone, done = std::move(done), version = *versions_.head_number()] {
      done(version);
      for (const auto& one : sent)
        emit was_set(one);
      for (const auto& name : gone)
        emit was_removed(name);
      if (!all().empty())
        part_.solver().solve();
      emit changed();
    });
}

void load_requests::send(std::vector<fem::load_case> loads, std::function<void()> then) {
  if (loads.empty())
    return;
  change(
    tr("Set the load cases"),
    [loads = std::move(loads)](client::client& c, const execution&) -> expected<void> {
      for (const auto& one : loads)
        if (auto ok = c.set_load_case(one); !ok)
          return ok;
      return {};
    },
    [this, then = std::move(then)] {
      if (then)
        then();
      part_.solver().solve();
    });
}

void load_requests::set(const fem::load_case& loads) {
  send({loads}, [this, loads] { emit was_set(loads); });
}

void load_requests::remove(const std::string& name) {
  change(
    tr("Remove the load case"),
    [name](client::client& c, const execution&) { return c.remove_load_case(name); },
    [this, name] {
      emit was_removed(name);
      if (!all().empty())
        part_.solver().solve();
    });
}

void load_requests::rename(const std::string& before, const fem::load_case& renamed) {
  change(
    tr("Rename the load case"),
    [before, renamed](client::client& c, const execution&) -> expected<void> {
      if (auto ok = c.set_load_case(renamed); !ok)
        return ok;
      return c.remove_load_case(before);
    },
    [this, before, renamed] {
      emit was_set(renamed);
      emit was_removed(before);
      part_.solver().solve();
    });
}

}  // namespace tedit::desktop
