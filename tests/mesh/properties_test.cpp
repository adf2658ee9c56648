// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Properties over random inputs (rapidcheck). A failure prints the smallest input found and a
// line RC_PARAMS="reproduce=..." that runs exactly that case again.
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "mesh/builder.hpp"
#include "mesh/changes.hpp"
#include "mesh/checks.hpp"
#include "mesh/predicates.hpp"
#include "mesh/surface_map.hpp"
#include "tests/support/local_moves.hpp"
#include "tests/support/meshes.hpp"

// -- what an allocation-bound property measures: live bytes of this thread, and their peak --------

namespace {
thread_local std::ptrdiff_t live_bytes = 0;
thread_local std::ptrdiff_t peak_bytes = 0;
}  // namespace

// Sanitizers bring their own allocators; the bound is measured in ordinary builds only.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
void* operator new(std::size_t size) {
  void* block = std::malloc(std::max<std::size_t>(size, 1));
  if (!block)
    throw std::bad_alloc();
  live_bytes += static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  peak_bytes = std::max(peak_bytes, live_bytes);
  return block;
}

void operator delete(void* block) noexcept {
  live_bytes -= static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}
#endif

namespace tedit {
namespace {

/// What to do, at which element, with which numbers: each test reads it in its own way.
using step = std::tuple<int, std::uint32_t, std::uint32_t>;

std::vector<step> random_steps(int kinds) {
  return *rc::gen::container<std::vector<step>>(
    rc::gen::tuple(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, kinds)),
                   rc::gen::arbitrary<std::uint32_t>(), rc::gen::arbitrary<std::uint32_t>()));
}

// -- paged arrays ---------------------------------------------------------------------------------

/// So large that a page holds 16 of them: short sequences cross pages.
using block = std::array<std::uint64_t, 512>;
using paged_blocks = paged_array<block>;

block block_of(std::uint32_t value) {
  block result;
  result.fill(value);
  return result;
}

std::vector<block> blocks_of(const std::vector<std::uint32_t>& values) {
  std::vector<block> result;
  std::ranges::transform(values, std::back_inserter(result), block_of);
  return result;
}

/// Any sequence of writes, appends and freezes gives what the same sequence gives on a vector, for
/// every frozen state, also after later writes; a page is the very same object as in the state
/// before exactly when nothing was written to it. Each state goes to its pages and back, not with a
/// wrong length, and equal content has equal page identities however it came about.
RC_GTEST_PROP(PagedArrayProperty, ABuilderIsAVectorThatSharesPages,
              (std::vector<std::uint32_t> values)) {
  std::vector<std::pair<paged_blocks, std::vector<std::uint32_t>>> states;
  states.emplace_back(paged_blocks::from(blocks_of(values)), values);
  paged_array_builder<block> builder(states.back().first);
  std::set<std::size_t> written;
  const auto freeze = [&] {
    const auto before = states.back().first.pages();
    states.emplace_back(builder.freeze(), values);
    const auto& after = states.back().first.pages();
    for (std::size_t p = 0; p < before.size(); ++p)
      RC_ASSERT((before[p] == after[p]) == !written.contains(p));
    written.clear();
  };
  for (const auto& [kind, where, value] : random_steps(7)) {
    if (kind == 0) {
      freeze();
    } else if (kind < 3 || values.empty()) {
      RC_ASSERT(builder.push_back(block_of(value)) == values.size());
      written.insert(values.size() / paged_blocks::items_per_page);
      values.push_back(value);
    } else {
      builder.write(where % values.size()) = block_of(value);
      written.insert(where % values.size() / paged_blocks::items_per_page);
      values[where % values.size()] = value;
    }
  }
  freeze();
  for (const auto& [array, model] : states) {
    RC_ASSERT((array.to_vector() == blocks_of(model)));
    const auto back = paged_blocks::from_pages(array.pages(), model.size());
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->pages() == array.pages());
    RC_ASSERT(!paged_blocks::from_pages(array.pages(), model.size() + 1).has_value());
  }
  const auto again = paged_blocks::from(blocks_of(values)).pages();
  RC_ASSERT(std::ranges::equal(again, states.back().first.pages(), {}, &page::id, &page::id));
}

// -- manifests ------------------------------------------------------------------------------------

