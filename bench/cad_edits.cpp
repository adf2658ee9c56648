// SPDX-License-Identifier: AGPL-3.0-or-later
// bench_cad CAD_FILE MESH UNIT FEATURES.json [SEED [new] [LABEL ...]]: edits of a part on its mesh
// (a file, or "coarse", "medium", "fine": as `tedit import` makes it) and on its CAD model. Each
// listed hole filled; both walls of each listed plate taken down and put on by 1 mm (or a tenth of
// the plate); edges of random walls rounded, all of a wall and one by one, holes drilled into
// random flat walls, bores resized; holes moved, copied and mirrored, text, an SVG ring, a box from
// a file and ribs on random flat walls, the part hollowed and cut in two; then all listed holes one
// after the other. "new" after the seed: only what is in the line before; labels: only these. The
// mesh's surfaces must be the CAD file's faces by their places. A line an edit: operation |
// surfaces | on the mesh | on the CAD model | way | deviation mm | ms of both; then the reason, and
// a summary line an operation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/attachment.hpp"
#include "base/part_sizes.hpp"
#include "cad/import.hpp"
#include "cad/replay.hpp"
#include "edit/make_edit.hpp"
#include "mesh/features/surface_shape.hpp"
#include "mesh/features/wall_shape.hpp"
#include "mesh/io/import.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit {
namespace {

struct state {
  version_ptr mesh;
  cad::cad_model model;
};

struct tally {
  int tried = 0;
  int on_mesh = 0;
  int on_cad = 0;
  std::vector<double> ms;
};

class cad_run {
public:
  cad_run(state base, std::set<std::string> labels)
      : base_(std::move(base)),
        plugins_(ops::load_default_catalogue()),
        labels_(std::move(labels)) {}

  [[nodiscard]] const state& base() const { return base_; }

  /// The state after it, or where the CAD model has it not the one before.
  state edit(const std::string& label, const state& from, const edit_request& wanted) {
    if (!labels_.empty() && !labels_.contains(label))
      return from;
    auto& sum = sums_[label];
    ++sum.tried;
    operation_place place;
    place.find_most = false;
    const auto start = std::chrono::steady_clock::now();
    const auto made = make_edit(plugins_, from.mesh, wanted, {}, place, {});
    const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    std::printf("%s |", label.c_str());
    for (const auto id : wanted.surfaces)
      std::printf(" %ld", id);
    if (!made) {
      std::printf(" | %s\n", std::string(code_name(made.error().code)).c_str());
      return from;
    }
    ++sum.on_mesh;
    const auto found = plugins_.find(wanted.operation);
    const auto replayed = cad::replay_edit(
      {from.model, (*found)->description, from.mesh, made->version, wanted, made->report}, {});
    if (!replayed) {
      std::printf(" | ok | %s\n", replayed.error().message.c_str());
      return from;
    }
    const auto& verdict = replayed->verdict;
    sum.on_cad += verdict.is_same;
    if (replayed->ms > 0)
      sum.ms.push_back(replayed->ms);
    std::printf(" | ok | %s | %s | %.2g | %.0f %.0f | %s\n", verdict.is_same ? "same" : "MESH ONLY",
                verdict.how.c_str(), verdict.deviation_mm, ms, replayed->ms,
                verdict.reason.c_str());
    std::fflush(stdout);
    return verdict.is_same ? state{made->version, replayed->model} : from;
  }

