// SPDX-License-Identifier: AGPL-3.0-or-later
#include <dlfcn.h>

#include <algorithm>
#include <iostream>
#include <typeinfo>

#include "ops/conformance/kit.hpp"
#include "ops/loader/operation_log.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::ops::kit {

namespace {

/// Findings of one rule at one element, to tell old faults from new ones.
bool same_place(const finding& a, const finding& b) {
  return a.rule == b.rule && a.element == b.element;
}

void add_table_faults(const mesh_version& candidate, std::vector<finding>& faults) {
  for (std::size_t i = 0; i + 1 < candidate.surfaces().size(); ++i)
    if (candidate.surfaces()[i].id >= candidate.surfaces()[i + 1].id)
      faults.push_back({ec::invalid_mesh, "surface table ascends", "row " + std::to_string(i + 1),
                        "id " + std::to_string(candidate.surfaces()[i + 1].id)});
  for (tet_id t = 0; t < candidate.tet_slots(); ++t) {
    const auto region = candidate.is_live_tet(t) ? candidate.region_of(t) : 0;
    if (candidate.is_live_tet(t) &&
        std::ranges::find(candidate.regions(), region, &region_info::id) ==
          candidate.regions().end()) {
      faults.push_back({ec::invalid_mesh, "region is in the table", "tet " + std::to_string(t),
                        "region " + std::to_string(region)});
      return;  // One is enough to name the rule.
    }
  }
}

}  // namespace

const catalogue& built_in_operations() {
  static const catalogue all = load_default_catalogue(plugin_source::built_in);
  return all;
}

void plugin_trial::open() {
  mark("loading the file");
  library_ = dlopen(plan_.settings->file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library_)
    throw failure{readable_dl_error(dlerror()),
                  "Link what is missing into the plugin, or install it on every machine that runs "
                  "TEdit; \"ldd FILE\" lists what is looked for"};
}

void plugin_trial::find_entry() {
  open();
  mark("calling tedit_plugin_query");
  const auto query =
    reinterpret_cast<const plugin_descriptor* (*)()>(dlsym(library_, "tedit_plugin_query"));
  if (!query)
    throw failure{"there is no function tedit_plugin_query",
                  "Write TEDIT_PLUGIN(name, version, class) once, outside all namespaces"};
  descriptor_ = query();
  if (!descriptor_)
    throw failure{"tedit_plugin_query returned a null pointer", "Use the macro TEDIT_PLUGIN"};
}

void plugin_trial::load() {
  find_entry();
  mark("making the operation");
  code_ = make();
  mark("asking for the description");
  description_ = code_->describe();
  // For the whole check, which may be hundreds of edits.
  log_ = operation_log(description_.id, [](const std::string& line) { std::cerr << line + "\n"; });
}

std::shared_ptr<const operation> plugin_trial::make() const {
  auto* made = descriptor_->create(plan_.operation);
  if (!made)
    throw failure{"create(" + std::to_string(plan_.operation) + ") returned a null pointer",
                  "Return a new operation for every index below operation_count"};
  return {made, [d = descriptor_](const operation* p) { d->destroy(const_cast<operation*>(p)); }};
}

parameters plugin_trial::values() const {
  auto completed = complete_parameters(description_, plan_.settings->values);
  if (!completed)
    throw failure{render(completed.error()), "See the check \"defaults\""};
  return *completed;
}

expected<edit_result> plugin_trial::apply_by(const operation& code, const version_ptr& mesh,
                                             const std::vector<surface_id>& surfaces,
                                             const parameters& with, const execution& run) const {
  const auto host = make_host_services();
  context ctx;
  ctx.run = run;
  ctx.host = host.get();
  ctx.log = log_;
  ctx.apply_other = others_of(built_in_operations(), ctx);
  try {
    return code.apply(mesh, {surfaces}, with, ctx);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "the operation ran out of memory");
  } catch (const std::exception& e) {
    throw failure{std::string("apply threw ") + typeid(e).name() + ": " + e.what(),
                  "Return fail(...) with a code, a message and a remedy instead of throwing"};
  }
}

edit_result plugin_trial::succeed(const working_case& c, const execution& run) const {
  mark("applying to surface " + where(*this, c));
  auto answer = apply(sample_of(c).mesh, c.surfaces, values(), run);
  if (!answer)
    throw failure{"surface " + where(*this, c) +
                    " was accepted before and is refused now: " + render(answer.error()),
                  "Keep no state between calls"};
  if (!answer->candidate)
    throw failure{"the result on surface " + where(*this, c) + " has no candidate",
                  "Set edit_result::candidate to what mesh_builder::freeze returns"};
  return std::move(*answer);
}

std::string where(const plugin_trial& b, const working_case& c) {
  std::string ids;
  for (const auto id : c.surfaces)
    ids += (ids.empty() ? "" : ", ") + std::to_string(id);
  return (ids.empty() ? "(none)" : ids) + " of " + b.sample_of(c).name;
}

std::string to_text(const finding& f) {
  return f.rule + " does not hold" + (f.element.empty() ? "" : " at " + f.element) +
         (f.numbers.empty() ? "" : " (" + f.numbers + ")");
}

std::vector<finding> faults_of(const mesh_version& base, const edit_result& edit) {
  edit_claim claim;
  claim.touched = edit.touched;
  claim.volume_change = edit.volume_change;
  claim.quality_floor = 0;
  claim.bodies_added = edit.bodies_added;
  const auto& candidate = *edit.candidate;
  const auto before = check_version(base).findings;
  std::vector<finding> result;
  const auto add = [&](const std::vector<finding>& more) {
    for (const auto& f : more) {
      const auto same = [&](const finding& other) { return same_place(f, other); };
      if (std::ranges::none_of(before, same) && std::ranges::none_of(result, same))
        result.push_back(f);
    }
  };
  add(check_version(candidate).findings);
  if (std::ranges::any_of(result, [](const finding& f) { return f.rule == "corners exist"; }))
    return result;  // Nothing else can be asked of such a mesh.
  add(check_edit(base, candidate, claim).findings);
  add_table_faults(candidate, result);
  return result;
}

void check_refusal(const error& e, const std::string& what) {
  if (e.message.empty())
    throw failure{
      what + ": refused with the code " + std::string(code_name(e.code)) + " and no message",
      "Say what is wrong, with the numbers, as fail's second argument"};
  const bool obvious = e.code == ec::cancelled || e.code == ec::out_of_memory;
  if (e.remedy.empty() && !obvious)
    throw failure{what + ": refused without a remedy: " + e.message,
                  "Say what the person can do about it as fail's third argument"};
}

bool check_answer(const plugin_trial& b, const mesh_version& mesh,
                  const expected<edit_result>& answer, const std::string& what) {
  if (!answer) {
    if (answer.error().message.empty())
      check_refusal(answer.error(), what);
    return false;
  }
  if (!answer->candidate)
    throw failure{what + ": the result has no candidate",
                  "Set edit_result::candidate, or return fail(...)"};
  if (b.the_plan().faulty)
    return true;
  if (const auto faults = faults_of(mesh, *answer); !faults.empty())
    throw failure{what + ": " + to_text(faults.front()),
                  "Refuse what cannot be done with an error that names the reason"};
  return true;
}

}  // namespace tedit::ops::kit
