// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "fem/vulkan/system.hpp"
#include "gpu/device.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem::test {

/// 7 x 9 x 11 corners (693: no multiple of any group size), bent so that no two tets are alike,
/// with one planted sliver (of an even number of cells) and rollers; a stiffness jump is in
/// `constants`.
inline problem bent_bar(int order = 1, std::array<int, 3> cells = {6, 8, 10}) {
  using tedit::test::box_mesh;
  load_case loads;
  loads.materials = {{"a", 70e9, 0.33, 2700, 0, {}}};
  loads.constraints = {
    {{1}, fixed{}}, {{3}, roller{}}, {{6}, prescribed_displacement{{}, {}, 0.0}}};
  loads.loads = {{{2}, force{{100, 50, -200}}}};
  const auto place = [](vec3 p) {
    vec3 q = p + 0.02 * vec3{std::sin(5 * p.y), std::sin(4 * p.z), std::sin(3 * p.x)};
    if (norm(p - vec3{0.5, 0.5, 0.5}) < 1e-9)
      q.x += 0.16;  // close to the opposite face of its cells
    return 0.05 * q;
  };
  auto p = make_problem(*box_mesh(cells, {1, 1, 1}, place), loads, order);
  EXPECT_TRUE(p.has_value()) << (p ? "" : render(p.error()));
  p->constants.push_back({p->constants[0].lambda * 1e-3, p->constants[0].mu * 1e-3});
  p->densities.push_back(p->densities[0]);
  p->yield_strengths.push_back(0);
  for (std::size_t e = 0; e < p->element_count(); e += 3)
    p->element_materials[e] = 1;
  return *p;
}

/// A device reads whole slices exactly, the native backend single rows: as the device does.
inline void read_whole_slices(const vulkan_settings& settings, hierarchy& h) {
  const auto subgroup = gpu::device::open("").value()->limits().subgroup_size;
  const std::size_t side =
    settings.slice_rows ? settings.slice_rows : std::clamp(std::bit_floor(subgroup), 1u, 64u);
  for (std::size_t first = 0; first < h.exact_rows.size(); first += side) {
    const auto slice = std::span(h.exact_rows).subspan(first);
    const auto rows = slice.first(std::min(side, slice.size()));
    std::ranges::fill(rows, std::ranges::max(rows));
  }
}

/// A system on `on` with kernels of its own.
inline expected<std::unique_ptr<vulkan::system>> make_system(
  const problem& p, const vulkan_settings& settings,
  std::shared_ptr<gpu::device> on = *gpu::device::open("")) {
  auto kernels = vulkan::kernel_store::make(on, settings);
  if (!kernels)
    return fail(kernels.error());
  return vulkan::system::make(std::move(on), std::move(*kernels), p, settings, {});
}

inline std::vector<double> wave(std::size_t size, double step) {
  std::vector<double> result(size);
  for (std::size_t i = 0; i < size; ++i)
    result[i] = std::sin(1 + step * static_cast<double>(i));
  return result;
}

inline double largest(std::span<const double> x) {
  double result = 0;
  for (const double value : x)
    result = std::max(result, std::abs(value));
  return result;
}

inline void expect_near_all(std::span<const double> a, std::span<const double> b, double relative) {
  ASSERT_EQ(a.size(), b.size());
  const double allowed = relative * largest(b);
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_NEAR(a[i], b[i], allowed) << i;
}

}  // namespace tedit::fem::test