  void print_sums() {
    for (auto& [label, sum] : sums_) {
      std::ranges::sort(sum.ms);
      std::printf(
        "SUM | %s | tried %d, on the mesh %d, on the CAD model %d | ms median %.0f max %.0f\n",
        label.c_str(), sum.tried, sum.on_mesh, sum.on_cad,
        sum.ms.empty() ? 0 : sum.ms[sum.ms.size() / 2], sum.ms.empty() ? 0 : sum.ms.back());
    }
  }

private:
  state base_;
  ops::catalogue plugins_;
  std::set<std::string> labels_;  ///< None: all.
  std::map<std::string, tally> sums_;
};

std::vector<surface_id> ids_of(const nlohmann::json& list) {
  return list.get<std::vector<surface_id>>();
}

void run_plates(cad_run& run, const nlohmann::json& features) {
  std::map<surface_id, double> faces;
  for (const auto& plate : features["plates"]) {
    const double thickness = plate.value("thickness", 1.0);
    for (const char* side : {"a", "b"})
      if (plate.contains(side))
        faces.emplace(plate[side].get<surface_id>(), thickness);
  }
  for (const auto& plane : features["largest_planes"])
    faces.emplace(plane["id"].get<surface_id>(), 4.0);
  for (const auto& [face, thickness] : faces) {
    const double depth = 1e-3 * std::min(1.0, thickness / 4);
    run.edit("erode", run.base(), {"erode", {face}, {{"depth", depth}}, {}});
    run.edit("thicken", run.base(), {"thicken", {face}, {{"depth", depth}}, {}});
  }
}

/// Walls in a random order.
std::vector<surface_id> random_walls(const mesh_version& mesh, std::mt19937_64& random) {
  std::vector<surface_id> walls;
  for (const auto& row : mesh.surfaces())
    walls.push_back(row.id);
  std::ranges::shuffle(walls, random);
  return walls;
}

void run_random(cad_run& run, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& mesh = *run.base().mesh;
  const auto extent = ops::extent_of(mesh);
  const vec3 size = extent.high - extent.low;
  const double least = std::min({size.x, size.y, size.z});
  int drilled = 0;
  int bossed = 0;
  int pins = 0;
  int rounded = 0;
  for (const auto wall : random_walls(mesh, random)) {
    const auto shape = fit_wall(mesh, facets_of(mesh, std::array{wall}), {1e-3, true, false});
    if (shape && shape->type == wall_shape::kind::plane && drilled++ < 10) {
      run.edit("drill", run.base(), {"drill", {wall}, {{"diameter", least / 10}}, {}});
      run.edit("drill blind", run.base(),
               {"drill",
                {wall},
                {{"diameter", least / 10}, {"depth", least / 6}, {"tip_angle", 2.06}},
                {}});
      run.edit("pocket", run.base(),
               {"pocket",
                {wall},
                {{"profile", std::string("slot")}, {"size", least / 12}, {"height", least / 30}},
                {}});
    }
    if (shape && shape->type == wall_shape::kind::plane && bossed++ < 10)
      run.edit("boss", run.base(),
               {"boss", {wall}, {{"size", least / 12}, {"height", least / 20}}, {}});
    if (shape && shape->type == wall_shape::kind::cylinder && pins++ < 10)
      run.edit(
        "resize_bore", run.base(),
        {"resize_bore", {wall}, {{"diameter", (shape->side < 0 ? 2.1 : 1.9) * shape->radius}}, {}});
    if (rounded++ < 10)
      run.edit("open", run.base(), {"open", {wall}, {{"radius", 1e-3}}, {}});
  }
}

/// Ten edges of random walls, outer and inner ones, that bend by more than 60 degrees: those of a
/// coarse fillet's facets, where there is nothing to round, bend by less.
void run_rounding(cad_run& run, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& mesh = *run.base().mesh;
  const auto extent = ops::extent_of(mesh);
  const vec3 size = extent.high - extent.low;
  const double radius = std::min({size.x, size.y, size.z}) / 50;
  int done = 0;
  for (const auto wall : random_walls(mesh, random))
    for (const auto& [other, joint] : shape_of(mesh, wall).joints) {
      const double bend = joint.angle - std::numbers::pi;
      if (other < wall || std::abs(bend) < std::numbers::pi / 3 || done++ >= 10)
        continue;
      run.edit(bend < 0 ? "open, one edge" : "close, one edge", run.base(),
               {bend < 0 ? "open" : "close", {wall, other}, {{"radius", radius}}, {}});
    }
}

std::string vector_text(vec3 v) {
  char text[96];
  std::snprintf(text, sizeof(text), "%.9g,%.9g,%.9g", v.x, v.y, v.z);
  return text;
}

/// Each listed hole by its diameter along the wall around it, where it may be.
void run_copies(cad_run& run, const nlohmann::json& features, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto& mesh = *run.base().mesh;
  for (const auto& hole : features["holes"]) {
    const auto walls = ids_of(hole["surfaces"]);
    const auto shape =
      fit_wall(mesh, facets_of(mesh, std::array{walls.front()}), {1e-3, true, false});
    if (!shape || shape->type != wall_shape::kind::cylinder)
      continue;
    const vec3 any{unit(random), unit(random), unit(random)};
    const vec3 across = normalized(any - dot(any, shape->axis) * shape->axis);
    const std::string near = vector_text(shape->radius * across);
    const std::string far = vector_text(3 * shape->radius * across);
    run.edit("move", run.base(), {"move", walls, {{"by", near}}, {}});
    run.edit("move, a copy", run.base(), {"move", walls, {{"by", far}, {"copy", true}}, {}});
    run.edit("pattern, mirrored", run.base(),
             {"pattern",
              walls,
              {{"kind", std::string("mirror")},
               {"at", vector_text(shape->point + 1.5 * shape->radius * across)},
               {"direction", vector_text(across)}},
              {}});
  }
}

/// A box of that size as an OBJ in mm, its middle in the origin.
std::string box_obj(double size) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    char line[96];
    std::snprintf(line, sizeof(line), "v %.9g %.9g %.9g\n", 1e3 * size * ((i & 1) - 0.5),
                  1e3 * size * ((i >> 1 & 1) - 0.5), 1e3 * size * ((i >> 2 & 1) - 0.5));
    text += line;
  }
  return text +
         "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\n"
         "f 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";
}

