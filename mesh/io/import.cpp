// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/import.hpp"

#include <new>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

expected<imported_mesh> import_mesh(const std::filesystem::path& path,
                                    const std::string& length_unit) {
  const stopwatch clock;
  auto bytes = read_file(path);
  if (!bytes)
    return fail(bytes.error());
  const double file_ms = clock.milliseconds();
  auto result = import_mesh_bytes(*std::move(bytes), length_unit);
  if (!result) {
    auto failure = result.error();
    failure.where = path.string() + (failure.where.empty() ? "" : ", " + failure.where);
    return fail(std::move(failure));
  }
  result->read_ms += file_ms;
  return result;
}

namespace {

/// Bytes of a surface's or region's name that are kept; Gmsh's own have 127 at most.
constexpr std::size_t longest_name = 200;

/// Where the vertices that tets use stand among these: as `build_version` numbers them.
class vertex_ranks {
public:
  explicit vertex_ranks(const raw_mesh& raw) : ranks_(raw.positions.size(), no_id) {
    for (const auto& t : raw.tets)
      for (const auto v : t.v)
        if (v < ranks_.size())
          ranks_[v] = 0;
    for (auto& rank : ranks_)
      if (rank != no_id)
        rank = count_++;
  }

  /// Makes the vertices of `loads` those of the version. False where the two do not fit, because
  /// tets were left out.
  bool apply(const mesh_version& mesh, deck& loads) const {
    if (mesh.vertex_count() != count_)
      return false;
    std::vector<vertex_id> slot(count_);
    const auto& order = mesh.data().vertex_order;
    for (vertex_id v = 0; v < count_; ++v)
      slot[order.size() == count_ ? order[v] : v] = v;
    const auto move = [&](vertex_id& v) { v = slot[ranks_[v]]; };
    for (auto& one : loads.supports)
      move(one.vertex);
    for (auto& one : loads.forces)
      move(one.vertex);
    for (auto& one : loads.pressures)
      for (auto& v : one.corners)
        move(v);
    return true;
  }

private:
  std::vector<std::uint32_t> ranks_;
  std::uint32_t count_ = 0;
};

/// In the unit that the file says, which is told where somebody expects another one.
void take_unit(const read_mesh& read, const std::string& asked, imported_mesh& result) {
  result.length_unit = read.length_unit.empty() ? asked : read.length_unit;
  if (result.length_unit != asked)
    result.warnings.push_back("the file says that its lengths are in " + result.length_unit +
                              "; they are read so, not in " + asked);
}

/// `let_go` is called once nothing of the bytes is needed any more.
template <class LetGo>
expected<imported_mesh> read_and_build(std::span<const char> bytes, const std::string& length_unit,
                                       LetGo let_go) {
  if (const auto unit = metres_per_unit(length_unit); !unit)
    return fail(unit.error());
  stopwatch clock;
  auto read = read_any(bytes);
  if (!read)
    return fail(read.error());
  let_go();
  imported_mesh result;
  result.read_ms = clock.restart();
  take_unit(*read, length_unit, result);
  const auto unit = metres_per_unit(result.length_unit);
  if (!unit)
    return fail(unit.error());
  result.loads = std::move(read->loads);
  deck_in_metres(result.loads, *unit);
  const vertex_ranks ranks(read->mesh);
  // Names go into files and messages that must be UTF-8, and old files hold what they like.
  for (auto& surface : read->mesh.surface_names)
    surface.name = cut_text(to_utf8(surface.name), longest_name);
  for (auto& region : read->mesh.region_names)
    region.name = cut_text(to_utf8(region.name), longest_name);
  auto built = build_version(std::move(read->mesh), *unit, slot_order::along_curve);
  if (!built)
    return fail(built.error());
  result.build_ms = clock.restart();
  result.version = std::move(built->version);
  if (!ranks.apply(*result.version, result.loads)) {
    if (!result.loads.empty())
      result.warnings.push_back("supports and loads of the file are left out, as tets were");
    result.loads = {};
  }
  result.warnings.insert(result.warnings.end(), read->notices.begin(), read->notices.end());
  result.warnings.insert(result.warnings.end(), built->warnings.begin(), built->warnings.end());
  return result;
}

template <class LetGo>
expected<imported_mesh> import_within_memory(std::span<const char> bytes,
                                             const std::string& length_unit, LetGo let_go) {
  try {
    return read_and_build(bytes, length_unit, let_go);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "there is not enough memory for this mesh",
                "Close other programs or take a coarser mesh");
  }
}

}  // namespace

expected<imported_mesh> import_mesh_bytes(std::span<const char> bytes,
                                          const std::string& length_unit) {
  return import_within_memory(bytes, length_unit, [] {});
}

expected<imported_mesh> import_mesh_bytes(std::vector<char>&& bytes,
                                          const std::string& length_unit) {
  return import_within_memory(bytes, length_unit, [&] { bytes = std::vector<char>(); });
}

}  // namespace tedit
