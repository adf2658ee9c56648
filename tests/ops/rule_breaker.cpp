// SPDX-License-Identifier: AGPL-3.0-or-later
// A correct operation, which breaks the one rule that $TEDIT_BREAK names: what the conformance kit
// must find. It moves surfaces along their mean normals.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/quality.hpp"
#include "ops/sdk/operation.hpp"

namespace {

using namespace tedit;

bool breaks(const std::string& rule) {
  const char* chosen = std::getenv("TEDIT_BREAK");
  return chosen && rule == chosen;
}

void* volatile lost = nullptr;
int* volatile nowhere = nullptr;  // Volatile itself: a store through a known null may be left out.

/// Dies of the store, not of a sanitizer that is told of it.
__attribute__((no_sanitize("null"))) void crash() {
  signal(SIGSEGV, SIG_DFL);
  *nowhere = 1;
}

struct at_load {
  at_load() {
    if (breaks("file_opens"))
      std::abort();
  }
} const loaded;

vec3 mean_normal(const mesh_version& mesh, surface_id id) {
  vec3 sum{};
  for (const auto f : facets_of(mesh, std::array{id}))
    sum += area_vector(mesh, mesh.facet(f));
  return norm(sum) > 0 ? normalized(sum) : vec3{};
}

using moves = std::map<vertex_id, vec3>;

moves plan_moves(const mesh_version& mesh, std::vector<surface_id> surfaces, double distance) {
  std::set<surface_id> done;
  if (!breaks("selection_order"))
    std::sort(surfaces.begin(), surfaces.end());
  moves result;
  double scale = 1;
  for (const auto id : surfaces) {
    if (!done.insert(id).second && !breaks("duplicate_selection"))
      continue;
    const auto step = scale * distance * mean_normal(mesh, id);
    std::set<vertex_id> vertices;
    for (const auto f : facets_of(mesh, std::array{id}))
      vertices.insert(mesh.facet(f).v.begin(), mesh.facet(f).v.end());
    for (const auto v : vertices)
      result[v] += step;
    if (breaks("selection_order"))
      scale *= 0.5;
  }
  return result;
}

/// What only shows in the frozen arrays.
version_ptr spoiled(const version_ptr& candidate) {
  auto data = candidate->data();
  if (breaks("adjacency")) {
    auto rows = data.neighbours.to_vector();
    std::swap(rows[0][0], rows[0][1]);
    data.neighbours = paged_array<adjacency>::from(rows);
  }
  if (breaks("surface_ids")) {
    auto rows = data.facets.to_vector();
    rows[0].surface = 4711;
    data.facets = paged_array<boundary_facet>::from(rows);
  }
  if (breaks("counts"))
    ++data.live_tets;
  if (breaks("regions_kept"))
    data.regions[0].name += " changed";
  return mesh_version::create(std::move(data));
}

/// Takes out one tet that no facet touches: a void.
void dig_void(mesh_builder& builder, const mesh_version& mesh, ops::edit_result& result) {
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto& v = mesh.tet_at(t).v;
    bool inside = true;
    for (const auto i : v)
      inside = inside && !builder.is_boundary_vertex(i);
    if (!inside)
      continue;
    cavity_change change;
    change.removed = {t};
    for (const auto& face : tet_faces)
      change.facets.push_back({{v[face[0]], v[face[1]], v[face[2]]}, mesh.surfaces()[0].id});
    result.volume_change -= signed_volume(mesh.corners(t));
    (void)builder.apply(change);
    return;
  }
}

