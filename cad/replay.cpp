// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/replay.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "cad/edited_surface.hpp"
#include "cad/private_folder.hpp"
#include "cad/steps.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::cad {

namespace {

/// Faces of surfaces that the mesh has not, as they were too small to be meshed, have no id.
part_facts facts_with_ids_of(const mesh_version& mesh, part_facts facts) {
  std::vector<bool> seen;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && mesh.facet(f).surface >= 0) {
      const auto id = static_cast<std::size_t>(mesh.facet(f).surface);
      seen.resize(std::max(seen.size(), id + 1));
      seen[id] = true;
    }
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i) {
    const auto id = static_cast<std::size_t>(mesh.data().interfaces[i].surface);
    seen.resize(std::max(seen.size(), id + 1));
    seen[id] = true;
  }
  for (auto& face : facts.faces)
    std::erase_if(face.ids, [&](int id) {
      return id < 0 || static_cast<std::size_t>(id) >= seen.size() ||
             !seen[static_cast<std::size_t>(id)];
    });
  return facts;
}

/// Faces that the CAD program has not named are called as the surface that an edit made of them.
void name_new_faces(part_facts& facts, const mesh_version& before, const mesh_version& after) {
  for (auto& face : facts.faces)
    if (face.name.empty() && face.ids.size() == 1 && !before.find_surface(face.ids.front()))
      if (const auto* made = after.find_surface(face.ids.front()))
        face.name = made->name;
}

expected<void> write_inputs(const replay_request& request, cad_step& step,
                            const std::filesystem::path& folder) {
  const auto extent = ops::extent_of(*request.before);
  step.size_mm = 1e3 * norm(extent.high - extent.low);
  step.volume_change_mm3 = 1e9 * request.report.volume_change;
  step.bodies = count_bodies(*request.after);
  const cad_model model{request.model.shape,
                        facts_with_ids_of(*request.before, request.model.facts)};
  if (auto ok = save_model(model, folder); !ok)
    return fail(ok.error());
  if (save_step(step, folder) &&
      save_surface(surface_after(*request.before, *request.after), folder))
    return {};
  return fail(ec::io_error, "the edit cannot be written for the CAD model",
              "Make room on the disk of the temporary folder ($TMPDIR)");
}

}  // namespace

expected<replayed_edit> replay_edit(const replay_request& request, const execution& run) {
  const stopwatch clock;
  replayed_edit result;
  auto step = step_of(request.description, *request.before, request.wanted, request.report);
  if (!step) {
    result.verdict.reason = step.error();
    return result;
  }
  if (auto there = find_program("tedit-cad-editor"); !there)
    return fail(there.error());
  const private_folder folder("tedit-cad-edit-");
  if (folder.path().empty())
    return fail(no_private_folder());
  if (auto ok = write_inputs(request, *step, folder.path()); !ok)
    return fail(ok.error());
  const auto end =
    run_program("tedit-cad-editor", "the CAD editor", folder.path(), {}, request.limits, run);
  result.ms = clock.milliseconds();
  if (end.by_clock && request.limits.clock > request.limits.time)
    return fail(ec::timeout,
                "the machine was too busy to make the edit on the CAD model within " +
                  std::to_string(request.limits.clock.count()) + " s",
                "Try again when less runs on it");
  if (!end.done) {
    if (end.why.code == ec::cancelled || end.why.code == ec::service_unavailable)
      return fail(end.why);
    result.verdict.reason = end.why.message;
    return result;
  }
  auto verdict = load_verdict(folder.path());
  if (!verdict)
    return fail(verdict.error());
  result.verdict = std::move(*verdict);
  if (!result.verdict.is_same)
    return result;
  auto model = load_model(folder.path());
  if (!model)
    return fail(model.error());
  result.model = std::move(*model);
  name_new_faces(result.model.facts, *request.before, *request.after);
  result.ms = clock.milliseconds();
  return result;
}

}  // namespace tedit::cad
