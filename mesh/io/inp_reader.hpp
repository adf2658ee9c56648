// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "mesh/io/deck_builder.hpp"
#include "mesh/io/inp_cards.hpp"
#include "mesh/io/number_sets.hpp"

namespace tedit {

/// Corners of the faces S1 to S4 (P1 to P4) of C3D4 and C3D10.
inline constexpr std::array<std::array<std::size_t, 3>, 4> inp_faces_of_tet{
  {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};

/// Reads a deck of Abaqus or CalculiX; used once. What each keyword becomes is in `inp_reader.cpp`
/// (the model) and `inp_loads.cpp` (materials, supports, loads).
class inp_reader {
public:
  explicit inp_reader(std::span<const char> bytes);

  /// Throws `file_failure`.
  [[nodiscard]] read_mesh run();

private:
  using handler = void (inp_reader::*)(const inp_keyword&);
  struct row {
    const char* keyword;
    handler read;
  };
  struct section {
    std::string elements;
    std::string material;
  };
  /// One line of *DLOAD or *DSLOAD, until faces and sets are known.
  struct face_load {
    std::string on;
    std::size_t face;  ///< 1 to 4; 0: `on` is a surface.
    double value;
    std::size_t line;
  };
  struct nodal_line {
    std::string on;  ///< A set or a number.
    int first = 0;
    int last = 0;
    double value = 0;
    bool is_support = false;
    std::size_t line = 0;
  };
  struct surface_line {
    std::size_t surface;  ///< Place in `mesh.face_sets`.
    std::string elements;
    std::size_t face;  ///< 1 to 4; 0: all that a shell has.
    std::size_t line;
  };

  static const row* find(const std::string& keyword);

  /// The next data line; false at a keyword line or the end. Comments are read on the way.
  bool next_data();
  void read_comment(std::string_view line);
  void skip(const inp_keyword&);
  void refuse_many(const inp_keyword& key);
  void refuse_include(const inp_keyword& key);
  void begin_part(const inp_keyword& key);
  void begin_instance(const inp_keyword& key);
  void read_heading(const inp_keyword& key);
  void read_nodes(const inp_keyword& key);
  void read_elements(const inp_keyword& key);
  [[noreturn]] static void refuse_element(const std::string& type,
                                          const std::vector<std::uint64_t>& numbers,
                                          std::size_t nodes, std::size_t line);
  void add_element(const std::string& type, const std::vector<std::uint64_t>& numbers,
                   const inp_keyword& key);
  void read_node_set(const inp_keyword& key);
  void read_element_set(const inp_keyword& key);
  void read_set(const inp_keyword& key, number_sets_of_deck& sets, const std::string& name);
  void add_member(number_sets_of_deck& sets, number_sets_of_deck::entry& to,
                  std::string_view field);
  void require_room(bool has_room);
  void read_surface(const inp_keyword& key);

  void begin_material(const inp_keyword& key);
  void read_elastic(const inp_keyword& key);
  void read_density(const inp_keyword& key);
  void read_section(const inp_keyword& key);
  void read_boundary(const inp_keyword& key);
  void read_cload(const inp_keyword& key);
  void read_dload(const inp_keyword& key);
  void read_dsload(const inp_keyword& key);
  void begin_step(const inp_keyword& key);
  void end_step(const inp_keyword& key);
  void read_procedure(const inp_keyword& key);
  [[nodiscard]] bool loads_count(const inp_keyword& key);
  [[nodiscard]] double real_or_zero(const std::vector<std::string_view>& fields, std::size_t i,
                                    const char* what);

  void make_regions();
  void give_materials();
  void resolve_surfaces();
  void resolve_loads();
  void resolve_nodal(const nodal_line& one);
  void resolve_face(const face_load& one);
  [[nodiscard]] std::vector<std::uint64_t> elements_under(const face_load& one) const;
  void add_faces(std::size_t set, std::int64_t element, std::size_t face, std::size_t line);
  void take_marked_case();

  line_cursor in_;
  deck_builder out_;
  number_sets_of_deck node_sets_;
  number_sets_of_deck element_sets_;
  std::vector<std::string> element_blocks_;    ///< ELSET of the blocks of tets, each once.
  std::vector<std::size_t> block_of_tet_;      ///< Place in `element_blocks_`, or past its end.
  std::map<std::string, std::size_t> shells_;  ///< Sets of faces made of shells, by ELSET.
  std::map<std::string, std::size_t> surface_places_;
  std::vector<surface_line> surface_lines_;
  std::vector<section> sections_;
  std::vector<nodal_line> nodal_lines_;
  std::vector<face_load> face_loads_;
  std::size_t parts_ = 0;
  std::size_t instances_ = 0;
  std::size_t steps_ = 0;
  std::size_t ended_steps_ = 0;
  bool reads_density_ = false;
};

}  // namespace tedit
