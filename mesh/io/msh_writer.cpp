// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <map>
#include <ostream>

#include "base/units.hpp"
#include "mesh/box.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/io/formats.hpp"

namespace tedit {

namespace {

template <class T>
void put(std::ostream& out, T value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Many numbers on their way to a stream, which takes longer over each than over a thousand.
class number_buffer {
public:
  explicit number_buffer(std::ostream& out) : out_(out) {}
  number_buffer(const number_buffer&) = delete;
  number_buffer& operator=(const number_buffer&) = delete;
  ~number_buffer() { flush(); }

  template <class T>
  void put(T value) {
    if (used_ + sizeof(T) > bytes_.size())
      flush();
    std::memcpy(bytes_.data() + used_, &value, sizeof(T));
    used_ += sizeof(T);
  }

private:
  void flush() {
    out_.write(bytes_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

  std::ostream& out_;
  std::vector<char> bytes_ = std::vector<char>(std::size_t{64} << 10);
  std::size_t used_ = 0;
};

using triangle_list = std::vector<std::array<vertex_id, 3>>;

class msh_writer {
public:
  msh_writer(const mesh_version& mesh, double scale)
      : mesh_(mesh),
        scale_(scale),
        vertices_(vertices_of_file(mesh)),
        live_tets_(tets_of_file(mesh)) {
    for (facet_id f = 0; f < mesh.facet_slots(); ++f)
      if (mesh.is_live_facet(f))
        triangles_[mesh.facet(f).surface].push_back(mesh.facet(f).v);
    const auto& interfaces = mesh.data().interfaces;
    for (std::size_t i = 0; i < interfaces.size(); ++i)
      triangles_[interfaces[i].surface].push_back(interfaces[i].v);
    for (const auto t : live_tets_.slots)
      tets_[mesh.region_of(t)].push_back(t);
  }

  void write(std::ostream& out) const {
    out << "$MeshFormat\n4.1 1 8\n";
    put<std::int32_t>(out, 1);
    out << "\n$EndMeshFormat\n";
    write_names(out);
    write_entities(out);
    write_nodes(out);
    write_elements(out);
  }

private:
  [[nodiscard]] vec3 point(vertex_id v) const { return scale_ * mesh_.position(v); }

  /// Physical group of a surface or region: its place in the table, from 1. Where none has a name
  /// there are no groups; where some have one, all get a group, as meshio wants it.
  template <class Rows, class Id>
  [[nodiscard]] std::int32_t group_of(const Rows& rows, Id id) const {
    const auto is_named = [](const auto& row) { return !row.name.empty(); };
    if (std::ranges::none_of(mesh_.surfaces(), is_named) &&
        std::ranges::none_of(mesh_.regions(), is_named))
      return 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].id == id)
        return static_cast<std::int32_t>(i + 1);
    return 0;
  }

  void write_names(std::ostream& out) const {
    std::string lines;
    std::size_t count = 0;
    const auto add = [&](int dimension, const auto& rows) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].name.empty())
          continue;
        lines +=
          std::to_string(dimension) + " " + std::to_string(i + 1) + " \"" + rows[i].name + "\"\n";
        ++count;
      }
    };
    add(2, mesh_.surfaces());
    add(3, mesh_.regions());
    if (count > 0)
      out << "$PhysicalNames\n" << count << '\n' << lines << "$EndPhysicalNames\n";
  }

  /// @param extents in metres.
  void write_entity(std::ostream& out, std::int32_t tag, const box& extents,
                    std::int32_t group) const {
    put(out, tag);
    for (const auto p : {scale_ * extents.low, scale_ * extents.high}) {
      put(out, p.x);
      put(out, p.y);
      put(out, p.z);
    }
    put<std::uint64_t>(out, group ? 1 : 0);
    if (group)
      put(out, group);
    put<std::uint64_t>(out, 0);
  }

  void write_entities(std::ostream& out) const {
    out << "$Entities\n";
    put<std::uint64_t>(out, 0);
    put<std::uint64_t>(out, 0);
    put<std::uint64_t>(out, triangles_.size());
    put<std::uint64_t>(out, tets_.size());
    for (const auto& [surface, list] : triangles_) {
      box extents;
      for (const auto& triangle : list)
        for (const auto v : triangle)
          extents.add(mesh_.position(v));
      write_entity(out, static_cast<std::int32_t>(surface), extents,
                   group_of(mesh_.surfaces(), surface));
    }
    for (const auto& [region, list] : tets_)
      write_entity(out, region, extents_of(list), group_of(mesh_.regions(), region));
    out << "\n$EndEntities\n";
  }

  [[nodiscard]] box extents_of(const std::vector<tet_id>& list) const {
    box extents;
    if (list.size() == live_tets_.slots.size()) {  // Each vertex once, not for each tet.
      for (const auto v : vertices_.slots)
        extents.add(mesh_.position(v));
      return extents;
    }
    for (const auto t : list)
      for (const auto v : mesh_.tet_at(t).v)
        extents.add(mesh_.position(v));
    return extents;
  }

  void write_nodes(std::ostream& out) const {
    const auto count = static_cast<std::uint64_t>(vertices_.slots.size());
    out << "$Nodes\n";
    for (const std::uint64_t number : {std::uint64_t{1}, count, std::uint64_t{1}, count})
      put(out, number);
    put<std::int32_t>(out, 3);
    put<std::int32_t>(out, tets_.empty() ? 1 : tets_.begin()->first);
    put<std::int32_t>(out, 0);
    put(out, count);
    {
      number_buffer numbers(out);
      for (std::uint64_t i = 1; i <= count; ++i)
        numbers.put(i);
      for (const auto v : vertices_.slots)
        numbers.put(point(v));
    }
    out << "\n$EndNodes\n";
  }

  [[nodiscard]] std::uint64_t node(vertex_id v) const { return vertices_.index[v] + 1ull; }

  void begin_block(std::ostream& out, int dimension, std::int32_t tag, int type,
                   std::size_t count) const {
    put<std::int32_t>(out, dimension);
    put(out, tag);
    put<std::int32_t>(out, type);
    put<std::uint64_t>(out, count);
  }

  void write_elements(std::ostream& out) const {
    std::uint64_t total = live_tets_.slots.size();
    for (const auto& [surface, list] : triangles_)
      total += list.size();
    out << "$Elements\n";
    put<std::uint64_t>(out, triangles_.size() + tets_.size());
    put(out, total);
    put<std::uint64_t>(out, 1);
    put(out, total);
    std::uint64_t number = 0;
    for (const auto& [surface, list] : triangles_) {
      begin_block(out, 2, static_cast<std::int32_t>(surface), 2, list.size());
      number_buffer numbers(out);
      for (const auto& triangle : list) {
        numbers.put(++number);
        for (const auto v : triangle)
          numbers.put(node(v));
      }
    }
    for (const auto& [region, list] : tets_) {
      begin_block(out, 3, region, 4, list.size());
      number_buffer numbers(out);
      for (const auto t : list) {
        numbers.put(++number);
        for (const auto v : mesh_.tet_at(t).v)
          numbers.put(node(v));
      }
    }
    out << "\n$EndElements\n";
  }

  const mesh_version& mesh_;
  double scale_;
  compaction vertices_;
  compaction live_tets_;
  std::map<surface_id, triangle_list> triangles_;
  std::map<region_id, std::vector<tet_id>> tets_;
};

}  // namespace

expected<void> formats::msh::write(const file_target& to, const mesh_version& mesh,
                                   const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  for (const auto& row : mesh.surfaces())
    if (row.id < INT32_MIN || row.id > INT32_MAX)
      return fail(ec::invalid_argument,
                  "surface id " + std::to_string(row.id) + " does not fit into a MSH file");
  return to.write([&](std::ostream& out) { msh_writer(mesh, 1 / *unit).write(out); });
}

}  // namespace tedit
