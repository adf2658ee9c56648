// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/for_people.hpp"
#include "mesh/field.hpp"
#include "mesh/types.hpp"

/// The table of file formats: what the command line, the server, recipes and the window know of
/// them. A new format is a row here and its writer in `mesh/io`; docs and translations beside it.
/// Who needs no more than what a format is, as a client does, includes this alone; what reads and
/// writes them is in `mesh/io/formats.hpp`.
namespace tedit {

class file_target;
class mesh_version;
struct read_mesh;

/// Red, green and blue.
using byte_colour = std::array<std::uint8_t, 3>;

/// How a part looks in a file that keeps colours: by its surfaces, vertices or facets, or neither.
struct file_colours {
  std::map<surface_id, byte_colour> of_surfaces = {};  ///< Those that are left out have none.
  /// Of each vertex slot, a place in `palette`. Steps, for a file names each colour once.
  std::vector<std::uint8_t> of_vertices = {};
  std::vector<std::uint8_t> of_facets = {};  ///< Likewise of each facet slot.
  std::vector<byte_colour> palette = {};
};

/// What a file has beside the mesh itself.
struct file_terms {
  std::string length_unit = "mm";  ///< Of coordinates; formats that keep fields take metres.
  std::vector<field> fields = {};
  std::vector<std::pair<std::string, std::string>> notes = {};  ///< What the fields are worth.
  file_colours colours = {};
  std::string title = {};  ///< Of the part, for people; UTF-8.
};

/// Errors: `io_error`; `invalid_argument` for the unit or for what the format cannot hold.
using file_writer = expected<void>(const file_target&, const mesh_version&, const file_terms&);
/// Errors: `bad_input`, `unsupported_format`.
using file_reader = expected<read_mesh>(std::span<const char> bytes);
/// Whether bytes are a file of the format. Cheap: it looks at the beginning and the size.
using file_recogniser = bool(std::span<const char> bytes);

/// What a file of the format keeps of a version, beside its boundary.
struct kept_in_file {
  bool tets = false;
  bool surfaces = false;  ///< Their ids.
  bool fields = false;    ///< Of the last solve.
  bool unit = false;      ///< The file itself says the unit of its coordinates.
  bool loads = false;     ///< Materials, supports and loads: read, and written by `tedit export`.
  bool colours = false;   ///< Of surfaces or vertices, where the writer is given some.
};

struct file_format {
  std::string_view name;   ///< Also the suffix of such files, without its dot.
  std::string_view title;  ///< For people who choose one: "Mesh".
  std::string_view kind;   ///< For sentences about a file: "an STL surface".
  kept_in_file keeps;
  std::string_view also = {};  ///< Other suffixes of such files, with blanks between them.
  bool reads = false;          ///< A version can be made from such a file.
  bool writes = false;
};

/// The rows. A format is read when it has a `read`, written when it has a `write`; `mesh/io` has
/// the functions.
namespace formats {

/// Gmsh 4.1, binary: surface ids as entity tags of dimension 2, region ids of dimension 3, names as
/// physical groups, interface triangles. Refuses ids beyond 32 bits. Read are MSH 2.2 and 4.1,
/// ASCII and binary (either byte order), ids and names as they are written (2.2: second tag of an
/// element); quadratic tets become their corner tets with a notice, points and lines are skipped,
/// other volume elements refused by name.
struct msh {
  static constexpr file_format about{
    "msh", for_people("formats", "Mesh"), "a Gmsh mesh", {.tets = true, .surfaces = true}};
  static file_writer write;
  static file_reader read;
};

/// Gmsh 2.2, text, as older programs read it: the same but interfaces, which are triangles like
/// others there. Gmsh has this suffix for it, too.
struct msh2 {
  static constexpr file_format about{"msh2",
                                     for_people("formats", "Mesh, Gmsh 2.2"),
                                     "a Gmsh mesh",
                                     {.tets = true, .surfaces = true}};
  static file_writer write;
  static file_reader read;
};

/// A deck of CalculiX or Abaqus. Tets are C3D4; regions element sets, surfaces *SURFACE blocks of
/// element faces; ids, names and unit in comments. Read are C3D4 and C3D10, sets with GENERATE,
/// surfaces by faces, by nodes, or as shells; materials, supports and loads of the first step.
struct inp {
  static constexpr file_format about{"inp",
                                     for_people("formats", "Deck of CalculiX or Abaqus"),
                                     "an input deck of CalculiX or Abaqus",
                                     {.tets = true, .surfaces = true, .unit = true, .loads = true}};
  static file_writer write;
  static file_reader read;
  static file_recogniser recognises;
};

/// A deck of Nastran: CTETRA, regions as properties, surfaces as BSURFS; ids, names and unit in
/// comments. Coordinates have the 16 characters of large fields. Read are free, small and large
/// fields, CTETRA of 4 and 10 nodes, surfaces also as CTRIA3; MAT1, SPC, SPC1, FORCE, PLOAD4, GRAV
/// and LOAD as the case control asks for them.
struct bdf {
  static constexpr file_format about{"bdf",
                                     for_people("formats", "Deck of Nastran"),
                                     "a deck of Nastran",
                                     {.tets = true, .surfaces = true, .unit = true, .loads = true},
                                     "nas dat"};
  static file_writer write;
  static file_reader read;
  static file_recogniser recognises;
};

/// A universal file of I-DEAS, as Salome, Gmsh and others have it: datasets 164 (units), 2411, 2412
/// (111, 118 and triangles) and groups, which are named "surface 12: NAME" and "region 3: NAME".
/// Read are also groups of nodes and of other names.
struct unv {
  static constexpr file_format about{"unv",
                                     for_people("formats", "Universal file of I-DEAS"),
                                     "a universal file (UNV)",
                                     {.tets = true, .surfaces = true, .unit = true}};
  static file_writer write;
  static file_reader read;
  static file_recogniser recognises;
};

/// MED of Salome and code_aster, which is HDF5: surfaces as groups of TRIA3, regions as groups of
/// TETRA4, named as in UNV; the unit that of the axes. The program `tedit-med` reads and writes it:
/// no other has HDF5 in it. Read are also TETRA10 and TRIA6 and groups of other names. Errors also:
/// `service_unavailable` where the program is not there.
struct med {
  static constexpr file_format about{"med",
                                     for_people("formats", "MED of Salome and code_aster"),
                                     "a MED file",
                                     {.tets = true, .surfaces = true, .unit = true},
                                     "rmed"};
  static constexpr std::string_view program = "tedit-med";
  static file_writer write;
  static file_reader read;
  static file_recogniser recognises;
};

/// Live vertices and tets in slot order, in metres, with the region of each tet; surfaces, ids and
/// names as field data, so that the cells stay tets. Read are also files of others: text, base64
/// and raw data, plain or packed by zlib, triangles as surfaces.
struct vtu {
  static constexpr file_format about{
    "vtu",
    for_people("formats", "Fields for ParaView"),
    "a VTU file",
    {.tets = true, .surfaces = true, .fields = true, .unit = true}};
  static file_writer write;
  static file_reader read;
  static file_recogniser recognises;
};

/// Binary; it says neither surfaces nor the unit.
struct stl {
  static constexpr file_format about{
    "stl", for_people("formats", "Boundary"), "an STL surface", {}};
  static file_writer write;
  static file_recogniser recognises;
};

/// Wavefront, text: a group for each surface, of its name and id.
struct obj {
  static constexpr file_format about{
    "obj", for_people("formats", "Boundary with surfaces"), "an OBJ surface", {.surfaces = true}};
  static file_writer write;
  static file_recogniser recognises;
};

/// For 3D printing: an object of each region with its name, faces between regions in both of them;
/// several are parts of one. Surfaces are materials where they have colours, vertices have colours
/// of a group. Units are those that the format knows: um, mm, cm, m, in, ft. The same mesh gives
/// the same bytes.
struct threemf {
  static constexpr file_format about{"3mf",
                                     for_people("formats", "Part for 3D printing"),
                                     "a 3MF file",
                                     {.unit = true, .colours = true}};
  static file_writer write;
  static file_recogniser recognises;
};

/// Binary, to look at: colours of vertices, or of faces by their surface.
struct ply {
  static constexpr file_format about{
    "ply", for_people("formats", "Boundary with colours"), "a PLY surface", {.colours = true}};
  static file_writer write;
  static file_recogniser recognises;
};

/// glTF 2.0, binary, to look at: in metres, z turned up; a primitive for each surface, its material
/// with the surface's name and id (`extras.surface`) and colour, colours of vertices beside them.
struct glb {
  static constexpr file_format about{"glb",
                                     for_people("formats", "Boundary for viewers (glTF)"),
                                     "a glTF file",
                                     {.surfaces = true, .unit = true, .colours = true}};
  static file_writer write;
  static file_recogniser recognises;
};

/// In the order in which people are offered them.
using all = std::tuple<msh, vtu, stl, obj, threemf, ply, glb, inp, bdf, unv, med, msh2>;

template <class Format>
consteval file_format describe() {
  auto result = Format::about;
  result.reads = requires {
    Format::read;
  };
  result.writes = requires {
    Format::write;
  };
  return result;
}

template <class... Format>
consteval auto describe(const std::tuple<Format...>*) {
  return std::array{describe<Format>()...};
}

}  // namespace formats

inline constexpr auto file_formats = formats::describe(static_cast<formats::all*>(nullptr));

/// A whole document as one file; the server keeps and writes it, not `mesh/io`.
inline constexpr std::string_view document_format = "tedit";

/// The format of this name, or null.
[[nodiscard]] const file_format* find_format(std::string_view name);

/// The format whose name or other suffix this is, in any case; null where there is none.
[[nodiscard]] const file_format* format_of_suffix(std::string_view suffix);

/// The format to write a file in, by its suffix in any case. Errors: `invalid_argument` for one
/// that is not written, naming those that are.
[[nodiscard]] expected<const file_format*> format_for(const std::filesystem::path& file);

/// That there is no such format to write, but these: "Take msh, vtu or stl".
[[nodiscard]] error no_such_format(std::string_view name,
                                   std::span<const std::string_view> there_are);

/// The names of the formats that are written, in the table's order.
[[nodiscard]] std::vector<std::string_view> written_formats();

/// The suffixes of files that are read, the most usual first: "msh", "inp", ...
[[nodiscard]] std::vector<std::string_view> read_suffixes();

/// Those for a help text: "a mesh: .msh, .inp or .bdf".
[[nodiscard]] std::string read_formats_text();

/// Those that are written, for a help text: ".msh (mesh), .vtu (fields for ParaView) or .stl
/// (boundary)".
[[nodiscard]] std::string written_formats_text();

/// Those that keep colours: ".3mf, .ply or .glb".
[[nodiscard]] std::string coloured_formats_text();

}  // namespace tedit