spline_surface random_spline() {
  spline_surface s;
  for (int d = 0; d < 2; ++d) {
    s.degree[d] = *rc::gen::inRange(1u, 4u);
    const auto inner = *rc::gen::inRange(0, 3);
    s.knots[d].assign(s.degree[d] + 1, 0);
    for (int i = 0; i < inner; ++i)
      s.knots[d].push_back(1 + i);
    s.knots[d].insert(s.knots[d].end(), s.degree[d] + 1, 1 + inner);
  }
  const auto number = [] { return 1e-3 * *rc::gen::inRange(-1000, 1000); };
  for (std::size_t i = 0; i < s.count(0) * s.count(1); ++i)
    s.poles.push_back({number(), number(), number()});
  if (*rc::gen::arbitrary<bool>())
    for (std::size_t i = 0; i < s.poles.size(); ++i)
      s.weights.push_back(2 + number());
  return s;
}

/// In half of all cases none.
surface_geometry random_geometry() {
  surface_geometry g;
  const int type = *rc::gen::inRange(-6, 7);
  if (type <= 0)
    return g;
  g.type = static_cast<surface_geometry::kind>(type);
  g.tolerance = 1e-9 * *rc::gen::inRange(0, 1000);
  if (g.type == surface_geometry::kind::spline) {
    g.spline = std::make_shared<const spline_surface>(random_spline());
    return g;
  }
  const auto number = [] { return 1e-3 * *rc::gen::inRange(-1000, 1000); };
  g.point = {number(), number(), number()};
  g.axis = {number(), number(), number()};
  g.radius = number();
  g.slope = number();
  g.tube_radius = number();
  return g;
}

manifest random_manifest() {
  using hashes = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
  manifest list;
  for (const auto& [size, pages] :
       *rc::gen::arbitrary<std::vector<std::pair<std::uint64_t, hashes>>>()) {
    list.arrays.push_back({size, {}});
    for (const auto& [high, low] : pages)
      list.arrays.back().pages.push_back({high, low});
  }
  for (auto& [id, name] : *rc::gen::arbitrary<std::map<surface_id, std::string>>())
    list.surfaces.push_back({id, name, random_geometry()});
  for (auto& [id, name] : *rc::gen::arbitrary<std::map<region_id, std::string>>())
    list.regions.push_back({id, name});
  list.counts = *rc::gen::arbitrary<std::array<std::uint32_t, 6>>();
  return list;
}

/// Reads bytes that anybody may have sent: it must come back, hold only a small multiple of the
/// input's bytes at any time (a row of a table is 40 bytes for 8 in the file, and a growing vector
/// briefly holds three times its content), and accept nothing but what `to_bytes` writes.
void read_untrusted(const std::vector<std::byte>& bytes) {
  live_bytes = peak_bytes = 0;
  const auto list = manifest::from_bytes(bytes);
  RC_ASSERT(peak_bytes <= static_cast<std::ptrdiff_t>(16 * bytes.size() + 1024));
  RC_ASSERT((!list || list->to_bytes() == bytes));
}

/// A manifest comes back from its bytes as it was; cut or lengthened ones are refused; one with
/// changed bytes or a count of up to 2^64 written over it, and noise behind the tag, are read or
/// refused, no more.
RC_GTEST_PROP(ManifestProperty, RoundTripsAndSurvivesDamage, ()) {
  const auto list = random_manifest();
  const auto good = list.to_bytes();
  const auto back = manifest::from_bytes(good);
  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == list);
  const auto cut = *rc::gen::inRange<std::size_t>(0, good.size());
  RC_ASSERT(!manifest::from_bytes(std::span(good).first(cut)).has_value());
  auto noise = std::vector<std::byte>(good.begin(), good.begin() + 4);
  for (const auto value : *rc::gen::arbitrary<std::vector<std::uint8_t>>())
    noise.push_back(static_cast<std::byte>(value));
  read_untrusted(noise);
  auto longer = good;
  longer.push_back(std::byte{0});
  RC_ASSERT(!manifest::from_bytes(longer).has_value());
  auto changed = good;
  for (const auto& [kind, where, value] : random_steps(2)) {
    if (kind == 0) {
      changed[where % changed.size()] = static_cast<std::byte>(value);
    } else {
      const auto count = std::uint64_t{value} << (where % 40);
      std::memcpy(changed.data() + where % (changed.size() - sizeof(count)), &count, sizeof(count));
    }
    read_untrusted(changed);
  }
}

// -- edits ----------------------------------------------------------------------------------------

/// Random valid changes of a mesh in the unit cube; the same steps make the same changes.
class random_edit {
public:
  explicit random_edit(version_ptr base) : mesh(std::move(base)) {}

  static constexpr int kinds = 9;
  static constexpr int refused = 8;

  mesh_builder mesh;

  version_ptr run_all(std::span<const step> steps) {
    for (const auto& s : steps)
      run(s);
    return mesh.freeze();
  }

