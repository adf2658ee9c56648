// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "ops/conformance/kit.hpp"

namespace tedit::ops::kit {

namespace {

/// At most this many selections of one mesh are tried alone.
constexpr std::size_t most_alone = 40;

/// The smallest selections that the operation's description allows: for most operations every
/// surface alone, and for those that need none nothing. Of many, some spread evenly. What
/// `check_selection` refuses no plugin gets to see: it is not tried.
std::vector<std::vector<surface_id>> smallest_selections(const plugin_trial& b,
                                                         const mesh_version& mesh) {
  const auto size = std::max<std::size_t>(1, b.description().selection.minimum);
  const auto& table = mesh.surfaces();
  std::vector<std::vector<surface_id>> all;
  if (b.description().selection.minimum == 0)
    all.emplace_back();
  for (std::size_t first = 0; first + size <= table.size(); ++first) {
    auto& one = all.emplace_back();
    for (std::size_t i = 0; i < size; ++i)
      one.push_back(table[first + i].id);
  }
  if (all.size() <= most_alone)
    return all;
  std::vector<std::vector<surface_id>> some;
  for (std::size_t i = 0; i < most_alone; ++i)
    some.push_back(all[i * all.size() / most_alone]);
  return some;
}

std::vector<surface_id> whole(const plugin_trial& b, const mesh_version& mesh) {
  std::vector<surface_id> result;
  for (const auto& row : mesh.surfaces())
    result.push_back(row.id);
  if (const auto most = b.description().selection.maximum; most > 0 && result.size() > most)
    result.resize(most);
  return result;
}

/// Tells the parent that this selection works.
void say_case(const plugin_trial& b, const working_case& c) {
  std::string line = std::to_string(c.sample);
  for (const auto id : c.surfaces)
    line += " " + std::to_string(id);
  b.say(line);
}

/// Tells the parent that this selection was refused, and whether the refusal was explained.
void say_refusal(const plugin_trial& b, const error& e, const std::string& what) {
  try {
    check_refusal(e, what);
    b.say(std::string(refused));
  } catch (const failure& f) {
    b.say(std::string(refused) + " " + f.seen + std::string(remedy_mark) + f.remedy);
  }
}

/// Tries one selection; true when it was accepted.
bool accepts(const plugin_trial& b, const working_case& c) {
  const auto what = "surface " + where(b, c);
  b.mark("applying to " + what);
  const auto answer = b.apply(b.sample_of(c).mesh, c.surfaces, b.values());
  if (!answer) {
    say_refusal(b, answer.error(), what);
    return false;
  }
  if (!answer->candidate)
    throw failure{"the result on surface " + where(b, c) + " has no candidate",
                  "Set edit_result::candidate, or return fail(...)"};
  return true;
}

std::string alone(plugin_trial& b) {
  b.load();
  std::size_t tried = 0;
  std::size_t accepted = 0;
  const auto& p = b.the_plan();
  for (std::size_t i = 0; i < p.samples.size(); ++i) {
    const bool is_part = p.samples[i].mesh == p.settings->part;
    bool any = false;
    const auto attempt = [&](std::vector<surface_id> surfaces) {
      const working_case c{i, std::move(surfaces)};
      ++tried;
      if (!accepts(b, c))
        return;
      ++accepted;
      any = true;
      say_case(b, c);
    };
    if (is_part && !p.settings->selected.empty())
      attempt(p.settings->selected);
    for (auto& surfaces : smallest_selections(b, *p.samples[i].mesh))
      attempt(std::move(surfaces));
    if (!any)
      attempt(whole(b, *p.samples[i].mesh));
  }
  return std::to_string(tried) + " selections on " + std::to_string(p.samples.size()) +
         " meshes answered, " + std::to_string(accepted) + " accepted";
}

std::string accepts_something(plugin_trial& b) {
  b.load();
  const auto& p = b.the_plan();
  const auto part_case = [&](const working_case& c) {
    return p.samples[c.sample].mesh == p.settings->part && c.surfaces == p.settings->selected;
  };
  if (!p.settings->selected.empty() && std::ranges::none_of(p.cases, part_case)) {
    const working_case c{p.samples.size() - 1, p.settings->selected};
    b.mark("applying to surface " + where(b, c));
    const auto answer = b.apply(b.sample_of(c).mesh, c.surfaces, b.values());
    throw failure{"the given selection " + where(b, c) + " is refused" +
                    (answer ? "" : ": " + render(answer.error())),
                  "Give a selection that the operation accepts"};
  }
  if (!p.cases.empty())
    return "works on " + std::to_string(p.cases.size()) + " of " +
           std::to_string(p.samples.size()) + " meshes, for example on surface " +
           where(b, p.cases.front());
  const working_case c{1, {11}};
  b.mark("applying to surface " + where(b, c));
  const auto answer = b.apply(b.sample_of(c).mesh, c.surfaces, b.values());
  throw failure{"no selection of any mesh was accepted; on surface " + where(b, c) + ": " +
                  (answer ? "accepted now, refused before" : render(answer.error())),
                "Give a mesh and a selection that the operation accepts: --mesh FILE --select IDS; "
                "--set NAME=VALUE sets parameters"};
}

std::string whole_selection(plugin_trial& b) {
  b.load();
  int accepted = 0;
  const auto& samples = b.the_plan().samples;
  for (const auto& s : samples) {
    b.mark("applying to all surfaces of " + s.name);
    accepted += check_answer(b, *s.mesh, b.apply(s.mesh, whole(b, *s.mesh), b.values()),
                             "all surfaces of " + s.name);
  }
  return "answered on " + std::to_string(samples.size()) + " meshes, accepted on " +
         std::to_string(accepted);
}

std::string duplicates(plugin_trial& b) {
  b.load();
  for (const auto& c : b.the_plan().cases) {
    if (c.surfaces.empty())
      continue;
    const auto once = b.succeed(c).candidate->id();
    auto twice = c;
    twice.surfaces.push_back(c.surfaces.front());
    b.mark("applying to surface " + where(b, twice));
    const auto answer = b.apply(b.sample_of(c).mesh, twice.surfaces, b.values());
    if (check_answer(b, *b.sample_of(c).mesh, answer, "surface " + where(b, twice)) &&
        answer->candidate->id() != once)
      throw failure{"naming surface " + std::to_string(c.surfaces.front()) +
                      " twice gives another result than naming it once",
                    "Treat the selection as a set"};
  }
  return "no difference";
}

/// Two surfaces that work together, or nothing.
std::optional<working_case> pair_case(const plugin_trial& b) {
  const auto& p = b.the_plan();
  for (const auto& c : p.cases) {
    if (c.surfaces.size() > 1)
      return c;
    for (const auto& row : b.sample_of(c).mesh->surfaces()) {
      working_case both = c;
      if (c.surfaces.empty() || row.id == c.surfaces.front())
        continue;
      both.surfaces.push_back(row.id);
      b.mark("applying to surface " + where(b, both));
      if (const auto a = b.apply(b.sample_of(c).mesh, both.surfaces, b.values()); a && a->candidate)
        return both;
    }
  }
  return std::nullopt;
}

std::string order(plugin_trial& b) {
  b.load();
  if (b.description().selection.maximum == 1)
    return "it takes one surface only";
  const auto c = pair_case(b);
  if (!c)
    return "no two surfaces were accepted together";
  auto reversed = *c;
  std::ranges::reverse(reversed.surfaces);
  if (b.succeed(*c).candidate->id() != b.succeed(reversed).candidate->id())
    throw failure{"surfaces " + where(b, *c) + " and the same in reverse order give two versions",
                  "Sort the selection first, or do each step in the order of the slots"};
  return "surfaces " + where(b, *c) + " in either order give one version";
}

std::string refusals(plugin_trial& b) {
  b.load();
  const auto& p = b.the_plan();
  if (!p.unexplained.empty())
    throw failure{p.unexplained.front()};
  auto refused_ones = p.refusals;
  for (const auto& s : p.samples) {
    const auto what = "all surfaces of " + s.name;
    b.mark("applying to " + what);
    const auto answer = b.apply(s.mesh, whole(b, *s.mesh), b.values());
    if (answer)
      continue;
    ++refused_ones;
    check_refusal(answer.error(), what);
  }
  return std::to_string(refused_ones) + " refusals, each with message and remedy";
}

}  // namespace

const std::vector<check>& survey_checks() {
  static const std::vector<check> list{
    {"every_surface_alone",
     "Every surface alone gets an answer in time, without a crash; nothing selected, too, where "
     "`minimum` is 0",
     need::plugin, alone},
    {"accepts_something", "There is a selection that works", need::plugin, accepts_something}};
  return list;
}

const std::vector<check>& selection_checks() {
  static const std::vector<check> list{
    {"whole_selection", "All surfaces at once get an answer that holds", need::plugin,
     whole_selection},
    {"duplicate_selection", "A surface named twice counts once", need::deterministic, duplicates},
    {"selection_order", "The order of the selection does not matter", need::deterministic, order},
    {"refusals_explained", "Every refusal has a message and a remedy", need::plugin, refusals}};
  return list;
}

}  // namespace tedit::ops::kit
