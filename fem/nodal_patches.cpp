// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/nodal_patches.hpp"

#include "fem/element_lanes.hpp"
#include "fem/incidence.hpp"
#include "fem/recovery.hpp"

namespace tedit::fem {

nodal_patches::nodal_patches(const problem& p, const element_chunks& chunks,
                             std::span<const double> displacement)
    : problem_(p) {
  if (p.constants.size() > 1)
    find_materials();
  polled_resize(means_, first_of(p.corner_count));
  polled_resize(around_, p.corner_count);
  sum_stress(chunks, displacement);
  sum_meetings(displacement);
}

void nodal_patches::find_materials() {
  const auto& p = problem_;
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  std::vector<std::uint32_t> one(p.corner_count, no_id);
  polled_for(p.element_count(), [&](std::size_t e) {
    for (std::size_t a = 0; a < 4; ++a) {
      const auto n = p.element_nodes[per * e + a];
      if (one[n] == no_id)
        one[n] = p.element_materials[e];
      else if (one[n] != p.element_materials[e])
        meetings_.push_back(n);
    }
  });
  sort_unique(meetings_);
  const auto corners = corners_at(p, meetings_);
  auto meeting = meetings_.begin();
  first_.reserve(p.corner_count + 1);
  polled_for(p.corner_count, [&](std::size_t n) {
    first_.push_back(material_.size());
    if (meeting == meetings_.end() || *meeting != n) {
      material_.push_back(one[n] == no_id ? 0 : one[n]);
      return;
    }
    std::vector<std::uint32_t> found;
    for (const auto corner : corners[static_cast<std::size_t>(meeting++ - meetings_.begin())])
      found.push_back(p.element_materials[corner / per]);
    sort_unique(found);
    material_.insert(material_.end(), found.begin(), found.end());
  });
  first_.push_back(material_.size());
  share_.assign(material_.size(), 1);
}

/// Adds stress times volume, and the volume, to the nodes of elements.
template <std::size_t Nodes>
TEDIT_INLINE void nodal_patches::add_elements(const chunk_elements& elements,
                                              std::array<double, 7>* sums, totals& all) const {
  for_each_lanes<Nodes>(elements, [&](const lane_group<Nodes>& group) TEDIT_INLINED {
    const auto add = [&](auto corner, const lanes6& stress) TEDIT_INLINED {
      unrolled<lane_count>([&](std::size_t lane) TEDIT_INLINED {
        if (lane >= group.count)
          return;
        auto& sum = sums[group.place(lane, corner)];
        unrolled<6>([&](auto c) TEDIT_INLINED { sum[c] += stress[c][lane]; });
        sum[6] += group.elements.volume[lane];
      });
    };
    const auto weighted = [&](lanes6 stress) TEDIT_INLINED {
      unrolled<6>([&](auto c) TEDIT_INLINED { stress[c] *= group.elements.volume; });
      return stress;
    };
    if constexpr (Nodes == 4) {
      const auto stress = stress_of(group.value, group.elements);
      for (std::size_t lane = 0; lane < group.count; ++lane) {
        const std::array<double, 6> s{stress[0][lane], stress[1][lane], stress[2][lane],
                                      stress[3][lane], stress[4][lane], stress[5][lane]};
        if (const double found = von_mises(s.data()); found > all.von_mises) {
          all.von_mises = found;
          all.worst = static_cast<std::uint32_t>(group.element(lane));
        }
      }
      const auto share = weighted(stress);
      unrolled<4>([&](auto corner) TEDIT_INLINED { add(corner, share); });
    } else {
      unrolled<4>([&](auto corner) TEDIT_INLINED {
        add(corner, weighted(corner_stress_of<corner>(group.value, group.elements)));
      });
    }
    for (std::size_t lane = 0; lane < group.count; ++lane) {
      const double volume = group.elements.volume[lane];
      const auto material = problem_.element_materials[group.element(lane)];
      all.volume += volume;
      all.mass += volume * problem_.densities[material];
    }
  });
}

void nodal_patches::sum_stress(const element_chunks& chunks, std::span<const double> displacement) {
  const auto& p = problem_;
  std::vector<totals> parts(chunk_count(p.element_count()));
  const auto fill = [&](std::size_t first, std::size_t last, std::size_t c,
                        std::array<double, 7>* sums) {
    const chunk_elements elements(p, chunks, c, first, last, displacement);
    run_wide_unfused([&]() TEDIT_INLINED {
      if (p.element_order == 2)
        add_elements<10>(elements, sums, parts[c]);
      else
        add_elements<4>(elements, sums, parts[c]);
    });
  };
  chunks.sum_at_nodes<7>(fill, [&](std::size_t node, const std::array<double, 7>& sum) {
    if (node >= p.corner_count || !(sum[6] > 0))
      return;
    around_[node] = sum[6];
    auto& mean = means_[first_of(node)];
    for (std::size_t c = 0; c < 6; ++c)
      mean[c] = sum[c] / sum[6];
  });
  for (const auto& part : parts) {
    all_.volume += part.volume;
    all_.mass += part.mass;
    if (part.von_mises > all_.von_mises) {
      all_.von_mises = part.von_mises;
      all_.worst = part.worst;
    }
  }
}

/// Where materials meet each patch is summed by itself; they are few.
void nodal_patches::sum_meetings(std::span<const double> displacement) {
  const auto& p = problem_;
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  const auto corners = corners_at(p, meetings_);
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const auto node = meetings_[i];
    std::vector<double> volume(end_of(node) - first_of(node), 0);
    means_[first_of(node)] = {};
    for (const auto corner : corners[i]) {
      const std::size_t e = corner / per;
      const auto patch = patch_in(node, e);
      const double v = gradients_of(p, e).volume;
      const auto stress = corner_stress(p, displacement, e)[corner % per];
      for (std::size_t c = 0; c < 6; ++c)
        means_[patch][c] += v * stress[c];
      volume[patch - first_of(node)] += v;
    }
    for (auto patch = first_of(node); patch < end_of(node); ++patch) {
      const double v = volume[patch - first_of(node)];
      share_[patch] = v / around_[node];
      for (auto& mean : means_[patch])
        mean /= v;
    }
  }
}

}  // namespace tedit::fem
