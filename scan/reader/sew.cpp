// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "mesh/box_tree.hpp"
#include "scan/reader/mend.hpp"

namespace tedit::scan {

namespace {

/// Gaps in terms of the extent, and of the shorter edges beside them.
constexpr double widest_gap = 1e-3;
constexpr double gap_of_edge = 0.25;
/// Loops that are filled, in terms of the extent.
constexpr double longest_filled = 0.05;
constexpr int most_rounds = 8;

struct border_edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t triangle = 0;
};

std::vector<border_edge> borders_of(const triangle_surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, border_edge>> edges;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto a = surface.triangles[t][k];
      const auto b = surface.triangles[t][(k + 1) % 3];
      auto& [count, edge] = edges[std::minmax(a, b)];
      ++count;
      edge = {a, b, t};
    }
  std::vector<border_edge> result;
  for (const auto& [key, found] : edges)
    if (found.first == 1)
      result.push_back(found.second);
  return result;
}

class sewer {
public:
  explicit sewer(file_surface& read) : read_(read), extent_(extent_of(read.surface)) {}

  expected<sew_report> run() {
    for (int round = 0; round < most_rounds; ++round) {
      borders_ = borders_of(surface());
      if (borders_.empty())
        return report_;
      find_reach();
      if (const auto merged = merge_points(), split = split_edges(); merged + split == 0)
        break;
    }
    borders_ = borders_of(surface());
    if (const auto filled = fill_loops(); !filled)
      return fail(filled.error());
    return report_;
  }

private:
  triangle_surface& surface() { return read_.surface; }
  const vec3& point(std::uint32_t v) const { return read_.surface.points[v]; }

  /// How far a border's point may be from what it is sewn to.
  void find_reach() {
    reach_.clear();
    for (const auto& e : borders_)
      for (const auto v : {e.from, e.to}) {
        const double mine =
          std::min(widest_gap * extent_, gap_of_edge * norm(point(e.to) - point(e.from)));
        const auto [found, is_new] = reach_.emplace(v, mine);
        found->second = std::min(found->second, mine);
      }
  }

