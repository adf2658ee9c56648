// SPDX-License-Identifier: AGPL-3.0-or-later
// What passes between this program and `tedit-med`, which alone has libmed and HDF5 in it. What it
// answers is a stranger's word: a file may have made it do anything.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/io/read_mesh.hpp"

namespace tedit {

/// Bytes of a group's, a family's or mesh's, and a unit's name in MED.
inline constexpr std::size_t longest_med_group = 80;
inline constexpr std::size_t longest_med_name = 64;
inline constexpr std::size_t longest_med_unit = 16;

/// How often an answer may be as large as the MED file: HDF5 may hold it packed.
inline constexpr std::uint64_t most_unpacked = 16;

/// A mesh as MED has it: nodes by their places from 1, corners in MED's order, families.
struct med_content {
  struct family {
    std::int32_t number = 0;
    std::string name = {};
    std::vector<std::string> groups = {};
  };
  /// Elements of one kind: so many nodes each, and their families (0: none).
  struct elements {
    std::vector<std::int32_t> nodes = {};
    std::vector<std::int32_t> families = {};
  };

  std::string name;                 ///< Of the mesh.
  std::string unit;                 ///< Of the axes, as the file has it; empty: it says none.
  std::vector<double> coordinates;  ///< Three for each node.
  std::vector<std::int32_t> node_families;  ///< Of each node, or none at all.
  elements tets;                            ///< TETRA4.
  elements tets10;                          ///< TETRA10: four corners, six middles.
  elements triangles;                       ///< TRIA3, and the corners of TRIA6 and TRIA7.
  std::vector<family> families;
  std::vector<std::string> notices;  ///< What was left out, for people.
};

/// Whether bytes begin as HDF5 files do.
[[nodiscard]] bool is_hdf5(std::span<const char> bytes);

/// A mesh to write; `tedit-med` answers with a file or `to_answer` of an error.
[[nodiscard]] std::vector<char> to_bytes(const med_content& content);
/// The inverse. Errors: `internal` where the bytes are none of that.
[[nodiscard]] expected<med_content> content_from(std::span<const char> bytes);

/// What a file's content is as a mesh: groups of faces are surfaces, those of tets regions; each
/// number is checked. Errors: `bad_input`, `out_of_memory`. Cost: O(n log n).
[[nodiscard]] expected<read_mesh> mesh_from(med_content content);

/// That it was refused, as an answer.
[[nodiscard]] std::vector<char> to_answer(const error& why);
/// The error that an answer is, if it is one.
[[nodiscard]] std::optional<error> refusal_in(std::span<const char> answer);

/// Processor time that `tedit-med` may use up for so many bytes; it ends itself (SIGPROF).
[[nodiscard]] std::chrono::seconds med_time(std::size_t bytes);

/// Has `tedit-med` read a file, or write the one that `to_bytes` made. Errors: what it refuses;
/// `service_unavailable` where the program is not there, `timeout`, `out_of_memory`, and
/// `bad_input` where the file ended it.
[[nodiscard]] expected<std::vector<char>> ask_med(std::span<const char> question);

}  // namespace tedit
