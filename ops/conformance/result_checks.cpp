// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/finish_edit.hpp"
#include "ops/conformance/kit.hpp"

namespace tedit::ops::kit {

namespace {

constexpr auto changes_nothing = "changes something";
constexpr auto loses_region = "region stays in the table";

void look_at(const plugin_trial& b, const working_case& c, const edit_result& edit,
             std::vector<broken_rule>& broken) {
  const auto& before = *b.sample_of(c).mesh;
  const auto at = "on surface " + where(b, c) + ": ";
  b.mark("checking the result on surface " + where(b, c));
  for (const auto& fault : faults_of(before, edit))
    broken.push_back({fault.rule, at + to_text(fault)});
  for (const auto& row : before.regions())
    if (std::ranges::find(edit.candidate->regions(), row) == edit.candidate->regions().end())
      broken.push_back({loses_region, at + "region " + std::to_string(row.id) + " left the table"});
  // What asks for a thorough optimisation leaves the change to the host.
  if (edit.improve != improvement::thorough && edit.candidate->id() == before.id() &&
      edit.notices.empty())
    broken.push_back({changes_nothing, at + "the edit changed nothing and did not say so"});
}

/// What the working cases break. Runs them unless another check has told.
std::vector<broken_rule> broken_rules(plugin_trial& b) {
  if (b.the_plan().broken)
    return *b.the_plan().broken;
  b.load();
  std::vector<broken_rule> broken;
  for (const auto& c : b.the_plan().cases)
    look_at(b, c, b.succeed(c), broken);
  return broken;
}

/// Fails when a candidate of the working cases breaks one of these rules.
std::string judge(plugin_trial& b, const std::set<std::string>& rules, const char* remedy) {
  for (const auto& one : broken_rules(b))
    if (rules.contains(one.rule))
      throw failure{one.seen, remedy};
  return "holds in " + std::to_string(b.the_plan().cases.size()) + " edits";
}

void check_complete(const plugin_trial& b, const working_case& c, const edit_result& edit) {
  const auto& mesh = *edit.candidate;
  const auto at = "on surface " + where(b, c) + ": ";
  if (!std::isfinite(edit.volume_change))
    throw failure{at + "volume_change is not a finite number", "Compute it in m^3"};
  for (const auto t : edit.touched)
    if (t >= mesh.tet_slots() || !mesh.is_live_tet(t))
      throw failure{at + "touched names tet " + std::to_string(t) + ", which is not there",
                    "Hand back what mesh_builder::touched() returns"};
  for (const auto id : c.surfaces)
    if (std::ranges::find(edit.surfaces_used, id) == edit.surfaces_used.end())
      throw failure{at + "surfaces_used leaves out the selected surface " + std::to_string(id),
                    "Fill it with the selection as completed by the operation"};
  for (const auto& notice : edit.notices)
    if (notice.empty())
      throw failure{at + "a notice is empty", "Say something, or leave it out"};
}

/// Tells those that come after it what else the results break.
std::string complete(plugin_trial& b) {
  b.load();
  std::vector<broken_rule> broken;
  for (const auto& c : b.the_plan().cases) {
    const auto edit = b.succeed(c);
    check_complete(b, c, edit);
    look_at(b, c, edit, broken);
  }
  for (const auto& one : broken)
    b.say(std::string(breaks) + one.rule + "\t" + one.seen);
  b.say(std::string(looked_at));
  return "touched tets, volume, surfaces and notices are filled in";
}

std::string positive_tets(plugin_trial& b) {
  return judge(b, {"positive orientation"},
               "Check signed_volume of every touched tet and refuse the edit before it gets here");
}

std::string adjacency_right(plugin_trial& b) {
  return judge(b,
               {"corners exist", "neighbours share a face", "boundary face has its facet",
                "facet lies on its tet", "incident tet holds the vertex"},
               "Change topology through mesh_builder::apply only: it keeps adjacency up to date");
}

std::string manifold(plugin_trial& b) {
  return judge(b, {"boundary is a 2-manifold"},
               "Put back tets at the edge or vertex named until its facets form one fan");
}

std::string surfaces_total(plugin_trial& b) {
  return judge(b, {"facet has a surface of the table", "surface table ascends"},
               "Name new facets in cavity_change::facets, with ids of the table or from "
               "mesh_builder::add_surface");
}

std::string counts(plugin_trial& b) {
  return judge(b, {"counts are right"}, "Build the candidate by mesh_builder only");
}

std::string regions(plugin_trial& b) {
  (void)judge(b, {loses_region}, "Regions carry materials: keep the table as it is");
  return judge(b, {"untouched tets keep their region", "region is in the table"},
               "Give each new tet the region of the tet that it lies against");
}

std::string untouched(plugin_trial& b) {
  return judge(b, {"untouched tets are identical"},
               "Hand back mesh_builder::touched(), which lists every new or moved tet");
}

std::string volume_claim(plugin_trial& b) {
  return judge(b, {"volume changes as the operation says"},
               "Compute the change apart from the tets, for example by the divergence theorem over "
               "the facets that changed");
}

std::string no_void(plugin_trial& b) {
  return judge(b, {"no new closed void or separate boundary"},
               "Refuse an edit that would close off a void or cut the part in pieces, or, where "
               "that was asked for, count them in bodies_added");
}

std::string quality(plugin_trial& b) {
  b.load();
  for (const auto& c : b.the_plan().cases) {
    const auto edit = b.succeed(c);
    if (!faults_of(*b.sample_of(c).mesh, edit).empty())
      throw not_applicable{"the candidate breaks other rules: see there"};
    b.mark("improving the result on surface " + where(b, c));
    edit_claim claim;
    claim.touched = edit.touched;
    claim.volume_change = edit.volume_change;
    claim.quality_floor = edit.quality_floor;
    claim.bodies_added = edit.bodies_added;
    const auto done = finish_edit(b.sample_of(c).mesh, edit.candidate, claim,
                                  {edit.improve, edit.thorough}, {}, {});
    if (!done)
      throw failure{"on surface " + where(b, c) + ": " + done.error().message,
                    "Make better tets where the edit is, or let the host improve them"};
  }
  return "after the host's improvement, q is at least min(the operation's floor, before)";
}

std::string changes_something(plugin_trial& b) {
  (void)judge(b, {changes_nothing}, "Refuse what would change nothing, or say it in a notice");
  return "every edit changed the mesh or said why not";
}

/// Whether the operation was tried on a mesh, and what became of it.
std::string on_sample(plugin_trial& b, std::size_t index) {
  b.load();
  const auto& s = b.the_plan().samples[index];
  std::size_t accepted = 0;
  std::size_t tried = 0;
  for (const auto& row : s.mesh->surfaces()) {
    if (++tried > 40)
      break;
    const working_case c{index, {row.id}};
    b.mark("applying to surface " + where(b, c));
    accepted +=
      check_answer(b, *s.mesh, b.apply(s.mesh, c.surfaces, b.values()), "surface " + where(b, c));
  }
  return std::to_string(accepted) + " edits hold, " +
         std::to_string(std::min<std::size_t>(tried, 40) - accepted) + " refused";
}

std::string two_regions(plugin_trial& b) {
  return on_sample(b, 2);
}

std::string free_slots(plugin_trial& b) {
  return on_sample(b, 3);
}

std::string on_part(plugin_trial& b) {
  if (!b.the_plan().settings->part)
    throw not_applicable{"no part was given; try --mesh FILE"};
  return on_sample(b, 4);
}

}  // namespace

const std::vector<check>& result_checks() {
  static const std::vector<check> list{
    {"result_complete", "Touched tets, volume change and used surfaces are filled in",
     need::working_case, complete},
    {"changes_something", "An edit changes the mesh or says why not", need::working_case,
     changes_something},
    {"positive_tets", "Every tet is positively oriented", need::working_case, positive_tets},
    {"adjacency", "Neighbours, facets and incident tets agree", need::working_case,
     adjacency_right},
    {"manifold_boundary", "The boundary stays a closed 2-manifold", need::working_case, manifold},
    {"surface_ids", "Every facet has a surface of the table", need::working_case, surfaces_total},
    {"counts", "Counts and free lists are right", need::working_case, counts},
    {"regions_kept", "Regions stay: the table, and those of untouched tets", need::working_case,
     regions},
    {"untouched_tets", "What is not listed as touched is identical", need::working_case, untouched},
    {"volume_claim", "The volume changes by what the operation says", need::working_case,
     volume_claim},
    {"no_void", "No closed void or separate piece appears that is not claimed", need::working_case,
     no_void},
    {"quality_floor", "The touched region is good enough after the host's improvement",
     need::working_case, quality},
    {"two_regions", "Results on a mesh of two regions hold", need::plugin, two_regions},
    {"free_slots", "Results on an edited mesh with free slots hold", need::plugin, free_slots},
    {"part_mesh", "Results on the given part hold", need::plugin, on_part}};
  return list;
}

}  // namespace tedit::ops::kit
