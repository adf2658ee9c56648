// SPDX-License-Identifier: AGPL-3.0-or-later
// The exact boolean of two closed surfaces: stdin to stdout, see exchange.hpp. Every number is a
// rational one until the end. What comes in may be anything: whoever starts this program sets a
// time limit and expects that it may end.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "ops/mesher/corefine_exchange.hpp"
#include "ops/mesher/jobs.hpp"

namespace {

using namespace tedit::ops;
namespace pmp = CGAL::Polygon_mesh_processing;
using kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using point = kernel::Point_3;
using surface = CGAL::Surface_mesh<point>;
using vertex = surface::Vertex_index;
using face = surface::Face_index;
using parents = surface::Property_map<face, std::int32_t>;
using triple = std::array<std::uint32_t, 3>;
using place = std::array<double, 3>;

/// A surface as it comes in.
struct soup {
  std::vector<place> points;
  std::vector<triple> triangles;
};

struct plane_points {
  corefine_plane plane;
  std::array<std::vector<std::uint32_t>, 2> on;
};

template <class T>
bool read_all(std::vector<T>& values, std::size_t count) {
  values.resize(count);
  return count == 0 || std::fread(values.data(), sizeof(T), count, stdin) == count;
}

template <class T>
bool write_all(const std::vector<T>& values) {
  return values.empty() ||
         std::fwrite(values.data(), sizeof(T), values.size(), stdout) == values.size();
}

bool all_below(const std::vector<std::uint32_t>& values, std::size_t limit) {
  for (const auto value : values)
    if (value >= limit)
      return false;
  return true;
}

bool read_soup(soup& s, std::uint32_t points, std::uint32_t triangles) {
  if (!read_all(s.points, points) || !read_all(s.triangles, triangles))
    return false;
  for (const auto& p : s.points)
    for (const double x : p)
      if (!std::isfinite(x))
        return false;
  for (const auto& t : s.triangles)
    for (const auto v : t)
      if (v >= points)
        return false;
  return true;
}

/// Points on planes are moved onto them exactly: on one to its foot, on two to the foot on their
/// line, on three to their common point.
std::vector<point> exact_points(const soup& s, const std::vector<plane_points>& planes, int which) {
  std::vector<point> result;
  for (const auto& p : s.points)
    result.emplace_back(p[0], p[1], p[2]);
  std::map<std::uint32_t, std::vector<kernel::Plane_3>> through;
  for (const auto& row : planes)
    for (const auto v : row.on[which])
      if (v < result.size())
        through[v].emplace_back(row.plane.normal[0], row.plane.normal[1], row.plane.normal[2],
                                -row.plane.offset);
  for (const auto& [v, on] : through) {
    auto& p = result[v];
    if (on.size() == 1) {
      p = on[0].projection(p);
    } else if (on.size() == 2) {
      const auto meet = CGAL::intersection(on[0], on[1]);
      if (const auto* line = meet ? boost::get<kernel::Line_3>(&*meet) : nullptr)
        p = line->projection(p);
    } else {
      const auto meet = CGAL::intersection(on[0], on[1], on[2]);
      if (const auto* corner = meet ? boost::get<point>(&*meet) : nullptr)
        p = *corner;
    }
  }
  return result;
}

/// A mesh of the triangles in which a corner where several fans meet is one vertex a fan; nothing
/// where an edge has not one triangle on each side.
class fan_builder {
public:
  fan_builder(std::span<const triple> triangles, const std::vector<point>& points, surface& mesh)
      : triangles_(triangles), points_(points), mesh_(mesh), corners_(triangles.size()) {}

  /// The first triangle is told as a part of `from`, the others as of the next ones.
  bool build(parents& parent, std::int32_t from, bool second) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (!edges_.try_emplace({triangles_[t][k], triangles_[t][(k + 1) % 3]}, t).second)
          return false;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (!corners_[t][k] && !turn_fan(t, triangles_[t][k]))
          return false;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto f = mesh_.add_face(*corners_[t][0], *corners_[t][1], *corners_[t][2]);
      if (f == surface::null_face())
        return false;
      const auto i = from + static_cast<std::int32_t>(t);
      parent[f] = second ? -1 - i : i;
    }
    return true;
  }

