// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesh_file.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <span>

#include "mesh/build_version.hpp"
#include "mesh/io/file.hpp"

namespace tedit::cad {

namespace {

namespace fs = std::filesystem;

/// What lies in the file, taken piece by piece.
class byte_reader {
public:
  explicit byte_reader(std::span<const char> bytes) : bytes_(bytes) {}

  template <class T>
  bool take(std::vector<T>& into, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T))
      return false;
    into.resize(count);
    std::memcpy(into.data(), bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return true;
  }

private:
  std::span<const char> bytes_;
  std::size_t at_ = 0;
};

/// The mesher numbers faces by their places, from 1. A face of several surfaces is the first.
surface_id surface_at(const part_facts& facts, int place) {
  const bool is_known = place >= 1 && place <= static_cast<int>(facts.faces.size());
  return is_known ? facts.faces[static_cast<std::size_t>(place) - 1].ids.front() : place;
}

/// A surface may be several faces: it is called as the first that has a name, and has a geometry
/// where all have the same.
std::vector<surface_info> surfaces_of(const part_facts& facts,
                                      const std::vector<surface_geometry>& geometries) {
  std::map<surface_id, surface_info> rows;
  for (std::size_t i = 0; i < facts.faces.size(); ++i) {
    const auto id = surface_at(facts, static_cast<int>(i) + 1);
    const auto geometry = i < geometries.size() ? geometries[i] : surface_geometry{};
    const auto [row, is_first] =
      rows.try_emplace(id, surface_info{id, facts.faces[i].name, geometry});
    if (row->second.name.empty())
      row->second.name = facts.faces[i].name;
    if (!is_first && row->second.geometry != geometry)
      row->second.geometry = {};
  }
  std::vector<surface_info> result;
  for (auto& [id, row] : rows)
    result.push_back(std::move(row));
  return result;
}

expected<raw_mesh> load_mesh(const fs::path& folder, const part_facts& facts,
                             const std::vector<surface_geometry>& geometries) {
  const auto bytes = read_file(folder / mesh_file);
  if (!bytes)
    return fail(bytes.error());
  byte_reader from(*bytes);
  std::vector<mesh_header> header;
  raw_mesh raw;
  std::vector<std::array<std::int32_t, 4>> triangles;
  std::vector<std::array<std::int32_t, 5>> tets;
  if (!from.take(header, 1) || header[0].magic != mesh_header{}.magic ||
      !from.take(raw.positions, header[0].points) || !from.take(triangles, header[0].triangles) ||
      !from.take(tets, header[0].tets))
    return fail(ec::internal, "the mesher's answer is damaged", "Try again");
  const auto corner = [](std::int32_t v) { return static_cast<vertex_id>(v); };
  for (const auto& t : triangles)
    raw.triangles.push_back(
      {{corner(t[0]), corner(t[1]), corner(t[2])}, surface_at(facts, t[3]), true});
  for (const auto& t : tets) {
    raw.tets.push_back({{corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3])}});
    raw.tet_regions.push_back(t[4]);
  }
  raw.surface_names = surfaces_of(facts, geometries);
  for (std::size_t i = 0; i < facts.solids.size(); ++i)
    raw.region_names.push_back({static_cast<region_id>(i + 1), facts.solids[i].name});
  return raw;
}

std::string sentence_on_gone(const std::vector<int>& gone) {
  constexpr std::size_t most_named = 10;
  std::string ids;
  for (std::size_t i = 0; i < std::min(gone.size(), most_named); ++i)
    ids += (i > 0 ? ", " : "") + std::to_string(gone[i]);
  return "faces that are narrower than a twentieth of the wall went into their neighbours (" +
         std::to_string(gone.size()) + "): surface " + ids +
         (gone.size() > most_named ? ", ..." : "");
}

}  // namespace

expected<void> take_mesh(const fs::path& folder, imported_part& part,
                         const std::vector<surface_geometry>& geometries) {
  auto report = load_report(folder);
  auto raw = load_mesh(folder, part.model.facts, geometries);
  if (!report || !raw)
    return fail(report ? raw.error() : report.error());
  constexpr double millimetre = 1e-3;
  auto built = build_version(std::move(*raw), millimetre, slot_order::along_curve);
  if (!built)
    return fail(built.error());
  part.version = std::move(built->version);
  part.report = std::move(*report);
  for (int& place : part.report.gone)
    place = static_cast<int>(surface_at(part.model.facts, place));
  std::ranges::copy(built->warnings, std::back_inserter(part.warnings));
  if (!part.report.gone.empty())
    part.warnings.push_back(sentence_on_gone(part.report.gone));
  return {};
}

}  // namespace tedit::cad
