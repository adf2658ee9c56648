// SPDX-License-Identifier: AGPL-3.0-or-later
// Random tools on real parts: what services::boolean makes of them.
// usage: bench_boolean MESH UNIT PER_KIND SEED [KIND ...]
// A line an edit: part | kind | index | outcome or error | deviation / size | worst q before, after
// | tets touched | new vertices at round walls, those off them by more than 1e-6 of the part's size
// | ms; and a summary a kind.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "mesh/checks.hpp"
#include "mesh/features/exact_wall.hpp"
#include "mesh/io/import.hpp"
#include "mesh/quality.hpp"
#include "ops/services/host_services.hpp"
#include "ops/tools/tools.hpp"

namespace tedit::ops {
namespace {

struct placement {
  tool_surface tool;
  boolean_mode mode = boolean_mode::cut;
};

class placer {
public:
  placer(const version_ptr& mesh, services& host, std::uint64_t seed)
      : mesh_(mesh), host_(host), random_(seed), extent_(extent_of(*mesh)) {
    for (facet_id f = 0; f < mesh->facet_slots(); ++f)
      if (mesh->is_live_facet(f))
        facets_.push_back(f);
  }

  expected<placement> make(const std::string& kind) {
    pick();
    const double through = thickness();
    const double r = radius_;
    const int n = segments_of(2 * r, size_);
    const double s = std::min(size_, 2 * std::numbers::pi * r / n);
    const frame up = make_frame(point_, normal_, random_direction());
    if (kind == "drill") {
      const double tilt = uniform(0, 0.6);
      const frame f = make_frame(point_, normal_ + std::tan(tilt) * up.x);
      const double more = r * std::tan(tilt) + 1.1 * size_;
      return placement{revolve(f, rod(r, more, -through / std::cos(tilt) - more), n, s)};
    }
    if (kind == "blind")
      return placement{
        revolve(up, rod(r, size_, -std::min(uniform(0.3, 0.7) * through, 6 * r)), n, s)};
    if (kind == "boss")
      return extruded(up, circle(2 * r, n), -std::min(0.4 * size_, 0.4 * through),
                      uniform(1, 3) * r, s, boolean_mode::add);
    if (kind == "boss_flush")
      return extruded(up, rectangle(uniform(2, 4) * size_, uniform(1.5, 3) * size_), 0,
                      uniform(1, 3) * size_, 0.8 * size_, boolean_mode::add);
    if (kind == "pocket")
      return extruded(up, rectangle(uniform(2, 4) * size_, uniform(1.5, 3) * size_),
                      -uniform(0.3, 0.6) * through, 0, 0.8 * size_, boolean_mode::cut);
    if (kind == "slot_through")
      return extruded(up, slot(uniform(3, 6) * size_, uniform(1.5, 2.5) * size_, n), -through,
                      size_, 0.8 * size_, boolean_mode::cut);
    if (kind == "plane") {
      const auto v = mesh_->facet(facets_[random_() % facets_.size()]).v[0];
      auto tool = half_space(extent_, mesh_->position(v), random_direction(), size_, "cut", host_);
      if (!tool)
        return fail(tool.error());
      return placement{std::move(*tool)};
    }
    if (kind == "star_raised" || kind == "star_sunk") {
      std::vector<std::array<double, 2>> star;
      const double big = uniform(3, 5) * size_;
      for (int i = 0; i < 10; ++i) {
        const double rr = i % 2 == 0 ? big : 0.5 * big;
        const double a = i * std::numbers::pi / 5;
        star.push_back({rr * std::cos(a), rr * std::sin(a)});
      }
      if (kind == "star_raised")
        return extruded(up, polygon(star), -std::min(0.3 * size_, 0.3 * through), 0.8 * size_,
                        0.8 * size_, boolean_mode::add);
      return extruded(up, polygon(star), -std::min(0.8 * size_, 0.5 * through), 0.5 * size_,
                      0.8 * size_, boolean_mode::cut);
    }
    // At an edge of the part.
    const frame f =
      make_frame(mesh_->position(mesh_->facet(facet_).v[0]), normal_ + 0.4 * random_direction());
    return placement{revolve(f, rod(r, 2 * size_, -uniform(0.3, 1.3) * through - size_), n, s)};
  }

private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }

  vec3 random_direction() {
    for (;;) {
      const vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (norm(v) > 0.1 && norm(v) < 1)
        return normalized(v);
    }
  }

  static std::vector<section_point> rod(double r, double top, double bottom) {
    return {{0, top, ""}, {r, top, "top"}, {r, bottom, "wall"}, {0, bottom, "bottom"}};
  }