private:
  /// The triangles around corner v of `first`, over shared edges, get one vertex.
  bool turn_fan(std::uint32_t first, std::uint32_t v) {
    const auto fresh = mesh_.add_vertex(points_[v]);
    std::uint32_t t = first;
    do {
      const auto& corners = triangles_[t];
      const int k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
      if (corners[k] != v || corners_[t][k])
        return false;
      corners_[t][k] = fresh;
      const auto next = edges_.find({v, corners[(k + 2) % 3]});
      if (next == edges_.end())
        return false;
      t = next->second;
    } while (t != first);
    return true;
  }

  std::span<const triple> triangles_;
  const std::vector<point>& points_;
  surface& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges_;
  std::vector<std::array<std::optional<vertex>, 3>> corners_;
};

/// A surface, and what each of its triangles is a part of.
struct tracked {
  surface mesh;
  parents parent = mesh.add_property_map<face, std::int32_t>(name, 0).first;

  tracked() = default;
  tracked(const tracked& other)
      : mesh(other.mesh), parent(mesh.property_map<face, std::int32_t>(name).first) {}
  tracked& operator=(const tracked&) = delete;

  static constexpr auto name = "f:parent";
};

/// Hands on what each part of a triangle is a part of.
struct parent_keeper : pmp::Corefinement::Default_visitor<surface> {
  std::array<tracked*, 3> of;
  std::int32_t split = 0;

  parents& at(const surface& mesh) {
    return &mesh == &of[0]->mesh   ? of[0]->parent
           : &mesh == &of[1]->mesh ? of[1]->parent
                                   : of[2]->parent;
  }
  void before_subface_creations(face f, const surface& mesh) { split = at(mesh)[f]; }
  void after_subface_created(face f, const surface& mesh) { at(mesh)[f] = split; }
  void after_face_copy(face from, const surface& source, face to, const surface& target) {
    at(target)[to] = at(source)[from];
  }
};

/// What is left of both, which get each other's edges.
bool operate(std::uint32_t mode, tracked& one, tracked& other, tracked& out) {
  parent_keeper keeper;
  keeper.of = {&one, &other, &out};
  const auto told = CGAL::parameters::visitor(keeper);
  return mode == 0   ? pmp::corefine_and_compute_difference(one.mesh, other.mesh, out.mesh, told)
         : mode == 1 ? pmp::corefine_and_compute_union(one.mesh, other.mesh, out.mesh, told)
                     : pmp::corefine_and_compute_intersection(one.mesh, other.mesh, out.mesh, told);
}

/// Both get each other's edges.
void imprint(tracked& one, tracked& other) {
  parent_keeper keeper;
  keeper.of = {&one, &other, &other};
  pmp::corefine(one.mesh, other.mesh, CGAL::parameters::visitor(keeper));
}

