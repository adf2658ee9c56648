// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <queue>
#include <tuple>

#include "mesh/adapt/split_edges.hpp"
#include "mesh/adapt/wall_places.hpp"

namespace tedit {

/// The longest first; of equal ones always the same.
struct splitter_edge {
  double length = 0;  ///< m
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  [[nodiscard]] bool operator<(const splitter_edge& other) const {
    return std::tuple(length, a, b) < std::tuple(other.length, other.a, other.b);
  }
};

class edge_splitter;

struct split_rule {
  using test = std::function<bool(const edge_splitter&, const splitter_edge&)>;
  test is_too_long;
  /// A vertex has come, at a place on the edge of two others.
  std::function<void(vec3 place, std::uint32_t a, std::uint32_t b)> added;
  /// A vertex goes onto its round wall where no tet comes out worse than this, or than half of what
  /// it would be beside the wall.
  double least_quality = 0.1;
};

/// Halves edges until a rule finds none too long: always the longest edge of all tets around. New
/// vertices of the skin go onto its walls.
class edge_splitter {
public:
  /// All references outlive the splitter.
  edge_splitter(adapt_mesh& mesh, wall_places& walls, split_rule rule, std::size_t most_tets,
                const execution& run)
      : mesh_(mesh), walls_(walls), rule_(std::move(rule)), most_tets_(most_tets), run_(run) {}

  /// Errors: `invalid_parameter` when more than `most_tets` come out, `cancelled`.
  [[nodiscard]] expected<split_report> split_all();

  /// The walls whose triangles have the edge; none within the part. Cost: O(star of an end).
  [[nodiscard]] std::vector<surface_id> walls_at(const splitter_edge& e) const;

private:
  [[nodiscard]] std::vector<surface_id> walls_at(const splitter_edge& e,
                                                 const std::vector<std::uint32_t>& ring) const;
  void note_edges(const tet& corners);
  void note(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] splitter_edge longest_around() const;
  splitter_edge longest_from(splitter_edge e);
  [[nodiscard]] double worst_with(const splitter_edge& e, vec3 place) const;
  void split(const splitter_edge& e);

  adapt_mesh& mesh_;
  wall_places& walls_;
  split_rule rule_;
  std::size_t most_tets_;
  const execution& run_;
  std::priority_queue<splitter_edge> queue_;
  std::vector<std::uint32_t> ring_;
  split_report report_;
};

}  // namespace tedit
