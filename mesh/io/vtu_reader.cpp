// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "base/units.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/file_mesh.hpp"
#include "mesh/io/line_cursor.hpp"
#include "mesh/io/vtu_data.hpp"
#include "mesh/io/vtu_field.hpp"

namespace tedit {

namespace {

/// Cell types of VTK that are looked at, and how many nodes they have.
enum vtk_cell { vtk_triangle = 5, vtk_tet = 10, vtk_triangle6 = 22, vtk_tet10 = 24 };

bool is_skipped(std::int64_t type) {
  for (const int one : {1, 2, 3, 4, 21, 35, 68})  // Points and lines.
    if (type == one)
      return true;
  return false;
}

const char* name_of_cell(std::int64_t type) {
  switch (type) {
    case 8:
    case 9:
    case 23:
    case 28:
      return "quadrangle";
    case 11:
    case 12:
    case 25:
    case 29:
      return "hexahedron";
    case 13:
    case 26:
      return "wedge";
    case 14:
    case 27:
      return "pyramid";
    case 42:
      return "polyhedron";
    default:
      return "cell";
  }
}

[[noreturn]] void refuse_vtu(ec code, std::string message, std::string remedy,
                             std::string where = {}) {
  throw file_failure{{code, std::move(message), std::move(remedy), std::move(where)}};
}

class vtu_reader {
public:
  explicit vtu_reader(std::span<const char> bytes) : text_(bytes.data(), bytes.size()) {}

  read_mesh run() {
    parse();
    const vtu_data data(encoding());
    const auto pieces = file_.child("UnstructuredGrid").children("Piece");
    if (pieces.begin() == pieces.end())
      refuse_vtu(ec::bad_input, "the file holds no piece of a grid", "Write the mesh again",
                 "UnstructuredGrid");
    if (std::distance(pieces.begin(), pieces.end()) != 1)
      refuse_vtu(ec::unsupported_format,
                 "the file holds " + std::to_string(std::distance(pieces.begin(), pieces.end())) +
                   " pieces; one is read",
                 "Write it as one piece, for example with ParaView's filter Clean to Grid",
                 place_of(*std::next(pieces.begin())));
    const auto piece = *pieces.begin();
    read_points(piece, data);
    read_cells(piece, data);
    read_own_surfaces(data);
    read_names(data);
    auto out = mesh_.finish();
    out.length_unit = unit_;
    return out;
  }

  point_field field_of_points(std::string_view name) {
    parse();
    const vtu_data data(encoding());
    const auto piece = file_.child("UnstructuredGrid").child("Piece");
    const auto array = find_point_array(piece.child("PointData"), name);
    const auto count = count_of(piece, "NumberOfPoints");
    const auto components = array.attribute("NumberOfComponents").as_ullong(1);
    constexpr std::uint64_t most_components = 9;
    if (components < 1 || components > most_components)
      fail_array(array.attribute("Name").as_string(),
                 "has " + std::to_string(components) + " components");
    const auto all = data.reals(array, components * count);
    point_field result{to_utf8(array.attribute("Name").as_string()), {}};
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0;
      for (std::size_t c = 0; c < components; ++c)
        sum += all[i * components + c] * all[i * components + c];
      result.values.push_back(components == 1 ? all[i] : std::sqrt(sum));
    }
    return result;
  }

private:
  /// The array of this name, or the only one whose name is this and a unit.
  static pugi::xml_node find_point_array(const pugi::xml_node& arrays, std::string_view name) {
    std::string known;
    std::vector<pugi::xml_node> with_unit;
    for (const auto& array : arrays.children("DataArray")) {
      const std::string own = array.attribute("Name").as_string();
      if (own == name)
        return array;
      const auto unit = own.find_last_of('_');
      if (unit != own.npos && own.substr(0, unit) == name)
        with_unit.push_back(array);
      known += (known.empty() ? "" : ", ") + shown(own);
    }
    if (with_unit.size() == 1)
      return with_unit.front();
    refuse_vtu(ec::invalid_argument,
               "the file has no field \"" + shown(std::string(name)) + "\" at its points",
               known.empty() ? "Take the file that \"tedit solve -o\" writes" : "It has " + known);
  }

