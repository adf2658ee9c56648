// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/several_places.hpp"

#include <algorithm>
#include <cstdio>
#include <span>

#include "base/short_number.hpp"
#include "mesh/checks.hpp"

namespace tedit::ops {

namespace {

constexpr double most_places = 200;
constexpr double nearest_places = 1e-9;  // m: less than any mesh has.
/// Made one after the other: more take longer than a person waits.
constexpr std::size_t most_overlapping = 30;
/// Of one boolean.
constexpr std::size_t most_triangles = 4000;

/// Tools as one; `sizes` by the least.
placed_tool joined(std::span<const placed_tool> tools) {
  placed_tool all = tools.front();
  for (const auto& one : tools.subspan(1)) {
    const auto points = static_cast<std::uint32_t>(all.tool.points.size());
    const auto faces = static_cast<std::uint32_t>(all.tool.names.size());
    all.tool.points.insert(all.tool.points.end(), one.tool.points.begin(), one.tool.points.end());
    for (const auto& t : one.tool.triangles)
      all.tool.triangles.push_back({points + t[0], points + t[1], points + t[2]});
    for (const auto face : one.tool.faces)
      all.tool.faces.push_back(faces + face);
    all.tool.names.insert(all.tool.names.end(), one.tool.names.begin(), one.tool.names.end());
    all.size = std::min(all.size, one.size);
  }
  return all;
}

/// Applies tools one after the other, or those that are apart at once.
class tool_series {
public:
  tool_series(const version_ptr& mesh, const std::vector<placed_tool>& tools, boolean_mode mode,
              context& ctx)
      : base_(mesh), tools_(tools), mode_(mode), ctx_(ctx), now_(mesh) {}

  expected<edit_result> run(const std::vector<surface_id>& used) {
    if (auto ok = check_boxes(); !ok)
      return fail(ok.error());
    for (std::size_t first = 0; first < tools_.size();) {
      const auto last = first + apart_from(first);
      if (last - first == 1 || !make(first, last)) {
        for (std::size_t i = first; i < last; ++i)
          if (auto ok = make(i, i + 1); !ok)
            return fail(at_place(ok.error(), i + 1, tools_.size(), tools_[i].at));
      }
      first = last;
    }
    return result(used);
  }

private:
  /// What can be told before anything is made.
  [[nodiscard]] expected<void> check_boxes() const {
    const auto part = extent_of(*base_);
    std::vector<box> boxes;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      boxes.push_back(extent_of(tools_[i].tool));
      if (!boxes.back().meets(part))
        return fail(at_place({ec::empty_selection, "it is beside the part", "Choose another place"},
                             i + 1, tools_.size(), tools_[i].at));
    }
    std::size_t overlapping = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (boxes[i].meets(boxes[k])) {
          ++overlapping;
          break;
        }
    if (overlapping > most_overlapping)
      return fail(ec::invalid_parameter,
                  std::to_string(overlapping) +
                    " places that overlap others are more than the 30 that one edit makes",
                  "Give fewer, or further apart");
    return {};
  }

  /// How many from there on are apart from each other and not too many for one boolean.
  [[nodiscard]] std::size_t apart_from(std::size_t first) const {
    std::vector<box> taken;
    std::size_t triangles = 0;
    std::size_t i = first;
    for (; i < tools_.size(); ++i) {
      const auto extent = extent_of(tools_[i].tool);
      triangles += tools_[i].tool.triangles.size();
      const bool meets =
        std::ranges::any_of(taken, [&](const box& other) { return other.meets(extent); });
      if (i > first && (meets || triangles > most_triangles))
        break;
      taken.push_back(extent);
    }
    return i - first;
  }

