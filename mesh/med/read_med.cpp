// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "mesh/med/med_file.hpp"
#include "mesh/med/med_jobs.hpp"

namespace tedit::med {

namespace {

/// Of names in one sentence; a hostile file has as many as it likes.
constexpr std::size_t most_names = 12;

struct element_kind {
  med_geometry_type type;
  const char* name;
};

/// What has a volume and is no tet.
constexpr std::array other_solids{element_kind{MED_HEXA8, "hexahedra (HEXA8)"},
                                  element_kind{MED_PENTA6, "prisms (PENTA6)"},
                                  element_kind{MED_PYRA5, "pyramids (PYRA5)"},
                                  element_kind{MED_HEXA20, "hexahedra (HEXA20)"},
                                  element_kind{MED_HEXA27, "hexahedra (HEXA27)"},
                                  element_kind{MED_PENTA15, "prisms (PENTA15)"},
                                  element_kind{MED_PENTA18, "prisms (PENTA18)"},
                                  element_kind{MED_PYRA13, "pyramids (PYRA13)"},
                                  element_kind{MED_OCTA12, "hexagonal prisms (OCTA12)"},
                                  element_kind{MED_POLYHEDRON, "polyhedra"}};

/// What cannot be a face of a tet.
constexpr std::array other_faces{
  element_kind{MED_QUAD4, "quadrangles (QUAD4)"}, element_kind{MED_QUAD8, "quadrangles (QUAD8)"},
  element_kind{MED_QUAD9, "quadrangles (QUAD9)"}, element_kind{MED_POLYGON, "polygons"},
  element_kind{MED_POLYGON2, "quadratic polygons"}};

/// One mesh of the file at one time.
struct mesh_at {
  std::string name;
  med_int space = 0;
  med_int dimension = 0;
  med_mesh_type type = MED_UNDEF_MESH_TYPE;
  med_axis_type axes = MED_UNDEF_AXIS_TYPE;
  std::string unit;
  med_int steps = 0;
  med_int step = MED_NO_DT;
  med_int iteration = MED_NO_IT;
};

class med_reading {
public:
  explicit med_reading(std::span<const char> bytes) : file_(bytes), bytes_(bytes.size()) {}

  med_content run() {
    choose_mesh();
    refuse_others();
    out_.name = mesh_.name;
    out_.unit = mesh_.unit;
    read_nodes();
    out_.tets = read_elements(MED_TETRA4, 4, 4);
    out_.tets10 = read_elements(MED_TETRA10, 10, 10);
    read_triangles();
    read_families();
    say_fields();
    return std::move(out_);
  }

private:
  // -- which mesh --------------------------------------------------------------------------------

  mesh_at describe(int place) {
    const auto axes = MEDmeshnAxis(file_.id(), place);
    if (axes < 0 || axes > 3)
      refuse_damaged("mesh " + std::to_string(place));
    std::array<char, MED_NAME_SIZE + 1> name{};
    std::array<char, MED_COMMENT_SIZE + 1> description{};
    std::array<char, MED_SNAME_SIZE + 1> time{};
    std::array<char, 3 * MED_SNAME_SIZE + 1> axis{};
    std::array<char, 3 * MED_SNAME_SIZE + 1> unit{};
    med_sorting_type sorting = MED_SORT_UNDEF;
    mesh_at made;
    if (MEDmeshInfo(file_.id(), place, name.data(), &made.space, &made.dimension, &made.type,
                    description.data(), time.data(), &sorting, &made.steps, &made.axes, axis.data(),
                    unit.data()) < 0)
      refuse_damaged("mesh " + std::to_string(place));
    made.name = std::string(name.data(), strnlen(name.data(), MED_NAME_SIZE));
    made.unit = text_in(unit.data(), MED_SNAME_SIZE);
    med_float when = 0;
    if (made.type == MED_UNSTRUCTURED_MESH && made.steps > 0 &&
        MEDmeshComputationStepInfo(file_.id(), made.name.c_str(), 1, &made.step, &made.iteration,
                                   &when) < 0)
      refuse_damaged("the first step of mesh \"" + made.name + "\"");
    return made;
  }

