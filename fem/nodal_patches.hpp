// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/element_operator.hpp"

namespace tedit::fem {

/// The stress of a displacement averaged around each corner node, by volume. Where materials meet
/// it jumps, so it is averaged within each one only: a patch is a corner node and a material.
class nodal_patches {
public:
  /// `p` must outlive the patches. `displacement`: m, 3 per node. Cost: O(elements), on all cores;
  /// stresses of elements are not kept.
  nodal_patches(const problem& p, const element_chunks& chunks,
                std::span<const double> displacement);

  [[nodiscard]] std::size_t count() const { return means_.size(); }
  /// The patches of a node, at least one.
  [[nodiscard]] std::size_t first_of(std::size_t node) const {
    return first_.empty() ? node : first_[node];
  }
  [[nodiscard]] std::size_t end_of(std::size_t node) const { return first_of(node + 1); }
  /// The patch of a node in an element that has the node.
  [[nodiscard]] std::size_t patch_in(std::size_t node, std::size_t element) const {
    std::size_t patch = first_of(node);
    if (!first_.empty())
      while (material_[patch] != problem_.element_materials[element])
        ++patch;
    return patch;
  }

  [[nodiscard]] std::uint32_t material_of(std::size_t patch) const {
    return material_.empty() ? 0 : material_[patch];
  }
  /// Volume of the patch's elements over that of all elements around the node.
  [[nodiscard]] double share_of(std::size_t patch) const {
    return share_.empty() ? 1 : share_[patch];
  }
  /// Pa, 6 components; zeros without elements.
  [[nodiscard]] const std::array<double, 6>& mean_of(std::size_t patch) const {
    return means_[patch];
  }
  [[nodiscard]] double volume_around(std::size_t node) const { return around_[node]; }  ///< m^3.

  [[nodiscard]] double volume() const { return all_.volume; }  ///< m^3, of the part.
  [[nodiscard]] double mass() const { return all_.mass; }      ///< kg.
  /// Linear tets: the element with the largest von Mises stress, and that. The first of several;
  /// `no_id` when there is no stress at all.
  [[nodiscard]] std::uint32_t worst_element() const { return all_.worst; }
  [[nodiscard]] double worst_von_mises() const { return all_.von_mises; }  ///< Pa.

private:
  /// What a pass over some elements adds up besides.
  struct totals {
    double volume = 0, mass = 0, von_mises = 0;
    std::uint32_t worst = no_id;
  };

  void find_materials();
  void sum_stress(const element_chunks& chunks, std::span<const double> displacement);
  void sum_meetings(std::span<const double> displacement);
  template <std::size_t Nodes>
  void add_elements(const struct chunk_elements& elements, std::array<double, 7>* sums,
                    totals& all) const;

  const problem& problem_;
  std::vector<std::uint32_t> meetings_;  ///< Nodes with several materials, ascending.
  std::vector<std::size_t> first_;       ///< Of each node; this and the next two empty for one
  std::vector<std::uint32_t> material_;  ///< material, where patch and node are the same.
  std::vector<double> share_;
  std::vector<std::array<double, 6>> means_;
  std::vector<double> around_;
  totals all_;
};

}  // namespace tedit::fem
