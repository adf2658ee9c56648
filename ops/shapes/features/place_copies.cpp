// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/place_copies.hpp"

#include <algorithm>

#include "mesh/checks.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

class copier {
public:
  copier(const copy_source& from, context& ctx) : from_(from), now_(from.start), ctx_(ctx) {
    change_ = from.volume_change;
    bodies_ = boundary_components(*from.base);
  }

  expected<void> place(const feature_tool& feature, const motion& way, const std::string& which,
                       const execution& run) {
    box extent;
    for (const auto& p : feature.tool.points)
      extent.add(way(p));
    const double size = local_size(*now_, extent);
    const auto tool = placed(*now_, feature, way, size);
    std::vector<std::optional<surface_id>> continues(tool.names.size());
    if (from_.keeps_ids)
      std::ranges::copy(feature.surfaces, continues.begin());
    auto made =
      ctx_.host->boolean_onto(now_, tool, continues, {feature.mode, deviation_share * size}, run);
    if (!made)
      return fail(of_copy(made.error(), which));
    if (boundary_components(*made->candidate) > bodies_)
      return fail(of_copy({ec::invalid_argument,
                           feature.mode == boolean_mode::add
                             ? "it would not touch the part"
                             : "the part would fall into pieces, or have a closed void",
                           "Choose another place"},
                          which));
    now_ = made->candidate;
    change_ += made->volume_change;
    deviation_ = std::max(deviation_, made->deviation);
    for (std::size_t i = 0; i < made->surfaces.size(); ++i)
      if (made->surfaces[i] && !from_.base->find_surface(*made->surfaces[i]))
        fresh_ += (fresh_.empty() ? "" : ", ") + std::to_string(*made->surfaces[i]) + " (" +
                  tool.names[i] + ")";
    return {};
  }

  edit_result result(const std::vector<surface_id>& used) const {
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
  static error of_copy(error e, const std::string& which) {
    if (!which.empty())
      e.message = which + ": " + e.message;
    return e;
  }

  const copy_source& from_;
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
  copier work(from, ctx);
  const auto all = motions.size() * features.tools.size();
  std::size_t done = 0;
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (const auto& feature : features.tools) {
      if (ctx.run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const auto share = [&](std::size_t n) { return 0.2 + 0.8 * double(n) / double(all); };
      const std::string which = motions.size() < 2 ? std::string()
                                                   : "copy " + std::to_string(i + 1) + " of " +
                                                       std::to_string(motions.size());
      if (auto ok =
            work.place(feature, motions[i], which, ctx.run.part(share(done), share(done + 1)));
          !ok)
        return fail(ok.error());
      ++done;
    }
  return work.result(features.surfaces);
}

}  // namespace tedit::ops