  /// The XML ends where appended data begin, which are no XML.
  void parse() {
    auto head = std::string(text_);
    if (const auto at = text_.find("<AppendedData"); at != text_.npos) {
      const auto mark = text_.find('_', at);
      const auto end = text_.find('>', at);
      if (mark == text_.npos || end == text_.npos || mark < end)
        refuse_vtu(ec::bad_input, "the appended data do not begin with _",
                   "The file is cut off or damaged: write it again",
                   "byte offset " + std::to_string(at));
      const auto tag = text_.substr(at, end - at);
      is_base64_ = tag.find("\"base64\"") != tag.npos;
      if (!is_base64_ && tag.find("\"raw\"") == tag.npos)
        refuse_vtu(ec::unsupported_format, "the appended data are neither raw nor in base64",
                   "Write them as one of these", "byte offset " + std::to_string(at));
      appended_ = text_.substr(mark + 1);
      head = std::string(text_.substr(0, at)) + "</VTKFile>";
    }
    if (const auto ok = document_.load_buffer(head.data(), head.size()); !ok)
      refuse_vtu(ec::bad_input, std::string("the file is no sound XML: ") + ok.description(),
                 "It is cut off or damaged: write it again",
                 "byte offset " + std::to_string(ok.offset));
    file_ = document_.child("VTKFile");
    if (const std::string type = file_.attribute("type").as_string(); type != "UnstructuredGrid")
      refuse_vtu(ec::unsupported_format,
                 "this is a VTK file of type \"" + shown(type) + "\", not UnstructuredGrid",
                 "Write the volume mesh as an unstructured grid (.vtu)", place_of(file_));
  }

  vtu_encoding encoding() const {
    const std::string header = file_.attribute("header_type").as_string("UInt32");
    const std::string order = file_.attribute("byte_order").as_string("LittleEndian");
    const std::string compressor = file_.attribute("compressor").as_string();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      refuse_vtu(ec::unsupported_format,
                 "the file is packed by " + shown(compressor) + "; zlib is read",
                 "Write it without compression, or with zlib", place_of(file_));
    check_word("header_type", header, {"UInt32", "UInt64"});
    check_word("byte_order", order, {"LittleEndian", "BigEndian"});
    return {header == "UInt64", order == "BigEndian", !compressor.empty(), appended_, is_base64_};
  }

  void check_word(const char* attribute, const std::string& word,
                  const std::array<const char*, 2>& known) const {
    if (word != known[0] && word != known[1])
      refuse_vtu(
        ec::unsupported_format,
        std::string(attribute) + " is \"" + shown(word) + "\", not " + known[0] + " or " + known[1],
        "The file is damaged: write it again", place_of(file_));
  }

  static std::string place_of(const pugi::xml_node& node) {
    return "byte offset " + std::to_string(std::max<std::ptrdiff_t>(0, node.offset_debug()));
  }

  static std::uint64_t count_of(const pugi::xml_node& node, const char* attribute) {
    const std::string word = node.attribute(attribute).as_string();
    const auto count = integer_of(word);
    if (!count || *count < 0 || *count > std::int64_t{max_slots})
      refuse_vtu(ec::bad_input,
                 std::string(attribute) + " is \"" + shown(word) +
                   "\", not a whole number from 0 to " + std::to_string(max_slots),
                 "The file is damaged: write it again", place_of(node));
    return static_cast<std::uint64_t>(*count);
  }

  static pugi::xml_node array_named(const pugi::xml_node& parent, const char* name) {
    for (const auto& array : parent.children("DataArray"))
      if (upper(array.attribute("Name").as_string()) == upper(name))
        return array;
    return {};
  }

