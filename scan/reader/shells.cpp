// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/box.hpp"
#include "scan/reader/mend.hpp"

namespace tedit::scan {

namespace {

constexpr std::size_t most_shells = 1000;

class shell_finder {
public:
  explicit shell_finder(triangle_surface& surface)
      : surface_(surface), across_(triangles_across(surface.triangles)) {
    found_.shell_of.assign(surface.triangles.size(), no_id);
  }

  expected<shell_set> run() {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (found_.shell_of[t] == no_id)
        if (const auto ok = flood(t); !ok)
          return fail(ok.error());
    if (shells_.size() > most_shells)
      return fail(ec::bad_input,
                  "the file holds " + std::to_string(shells_.size()) +
                    " separate closed surfaces, more than 1,000",
                  "Take out what is no part of it, for example by MeshLab's \"Remove isolated "
                  "pieces\"");
    if (const auto ok = check_points(); !ok)
      return fail(ok.error());
    nest();
    return std::move(found_);
  }

private:
  struct shell {
    std::vector<std::uint32_t> triangles;
    box extent;
    double volume = 0;
    std::vector<std::uint32_t> inside_of;
  };

  /// Whether both triangles go along their common edge the same way: one of them is turned.
  bool runs_alike(std::uint32_t t, std::uint32_t other) const {
    const auto& a = surface_.triangles[t];
    const auto& b = surface_.triangles[other];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (a[i] == b[k] && a[(i + 1) % 3] == b[(k + 1) % 3])
          return true;
    return false;
  }

  void turn(std::uint32_t t) { std::swap(surface_.triangles[t][1], surface_.triangles[t][2]); }

  vec3 middle_of(std::uint32_t t) const {
    const auto& v = surface_.triangles[t];
    return (surface_.points[v[0]] + surface_.points[v[1]] + surface_.points[v[2]]) / 3;
  }

  /// All that hangs together with a triangle, looking as it does.
  expected<void> flood(std::uint32_t first) {
    const auto id = static_cast<std::uint32_t>(shells_.size());
    auto& one = shells_.emplace_back();
    std::size_t turned = 0;
    one.triangles.push_back(first);
    found_.shell_of[first] = id;
    for (std::size_t i = 0; i < one.triangles.size(); ++i) {
      const auto t = one.triangles[i];
      for (const auto next : across_[t]) {  // Whatever their places: turning changes those.
        const bool is_new = found_.shell_of[next] == no_id;
        if (is_new) {
          found_.shell_of[next] = id;
          one.triangles.push_back(next);
        }
        if (!runs_alike(t, next))
          continue;
        if (!is_new)
          return fail(ec::non_manifold,
                      "the surface has one side only, as a Moebius strip has, at " +
                        place_of(middle_of(next)),
                      "Repair it in the program that the file comes from");
        turn(next);
        ++turned;
      }
    }
    found_.turned += std::min(turned, one.triangles.size() - turned);
    measure(one, turned > one.triangles.size() / 2);
    return {};
  }

  /// `was_turned`: most of its triangles were, to look as the first one.
  void measure(shell& one, bool was_turned) {
    const vec3 origin = surface_.points[surface_.triangles[one.triangles.front()][0]];
    for (const auto t : one.triangles) {
      const auto& v = surface_.triangles[t];
      for (const auto p : v)
        one.extent.add(surface_.points[p]);
      one.volume += dot(surface_.points[v[0]] - origin,
                        cross(surface_.points[v[1]] - origin, surface_.points[v[2]] - origin)) /
                    6;
    }
    looked_inward_.push_back((one.volume < 0) != was_turned);
  }

  /// Corners of triangles around a point that hang together over edges are one fan.
  expected<void> check_points() const {
    std::vector<std::uint32_t> fans(surface_.points.size(), 0);
    std::vector<std::array<bool, 3>> seen(surface_.triangles.size(), {false, false, false});
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        if (seen[t][k])
          continue;
        const auto v = surface_.triangles[t][k];
        if (++fans[v] > 1)
          return fail(ec::non_manifold,
                      "the surface touches itself in one point, at " + place_of(surface_.points[v]),
                      "Part what touches there, or unite it, in the program that the file comes "
                      "from");
        std::vector<std::uint32_t> fan{t};
        while (!fan.empty()) {
          const auto at = fan.back();
          fan.pop_back();
          const auto& corners = surface_.triangles[at];
          const auto place =
            static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
          if (seen[at][place])
            continue;
          seen[at][place] = true;
          for (const auto next : across_[at])
            if (std::ranges::find(surface_.triangles[next], v) != surface_.triangles[next].end())
              fan.push_back(next);
        }
      }
    return {};
  }

  /// By the solid angle under which the shell is seen: all around within it, nothing outside.
  bool encloses(const shell& outer, vec3 p) const {
    box point;
    point.add(p);
    if (!outer.extent.meets(point))
      return false;
    double angle = 0;
    for (const auto t : outer.triangles) {
      const auto& v = surface_.triangles[t];
      const vec3 a = surface_.points[v[0]] - p;
      const vec3 b = surface_.points[v[1]] - p;
      const vec3 c = surface_.points[v[2]] - p;
      const double la = norm(a);
      const double lb = norm(b);
      const double lc = norm(c);
      angle += 2 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
  }

  void nest() {
    for (std::uint32_t i = 0; i < shells_.size(); ++i)
      for (std::uint32_t j = 0; j < shells_.size(); ++j)
        if (i != j && encloses(shells_[j], middle_of(shells_[i].triangles.front())))
          shells_[i].inside_of.push_back(j);
    found_.solid_of.assign(shells_.size(), no_id);
    for (std::uint32_t i = 0; i < shells_.size(); ++i) {
      const bool is_cavity = shells_[i].inside_of.size() % 2 == 1;
      found_.inward += !is_cavity && looked_inward_[i];
      if ((shells_[i].volume > 0) == is_cavity)
        for (const auto t : shells_[i].triangles)
          turn(t);
      if (is_cavity)
        ++found_.cavities;
      else
        found_.solid_of[i] = static_cast<std::uint32_t>(found_.solids++);
    }
    for (std::uint32_t i = 0; i < shells_.size(); ++i)
      if (found_.solid_of[i] == no_id)
        found_.solid_of[i] = found_.solid_of[around(i)];
  }

  /// The innermost shell around one.
  std::uint32_t around(std::uint32_t i) const {
    return *std::ranges::max_element(shells_[i].inside_of, {},
                                     [&](std::uint32_t j) { return shells_[j].inside_of.size(); });
  }

  triangle_surface& surface_;
  std::vector<triangle_corners> across_;
  std::vector<shell> shells_;
  std::vector<bool> looked_inward_;
  shell_set found_;
};

}  // namespace

expected<shell_set> orient(triangle_surface& surface) {
  return shell_finder(surface).run();
}

}  // namespace tedit::scan