  /// The one with volume; several are refused by their names, and none.
  void choose_mesh() {
    const auto count = MEDnMesh(file_.id());
    if (count < 0)
      refuse_damaged("how many meshes there are");
    std::vector<mesh_at> solid;
    std::string others;
    for (int place = 1; place <= count; ++place) {
      auto one = describe(place);
      mesh_ = one;
      if (one.type == MED_UNSTRUCTURED_MESH && has_solids())
        solid.push_back(std::move(one));
      else if (place <= static_cast<int>(most_names))
        others += (others.empty() ? "\"" : ", \"") + one.name + "\" (" + kind_of(one) + ")";
    }
    if (solid.empty())
      refuse(ec::bad_input,
             others.empty() ? "the file has no mesh" : "the file has no mesh with tets: " + others,
             "Mesh the volume with tetrahedra and export that mesh");
    if (solid.size() > 1)
      refuse(
        ec::unsupported_format,
        "the file has " + std::to_string(solid.size()) + " meshes of solids: " + names_of(solid),
        "Export one of them alone");
    mesh_ = solid.front();
    if (!others.empty())
      out_.notices.push_back("other meshes of the file are left out: " + others);
    if (mesh_.steps > 1)
      out_.notices.push_back("the mesh changes in " + std::to_string(mesh_.steps) +
                             " steps; the first is read");
  }

  static std::string kind_of(const mesh_at& one) {
    return one.type == MED_STRUCTURED_MESH ? "a grid"
                                           : "dimension " + std::to_string(one.dimension);
  }

  static std::string names_of(const std::vector<mesh_at>& all) {
    std::string text;
    for (std::size_t i = 0; i < std::min(all.size(), most_names); ++i)
      text += (text.empty() ? "\"" : ", \"") + all[i].name + "\"";
    return text;
  }

  bool has_solids() {
    if (count_of(MED_TETRA4) > 0 || count_of(MED_TETRA10) > 0)
      return true;
    return std::ranges::any_of(other_solids,
                               [this](const auto& kind) { return count_of(kind.type) > 0; });
  }

  void refuse_others() {
    if (mesh_.space != 3)
      refuse(ec::bad_input,
             "mesh \"" + mesh_.name + "\" has " + std::to_string(mesh_.space) +
               " coordinates for each node, not three",
             "Export it with three coordinates for each node");
    if (mesh_.axes != MED_CARTESIAN)
      refuse(ec::unsupported_format, "mesh \"" + mesh_.name + "\" has no cartesian coordinates",
             "Export it in cartesian coordinates");
    for (const auto& kinds :
         {std::span<const element_kind>(other_solids), std::span<const element_kind>(other_faces)})
      for (const auto& kind : kinds)
        if (const auto count = count_of(kind.type); count > 0)
          refuse(ec::unsupported_format,
                 std::string("the file holds ") + kind.name + ", " + std::to_string(count) +
                   " in all; only tetrahedra (TETRA4, TETRA10) are supported",
                 "Mesh the volume with tetrahedra");
  }

  // -- its content -------------------------------------------------------------------------------

  med_int how_many(med_entity_type entity, med_geometry_type kind, med_data_type data) {
    med_bool changed = MED_FALSE;
    med_bool moved = MED_FALSE;
    return MEDmeshnEntity(file_.id(), mesh_.name.c_str(), mesh_.step, mesh_.iteration, entity, kind,
                          data, entity == MED_NODE ? MED_NO_CMODE : MED_NODAL, &changed, &moved);
  }

  /// Polygons and polyhedra say where each one begins, and where the last one ends.
  std::int64_t count_of(med_geometry_type kind) {
    const bool polygons = kind == MED_POLYGON || kind == MED_POLYGON2;
    const bool variable = polygons || kind == MED_POLYHEDRON;
    const auto data = polygons ? MED_INDEX_NODE : variable ? MED_INDEX_FACE : MED_CONNECTIVITY;
    const auto count = how_many(MED_CELL, kind, data);
    return variable ? count - 1 : count;
  }

  /// Refuses before memory is taken.
  std::size_t checked(std::int64_t count, std::size_t item_bytes, const std::string& what) {
    if (count < 0)
      refuse_damaged("how many " + what + " there are");
    const auto items = static_cast<std::uint64_t>(count);
    if (items > most_unpacked * bytes_ / item_bytes)
      refuse(ec::bad_input,
             "the file says that it has " + std::to_string(count) + " " + what + ", but it has " +
               std::to_string(bytes_) + " bytes",
             "Write or copy the file again");
    return items;
  }

