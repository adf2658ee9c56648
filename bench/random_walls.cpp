// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_walls MESH UNIT WALLS SEED [SHARE [OPERATION ...]]: WALLS random walls of a mesh, each
// alone on the original mesh; erode and thicken by SHARE (0.02) of the part's least size. A line an
// edit: part | operation | wall | shape | outcome or error | worst q before, after | rays that
// measure the asked thickness within 1 % of it, of all | worst of those as a share of the depth |
// ms; then the message of a refusal, and a summary line an operation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "edit/make_edit.hpp"
#include "mesh/checks.hpp"
#include "mesh/features/wall_shape.hpp"
#include "mesh/io/import.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit {
namespace {

struct thickness_check {
  int right = 0;
  int rays = 0;
  double worst = 0;  ///< Share of the depth.

  void add(double off, double thickness, double depth) {
    ++rays;
    right += off <= 0.01 * thickness;
    worst = std::max(worst, off / depth);
  }
};

/// Where a ray through the wall as it was begins, m, and the outward direction.
struct probe {
  vec3 at;
  vec3 normal;
};

/// Flat walls: any point. Round ones: their vertices, where facets are on the shape that they stand
/// for, a little beside so that the ray hits a facet, along the shape's normal. Free-form ones:
/// vertices off the border alone, along the mean of their facets' normals.
std::vector<probe> random_probes(const mesh_version& mesh, surface_id wall,
                                 const std::vector<facet_id>& facets,
                                 const std::optional<wall_shape>& shape, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<probe> probes;
  for (int i = 0; i < 40; ++i) {
    const auto& v = mesh.facet(facets[random() % facets.size()]).v;
    const std::array p{mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    if (shape && shape->type == wall_shape::kind::plane) {
      const double a = unit(random);
      const double b = unit(random) * (1 - a);
      probes.push_back({p[0] + a * (p[1] - p[0]) + b * (p[2] - p[0]), shape->axis});
      continue;
    }
    const auto corner = random() % 3;
    const auto star = tets_around(mesh, std::array{v[corner]});
    bool inside = true;  // No facet of another wall is there.
    vec3 normal;
    for (const auto t : star)
      for (const auto n : mesh.neighbours(t)) {
        if (!is_facet(n) || !std::ranges::count(mesh.facet(n & ~facet_flag).v, v[corner]))
          continue;
        const auto& facet = mesh.facet(n & ~facet_flag);
        inside = inside && facet.surface == wall;
        normal += normalized(area_vector(mesh, facet));
      }
    const vec3 at = p[corner] + 1e-3 * ((p[0] + p[1] + p[2]) / 3 - p[corner]);
    if (inside || shape)
      probes.push_back({at, shape ? shape->normal(at) : normalized(normal)});
  }
  return probes;
}

/// How thick the part is along a ray that comes in against `normal`, where the material that begins
/// nearest to `entry` does; -1 without any.
double thickness(const mesh_version& mesh, const probe& at, double from, double entry) {
  const auto hits = ops::ray_hits(mesh, at.at + from * at.normal, -1 * at.normal);
  double nearest = 1e300;
  double result = -1;
  for (std::size_t h = 0; h + 1 < hits.size(); ++h)
    if (!hits[h].leaves && hits[h + 1].leaves && std::abs(hits[h].distance - entry) < nearest) {
      nearest = std::abs(hits[h].distance - entry);
      result = hits[h + 1].distance - hits[h].distance;
    }
  return result;
}

/// What material has come or gone at points of the wall as it was.
thickness_check measure(const mesh_version& before, const mesh_version& after, surface_id wall,
                        double outward, std::mt19937_64& random) {
  thickness_check sum;
  const auto facets = facets_of(before, std::array{wall});
  const auto shape = fit_wall(before, facets, {3e-3, true, true});
  const double depth = std::abs(outward);
  for (const auto& at : random_probes(before, wall, facets, shape, random)) {
    const double was = thickness(before, at, 3 * depth, 3 * depth);
    const double is = thickness(after, at, 3 * depth, 3 * depth - outward);
    if (was > 0)
      sum.add(is < 0 ? depth : std::abs(is - was - outward), was, depth);
  }
  return sum;
}

struct tally {
  int tried = 0;
  int done = 0;
  int below = 0;     ///< Worst q after < min(.1, before).
  int measured = 0;  ///< All but free-form walls without a vertex off the border.
  int right = 0;     ///< All rays but one in ten within 1 % of the thickness.
  std::vector<double> ms;
};

std::string shape_name(const mesh_version& mesh, surface_id wall) {
  const auto shape = fit_wall(mesh, facets_of(mesh, std::array{wall}), {3e-3, true, true});
  if (!shape)
    return "free";
  constexpr const char* names[] = {"plane", "cylinder", "cone"};
  return names[static_cast<int>(shape->type)];
}

class walls_run {
public:
  walls_run(std::string part, version_ptr mesh, double depth, std::uint64_t seed)
      : part_(std::move(part)),
        mesh_(std::move(mesh)),
        depth_(depth),
        random_(seed),
        plugins_(ops::load_default_catalogue()) {
    faults_before_ = check_version(*mesh_).total;
  }

  void run(const std::string& operation, const std::vector<surface_id>& walls) {
    tally sum;
    for (const auto wall : walls)
      one(operation, wall, sum);
    std::ranges::sort(sum.ms);
    std::printf(
      "SUM | %s | %s | done %d of %d | below min(.1, before) %d | thickness right %d of %d | ms "
      "median %.0f max %.0f\n",
      part_.c_str(), operation.c_str(), sum.done, sum.tried, sum.below, sum.right, sum.measured,
      sum.ms.empty() ? 0 : sum.ms[sum.ms.size() / 2], sum.ms.empty() ? 0 : sum.ms.back());
    std::fflush(stdout);
  }

private:
  void one(const std::string& operation, surface_id wall, tally& sum) {
    edit_request request{operation, {wall}, {}};
    request.parameters["depth"] = depth_;
    ++sum.tried;
    operation_place place;
    place.find_most = false;
    const auto start = std::chrono::steady_clock::now();
    const auto made = make_edit(plugins_, mesh_, request, {}, place, {});
    const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s | %s | %ld | %s | ", part_.c_str(), operation.c_str(), wall,
                shape_name(*mesh_, wall).c_str());
    if (!made) {
      std::printf("%s | | | | %.0f | %s\n", std::string(code_name(made.error().code)).c_str(), ms,
                  made.error().message.c_str());
      return;
    }
    ++sum.done;
    sum.ms.push_back(ms);
    const auto ratios = made->report.ratios.value_or(touched_ratios{1, 1, 1});
    sum.below += ratios.min_after < std::min(0.1, ratios.min_before) * (1 - 1e-9);
    const bool broken = check_version(*made->version).total > faults_before_;
    const auto rays =
      measure(*mesh_, *made->version, wall, operation == "erode" ? -depth_ : depth_, random_);
    sum.measured += rays.rays > 0;
    sum.right += rays.rays > 0 && 10 * (rays.rays - rays.right) <= rays.rays;
    std::printf("%s | %.3g %.3g | %d/%d | %.3g | %.0f |", broken ? "BROKEN" : "ok",
                ratios.min_before, ratios.min_after, rays.right, rays.rays, rays.worst, ms);
    for (const auto& notice : made->report.notices)
      std::printf(" %s;", notice.c_str());
    std::printf("\n");
    std::fflush(stdout);
  }

  std::string part_;
  version_ptr mesh_;
  double depth_;
  std::mt19937_64 random_;
  ops::catalogue plugins_;
  std::size_t faults_before_ = 0;
};

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) try {
  using namespace tedit;
  if (argc < 5) {
    std::fprintf(stderr, "usage: bench_walls MESH UNIT WALLS SEED [SHARE [OPERATION ...]]\n");
    return 2;
  }
  const auto imported = import_mesh(std::filesystem::path(argv[1]), argv[2]);
  if (!imported) {
    std::fprintf(stderr, "%s\n", render(imported.error()).c_str());
    return 65;
  }
  const auto& mesh = imported->version;
  const std::uint64_t seed = std::stoull(argv[4]);
  const double share = argc > 5 ? std::stod(argv[5]) : 0.02;
  const auto size = ops::extent_of(*mesh);
  const vec3 d = size.high - size.low;
  std::vector<surface_id> walls;
  for (const auto& row : mesh->surfaces())
    if (!facets_of(*mesh, std::array{row.id}).empty())
      walls.push_back(row.id);
  std::mt19937_64 random(seed);
  std::ranges::shuffle(walls, random);
  walls.resize(std::min(walls.size(), static_cast<std::size_t>(std::stoul(argv[3]))));
  const auto part = std::filesystem::path(argv[1]).stem().string();
  const double depth = share * std::min({d.x, d.y, d.z});
  std::printf("%s: depth %.4g mm\n", part.c_str(), 1e3 * depth);
  std::vector<std::string> operations(argv + std::min(argc, 6), argv + argc);
  if (operations.empty())
    operations = {"erode", "thicken"};
  for (const auto& operation : operations)
    walls_run(part, mesh, depth, seed).run(operation, walls);
  return 0;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