  expected<placement> extruded(const frame& f, const profile& p, double from, double to,
                               double size, boolean_mode mode) {
    auto tool = extrude(f, p, from, to, size, "tool", host_);
    if (!tool)
      return fail(tool.error());
    return placement{std::move(*tool), mode};
  }

  void pick() {
    for (int k = 0; k < 500; ++k) {
      facet_ = facets_[random_() % facets_.size()];
      const auto& facet = mesh_->facet(facet_);
      const auto wall = facets_of(*mesh_, std::array{facet.surface});
      const auto shape = fit_wall(*mesh_, wall);
      if (!shape || shape->type != wall_shape::kind::plane)
        continue;
      double area = 0;
      for (const auto f : wall)
        area += norm(area_vector(*mesh_, mesh_->facet(f)));
      const vec3 a = mesh_->position(facet.v[0]);
      const vec3 b = mesh_->position(facet.v[1]);
      const vec3 c = mesh_->position(facet.v[2]);
      size_ = (norm(b - a) + norm(c - b) + norm(a - c)) / 3;
      if (area < 12 * size_ * size_)
        continue;
      const double x = uniform(0.1, 0.8);
      const double y = uniform(0.1, 0.9 - x);
      point_ = a + x * (b - a) + y * (c - a);
      normal_ = normalized(area_vector(*mesh_, facet));
      radius_ = std::min(uniform(1, 3) * size_, 0.35 * std::sqrt(area));
      return;
    }
  }

  double thickness() {
    const auto hits = ray_hits(*mesh_, point_ - 1e-6 * size_ * normal_, -normal_);
    for (const auto& hit : hits)
      if (hit.leaves && hit.distance > 1e-3 * size_)
        return hit.distance;
    return 2 * size_;
  }