  /// These at once. Errors: also where one of several does not meet the part, which then has to be
  /// found by itself.
  expected<void> make(std::size_t first, std::size_t last) {
    const auto share = [&](std::size_t n) { return double(n) / double(tools_.size()); };
    const auto all = joined(std::span(tools_).subspan(first, last - first));
    auto made = ctx_.host->boolean(now_, all.tool, {mode_, deviation_share * all.size},
                                   ctx_.run.part(share(first), share(last)));
    if (!made)
      return fail(made.error());
    if (last - first > 1 && !each_has_a_wall(first, last, *made))
      return fail(ec::empty_selection, "one of the places is beside the part");
    if (const auto edit = as_edit(*now_, *made, all.tool, {}); !edit)
      return fail(edit.error());
    now_ = made->candidate;
    change_ += made->volume_change;
    deviation_ = std::max(deviation_, made->deviation);
    for (std::size_t i = 0; i < made->surfaces.size(); ++i)
      if (made->surfaces[i] && !base_->find_surface(*made->surfaces[i]))
        fresh_ += (fresh_.empty() ? "" : ", ") + std::to_string(*made->surfaces[i]) + " (" +
                  all.tool.names[i] + ")";
    return {};
  }

  [[nodiscard]] bool each_has_a_wall(std::size_t first, std::size_t last,
                                     const boolean_result& made) const {
    auto face = made.surfaces.begin();
    for (std::size_t i = first; i < last; ++i) {
      const auto end = face + static_cast<std::ptrdiff_t>(tools_[i].tool.names.size());
      if (std::none_of(face, end, [](const auto& s) { return s.has_value(); }))
        return false;
      face = end;
    }
    return true;
  }

  [[nodiscard]] edit_result result(const std::vector<surface_id>& used) const {
    edit_result done;
    done.candidate = now_;
    done.touched = changed_tets(*base_, *now_);
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

  const version_ptr& base_;
  const std::vector<placed_tool>& tools_;
  boolean_mode mode_;
  context& ctx_;
  version_ptr now_;
  double change_ = 0;
  double deviation_ = 0;
  std::string fresh_;
};

}  // namespace

parameter_description places_parameter(const std::string& help) {
  return {"places", "More places", help, parameter_type::polyline, "m", 1.0, most_places,
          {},       std::string()};
}

expected<std::vector<parameters>> at_each_place(const parameters& values) {
  if (!values.contains("places"))
    return std::vector{values};
  auto places = points_of(values, "places");
  if (places.empty())
    return std::vector{values};
  if (const auto at = vector_of(values, "at"))
    places.insert(places.begin(), *at);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = i + 1; k < places.size(); ++k)
      if (norm(places[i] - places[k]) < nearest_places)
        return fail(
          ec::invalid_parameter,
          "the places " + std::to_string(i + 1) + " and " + std::to_string(k + 1) + " are the same",
          "Give each place once; the one of its own counts as the first");
  std::vector<parameters> result;
  for (const auto& p : places) {
    std::array<char, 100> text{};
    std::snprintf(text.data(), text.size(), "%.17g, %.17g, %.17g", p.x, p.y, p.z);
    auto& one = result.emplace_back(values);
    one["at"] = std::string(text.data());
    one["places"] = std::string();
  }
  return result;
}

error at_place(error e, std::size_t number, std::size_t count, vec3 at) {
  const auto mm = [](double metres) { return short_number(1e3 * metres, 8); };
  if (count > 1)
    e.message = "place " + std::to_string(number) + " of " + std::to_string(count) + " (" +
                mm(at.x) + ", " + mm(at.y) + ", " + mm(at.z) + " mm): " + e.message;
  return e;
}

expected<edit_result> apply_tools(const version_ptr& mesh, std::vector<placed_tool> tools,
                                  boolean_mode mode, const std::vector<surface_id>& used,
                                  context& ctx) {
  if (tools.size() == 1)
    return apply_tool(mesh, tools.front().tool, mode, tools.front().size, used, ctx);
  for (std::size_t i = 1; i < tools.size(); ++i)
    for (auto& name : tools[i].tool.names)
      name += " " + std::to_string(i + 1);
  return tool_series(mesh, tools, mode, ctx).run(used);
}

}  // namespace tedit::ops
