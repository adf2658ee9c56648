// SPDX-License-Identifier: AGPL-3.0-or-later
// How near new vertices on walls of free form are to the CAD model, where the mesh does not come of
// it.
// usage: bench_free_form CAD_FILE SIZE MESH COUNT
// MESH: what `tedit import CAD_FILE --size SIZE -o MESH` wrote. COUNT blind holes at random places
// of each spline of the CAD file, as deep as they are wide, are drilled in it, each alone; how far
// the wall's vertices that are new are off the spline of the CAD file. A line a hole: surface |
// diameter, mm | new vertices | off it, um: half of them, the furthest | ms; and a summary.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>

#include "base/stopwatch.hpp"
#include "cad/import.hpp"
#include "edit/make_edit.hpp"
#include "mesh/features/known_wall.hpp"
#include "mesh/io/import.hpp"

namespace tedit::ops {
namespace {

/// Walls of fewer facets say nothing.
constexpr std::size_t least_facets = 12;

std::string text_of(vec3 p) {
  char text[100];
  std::snprintf(text, sizeof(text), "%.12g,%.12g,%.12g", p.x, p.y, p.z);
  return text;
}

/// A hole at the middle of a facet, half to twice as wide as that.
edit_request hole_at(const mesh_version& mesh, facet_id f, double share) {
  const auto& facet = mesh.facet(f);
  const std::array p{mesh.position(facet.v[0]), mesh.position(facet.v[1]),
                     mesh.position(facet.v[2])};
  const double diameter = share * norm(p[1] - p[0]);
  return {"drill",
          {facet.surface},
          {{"at", text_of((p[0] + p[1] + p[2]) / 3)},
           {"direction", text_of(-normalized(cross(p[1] - p[0], p[2] - p[0])))},
           {"diameter", diameter},
           {"depth", diameter}},
          {}};
}

/// um, ascending: of the surface's vertices that are new.
std::vector<double> offs(const mesh_version& before, const mesh_version& after, surface_id id,
                         const exact_wall& wall) {
  std::set<vertex_id> fresh;
  for (const auto f : facets_of(after, std::array{id}))
    for (const auto v : after.facet(f).v)
      if (v >= before.vertex_slots() || !before.is_live_vertex(v) ||
          !(before.position(v) == after.position(v)))
        fresh.insert(v);
  std::vector<double> result;
  for (const auto v : fresh)
    result.push_back(1e6 * std::abs(wall.distance(after.position(v))));
  std::ranges::sort(result);
  return result;
}

double at(std::vector<double>& of, double share) {
  std::ranges::sort(of);
  return of.empty() ? 0 : of[static_cast<std::size_t>(share * static_cast<double>(of.size() - 1))];
}

class holes {
public:
  explicit holes(version_ptr mesh) : mesh_(std::move(mesh)) {}

  void drill(surface_id id, const exact_wall& wall) {
    const auto facets = facets_of(*mesh_, std::array{id});
    const double share = std::uniform_real_distribution<>(0.5, 2)(random_);
    const auto wanted = hole_at(*mesh_, facets[random_() % facets.size()], share);
    const stopwatch time;
    const auto made = make_edit(plugins_, mesh_, wanted, {}, {}, {});
    ms_.push_back(time.milliseconds());
    if (!made) {
      ++refused_;
      std::printf("%d|%s\n", static_cast<int>(id), made.error().message.c_str());
      return;
    }
    auto off = offs(*mesh_, *made->version, id, wall);
    halves_.push_back(at(off, 0.5));
    furthest_.push_back(at(off, 1));
    std::printf("%d|%.2f|%zu|%.2f %.2f|%.0f\n", static_cast<int>(id),
                1e3 * std::get<double>(wanted.parameters.at("diameter")), off.size(),
                halves_.back(), furthest_.back(), ms_.back());
  }

  void sum_up() {
    double all = 0;
    for (const auto ms : ms_)
      all += ms;
    std::printf(
      "= %zu holes, %d refused; off the CAD model, um: half of the vertices %.2f, the "
      "furthest %.2f (medians), 90 %%: %.2f, %.2f; ms %.0f in the mean\n",
      ms_.size(), refused_, at(halves_, 0.5), at(furthest_, 0.5), at(halves_, 0.9),
      at(furthest_, 0.9), all / static_cast<double>(std::max<std::size_t>(1, ms_.size())));
  }

private:
  version_ptr mesh_;
  catalogue plugins_ = load_default_catalogue();
  std::mt19937_64 random_{7};
  std::vector<double> ms_;
  std::vector<double> halves_;
  std::vector<double> furthest_;
  int refused_ = 0;
};

int run(int argc, char** argv) {
  if (argc != 5)
    return 2;
  const auto part = cad::import_part({argv[1], argv[2], {}, {}}, {});
  const auto read = import_mesh(argv[3], "mm");
  if (!part || !read) {
    std::fprintf(stderr, "%s\n", render(part ? read.error() : part.error()).c_str());
    return 1;
  }
  holes all(read->version);
  const auto& model = *part->version;
  for (const auto& row : model.surfaces()) {
    const auto facets = facets_of(model, std::array{row.id});
    const auto wall = known_wall(model, facets, corners_of(model, facets));
    if (wall && wall->free_form && facets.size() >= least_facets)
      for (int i = 0; i < std::atoi(argv[4]); ++i)
        all.drill(row.id, *wall);
  }
  all.sum_up();
  return 0;
}

}  // namespace
}  // namespace tedit::ops

int main(int argc, char** argv) {
  return tedit::ops::run(argc, argv);
}