  void read_nodes() {
    const auto count = checked(how_many(MED_NODE, MED_NONE, MED_COORDINATE), 24, "nodes");
    out_.coordinates.resize(3 * count);
    if (count > 0 &&
        MEDmeshNodeCoordinateRd(file_.id(), mesh_.name.c_str(), mesh_.step, mesh_.iteration,
                                MED_FULL_INTERLACE, out_.coordinates.data()) < 0)
      refuse_damaged("the coordinates of the nodes");
    out_.node_families = read_family_numbers(MED_NODE, MED_NONE, count, "nodes");
    if (std::ranges::all_of(out_.node_families, [](auto family) { return family == 0; }))
      out_.node_families.clear();
  }

  std::vector<std::int32_t> read_family_numbers(med_entity_type entity, med_geometry_type kind,
                                                std::size_t count, const std::string& what) {
    std::vector<std::int32_t> result(count);
    const auto there = how_many(entity, kind, MED_FAMILY_NUMBER);
    if (there <= 0 || count == 0)
      return result;
    if (static_cast<std::size_t>(there) != count)
      refuse(ec::bad_input,
             "the file has " + std::to_string(there) + " family numbers for " +
               std::to_string(count) + " " + what,
             "Write the file again");
    if (MEDmeshEntityFamilyNumberRd(file_.id(), mesh_.name.c_str(), mesh_.step, mesh_.iteration,
                                    entity, kind, result.data()) < 0)
      refuse_damaged("the families of " + what);
    return result;
  }

  /// With the first `kept` nodes of each.
  med_content::elements read_elements(med_geometry_type kind, std::size_t width, std::size_t kept) {
    med_content::elements result;
    const auto what = "elements of " + std::to_string(width) + " nodes";
    const auto there = how_many(MED_CELL, kind, MED_CONNECTIVITY);
    const auto count = checked(there, width * sizeof(med_int), what);
    if (count == 0)
      return result;
    std::vector<med_int> all(width * count);
    if (MEDmeshElementConnectivityRd(file_.id(), mesh_.name.c_str(), mesh_.step, mesh_.iteration,
                                     MED_CELL, kind, MED_NODAL, MED_FULL_INTERLACE, all.data()) < 0)
      refuse_damaged("the nodes of " + what);
    result.families = read_family_numbers(MED_CELL, kind, count, what);
    if (kept == width)
      result.nodes = std::move(all);
    else
      for (std::size_t i = 0; i < count; ++i)
        result.nodes.insert(result.nodes.end(),
                            all.begin() + static_cast<std::ptrdiff_t>(width * i),
                            all.begin() + static_cast<std::ptrdiff_t>(width * i + kept));
    return result;
  }

  void read_triangles() {
    for (const auto& [kind, width] :
         {std::pair(MED_TRIA3, std::size_t{3}), std::pair(MED_TRIA6, std::size_t{6}),
          std::pair(MED_TRIA7, std::size_t{7})}) {
      const auto more = read_elements(kind, width, 3);
      auto& all = out_.triangles;
      all.nodes.insert(all.nodes.end(), more.nodes.begin(), more.nodes.end());
      all.families.insert(all.families.end(), more.families.begin(), more.families.end());
    }
  }

  void read_families() {
    const auto count = MEDnFamily(file_.id(), mesh_.name.c_str());
    checked(count, 1, "families");
    for (int place = 1; place <= count; ++place) {
      const auto groups =
        checked(MEDnFamilyGroup(file_.id(), mesh_.name.c_str(), place), MED_LNAME_SIZE, "groups");
      std::array<char, MED_NAME_SIZE + 1> name{};
      std::vector<char> texts(groups * MED_LNAME_SIZE + 1);
      med_content::family one;
      med_int number = 0;
      if (MEDfamilyInfo(file_.id(), mesh_.name.c_str(), place, name.data(), &number, texts.data()) <
          0)
        refuse_damaged("family " + std::to_string(place));
      one.number = number;
      one.name = text_in(name.data(), MED_NAME_SIZE);
      for (std::size_t i = 0; i < groups; ++i)
        one.groups.push_back(text_in(texts.data() + i * MED_LNAME_SIZE, MED_LNAME_SIZE));
      std::erase(one.groups, "");
      out_.families.push_back(std::move(one));
    }
  }

  void say_fields() {
    const auto count = MEDnField(file_.id());
    if (count > 0)
      out_.notices.push_back(std::to_string(count) +
                             (count == 1 ? " field of results is" : " fields of results are") +
                             " left out");
  }

  med_file file_;
  std::size_t bytes_;
  mesh_at mesh_;
  med_content out_;
};

}  // namespace

med_content read_med(std::span<const char> bytes) {
  return med_reading(bytes).run();
}

}  // namespace tedit::med