  std::size_t merge_points() {
    std::vector<std::uint32_t> points;
    std::vector<box> boxes;
    for (const auto& [v, reach] : reach_) {
      points.push_back(v);
      boxes.emplace_back().add(point(v));
    }
    const box_tree tree(boxes);
    std::map<std::uint32_t, std::uint32_t> into;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto v = points[i];
      if (into.contains(v))
        continue;
      (void)tree.any_meeting(boxes[i].grown(reach_[v]), [&](std::size_t j) {
        const auto w = points[j];
        const double apart = norm(point(w) - point(v));
        if (w > v && !into.contains(w) && apart <= std::min(reach_[v], reach_[w])) {
          into[w] = v;
          report_.widest_mm = std::max(report_.widest_mm, apart);
        }
        return false;
      });
    }
    report_.merged += into.size();
    if (into.empty())
      return 0;
    for (auto& t : surface().triangles)
      for (auto& v : t)
        if (const auto found = into.find(v); found != into.end())
          v = found->second;
    weld(read_, 1e-9 * extent_);
    return into.size();
  }

  struct cut {
    std::uint32_t triangle;
    double place;  ///< Along the edge, 0 to 1.
    std::uint32_t at;
    border_edge edge;
  };

  /// At the points of other borders that lie on them: one edge of a triangle in each round.
  std::size_t split_edges() {
    borders_ = borders_of(surface());
    find_reach();
    auto cuts = find_cuts();
    std::ranges::sort(cuts, [](const cut& a, const cut& b) {
      return std::tie(a.triangle, a.edge.from, a.place) <
             std::tie(b.triangle, b.edge.from, b.place);
    });
    std::size_t done = 0;
    for (std::size_t i = 0; i < cuts.size();) {
      std::size_t end = i + 1;
      while (end < cuts.size() && cuts[end].triangle == cuts[i].triangle &&
             cuts[end].edge.from == cuts[i].edge.from)
        ++end;
      split(cuts, i, end);
      done += end - i;
      while (end < cuts.size() && cuts[end].triangle == cuts[i].triangle)
        ++end;
      i = end;
    }
    report_.split += done;
    return done;
  }

  std::vector<cut> find_cuts() const {
    std::vector<box> boxes;
    for (const auto& e : borders_)
      boxes.push_back(box_of(std::array{point(e.from), point(e.to)}));
    const box_tree tree(boxes);
    std::vector<cut> cuts;
    for (const auto& [v, reach] : reach_) {
      box around;
      around.add(point(v));
      (void)tree.any_meeting(around.grown(reach), [&, v = v, reach = reach](std::size_t i) {
        const auto& e = borders_[i];
        const vec3 along = point(e.to) - point(e.from);
        const double place = dot(point(v) - point(e.from), along) / dot(along, along);
        const vec3 foot = point(e.from) + place * along;
        if (v != e.from && v != e.to && place > 0 && place < 1 && norm(point(v) - foot) <= reach &&
            std::ranges::find(surface_corners(e.triangle), v) == surface_corners(e.triangle).end())
          cuts.push_back({e.triangle, place, v, e});
        return false;
      });
    }
    return cuts;
  }

  const triangle_corners& surface_corners(std::uint32_t t) const {
    return read_.surface.triangles[t];
  }

  void split(const std::vector<cut>& cuts, std::size_t begin, std::size_t end) {
    const auto& first = cuts[begin];
    const auto t = first.triangle;
    const auto corners = surface().triangles[t];
    std::uint32_t apex = corners[0];
    for (const auto v : corners)
      if (v != first.edge.from && v != first.edge.to)
        apex = v;
    std::uint32_t from = first.edge.from;
    for (std::size_t i = begin; i < end; ++i) {
      const vec3 along = point(first.edge.to) - point(first.edge.from);
      const vec3 foot = point(first.edge.from) + cuts[i].place * along;
      report_.widest_mm = std::max(report_.widest_mm, norm(point(cuts[i].at) - foot));
      add_triangle({from, cuts[i].at, apex}, t);
      from = cuts[i].at;
    }
    surface().triangles[t] = {from, first.edge.to, apex};
  }

  /// Of the group and body of another one.
  void add_triangle(const triangle_corners& corners, std::uint32_t like) {
    surface().triangles.push_back(corners);
    if (!read_.group_of.empty())
      read_.group_of.push_back(read_.group_of[like]);
    if (!read_.body_of.empty())
      read_.body_of.push_back(read_.body_of[like]);
  }

  /// Borders in a row, each once around.
  expected<std::vector<std::vector<border_edge>>> loops() const {
    std::map<std::uint32_t, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < borders_.size(); ++i)
      for (const auto v : {borders_[i].from, borders_[i].to})
        at[v].push_back(i);
    for (const auto& [v, edges] : at)
      if (edges.size() != 2)
        return fail(ec::non_manifold,
                    "holes of the surface meet in one point, at " + place_of(point(v)),
                    "Close them in the program that the file comes from");
    std::vector<bool> seen(borders_.size(), false);
    std::vector<std::vector<border_edge>> found;
    for (std::size_t start = 0; start < borders_.size(); ++start) {
      if (seen[start])
        continue;
      auto& loop = found.emplace_back();
      auto v = borders_[start].from;
      for (std::size_t i = start; !seen[i];) {
        seen[i] = true;
        auto edge = borders_[i];
        if (edge.from != v)  // Triangles may be flipped.
          std::swap(edge.from, edge.to);
        v = edge.to;
        loop.push_back(edge);
        const auto& two = at.at(v);
        i = two[0] == i ? two[1] : two[0];
      }
    }
    return found;
  }

  double length_of(const std::vector<border_edge>& loop) const {
    double length = 0;
    for (const auto& e : loop)
      length += norm(point(e.to) - point(e.from));
    return length;
  }

  expected<void> fill_loops() {
    const auto found = loops();
    if (!found)
      return fail(found.error());
    const auto longest =
      std::ranges::max_element(*found, {}, [&](const auto& loop) { return length_of(loop); });
    if (longest != found->end() && length_of(*longest) > longest_filled * extent_)
      return fail(too_long(*longest, found->size()));
    for (const auto& loop : *found) {
      std::vector<vec3> points;
      for (const auto& e : loop)
        points.push_back(point(e.from));
      const auto triangles = fill_loop(points);
      if (triangles.empty())
        return fail(too_long(loop, found->size()));
      // Its triangles look the other way along the loop than those around it.
      for (const auto& t : triangles)
        add_triangle({loop[t[0]].from, loop[t[2]].from, loop[t[1]].from}, loop[0].triangle);
      ++report_.filled;
    }
    return {};
  }

  error too_long(const std::vector<border_edge>& loop, std::size_t count) const {
    vec3 middle;
    for (const auto& e : loop)
      middle += point(e.from) / static_cast<double>(loop.size());
    return {ec::bad_input,
            "the surface is not closed: it has " + std::to_string(count) +
              (count == 1 ? " hole" : " holes") + ", the longest is " +
              format_number("%.4g", length_of(loop)) + " mm around, its middle at " +
              place_of(middle),
            "Close it in the program that the file comes from, for example by MeshLab's \"Close "
            "holes\"; holes up to a twentieth of the part's extent around are closed here",
            {}};
  }

  file_surface& read_;
  double extent_;
  std::vector<border_edge> borders_;
  std::map<std::uint32_t, double> reach_;
  sew_report report_;
};

}  // namespace

expected<sew_report> sew(file_surface& read) {
  return sewer(read).run();
}

expected<void> check_edges(const triangle_surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k)
      ++count[std::minmax(t[k], t[(k + 1) % 3])];
  std::size_t bad = 0;
  vec3 first;
  for (const auto& [edge, triangles] : count)
    if (triangles > 2 && bad++ == 0)
      first = 0.5 * (surface.points[edge.first] + surface.points[edge.second]);
  if (bad == 0)
    return {};
  return fail(ec::non_manifold,
              std::to_string(bad) + (bad == 1 ? " edge has" : " edges have") +
                " more than two triangles, the first at " + place_of(first),
              "Bodies may touch but not share an edge, and no wall may lie within the material: "
              "part them, or unite them, in the program that the file comes from");
}

}  // namespace tedit::scan
