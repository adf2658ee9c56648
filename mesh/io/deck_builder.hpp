// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mesh/io/file_mesh.hpp"

namespace tedit {

/// What is alike in the readers of decks: names that comments keep, loads by node numbers, regions
/// of sets, and what was left out.
class deck_builder {
public:
  file_mesh mesh;
  std::string length_unit;
  std::string mesh_notice;  ///< A sentence of the reader's own, told with the others.
  deck loads;               ///< Without supports, forces and pressures, which `finish` adds.

  /// "TEdit surface 12 is SURFACE-12: Bore", "TEdit region ..." and "TEdit unit mm": what our
  /// writers say in comments. True where the comment is one of these.
  bool read_comment(std::string_view comment);

  /// The sets that comments name as regions, in capitals.
  [[nodiscard]] std::vector<std::string> region_comment_names() const;

  void add_support(std::uint64_t node, int component, double value);
  void add_force(std::uint64_t node, vec3 value);
  void add_pressure(const std::array<std::uint64_t, 3>& corners, double value);

  /// Something of the file that no load case and no mesh of ours can hold, by the name that the
  /// file has for it, with its line. Each name is said once, with how often it stands there.
  void leave_out(const std::string& what, std::size_t line);

  /// It was held after all, by the load case that stands in the file.
  void forget(const std::string& what) { left_out_.erase(what); }

  /// The tets of each set become a region: its id is what a comment says, the number at the end of
  /// its name where these are distinct, else its place. A tet of two sets stays with the first.
  /// Returns the ids in the order of `names`.
  std::vector<region_id> number_regions(const std::vector<std::string>& names);

  /// `file_mesh::finish`, with the names of comments, supports and loads, and sentences about what
  /// was left out. Throws `file_failure`.
  [[nodiscard]] read_mesh finish();

private:
  struct named {
    std::int64_t id = 0;
    std::string name;
  };
  struct nodal {
    std::uint64_t node;
    int component;
    vec3 value;
  };
  struct facet_load {
    std::array<std::uint64_t, 3> corners;
    double value;
  };

  void name_surfaces();
  void add_loads(read_mesh& out);
  void add_forces(read_mesh& out);
  std::optional<vertex_id> vertex_in_tet(std::uint64_t node);
  void say_left_out(read_mesh& out) const;

  std::map<std::string, named> surface_comments_;  ///< By the name in the file, in capitals.
  std::map<std::string, named> region_comments_;
  std::vector<nodal> supports_;
  std::vector<nodal> forces_;
  std::vector<facet_load> pressures_;
  std::vector<bool> is_used_;
  std::map<std::string, std::pair<std::size_t, std::size_t>> left_out_;  ///< First line, count.
  std::size_t stray_ = 0;  ///< Forces on nodes that no tet has.
};

}  // namespace tedit