  void read_points(const pugi::xml_node& piece, const vtu_data& data) {
    const auto count = count_of(piece, "NumberOfPoints");
    const auto array = piece.child("Points").child("DataArray");
    if (!array)
      refuse_vtu(ec::bad_input, "the file holds no points", "Write the mesh again",
                 place_of(piece));
    if (array.attribute("NumberOfComponents").as_int(3) != 3)
      fail_array("Points", "has not 3 components");
    const auto values = data.reals(array, 3 * count);
    for (std::size_t i = 0; i < count; ++i) {
      const vec3 p{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
      if (!is_finite(p))
        refuse_vtu(ec::bad_input,
                   "point " + std::to_string(i) + " has a coordinate that is not a finite number",
                   "Write the mesh again", "point " + std::to_string(i));
      mesh_.add_node(i, p);
    }
  }

  /// What says where cells belong: our own name first, then those of other programs.
  static std::vector<std::int64_t> tags(const pugi::xml_node& piece, const vtu_data& data,
                                        std::uint64_t cells) {
    for (const auto* name : {"region", "gmsh:geometrical", "gmsh:physical", "CellEntityIds",
                             "MaterialIds", "medit:ref", "cell_tags", "PartId"})
      if (const auto array = array_named(piece.child("CellData"), name))
        if (array.attribute("NumberOfComponents").as_int(1) == 1)
          return data.integers(array, cells);
    return {};
  }

  void read_cells(const pugi::xml_node& piece, const vtu_data& data) {
    const auto count = count_of(piece, "NumberOfCells");
    const auto cells = piece.child("Cells");
    const auto offsets = data.integers(array_of(cells, "offsets"), count);
    const auto types = data.integers(array_of(cells, "types"), count);
    check_offsets(offsets);
    const auto total = offsets.empty() ? 0 : offsets.back();
    const auto nodes =
      data.integers(array_of(cells, "connectivity"), static_cast<std::uint64_t>(total));
    const auto tag = tags(piece, data, count);
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < count; ++c) {
      add_cell(c, types[c],
               std::span(nodes).subspan(static_cast<std::size_t>(begin),
                                        static_cast<std::size_t>(offsets[c] - begin)),
               tag.empty() ? std::nullopt : std::optional(tag[c]));
      begin = offsets[c];
    }
  }

  /// They say where each cell ends, so that they never go back.
  static void check_offsets(const std::vector<std::int64_t>& offsets) {
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < offsets.size(); ++c) {
      if (offsets[c] < begin || offsets[c] > offsets.back())
        refuse_vtu(ec::bad_input,
                   "cell " + std::to_string(c) + " ends at " + std::to_string(offsets[c]) +
                     " of the connectivity, where it begins at " + std::to_string(begin) +
                     " and all end at " + std::to_string(offsets.back()),
                   "The file is damaged: write it again", "cell " + std::to_string(c));
      begin = offsets[c];
    }
  }

  static pugi::xml_node array_of(const pugi::xml_node& cells, const char* name) {
    if (const auto array = array_named(cells, name))
      return array;
    refuse_vtu(ec::bad_input, std::string("the cells have no array \"") + name + "\"",
               "Write the mesh again", cells ? place_of(cells) : "Piece");
  }

  void add_cell(std::size_t cell, std::int64_t type, std::span<const std::int64_t> nodes,
                std::optional<std::int64_t> tag) {
    if (is_skipped(type))
      return;
    const std::size_t wanted = type == vtk_triangle    ? 3
                               : type == vtk_triangle6 ? 6
                               : type == vtk_tet       ? 4
                               : type == vtk_tet10     ? 10
                                                       : 0;
    if (wanted == 0)
      refuse_vtu(ec::unsupported_format,
                 std::string("the mesh holds a ") + name_of_cell(type) + " (cell type " +
                   std::to_string(type) + "); only tetrahedra are supported",
                 "Mesh the volume with tetrahedra", "cell " + std::to_string(cell));
    std::vector<std::uint64_t> numbers;
    for (const auto node : nodes) {
      if (node < 0 || static_cast<std::size_t>(node) >= mesh_.positions.size())
        refuse_vtu(ec::bad_input,
                   "cell " + std::to_string(cell) + " names point " + std::to_string(node) +
                     ", which does not exist",
                   "The file is damaged: write it again", "cell " + std::to_string(cell));
      numbers.push_back(static_cast<std::uint64_t>(node));
    }
    if (numbers.size() != wanted)
      refuse_vtu(ec::bad_input,
                 "cell " + std::to_string(cell) + " of type " + std::to_string(type) + " has " +
                   std::to_string(numbers.size()) + " points",
                 "The file is damaged: write it again", "cell " + std::to_string(cell));
    if (wanted == 4 || wanted == 10)
      mesh_.add_tet(cell, region_of(tag), numbers);
    else
      set_of(tag.value_or(0)).faces.push_back({numbers[0], numbers[1], numbers[2]});
  }