place rounded(const point& p) {
  CGAL::exact(p);
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

struct result {
  corefine_answer answer;
  std::vector<place> points;
  std::vector<std::int32_t> origin;
  std::vector<triple> triangles;
  std::vector<std::int32_t> parent;
  std::vector<std::uint32_t> share;
};

/// Rounds the result; points of the first surface get their old coordinates back, points that
/// round to the same place become one.
class collector {
public:
  collector(const soup& first, const std::vector<point>& exact_first, result& out)
      : first_(first), out_(out) {
    for (std::size_t i = 0; i < exact_first.size(); ++i)
      known_[rounded(exact_first[i])] = static_cast<std::int32_t>(i);
  }

  void add(const tracked& part, std::uint32_t share) {
    const auto& mesh = part.mesh;
    std::vector<std::uint32_t> of_vertex(mesh.num_vertices() + mesh.number_of_removed_vertices());
    for (const auto v : mesh.vertices())
      of_vertex[v] = index_of(rounded(mesh.point(v)));
    for (const auto f : mesh.faces()) {
      triple t{};
      int k = 0;
      for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        t[k++] = of_vertex[v];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        continue;
      out_.triangles.push_back(t);
      out_.parent.push_back(part.parent[f]);
      out_.share.push_back(share);
    }
  }

private:
  std::uint32_t index_of(place p) {
    const auto old = known_.find(p);
    if (old != known_.end())
      p = first_.points[old->second];
    const auto [row, fresh] = index_.try_emplace(p, static_cast<std::uint32_t>(out_.points.size()));
    if (fresh) {
      out_.points.push_back(p);
      out_.origin.push_back(old == known_.end() ? -1 : old->second);
    }
    return row->second;
  }

  const soup& first_;
  result& out_;
  std::map<place, std::int32_t> known_;
  std::map<place, std::uint32_t> index_;
};

/// Do triangles pass through each other? Such a surface bounds nothing, and CGAL may never come
/// back from it. Triangles that have a corner's place in common only touch there: outlines may. In
/// numbers as they came in, which is several times as quick as in rational ones.
bool meets_itself(const soup& s) {
  using quick_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using quick_surface = CGAL::Surface_mesh<quick_kernel::Point_3>;
  quick_surface mesh;
  std::vector<quick_surface::Vertex_index> corners;
  for (const auto& p : s.points)
    corners.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  std::map<quick_surface::Face_index, std::size_t> triangle;
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto& t = s.triangles[i];
    const auto f = mesh.add_face(corners[t[0]], corners[t[1]], corners[t[2]]);
    if (f == quick_surface::null_face())
      return false;  // Two fans at a corner: what follows looks at it.
    triangle[f] = i;
  }
  std::vector<std::pair<quick_surface::Face_index, quick_surface::Face_index>> pairs;
  pmp::self_intersections(mesh, std::back_inserter(pairs));
  const auto places = [&](quick_surface::Face_index f) {
    const auto& t = s.triangles[triangle[f]];
    return std::array{s.points[t[0]], s.points[t[1]], s.points[t[2]]};
  };
  return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    const auto one = places(pair.first);
    const auto two = places(pair.second);
    return std::find_first_of(one.begin(), one.end(), two.begin(), two.end()) == one.end();
  });
}

class combination {
public:
  combination(std::uint32_t mode, const std::array<soup, 2>& in,
              const std::vector<corefine_share>& shares, const std::vector<plane_points>& planes)
      : mode_(mode),
        in_(in),
        shares_(shares),
        exact_{exact_points(in[0], planes, 0), exact_points(in[1], planes, 1)},
        collector_(in[0], exact_[0], out_) {}