  void run(const step& s) {
    const auto [kind, where, value] = s;
    auto t = where % mesh.tet_slots();
    while (!mesh.is_live_tet(t))
      t = (t + 1) % mesh.tet_slots();
    if (kind < 3) {
      std::unordered_set<tet_id> all;
      for (tet_id i = 0; i < mesh.tet_slots(); ++i)
        if (mesh.is_live_tet(i))
          all.insert(i);
      local_moves moves(mesh, std::move(all));
      (void)(kind == 0   ? moves.flip(t)
             : kind == 1 ? moves.relocate_corner(t)
                         : moves.insert_vertex(t));
    } else if (kind < 5) {
      split(t, kind == 4);
    } else if (kind < 7) {
      remove_vertex(t);
    } else if (kind == 7) {
      const auto& c = mesh.tet_at(t).v;
      replace({t}, {{{c[1], c[2], c[0], c[3]}}});
    } else {
      // The faces it would bare have no surface.
      RC_ASSERT(!mesh.apply({{t}, {}, {}, {}}).has_value());
    }
  }

private:
  /// Does nothing when a new tet would not be positive: then its vertex stays loose.
  void replace(std::vector<tet_id> removed, const std::vector<tet>& added,
               std::vector<new_facet> facets = {}) {
    cavity_change change{std::move(removed), {}, {}, std::move(facets)};
    for (const auto& corners : added) {
      const auto p = [&](int i) { return mesh.position(corners.v[i]); };
      if (orient3d(p(0), p(1), p(2), p(3)) <= 0)
        return;
      change.added.push_back({corners, mesh.region_of(change.removed.front())});
    }
    RC_ASSERT(mesh.apply(change).has_value());
  }

  /// Puts a vertex into the middle of t or of a boundary facet of t, exactly on the cube's side.
  void split(tet_id t, bool facet) {
    const auto corners = mesh.tet_at(t);
    const auto& row = mesh.neighbours(t);
    const auto side = facet ? std::ranges::find_if(row, is_facet) - row.begin() : 4;
    if (facet && side == 4)
      return;
    const auto f = facet ? mesh.facet(row[side] & ~facet_flag) : boundary_facet{};
    vec3 sum;
    for (int i = 0; i < 4; ++i)
      sum += i == side ? vec3{} : mesh.position(corners.v[i]);
    const auto fresh = mesh.add_vertex(sum / (facet ? 3 : 4));
    std::vector<tet> added;
    std::vector<new_facet> facets;
    for (int i = 0; i < 4; ++i) {
      if (i == side)
        continue;
      added.push_back(corners);
      added.back().v[i] = fresh;
      facets.push_back({f.v, f.surface});
      std::ranges::replace(facets.back().v, corners.v[i], fresh);
    }
    replace({t}, added, facet ? facets : std::vector<new_facet>{});
  }

  /// Undoes a split: an inner vertex with four tets around it goes, one tet takes their place.
  void remove_vertex(tet_id t) {
    const auto corner = mesh.tet_at(t).v;
    const auto v = std::ranges::find_if(
      corner, [&](vertex_id i) { return mesh.star(i).size() == 4 && !mesh.is_boundary_vertex(i); });
    if (v == corner.end())
      return;
    const auto star = mesh.star(*v);
    auto merged = mesh.tet_at(star[0]);
    for (const auto other : mesh.tet_at(star[1]).v)
      if (!std::ranges::count(merged.v, other))
        std::ranges::replace(merged.v, *v, other);
    replace(star, {merged});
  }
};

/// A box of one to three cells each way in the unit cube whose inner points are shaken.
version_ptr random_box() {
  const auto cells = [] { return *rc::gen::inRange(1, 4); };
  std::minstd_rand random(*rc::gen::arbitrary<std::uint32_t>());
  std::uniform_real_distribution<double> d(-0.03, 0.03);
  return test::box_mesh({cells(), cells(), cells()}, {1, 1, 1}, [&](vec3 p) {
    const auto inner = [](double x) { return x > 0 && x < 1; };
    const vec3 shake{d(random), d(random), d(random)};
    return inner(p.x) && inner(p.y) && inner(p.z) ? p + shake : p;
  });
}

