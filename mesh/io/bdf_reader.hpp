// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/io/bdf_cards.hpp"
#include "mesh/io/deck_builder.hpp"

namespace tedit {

/// Reads a deck of Nastran; used once. The mesh is read in `bdf_reader.cpp`, materials, supports
/// and loads in `bdf_loads.cpp`.
class bdf_reader {
public:
  explicit bdf_reader(std::span<const char> bytes) : in_(bytes) {}

  /// Throws `file_failure`.
  [[nodiscard]] read_mesh run();

private:
  using handler = void (bdf_reader::*)(const bdf_card&);
  struct row {
    const char* name;
    handler read;
  };
  /// A load, until it is known which of them the case control asks for.
  struct nodal_force {
    std::uint64_t set;
    std::uint64_t node;
    vec3 value;
  };
  struct face_pressure {
    std::uint64_t set;
    std::array<std::uint64_t, 3> corners;
    double value;
  };
  struct held_node {
    std::uint64_t set;
    std::uint64_t node;
    int component;
    double value;
  };
  struct gravity_card {
    std::uint64_t set;
    vec3 value;
  };
  struct combination {
    double factor = 1;
    std::vector<std::pair<double, std::uint64_t>> parts;
  };
  struct surface_face {
    std::uint64_t surface;
    std::array<std::uint64_t, 3> corners;
  };

  static const row* find(const std::string& name);

  void read_comment(std::string_view line);
  void read_case_control(std::string_view line);
  void check_behind_coordinates(const bdf_card& card);
  void read_grid(const bdf_card& card);
  void read_tetra(const bdf_card& card);
  void read_triangle(const bdf_card& card);
  void refuse_element(const bdf_card& card);
  void refuse_system(const bdf_card& card);
  void refuse_include(const bdf_card& card);
  void read_solid(const bdf_card& card);
  void read_bsurfs(const bdf_card& card);
  void read_material(const bdf_card& card);
  void read_spc(const bdf_card& card);
  void read_spc1(const bdf_card& card);
  void read_spcadd(const bdf_card& card);
  void read_force(const bdf_card& card);
  void read_load(const bdf_card& card);
  void read_pload4(const bdf_card& card);
  void read_grav(const bdf_card& card);

  [[nodiscard]] std::uint64_t number(const bdf_card& card, std::size_t field, const char* what);
  [[nodiscard]] double real(const bdf_card& card, std::size_t field, const char* what);
  void hold(std::uint64_t set, std::uint64_t node, std::string_view components, double value,
            const bdf_card& card);

  void make_regions();
  void make_surfaces();
  void say_what_is_not_there(const std::map<std::uint64_t, double>& asked);
  void take_loads();
  void take_pressures();
  [[nodiscard]] std::map<std::uint64_t, double> asked_loads() const;
  [[nodiscard]] bool is_asked_support(std::uint64_t set) const;

  line_cursor in_;
  deck_builder out_;
  bool in_bulk_ = false;
  bool has_begin_ = false;
  bool has_end_ = false;
  std::vector<std::string> nothing_asked_;  ///< Sentences about sets that are not there.
  std::size_t subcases_ = 0;
  std::optional<std::uint64_t> asked_load_;
  std::optional<std::uint64_t> asked_spc_;
  std::vector<std::uint64_t> property_of_tet_;
  std::map<std::uint64_t, std::uint64_t> material_of_property_;
  std::map<std::uint64_t, std::size_t> material_places_;  ///< In `out_.loads.materials`.
  std::map<std::uint64_t, std::string> names_;            ///< Of properties, by comments.
  std::map<std::uint64_t, std::size_t> shells_;           ///< Sets of faces, by property.
  std::vector<surface_face> surface_faces_;
  std::vector<held_node> held_;
  std::vector<nodal_force> forces_;
  std::vector<face_pressure> pressures_;
  std::vector<bdf_card> ploads_;
  std::vector<gravity_card> gravity_;
  std::map<std::uint64_t, combination> combinations_;
  std::map<std::uint64_t, std::set<std::uint64_t>> spc_sums_;
  std::uint64_t members_left_ = 20'000'000;  ///< Of THRU: few characters name many nodes.
};

}  // namespace tedit