  result made() {
    out_.answer.status = run();
    return std::move(out_);
  }

private:
  corefine_status run() {
    std::vector<tracked> first(shares_.size());
    std::uint32_t from = 0;
    for (std::size_t i = 0; i < shares_.size(); from += shares_[i++].triangles) {
      const auto own = std::span(in_[0].triangles).subspan(from, shares_[i].triangles);
      if (!fan_builder(own, exact_[0], first[i].mesh)
             .build(first[i].parent, static_cast<std::int32_t>(from), false))
        return corefine_status::first_not_manifold;
    }
    tracked tool;
    if (!fan_builder(in_[1].triangles, exact_[1], tool.mesh).build(tool.parent, 0, true))
      return corefine_status::second_not_manifold;
    if (meets_itself(in_[1]))
      return corefine_status::second_meets_itself;
    if (mode_ == 1 && first.size() > 1)
      return add_to_one(first, tool);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      tracked own_tool(tool);
      tracked result;
      const double before = volume_of(first[i]);
      if (shares_[i].stays != 0) {
        imprint(first[i], own_tool);
        take(first[i], i, before);
        continue;
      }
      if (!operate(mode_, first[i], own_tool, result))
        return corefine_status::result_not_manifold;
      take(result, i, before);
    }
    return corefine_status::done;
  }

  /// One share gets what of the tool is outside of the others.
  corefine_status add_to_one(std::vector<tracked>& first, const tracked& tool) {
    std::optional<std::uint32_t> home;
    double most = -1;
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      if (shares_[i].stays != 0)
        continue;
      tracked own(first[i]);
      tracked own_tool(tool);
      tracked both;
      if (!operate(1, own, own_tool, both))
        return corefine_status::result_not_manifold;
      const double covered = area_of_first(first[i]) - area_of_first(both);
      if (covered > most * (1 + 1e-9)) {
        home = i;
        most = covered;
      }
    }
    if (!home)
      return corefine_status::failed;
    auto rest = std::make_unique<tracked>(tool);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      if (i == *home)
        continue;
      auto less = std::make_unique<tracked>();
      const double before = volume_of(first[i]);
      if (!operate(0, *rest, first[i], *less))
        return corefine_status::result_not_manifold;
      rest = std::move(less);
      take(first[i], i, before);
    }
    tracked result;
    const double before = volume_of(first[*home]);
    if (!operate(1, first[*home], *rest, result))
      return corefine_status::result_not_manifold;
    take(result, *home, before);
    return corefine_status::done;
  }

  static double volume_of(const tracked& t) { return CGAL::to_double(pmp::volume(t.mesh)); }

  /// Of what is a part of the first surface.
  static double area_of_first(const tracked& t) {
    double sum = 0;
    for (const auto f : t.mesh.faces())
      if (t.parent[f] >= 0)
        sum += std::sqrt(CGAL::to_double(pmp::squared_face_area(f, t.mesh)));
    return sum;
  }

  void take(const tracked& part, std::uint32_t share, double before) {
    out_.answer.volume_before += before;
    out_.answer.volume_after += volume_of(part);
    collector_.add(part, share);
  }

  std::uint32_t mode_;
  const std::array<soup, 2>& in_;
  const std::vector<corefine_share>& shares_;
  std::array<std::vector<point>, 2> exact_;
  result out_;
  collector collector_;
};

bool read_planes(std::vector<plane_points>& planes, const std::array<soup, 2>& in) {
  for (auto& row : planes) {
    if (std::fread(&row.plane, sizeof(row.plane), 1, stdin) != 1)
      return false;
    for (int i = 0; i < 2; ++i)
      if (row.plane.points[i] > in[i].points.size() || !read_all(row.on[i], row.plane.points[i]) ||
          !all_below(row.on[i], in[i].points.size()))
        return false;
  }
  return true;
}

}  // namespace

int tedit::ops::combine_surfaces(std::uint32_t magic) {
  corefine_header header;
  constexpr std::uint32_t most = 10'000'000;
  if (!read_rest(header, magic) || header.mode > 2 || header.planes > 10'000 ||
      header.shares == 0 || header.shares > 1000 || !end_after(header.most_ms))
    return 2;
  std::array<soup, 2> in;
  for (int i = 0; i < 2; ++i)
    if (header.points[i] > most || header.triangles[i] > most ||
        !read_soup(in[i], header.points[i], header.triangles[i]))
      return 2;
  std::vector<corefine_share> shares;
  const auto with = [](std::uint64_t sum, const corefine_share& s) { return sum + s.triangles; };
  if (!read_all(shares, header.shares) ||
      std::accumulate(shares.begin(), shares.end(), std::uint64_t{0}, with) != header.triangles[0])
    return 2;
  std::vector<plane_points> planes(header.planes);
  if (!read_planes(planes, in))
    return 2;
  auto out = combination(header.mode, in, shares, planes).made();
  out.answer.points = static_cast<std::uint32_t>(out.points.size());
  out.answer.triangles = static_cast<std::uint32_t>(out.triangles.size());
  const bool ok = std::fwrite(&out.answer, sizeof(out.answer), 1, stdout) == 1 &&
                  write_all(out.points) && write_all(out.origin) && write_all(out.triangles) &&
                  write_all(out.parent) && write_all(out.share) && std::fflush(stdout) == 0;
  return ok ? 0 : 4;
}