/// What ends or harms the process that it runs in.
void harm_process() {
  if (breaks("every_surface_alone"))
    crash();
  if (breaks("aborts"))
    std::abort();
  if (breaks("exits"))
    _exit(0);
  if (breaks("exits_politely"))
    std::exit(3);
  if (breaks("hang"))
    while (true)
      usleep(1000);
  if (breaks("closes_descriptors"))
    close_range(0, ~0U, 0);
  if (breaks("writes_everywhere"))
    for (int fd = 0; fd < 256; ++fd)
      (void)!write(fd, "rubbish, not asked for\n", 23);
  if (breaks("eats_memory"))
    for (std::vector<std::string> eaten;;)
      eaten.emplace_back(std::size_t{1} << 24, 'x');
  if (breaks("leaves_a_child") && fork() == 0) {
    sleep(600);
    _exit(0);
  }
}

/// What harms others than the process itself.
void harm_others() {
  if (breaks("kills_parent")) {
    kill(getppid(), SIGKILL);
    pause();
  }
  if (breaks("kills_group"))
    kill(0, SIGKILL);
  if (breaks("leaves_no_descriptor"))
    while (open("/dev/null", O_RDONLY) >= 0) {
    }
  if (breaks("leaks"))
    while (void* more = std::malloc(1 << 20)) {
      lost = more;
      std::memset(more, 1, 1 << 20);
    }
}

/// Side effects on the process.
void misbehave(const mesh_version& mesh, const ops::context& ctx) {
  static int calls = 0;
  harm_process();
  harm_others();
  if (breaks("waits")) {  // No rule: for tests of what may happen meanwhile.
    ctx.run.report(0.1, "waiting");
    while (!ctx.run.cancel.cancelled())
      usleep(1000);
  }
  if (breaks("throws"))
    throw std::runtime_error("out of luck");
  if (breaks("logs"))  // No rule either.
    ctx.log("two\nlines of " + std::to_string(mesh.tet_count()) + " tets");
  if (breaks("free_slots") && mesh.surfaces().size() > 6)
    for (tet_id t = 0; t < mesh.tet_slots(); ++t)
      if (mesh.tet_at(t).v[0] == no_id)
        crash();
  if (breaks("input_unchanged"))
    const_cast<double&>(mesh.position(0).x) = -0.0;
  if (breaks("quiet"))
    std::printf("working\n");
  if (breaks("no_files"))
    std::ofstream("left.txt") << "mine";
  if (breaks("no_traces"))
    setenv("LC_ALL", "C", 1);
  if (breaks("no_handles"))
    (void)!open("/dev/null", O_RDONLY);
  if (breaks("repeats"))
    lost = std::calloc(1, 3000 + static_cast<std::size_t>(++calls % 3));
  if (breaks("progress"))
    ctx.run.report(100, "half");
}

/// Half a second of processor time, once in each process.
void work_without_asking() {
  static bool done = false;
  const auto end = std::clock() + CLOCKS_PER_SEC / 2;
  while (!done && std::clock() < end) {
    // Busy.
  }
  done = true;
}

/// Asks for a cancel as often as 3 ms allow: each run another number of times.
void ask_by_the_clock(const ops::context& ctx) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(3);
  while (std::chrono::steady_clock::now() < end && !ctx.run.cancel.cancelled())
    usleep(static_cast<unsigned>(std::rand() % 1000));
}

