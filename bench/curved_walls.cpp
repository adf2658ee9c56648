// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_curved MESH UNIT WALLS SEED [OPERATION ...]: edits at WALLS random walls of a mesh, each
// alone on the original mesh, and how far the new vertices of round walls are off the exact shape:
// of the part's own walls the cylinder, cone or sphere fitted to their corners, of a tool's the
// one that was asked for. A line an edit: part | operation | wall | outcome | new vertices of round
// walls, of those off by more than 1e-9 of the part | worst, mm, part and tool | worst q before,
// after | ms; then the message of a refusal, and a summary line an operation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "edit/make_edit.hpp"
#include "mesh/adapt/wall_places.hpp"
#include "mesh/checks.hpp"
#include "mesh/io/import.hpp"
#include "ops/tools/tools.hpp"

namespace tedit {
namespace {

/// What an edit asks for: the exact outline of its tool, if it has one, is all points at `radius`
/// from the line between two points of the frame's plane.
struct asked {
  edit_request request;
  std::optional<ops::frame> place;
  double half_length = 0;  ///< m: of that line; 0 for a circle.
  double radius = 0;       ///< m.

  [[nodiscard]] double off(vec3 p) const {
    const vec3 d = p - place->origin;
    const double x = dot(d, place->x);
    const double beyond = std::max(0.0, std::abs(x) - half_length);
    return std::abs(std::hypot(beyond, dot(d, place->y)) - radius);
  }
};

struct finding {
  int fresh = 0;
  int off = 0;
  double part = 0;  ///< m.
  double tool = 0;  ///< m.
};

std::string text_of(vec3 v) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.17g, %.17g, %.17g", v.x, v.y, v.z);
  return text;
}

class curved_run {
public:
  curved_run(std::string part, version_ptr mesh, std::uint64_t seed)
      : part_(std::move(part)),
        mesh_(std::move(mesh)),
        seed_(seed),
        walls_(*mesh_),
        plugins_(ops::load_default_catalogue()) {
    const auto extent = ops::extent_of(*mesh_);
    const vec3 d = extent.high - extent.low;
    size_ = norm(d);
    least_ = std::min({d.x, d.y, d.z});
    for (vertex_id v = 0; v < mesh_->vertex_slots(); ++v)
      if (mesh_->is_live_vertex(v))
        known_.insert(key(mesh_->position(v)));
    faults_before_ = check_version(*mesh_).total;
  }

  void run(const std::string& operation, const std::vector<surface_id>& walls) {
    int done = 0;
    int poor = 0;
    finding sum;
    std::vector<double> ms;
    for (const auto wall : walls)
      one(operation, wall, done, poor, sum, ms);
    std::ranges::sort(ms);
    std::printf(
      "SUM | %s | %s | done %d of %zu | new %d, off %d | worst mm part %.3g tool %.3g | "
      "below min(.1, before) %d | ms median %.0f\n",
      part_.c_str(), operation.c_str(), done, walls.size(), sum.fresh, sum.off, 1e3 * sum.part,
      1e3 * sum.tool, poor, ms.empty() ? 0 : ms[ms.size() / 2]);
    std::fflush(stdout);
  }

private:
  using place_key = std::tuple<double, double, double>;
  static place_key key(vec3 p) { return {p.x, p.y, p.z}; }

  asked make(const std::string& operation, surface_id wall) const {
    std::mt19937_64 random(seed_ * 7919 + static_cast<std::uint64_t>(wall));
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<>(low, high)(random);
    };
    asked result{{operation, {wall}, {}}, {}};
    auto& values = result.request.parameters;
    if (operation == "erode" || operation == "thicken") {
      values["depth"] = uniform(0.01, 0.05) * least_;
      return result;
    }
    const auto facets = facets_of(*mesh_, std::array{wall});
    const auto& facet = mesh_->facet(facets[random() % facets.size()]);
    const vec3 a = mesh_->position(facet.v[0]);
    const vec3 b = mesh_->position(facet.v[1]);
    const vec3 at = (a + b + mesh_->position(facet.v[2])) / 3;
    const vec3 along = normalized(b - a);
    result.place = ops::make_frame(at, normalized(area_vector(*mesh_, facet)));
    const double width = uniform(0.04, 0.12) * least_;
    result.radius = width / 2;
    values["at"] = text_of(at);
    values["direction"] = text_of(result.place->z);
    if (operation == "drill") {
      values["diameter"] = width;
      values["depth"] = uniform(1, 3) * width;
      return result;
    }
    values["profile"] = std::string(operation == "boss" ? "circle" : "slot");
    values["size"] = operation == "boss" ? width : 2 * width;
    values["width"] = width;
    values["height"] = uniform(1, 2) * width;
    values["along"] = text_of(along);
    if (operation == "pocket") {
      const vec3 z = result.place->z;
      result.place = ops::frame{at, along, cross(z, along), z};
      result.half_length = width / 2;
    }
    return result;
  }

