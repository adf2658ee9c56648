// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/face_key.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// All faces of a set of tets, in buckets by smallest corner: who shares a face, and which tet
/// faces have a given key. Cost: O(n) to build, O(bucket) to look up.
class face_table {
public:
  struct entry {
    vertex_id middle;
    vertex_id largest;
    /// odd << 31 | tet << 2 | local face: there are at most 2^29 tets, and four of these each.
    std::uint32_t slot;

    [[nodiscard]] std::uint32_t tet() const { return (slot & ~odd_flag) >> 2; }
    [[nodiscard]] int face() const { return static_cast<int>(slot & 3); }
    [[nodiscard]] bool odd() const { return (slot & odd_flag) != 0; }

    static constexpr std::uint32_t odd_flag = std::uint32_t{1} << 31;
  };

  face_table(const std::vector<tet>& tets, std::size_t vertices);

  /// Calls `visit(smallest corner, group)` for each distinct face; a group holds the one, two or
  /// (wrongly) more tet faces with these corners.
  template <class Visit>
  void for_each_face(Visit&& visit) const {
    for (vertex_id v = 0; v + 1 < first_.size(); ++v) {
      for (std::size_t i = first_[v], end = first_[v + 1]; i < end;) {
        std::size_t last = i + 1;
        while (last < end && entries_[last].middle == entries_[i].middle &&
               entries_[last].largest == entries_[i].largest)
          ++last;
        visit(v, std::span<const entry>(&entries_[i], last - i));
        i = last;
      }
    }
  }

  /// The tet faces with this key: none, one or two.
  [[nodiscard]] std::span<const entry> find(const face_key& key) const;

private:
  std::vector<std::uint32_t> first_;
  std::vector<entry> entries_;
};

}  // namespace tedit