expected<ops::edit_result> move_surfaces(const version_ptr& base,
                                         const std::vector<surface_id>& given, double distance,
                                         std::int64_t layers, ops::context& ctx) {
  const auto& mesh = *base;
  misbehave(mesh, ctx);
  if (breaks("surface_two") && given.size() == 1 && given[0] == 2)
    crash();
  auto surfaces = given;
  const auto in_table = [&](surface_id id) { return mesh.find_surface(id) != nullptr; };
  if (breaks("trusts_the_host") && (surfaces.empty() || !std::ranges::all_of(surfaces, in_table)))
    crash();
  if (facets_of(mesh, surfaces).empty())
    return fail(ec::empty_selection, "there is nothing to move",
                breaks("refusals_explained") ? "" : "Select a surface of the boundary");
  if (layers > 1000000 && breaks("hostile_parameters"))
    crash();
  if (distance > 0.0039 && breaks("parameters_at_limits"))
    crash();
  if (!breaks("cancelled_at_start") && ctx.run.cancel.cancelled())
    return fail(breaks("cancel_code") ? ec::internal : ec::cancelled, "the edit was cancelled",
                "Start it again");
  if (breaks("asks_by_the_clock"))
    ask_by_the_clock(ctx);
  if (!breaks("cancelled_at_start") && ctx.run.cancel.cancelled() && !breaks("cancelled_anywhere"))
    return fail(ec::cancelled, "the edit was cancelled");
  if (breaks("polls_often"))
    work_without_asking();
  if (!breaks("progress"))
    ctx.run.report(0.5, "moving");
  static int random = 0;
  if (breaks("deterministic"))
    distance *= 1 + 1e-6 * ++random;
  if (breaks("positive_tets"))
    distance = -0.03;
  if (breaks("quality_floor"))
    distance = -0.0099999;
  mesh_builder builder(base);
  ops::edit_result result;
  if (breaks("no_void"))
    dig_void(builder, mesh, result);
  for (const auto& [v, step] : plan_moves(mesh, surfaces, distance))
    if (!breaks("changes_something"))
      builder.set_position(v, mesh.position(v) + step);
  result.touched = builder.touched();
  for (const auto t : result.touched) {
    const double volume = signed_volume(builder.corners(t));
    if (volume <= 0 && !breaks("positive_tets"))
      return fail(ec::inverted_tet, "a tet would be turned inside out", "Take a smaller distance");
    result.volume_change += volume - signed_volume(mesh.corners(t));
  }
  if (breaks("volume_claim"))
    result.volume_change *= 1.01;
  if (breaks("untouched_tets"))
    result.touched.pop_back();
  if (!breaks("result_complete"))
    result.surfaces_used = surfaces;
  if (!breaks("no_candidate"))
    result.candidate = spoiled(builder.freeze());
  return result;
}

class rule_breaker final : public ops::operation {
public:
  explicit rule_breaker(std::uint32_t index = 0) : index_(index) {}

  ops::operation_description describe() const override {
    static int calls = 0;
    if (breaks("makes_operations"))
      throw std::runtime_error("no licence file");
    ops::operation_description d;
    d.id = breaks("ids") ? "RuleBreaker" : index_ == 0 ? "rule_breaker" : "Second";
    d.name = "Rule breaker";
    d.summary = breaks("texts") ? "" : "Moves surfaces along their mean normals.";
    d.version = breaks("version") ? "one" : "1.0.0";
    d.selection.help = "Surfaces to move.";
    d.parameters = {
      {"distance",
       "Distance",
       "How far.",
       ops::parameter_type::real,
       breaks("units") ? "mm" : "m",
       -0.004,
       breaks("parameters_guarded") ? std::nullopt : std::optional(0.004),
       {},
       breaks("defaults") ? 1.0 : 0.001},
      {"layers",
       "Layers",
       "Nothing depends on it.",
       ops::parameter_type::integer,
       "",
       1,
       {},
       {},
       std::int64_t{1}},
    };
    if (breaks("parameters_guarded"))
      d.parameters[0].min.reset();
    if (breaks("same_description"))
      d.summary += std::to_string(++calls);
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return move_surfaces(mesh, picked.surfaces, std::get<double>(values.at("distance")),
                         std::get<std::int64_t>(values.at("layers")), ctx);
  }

private:
  std::uint32_t index_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const ops::plugin_descriptor*
tedit_plugin_query() {
  static const auto descriptor = [] {
    auto made = ops::make_descriptor<rule_breaker>("rule_breaker", "1.0.0");
    made.operation_count = breaks("second_operation") ? 2 : 1;
    made.create = [](std::uint32_t index) -> ops::operation* { return new rule_breaker(index); };
#ifdef TEDIT_OLD_PLUGIN
    --made.layout_count;  // As before a minor release that added a fact.
#endif
    return made;
  }();
  return &descriptor;
}