  /// Walls that went somewhere else as a whole are not where they were by design.
  [[nodiscard]] std::set<surface_id> moved_walls(const mesh_version& after) const {
    std::set<surface_id> stays;
    std::set<surface_id> all;
    for_each_facet(after, [&](const boundary_facet& f) {
      all.insert(f.surface);
      for (const auto v : f.v)
        if (known_.contains(key(after.position(v))))
          stays.insert(f.surface);
    });
    std::set<surface_id> result;
    std::ranges::set_difference(all, stays, std::inserter(result, result.end()));
    return result;
  }

  template <class Visit>
  static void for_each_facet(const mesh_version& mesh, const Visit& visit) {
    for (facet_id f = 0; f < mesh.facet_slots(); ++f)
      if (mesh.is_live_facet(f))
        visit(mesh.facet(f));
  }

  finding measure(const mesh_version& after, const asked& what) {
    const auto& request = what.request;
    const auto moved = moved_walls(after);
    std::map<surface_id, bool> is_old;
    for (const auto& row : mesh_->surfaces())
      is_old[row.id] = true;
    std::map<vertex_id, std::pair<double, double>> worst;
    for_each_facet(after, [&](const boundary_facet& f) {
      const bool old = is_old.contains(f.surface);
      const bool selected = !what.place && f.surface == request.surfaces.front();
      if (selected || (old && moved.contains(f.surface)))
        return;
      if (old ? !walls_.is_round(f.surface) : !is_wall(after, f, what))
        return;
      for (const auto v : f.v) {
        const vec3 p = after.position(v);
        if (known_.contains(key(p)))
          continue;
        auto& at = worst[v];
        (old ? at.first : at.second) =
          std::max(old ? at.first : at.second, old ? walls_.off(f.surface, p) : what.off(p));
      }
    });
    finding result;
    for (const auto& [v, off] : worst) {
      ++result.fresh;
      result.off += std::max(off.first, off.second) > 1e-9 * size_;
      result.part = std::max(result.part, off.first);
      result.tool = std::max(result.tool, off.second);
    }
    return result;
  }

  /// Is the facet one of the tool's sides, along its axis?
  [[nodiscard]] static bool is_wall(const mesh_version& after, const boundary_facet& f,
                                    const asked& what) {
    return what.place && std::abs(dot(normalized(area_vector(after, f)), what.place->z)) < 0.1;
  }

  void one(const std::string& operation, surface_id wall, int& done, int& poor, finding& sum,
           std::vector<double>& ms) {
    const auto what = make(operation, wall);
    operation_place place;
    place.find_most = false;
    const auto start = std::chrono::steady_clock::now();
    const auto made = make_edit(plugins_, mesh_, what.request, {}, place, {});
    ms.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    std::printf("%s | %s | %ld | ", part_.c_str(), operation.c_str(), static_cast<long>(wall));
    if (!made) {
      std::printf("%s | | | | %.0f | %s\n", std::string(code_name(made.error().code)).c_str(),
                  ms.back(), made.error().message.c_str());
      return;
    }
    ++done;
    const auto ratios = made->report.ratios.value_or(touched_ratios{1, 1, 1});
    poor += ratios.min_after < std::min(0.1, ratios.min_before) * (1 - 1e-9);
    const auto found = measure(*made->version, what);
    const bool broken = check_version(*made->version).total > faults_before_;
    std::printf("%s | %d %d | %.3g %.3g | %.3g %.3g | %.0f |", broken ? "BROKEN" : "ok",
                found.fresh, found.off, 1e3 * found.part, 1e3 * found.tool, ratios.min_before,
                ratios.min_after, ms.back());
    for (const auto& notice : made->report.notices)
      std::printf(" %s;", notice.c_str());
    std::printf("\n");
    std::fflush(stdout);
    sum.fresh += found.fresh;
    sum.off += found.off;
    sum.part = std::max(sum.part, found.part);
    sum.tool = std::max(sum.tool, found.tool);
  }

  std::string part_;
  version_ptr mesh_;
  std::uint64_t seed_;
  wall_places walls_;
  ops::catalogue plugins_;
  std::set<place_key> known_;
  double size_ = 0;
  double least_ = 0;
  std::size_t faults_before_ = 0;
};

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) {
  using namespace tedit;
  if (argc < 5) {
    std::fprintf(stderr, "usage: bench_curved MESH UNIT WALLS SEED [OPERATION ...]\n");
    return 2;
  }
  const auto imported = import_mesh(std::filesystem::path(argv[1]), argv[2]);
  if (!imported) {
    std::fprintf(stderr, "%s\n", render(imported.error()).c_str());
    return 65;
  }
  const auto& mesh = imported->version;
  const std::uint64_t seed = std::stoull(argv[4]);
  std::vector<surface_id> walls;
  for (const auto& row : mesh->surfaces())
    if (!facets_of(*mesh, std::array{row.id}).empty())
      walls.push_back(row.id);
  std::mt19937_64 random(seed);
  std::ranges::shuffle(walls, random);
  walls.resize(std::min(walls.size(), static_cast<std::size_t>(std::stoul(argv[3]))));
  std::vector<std::string> operations(argv + 5, argv + argc);
  if (operations.empty())
    operations = {"drill", "pocket", "boss", "erode", "thicken"};
  curved_run bench(std::filesystem::path(argv[1]).stem().string(), mesh, seed);
  for (const auto& operation : operations)
    bench.run(operation, walls);
  return 0;
}