/// Any sequence of valid changes keeps every invariant and the volume. The same sequence without
/// the refused changes in it gives the same id, so a refusal changes nothing and ids are
/// reproducible. A builder that goes on after a freeze gives what a new builder on the frozen
/// version gives: all state is in the version. The base's pages keep what their identities say.
RC_GTEST_PROP(EditProperty, ChangesKeepInvariantsVolumeAndBase, ()) {
  const auto base = random_box();
  auto steps = random_steps(random_edit::kinds);
  const auto more = random_steps(random_edit::kinds);
  random_edit edit(base);

  const auto middle = edit.run_all(steps);
  const auto after = edit.run_all(more);

  for (const auto& mesh : {middle, after}) {
    const auto report = check_version(*mesh);
    if (!report.ok())
      RC_FAIL(to_error(report).message);
    RC_ASSERT(std::abs(total_volume(*mesh) - total_volume(*base)) <= 1e-12);
    RC_ASSERT(mesh->surfaces() == base->surfaces());
  }
  RC_ASSERT(random_edit(middle).run_all(more)->id() == after->id());
  std::erase_if(steps, [](const step& s) { return std::get<0>(s) == random_edit::refused; });
  RC_ASSERT(random_edit(base).run_all(steps)->id() == middle->id());
  base->for_each_page([](const page_ptr& p) { RC_ASSERT(hash_bytes(p->bytes()) == p->id()); });
  RC_ASSERT(hash_bytes(base->pages().to_bytes()) == base->id());
}

// -- differences between versions -----------------------------------------------------------------

/// Compares one array.
template <class T>
void compare_pages(const mesh_version& before, const mesh_version& after,
                   paged_array<T> mesh_data::*array) {
  const auto& a = before.data().*array;
  const auto& b = after.data().*array;
  std::set<std::size_t> differ;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    if (i >= a.size() || i >= b.size() || std::memcmp(&a[i], &b[i], sizeof(T)) != 0)
      differ.insert(i / paged_array<T>::items_per_page);
  const auto dirty = dirty_pages(a, b);
  RC_ASSERT(std::vector(differ.begin(), differ.end()) == dirty);
}

/// After random changes a page is dirty exactly when the bytes of a slot on it differ or a slot is
/// new or gone: who fetches the dirty pages has everything and nothing twice.
RC_GTEST_PROP(DifferenceProperty, DirtyPagesAreThoseWithASlotThatDiffers, ()) {
  static const auto base = test::box_mesh({12, 12, 12}, {1, 1, 1});
  auto steps = random_steps(random_edit::kinds);
  steps.resize(std::min<std::size_t>(steps.size(), 12));
  const auto after = random_edit(base).run_all(steps);
  const auto compare = [&](auto... arrays) { (compare_pages(*base, *after, arrays), ...); };
  compare(&mesh_data::positions, &mesh_data::vertex_tet, &mesh_data::tets, &mesh_data::tet_regions,
          &mesh_data::neighbours, &mesh_data::facets, &mesh_data::interfaces);
}

using triangles = std::set<std::array<vertex_id, 3>>;

std::map<surface_id, triangles> patches(const mesh_version& mesh) {
  std::map<surface_id, triangles> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      result[mesh.facet(f).surface].insert(mesh.facet(f).v);
  return result;
}

/// After random changes of topology and of facets' surfaces the comparison has one row for each
/// surface whose triangles differ and none for others; a surface is new, gone or
/// changed as the tables say.
RC_GTEST_PROP(DifferenceProperty, SurfaceRowsAreThoseWhoseTrianglesDiffer, ()) {
  const auto base = random_box();
  random_edit edit(base);
  for (const auto& s : random_steps(random_edit::kinds + 2)) {
    const auto [kind, where, value] = s;
    const auto f = where % edit.mesh.facet_slots();
    if (kind < random_edit::kinds)
      edit.run(s);
    else if (edit.mesh.is_live_facet(f))
      edit.mesh.set_surface(f, value % 8 < 6 ? 1 + value % 8 : edit.mesh.add_surface("new"));
  }

  const auto after = edit.mesh.freeze();
  const auto rows = compare_surfaces(*base, *after);

  auto old_patches = patches(*base);
  auto new_patches = patches(*after);
  std::size_t differ = 0;
  for (surface_id id = 0; id < 200; ++id)
    differ += old_patches[id] != new_patches[id];
  RC_ASSERT(rows.size() == differ);
  for (const auto& row : rows) {
    RC_ASSERT(old_patches[row.id] != new_patches[row.id]);
    const bool gone = row.fate == surface_fate::removed || row.fate == surface_fate::merged_into;
    const bool fresh = row.fate == surface_fate::added || row.fate == surface_fate::split_from;
    RC_ASSERT(gone == (after->find_surface(row.id) == nullptr));
    RC_ASSERT(fresh == (base->find_surface(row.id) == nullptr));
  }
}

}  // namespace
}  // namespace tedit
