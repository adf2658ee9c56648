// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/place_copies.hpp"

#include <algorithm>
#include <span>

#include "mesh/checks.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// Tools of one boolean, as far as they are not in each other's way: triangles, and copies that
/// overlap and so are made one after the other.
constexpr std::size_t triangles_at_once = 4000;
constexpr std::size_t most_overlapping = 100;

/// One feature in one place.
struct copy_job {
  const feature_tool* feature = nullptr;
  const motion* way = nullptr;
  std::size_t number = 0;  ///< From 1, of the motion.
  box extent;
};

std::vector<copy_job> jobs_of(const picked_features& features, const std::vector<motion>& motions) {
  std::vector<copy_job> jobs;
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (const auto& feature : features.tools) {
      copy_job job{&feature, &motions[i], i + 1, {}};
      for (const auto& p : feature.tool.points)
        job.extent.add(motions[i](p));
      jobs.push_back(job);
    }
  return jobs;
}

bool any_overlap(const std::vector<copy_job>& jobs) {
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (std::size_t j = i + 1; j < jobs.size(); ++j)
      if (jobs[i].extent.meets(jobs[j].extent))
        return true;
  return false;
}

class copier {
public:
  copier(const copy_source& from, std::size_t copies, context& ctx)
      : from_(from), copies_(copies), now_(from.start), ctx_(ctx) {
    change_ = from.volume_change;
    bodies_ = boundary_components(*from.base);
  }

  /// All at once; where that fails one after the other, so that the one that cannot be is named.
  expected<void> place(std::span<const copy_job> jobs, const execution& run) {
    auto done = place_at_once(jobs, run);
    if (done || jobs.size() == 1 || done.error().code == ec::cancelled)
      return done;
    for (std::size_t i = 0; i < jobs.size(); ++i)
      if (auto one = place_at_once(jobs.subspan(i, 1), run); !one)
        return one;
    return {};
  }

  [[nodiscard]] edit_result result(const std::vector<surface_id>& used) const {
    edit_result done;
    done.candidate = now_;
    done.touched = changed_tets(*from_.base, *now_);
    done.volume_change = change_;
    done.improve = improvement::none;  // The booleans have done it.
    done.quality_floor = lowest_boolean_quality;
    done.surfaces_used = used;
    if (!fresh_.empty())
      done.notices.push_back("new surfaces: " + fresh_);
    done.figures.push_back(
      {"deviation_mm", 1e3 * deviation_, "mm", "furthest off what was asked for"});
    return done;
  }

private:
  /// The tools of several copies as one, with what each face continues.
  struct joined_tool {
    tool_surface tool;
    std::vector<std::optional<surface_id>> continues;
    std::vector<std::size_t> first_face;  ///< Of each copy.
    double size = 1e300;                  ///< m: the least of the part's mean edges there.
  };

  [[nodiscard]] joined_tool join(std::span<const copy_job> jobs) const {
    joined_tool all;
    for (const auto& job : jobs) {
      const double size = local_size(*now_, job.extent);
      const auto one = placed(*now_, *job.feature, *job.way, size);
      const auto points = static_cast<std::uint32_t>(all.tool.points.size());
      const auto faces = static_cast<std::uint32_t>(all.tool.names.size());
      all.tool.points.insert(all.tool.points.end(), one.points.begin(), one.points.end());
      for (const auto& t : one.triangles)
        all.tool.triangles.push_back({points + t[0], points + t[1], points + t[2]});
      for (const auto face : one.faces)
        all.tool.faces.push_back(faces + face);
      all.first_face.push_back(faces);
      all.tool.names.insert(all.tool.names.end(), one.names.begin(), one.names.end());
      all.tool.geometries.insert(all.tool.geometries.end(), one.geometries.begin(),
                                 one.geometries.end());
      all.continues.resize(all.tool.names.size());
      if (from_.keeps_ids)
        std::ranges::copy(job.feature->surfaces, all.continues.begin() + faces);
      all.size = std::min(all.size, size);
    }
    return all;
  }

  expected<void> place_at_once(std::span<const copy_job> jobs, const execution& run) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    const auto mode = jobs.front().feature->mode;
    const auto all = join(jobs);
    auto made = ctx_.host->boolean_onto(now_, all.tool, all.continues,
                                        {mode, deviation_share * all.size}, run);
    if (!made)
      return fail(of_copy(made.error(), jobs.front()));
    if (jobs.size() > 1 && !all_made(all, *made))
      return fail(ec::empty_selection, "one of the copies does not meet the part");
    if (boundary_components(*made->candidate) > bodies_)
      return fail(of_copy(
        {ec::invalid_argument,
         mode == boolean_mode::add ? "it would not touch the part"
                                   : "the part would fall into pieces, or have a closed void",
         "Choose another place"},
        jobs.front()));
    now_ = made->candidate;
    change_ += made->volume_change;
    deviation_ = std::max(deviation_, made->deviation);
    for (std::size_t i = 0; i < made->surfaces.size(); ++i)
      if (made->surfaces[i] && !from_.base->find_surface(*made->surfaces[i]))
        fresh_ += (fresh_.empty() ? "" : ", ") + std::to_string(*made->surfaces[i]) + " (" +
                  all.tool.names[i] + ")";
    return {};
  }

  /// Has something of each copy become a surface?
  static bool all_made(const joined_tool& all, const boolean_result& made) {
    for (std::size_t i = 0; i < all.first_face.size(); ++i) {
      const auto last =
        i + 1 < all.first_face.size() ? all.first_face[i + 1] : made.surfaces.size();
      bool any = false;
      for (auto face = all.first_face[i]; face < last; ++face)
        any = any || made.surfaces[face].has_value();
      if (!any)
        return false;
    }
    return true;
  }

  [[nodiscard]] error of_copy(error e, const copy_job& job) const {
    if (copies_ > 1)
      e.message =
        "copy " + std::to_string(job.number) + " of " + std::to_string(copies_) + ": " + e.message;
    return e;
  }

  const copy_source& from_;
  std::size_t copies_;
  version_ptr now_;
  context& ctx_;
  std::size_t bodies_ = 0;
  double change_ = 0;
  double deviation_ = 0;
  std::string fresh_;
};

}  // namespace

expected<edit_result> place_copies(const copy_source& from, const picked_features& features,
                                   const std::vector<motion>& motions, context& ctx) {
  const auto jobs = jobs_of(features, motions);
  const bool overlap = any_overlap(jobs);
  if (overlap && jobs.size() > most_overlapping)
    return fail(ec::invalid_parameter,
                std::to_string(jobs.size()) + " copies that overlap each other are more than the " +
                  std::to_string(most_overlapping) + " that one edit makes",
                "Give a smaller count or a larger step");
  copier work(from, motions.size(), ctx);
  for (std::size_t first = 0; first < jobs.size();) {
    std::size_t last = first;
    std::size_t triangles = 0;
    do
      triangles += jobs[last++].feature->tool.triangles.size();
    while (!overlap && last < jobs.size() &&
           triangles + jobs[last].feature->tool.triangles.size() <= triangles_at_once);
    const auto share = [&](std::size_t n) { return 0.2 + 0.8 * double(n) / double(jobs.size()); };
    if (auto ok = work.place(std::span(jobs).subspan(first, last - first),
                             ctx.run.part(share(first), share(last)));
        !ok)
      return fail(ok.error());
    first = last;
  }
  return work.result(features.surfaces);
}

}  // namespace tedit::ops