  static region_id region_of(std::optional<std::int64_t> tag) {
    return tag && *tag >= INT32_MIN && *tag <= INT32_MAX ? static_cast<region_id>(*tag) : 0;
  }

  file_mesh::face_set& set_of(surface_id id) {
    const auto [at, fresh] = places_.try_emplace(id, mesh_.face_sets.size());
    if (fresh)
      mesh_.face_sets.push_back({"", id, {}});
    return mesh_.face_sets[at->second];
  }

  /// What our writer keeps beside the cells, so that these stay tets alone.
  void read_own_surfaces(const vtu_data& data) {
    const auto fields = file_.child("UnstructuredGrid").child("FieldData");
    const auto ids = array_named(fields, "surface_of_triangle");
    const auto corners = array_named(fields, "surface_triangles");
    if (!ids || !corners)
      return;
    const auto count = count_of(ids, "NumberOfTuples");
    const auto surface = data.integers(ids, count);
    const auto nodes = data.integers(corners, 3 * count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::uint64_t, 3> face{};
      for (std::size_t k = 0; k < 3; ++k)
        face[k] = static_cast<std::uint64_t>(nodes[3 * i + k]);
      set_of(surface[i]).faces.push_back(face);
    }
  }

  void read_names(const vtu_data& data) {
    const auto fields = file_.child("UnstructuredGrid").child("FieldData");
    const auto pairs = [&](const char* ids_name, const char* names_name, const auto& take) {
      const auto ids = array_named(fields, ids_name);
      const auto names = array_named(fields, names_name);
      if (!ids || !names)
        return;
      const auto texts = data.texts(names);
      const auto numbers = data.integers(ids, count_of(ids, "NumberOfTuples"));
      for (std::size_t i = 0; i < std::min(numbers.size(), texts.size()); ++i)
        take(numbers[i], texts[i]);
    };
    pairs("surface_ids", "surface_names", [&](std::int64_t id, const std::string& name) {
      if (const auto at = places_.find(id); at != places_.end())
        mesh_.face_sets[at->second].name = name;
    });
    pairs("region_ids", "region_names", [&](std::int64_t id, const std::string& name) {
      mesh_.region_names.push_back({region_of(id), name});
    });
    if (const auto unit = array_named(fields, "length_unit")) {
      const auto texts = data.texts(unit);
      if (!texts.empty() && metres_per_unit(texts[0]))
        unit_ = texts[0];
    }
  }

  std::string_view text_;
  std::string_view appended_;
  bool is_base64_ = false;
  pugi::xml_document document_;
  pugi::xml_node file_;
  file_mesh mesh_;
  std::map<surface_id, std::size_t> places_;
  std::string unit_;
};

}  // namespace

expected<point_field> read_point_field(std::span<const char> bytes, std::string_view name) {
  if (!formats::vtu::recognises(bytes))
    return fail(ec::invalid_argument, "the mesh is no VTU file, which alone has fields",
                "Take the file that \"tedit solve -o\" writes");
  try {
    return vtu_reader(bytes).field_of_points(name);
  } catch (const file_failure& failure) {
    return fail(failure.reason);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "there is not enough memory to read this field",
                "Close other programs or take a coarser mesh");
  }
}

expected<read_mesh> formats::vtu::read(std::span<const char> bytes) {
  return guarded_read([&] { return vtu_reader(bytes).run(); });
}

}  // namespace tedit