void run_tools(cad_run& run, const mesh_version& mesh, surface_id wall, const wall_shape& flat,
               double least) {
  const std::string ring =
    "<svg xmlns='http://www.w3.org/2000/svg'><rect width='6' height='6'/>"
    "<rect x='2' y='2' width='2' height='2'/></svg>";
  for (const double height : {least / 80, -least / 80})
    run.edit(height > 0 ? "emboss, raised" : "emboss, sunk", run.base(),
             {"emboss",
              {wall},
              {{"text", std::string("A8")}, {"size", least / 12}, {"height", height}},
              {}});
  run.edit("pocket, an SVG ring", run.base(),
           {"pocket",
            {wall},
            {{"profile", std::string("file")},
             {"file", attachment_text({"ring.svg", ring})},
             {"size", least / 10},
             {"height", least / 30}},
            {}});
  const auto middle = ops::middle_of(mesh, wall);
  for (const char* mode : {"add", "cut"})
    if (middle)
      run.edit(std::string("combine, ") + mode, run.base(),
               {"combine",
                {},
                {{"file", attachment_text({"box.obj", box_obj(least / 10)})},
                 {"mode", std::string(mode)},
                 {"at", vector_text(middle->point)},
                 {"direction", vector_text(flat.axis)}},
                {}});
}

/// Between walls at an angle, where there is an inner corner: those that do not touch are refused.
void run_ribs(cad_run& run, const std::vector<std::pair<surface_id, wall_shape>>& flats,
              double least) {
  int done = 0;
  for (std::size_t i = 0; i < flats.size() && done < 10; ++i)
    for (std::size_t k = i + 1; k < flats.size() && done < 10; ++k) {
      const auto& [a, one] = flats[i];
      const auto& [b, other] = flats[k];
      const auto from = ops::middle_of(*run.base().mesh, a);
      const auto to = ops::middle_of(*run.base().mesh, b);
      // Each wall lies in front of the other one.
      if (!from || !to || std::abs(dot(one.axis, other.axis)) > 0.5 ||
          dot(to->point - from->point, one.axis) <= 0 ||
          dot(from->point - to->point, other.axis) <= 0)
        continue;
      ++done;
      run.edit("rib", run.base(),
               {"rib", {a, b}, {{"thickness", least / 30}, {"size", least / 8}}, {}});
    }
}