  const version_ptr& mesh_;
  services& host_;
  std::mt19937_64 random_;
  box extent_;
  std::vector<facet_id> facets_;
  facet_id facet_ = 0;
  vec3 point_;
  vec3 normal_;
  double size_ = 0;
  double radius_ = 0;
};

/// New vertices at round walls, of the part and of the tool.
struct at_round_walls {
  std::size_t all = 0;
  std::size_t off = 0;  ///< By more than 1e-6 of the part's size.
};

/// What is round by the corners that the part's surfaces, and the tool's faces, had before.
std::map<surface_id, exact_wall> round_walls_of(const mesh_version& mesh, const tool_surface& tool,
                                                const boolean_result& made,
                                                const std::set<surface_id>& wanted) {
  std::map<surface_id, exact_wall> result;
  const auto add = [&](surface_id id, const facet_corners& corners) {
    if (const auto wall = fit_exact(corners); wall && !wall->flat())
      if (wall->sphere_radius > 0 || gaps_around(wall->shape, corners.points)[1] < 0.96)
        result.emplace(id, *wall);
  };
  for (const auto id : wanted)
    if (mesh.find_surface(id))
      add(id, corners_of(mesh, facets_of(mesh, std::array{id})));
  for (std::size_t face = 0; face < made.surfaces.size(); ++face) {
    facet_corners corners;
    for (std::size_t i = 0; i < tool.triangles.size(); ++i)
      if (tool.faces[i] == face) {
        const auto n = static_cast<std::uint32_t>(corners.points.size());
        for (const auto v : tool.triangles[i])
          corners.points.push_back(tool.points[v]);
        corners.triangles.push_back({n, n + 1, n + 2});
      }
    if (made.surfaces[face] && wanted.contains(*made.surfaces[face]))
      add(*made.surfaces[face], corners);
  }
  return result;
}

at_round_walls count_at_walls(const mesh_version& mesh, const tool_surface& tool,
                              const boolean_result& made) {
  const auto& after = *made.candidate;
  std::set<std::pair<vertex_id, surface_id>> fresh;
  std::set<surface_id> wanted;
  for (const auto t : made.touched)
    for (const auto n : after.neighbours(t))
      if (is_facet(n))
        for (const auto v : after.facet(n & ~facet_flag).v)
          if (v >= mesh.vertex_slots() || !mesh.is_live_vertex(v) ||
              !(mesh.position(v) == after.position(v))) {
            wanted.insert(after.facet(n & ~facet_flag).surface);
            fresh.emplace(v, after.facet(n & ~facet_flag).surface);
          }
  const auto walls = round_walls_of(mesh, tool, made, wanted);
  const auto extent = extent_of(mesh);
  at_round_walls result;
  for (const auto& [v, id] : fresh)
    if (const auto wall = walls.find(id); wall != walls.end()) {
      ++result.all;
      result.off +=
        std::abs(wall->second.distance(after.position(v))) > 1e-6 * norm(extent.high - extent.low);
    }
  return result;
}

struct tally {
  int tried = 0;
  int done = 0;
  int good = 0;
  int exact = 0;
  int invalid = 0;
  int on_walls = 0;  ///< Edits of which no new vertex is off a round wall.
  at_round_walls vertices;
  std::vector<double> ms;
  std::map<std::string, int> errors;
};

void one(const version_ptr& mesh, const std::string& part, const std::string& kind, int i,
         std::uint64_t seed, services& host, std::size_t faults, tally& sum) {
  placer place(mesh, host,
               seed * 7919 + static_cast<std::uint64_t>(i) * 131 +
                 std::hash<std::string>()(kind + part) % 100000);
  const auto where = place.make(kind);
  ++sum.tried;
  if (!where) {
    ++sum.errors["tool: " + where.error().message];
    return;
  }
  const double size = local_size(*mesh, where->tool);
  const auto begin = std::chrono::steady_clock::now();
  boolean_request request{where->mode, 0.03 * size};
  const auto made = host.boolean(mesh, where->tool, request, {});
  const double ms =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  sum.ms.push_back(ms);
  if (!made) {
    std::printf("%s|%s|%d|%s|||%.0f\n", part.c_str(), kind.c_str(), i, made.error().message.c_str(),
                ms);
    ++sum.errors[made.error().message.substr(0, 60)];
    return;
  }
  edit_claim claim;
  claim.volume_change = made->volume_change;
  claim.touched = made->touched;
  claim.quality_floor = 0.05;
  claim.bodies_added = 1000;
  const auto report = check_edit(*mesh, *made->candidate, claim);
  const bool whole = i % 10 != 0 || check_version(*made->candidate).total <= faults;
  const bool good = made->worst_after >= std::min(0.1, made->worst_before);
  const auto at_walls = count_at_walls(*mesh, where->tool, *made);
  sum.vertices.all += at_walls.all;
  sum.vertices.off += at_walls.off;
  sum.on_walls += at_walls.off == 0;
  std::printf("%s|%s|%d|%s|%.1e|%.3f %.3f|%zu|%zu %zu|%.0f\n", part.c_str(), kind.c_str(), i,
              report.ok() && whole ? "ok" : to_error(report).message.c_str(),
              made->deviation / size, made->worst_before, made->worst_after, made->touched.size(),
              at_walls.all, at_walls.off, ms);
  ++sum.done;
  sum.good += good;
  sum.exact += made->deviation <= 2e-4 * size;
  sum.invalid += !report.ok() || !whole;
}

int run(int argc, char** argv) {
  if (argc < 5)
    return 2;
  const auto mesh = import_mesh(argv[1], argv[2]);
  if (!mesh) {
    std::fprintf(stderr, "%s\n", mesh.error().message.c_str());
    return 1;
  }
  std::string part = argv[1];
  part = part.substr(part.rfind('/') + 1);
  std::vector<std::string> kinds(argv + 5, argv + argc);
  if (kinds.empty())
    kinds = {"drill", "blind",        "boss",  "boss_flush",  "pocket",
             "edge",  "slot_through", "plane", "star_raised", "star_sunk"};
  const auto host = make_host_services();
  const auto faults = check_version(*mesh->version).total;
  for (const auto& kind : kinds) {
    tally sum;
    for (int i = 0; i < std::atoi(argv[3]); ++i)
      one(mesh->version, part, kind, i, std::strtoull(argv[4], nullptr, 10), *host, faults, sum);
    std::ranges::sort(sum.ms);
    const auto at = [&](double share) {
      return sum.ms.empty() ? 0 : sum.ms[static_cast<std::size_t>(share * (sum.ms.size() - 1))];
    };
    std::printf(
      "= %s %s: done %d of %d, invalid %d, q kept %d, exact %d, on round walls %d (of %zu new "
      "vertices there %zu off), ms %.0f / %.0f\n",
      part.c_str(), kind.c_str(), sum.done, sum.tried, sum.invalid, sum.good, sum.exact,
      sum.on_walls, sum.vertices.all, sum.vertices.off, at(0.5), at(0.9));
    for (const auto& [message, count] : sum.errors)
      std::printf("=   %d x %s\n", count, message.c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace tedit::ops

int main(int argc, char** argv) {
  return tedit::ops::run(argc, argv);
}