void run_features(cad_run& run, const nlohmann::json& features, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& mesh = *run.base().mesh;
  const auto extent = ops::extent_of(mesh);
  const vec3 size = extent.high - extent.low;
  const double least = std::min({size.x, size.y, size.z});
  run_copies(run, features, random);
  std::vector<std::pair<surface_id, wall_shape>> flats;
  for (const auto wall : random_walls(mesh, random))
    if (const auto shape = fit_wall(mesh, facets_of(mesh, std::array{wall}), {1e-3, true, false});
        shape && shape->type == wall_shape::kind::plane)
      flats.emplace_back(wall, *shape);
  for (std::size_t i = 0; i < flats.size() && i < 6; ++i)
    run_tools(run, mesh, flats[i].first, flats[i].second, least);
  run_ribs(run, flats, least);
  run.edit("hollow", run.base(), {"hollow", {}, {{"thickness", least / 12}}, {}});
  run.edit("plane_cut in two", run.base(),
           {"plane_cut",
            {},
            {{"at", vector_text(0.5 * (extent.low + extent.high) + 0.01 * size)},
             {"normal", std::string("0,0,1")},
             {"keep", std::string("both")}},
            {}});
}

/// `mesh`: a file, or the size ("medium") at which the CAD file is meshed as `tedit import` does.
expected<state> base_of(const char* cad_file, const std::string& mesh, const char* unit) {
  if (std::ranges::find(part_sizes, mesh) != part_sizes.end()) {
    auto part = cad::import_part({cad_file, mesh, {}, {}}, {});
    if (!part)
      return fail(part.error());
    return state{std::move(part->version), std::move(part->model)};
  }
  auto model = cad::read_model({cad_file, "medium", {}, {}}, {});
  auto read = import_mesh(mesh, unit);
  if (!model || !read)
    return fail(model ? read.error() : model.error());
  return state{std::move(read->version), std::move(*model)};
}

}  // namespace
}  // namespace tedit

int main(int argc, char** argv) try {
  using namespace tedit;
  if (argc < 5) {
    std::fprintf(stderr,
                 "usage: bench_cad CAD_FILE MESH UNIT FEATURES.json [SEED [new] [LABEL ...]]\n");
    return 2;
  }
  auto base = base_of(argv[1], argv[2], argv[3]);
  if (!base) {
    std::fprintf(stderr, "%s\n", render(base.error()).c_str());
    return 1;
  }
  std::ifstream in(argv[4]);
  const auto features = nlohmann::json::parse(in);
  const bool only_new = argc > 6 && std::string(argv[6]) == "new";
  const int labels = only_new ? 7 : 6;
  cad_run run(std::move(*base), {argv + std::min(argc, labels), argv + argc});
  const std::uint64_t seed = argc > 5 ? std::stoull(argv[5]) : 1;
  run_features(run, features, seed);
  if (only_new) {
    run.print_sums();
    return 0;
  }
  for (const auto& hole : features["holes"])
    run.edit("fill_hole", run.base(), {"fill_hole", ids_of(hole["surfaces"]), {}, {}});
  run_plates(run, features);
  run_random(run, seed);
  run_rounding(run, seed);
  auto at = run.base();
  for (const auto& hole : features["holes"])
    at = run.edit("chain", at, {"fill_hole", ids_of(hole["surfaces"]), {}, {}});
  run.print_sums();
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return 1;
}
