// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/stopwatch.hpp"

namespace tedit::fem {

namespace {

constexpr std::uint64_t entry_bytes = 48;  // column and nine values in three uvec4
constexpr int iterations_per_batch = 32;   // even: the batch is recorded once

using float4 = std::array<float, 4>;

double norm_of(std::span<const double> x) {
  double sum = 0;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(sum);
}

}  // namespace

expected<std::unique_ptr<linear_system>> vulkan_system::make(std::shared_ptr<gpu::device> on,
                                                             const problem& p,
                                                             const vulkan_settings& settings,
                                                             const execution& run) {
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the solve was cancelled");
  const stopwatch clock;
  std::unique_ptr<vulkan_system> result(new vulkan_system(std::move(on), p, settings));
  if (auto ok = result->build(); !ok)
    return fail(ok.error());
  result->assembly_ms_ = clock.milliseconds();
  return result;
}

expected<void> vulkan_system::build() {
  if (problem_.nodes_per_element != 4)
    return fail(ec::device_unavailable, "Vulkan devices only solve linear tets for now",
                "Use --device cpu, or --order 1 for a preview");
  // About 14 neighbours a node, padded by a fifth, and the vectors.
  const std::uint64_t estimate = problem_.node_count() * (17 * entry_bytes + 16 * 12) +
                                 problem_.element_count() * (16 + 8 + 16 + 32);
  if (const auto memory = device_->limits().memory_bytes; memory > 0 && estimate > memory)
    return fail(ec::out_of_memory,
                "the system needs about " + std::to_string(estimate >> 20) +
                  " MiB, the device has " + std::to_string(memory >> 20),
                "Take a coarser mesh, or use --device cpu");
  const incidence corners(problem_);
  std::size_t most_corners = 0;
  for (std::size_t n = 0; n < problem_.node_count(); ++n)
    most_corners = std::max(most_corners, corners.of_node(n).size());
  // Around an inner node t tets have t/2 + 2 other corners; t + 3 is safe on a boundary.
  // Rounded up, so that similar parts share compiled kernels.
  most_columns_ = (static_cast<std::uint32_t>(most_corners + 3) + 31) / 32 * 32;
  auto kernels = make_kernels(device_, most_columns_);
  if (!kernels)
    return fail(kernels.error());
  kernels_ = std::move(*kernels);
  // Enough groups to fill a real GPU, few enough partial sums for a software one.
  groups_ = device_->summary().kind == "software" ? 16 : 512;
  if (auto ok = upload_mesh(corners); !ok)
    return ok;
  if (auto ok = allocate_vectors(); !ok)
    return ok;
  const auto columns = count_columns();
  if (!columns)
    return fail(columns.error());
  if (auto ok = cut_chunks(*columns); !ok)
    return ok;
  return fill_chunks();
}

expected<gpu::buffer> vulkan_system::make_buffer(std::uint64_t bytes) {
  if (bytes > device_->limits().storage_buffer_range)
    return fail(ec::out_of_memory, "a vector of this problem is larger than the device can bind",
                "Take a coarser mesh, or use --device cpu");
  device_bytes_ += bytes;
  return gpu::buffer::make(device_, bytes, gpu::buffer::place::device);
}

expected<void> vulkan_system::upload_mesh(const incidence& corners) {
  const auto& p = problem_;
  vec3 low{1e300, 1e300, 1e300};
  vec3 high = -low;
  for (const auto& x : p.nodes) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  size_ = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  for (const auto& m : p.constants)
    stiffness_ = std::max({stiffness_, std::abs(m.lambda), m.mu});
  std::vector<float4> leading(p.node_count());
  std::vector<float4> trailing(p.node_count());
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const vec3 x = (p.nodes[n] - 0.5 * (low + high)) / size_;
    const std::array<double, 3> c{x.x, x.y, x.z};
    for (int i = 0; i < 3; ++i) {
      leading[n][i] = static_cast<float>(c[i]);
      trailing[n][i] = static_cast<float>(c[i] - static_cast<double>(leading[n][i]));
    }
  }
  std::vector<std::array<float, 2>> lame(p.element_count());
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto& m = p.constants[p.element_materials[e]];
    lame[e] = {static_cast<float>(m.lambda / stiffness_), static_cast<float>(m.mu / stiffness_)};
  }
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> list;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto part = corners.of_node(n);
    list.insert(list.end(), part.begin(), part.end());
    first.push_back(static_cast<std::uint32_t>(list.size()));
  }
  const auto put = [&](gpu::buffer& to, std::span<const std::byte> bytes) -> expected<void> {
    auto made = make_buffer(bytes.size());
    if (!made)
      return fail(made.error());
    to = std::move(*made);
    return gpu::upload(kernels_.layout, to, bytes);
  };
  using row = std::pair<gpu::buffer*, std::span<const std::byte>>;
  for (const auto& [to, bytes] : {row{&position_high_, std::as_bytes(std::span(leading))},
                                  row{&position_low_, std::as_bytes(std::span(trailing))},
                                  row{&element_nodes_, std::as_bytes(std::span(p.element_nodes))},
                                  row{&element_lame_, std::as_bytes(std::span(lame))},
                                  row{&corner_first_, std::as_bytes(std::span(first))},
                                  row{&corners_, std::as_bytes(std::span(list))}})
    if (auto ok = put(*to, bytes); !ok)
      return ok;
  return {};
}

expected<void> vulkan_system::allocate_vectors() {
  const std::uint64_t nodes = problem_.node_count();
  const auto make = [&](gpu::buffer& to, std::uint64_t bytes) -> expected<void> {
    auto made = make_buffer(bytes);
    if (!made)
      return fail(made.error());
    to = std::move(*made);
    return {};
  };
  for (auto* vector : {&u_, &r_, &c_, &q_})
    if (auto ok = make(*vector, 16 * nodes); !ok)
      return ok;
  for (auto* pair : {&filter_, &inverse_, &nodal_})
    if (auto ok = make(*pair, 32 * nodes); !ok)
      return ok;
  if (auto ok = make(element_stresses_, 32 * problem_.element_count()); !ok)
    return ok;
  // Slices hold either one count per row or two numbers per slice.
  if (auto ok = make(slices_, 8 * (nodes + 1)); !ok)
    return ok;
  constexpr std::uint64_t most_chunks = 64;
  if (auto ok = make(scalars_, 4 * (TEDIT_SCALAR_PARTIALS + groups_ * (1 + most_chunks))); !ok)
    return ok;
  return make(counts_, 16);
}

expected<VkDescriptorSet> vulkan_system::bind(const gpu::buffer& slices, const gpu::buffer& blocks,
                                              const gpu::buffer& inverse) {
  const std::array<const gpu::buffer*, TEDIT_BINDINGS> all{&position_high_,
                                                           &position_low_,
                                                           &element_nodes_,
                                                           &element_lame_,
                                                           &corner_first_,
                                                           &corners_,
                                                           &slices,
                                                           &blocks,
                                                           &filter_,
                                                           &inverse,
                                                           &u_,
                                                           &r_,
                                                           &c_,
                                                           &q_,
                                                           &scalars_,
                                                           &counts_};
  return kernels_.layout->bind(all);
}

expected<void> vulkan_system::dispatch_rows(const gpu::kernel& k, VkDescriptorSet set,
                                            std::uint32_t rows, std::uint32_t first) {
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return fail(work.error());
  work->use(set);
  // At most 65535 groups a dispatch are guaranteed.
  const std::uint32_t most = 65535 * kernels_.group_size;
  for (std::uint32_t done = 0; done < rows; done += most) {
    push_constants push{};
    push.nodes = static_cast<std::uint32_t>(problem_.node_count());
    push.elements = static_cast<std::uint32_t>(problem_.element_count());
    push.first_row = first + done;
    push.rows = std::min(most, rows - done);
    push.groups = groups_;
    work->dispatch(k, (push.rows + kernels_.group_size - 1) / kernels_.group_size, &push);
  }
  if (auto ok = work->end(); !ok)
    return ok;
  return work->run();
}

expected<std::vector<std::uint32_t>> vulkan_system::count_columns() {
  const auto rows = static_cast<std::uint32_t>(problem_.node_count());
  const auto set = bind(slices_, element_stresses_, inverse_);
  if (!set)
    return fail(set.error());
  if (auto ok = dispatch_rows(kernels_.count_columns, *set, rows); !ok)
    return fail(ok.error());
  std::vector<std::uint32_t> columns(rows);
  if (auto ok = gpu::download(kernels_.layout, slices_, std::as_writable_bytes(std::span(columns)));
      !ok)
    return fail(ok.error());
  return columns;
}

/// Slices of rows are as wide as their longest row; chunks of slices fit into one binding.
expected<void> vulkan_system::cut_chunks(const std::vector<std::uint32_t>& columns) {
  std::uint64_t most = device_->limits().storage_buffer_range;
  if (settings_.most_bytes_per_binding > 0)
    most = std::min(most, settings_.most_bytes_per_binding);
  const std::uint32_t per_slice = kernels_.slice_rows;
  const auto rows = static_cast<std::uint32_t>(columns.size());
  std::vector<std::uint32_t> slices;
  chunk now;
  const auto close = [&]() -> expected<void> {
    auto made = make_buffer(now.entries * entry_bytes);
    if (!made)
      return fail(made.error());
    now.blocks = std::move(*made);
    auto set = bind(slices_, now.blocks, inverse_);
    if (!set)
      return fail(set.error());
    now.set = *set;
    chunks_.push_back(std::move(now));
    now = chunk{};
    return {};
  };
  for (std::uint32_t row = 0; row < rows; row += per_slice) {
    const auto last = std::min(rows, row + per_slice);
    const auto width = *std::max_element(columns.begin() + row, columns.begin() + last);
    const std::uint64_t entries = std::uint64_t{width} * per_slice;
    if (now.rows > 0 && (now.entries + entries) * entry_bytes > most)
      if (auto ok = close(); !ok)
        return ok;
    if (now.rows == 0)
      now.first_row = row;
    slices.push_back(static_cast<std::uint32_t>(now.entries));
    slices.push_back(width);
    now.entries += entries;
    now.rows += last - row;
  }
  if (auto ok = close(); !ok)
    return ok;
  constexpr std::size_t most_chunks = 64;
  if (chunks_.size() > most_chunks)
    return fail(ec::out_of_memory, "the matrix does not fit into 64 bindings of this device",
                "Take a coarser mesh, or use --device cpu");
  return gpu::upload(kernels_.layout, slices_, std::as_bytes(std::span(slices)));
}

expected<void> vulkan_system::fill_chunks() {
  for (const auto& part : chunks_)
    if (auto ok = dispatch_rows(kernels_.assemble_rows, part.set, part.rows, part.first_row); !ok)
      return ok;
  return set_filter(problem_.filter);
}

expected<void> vulkan_system::set_filter(std::span<const std::array<double, 6>> filter) {
  std::vector<std::array<float, 8>> packed(filter.size());
  for (std::size_t n = 0; n < filter.size(); ++n)
    for (int i = 0; i < 6; ++i)
      packed[n][i] = static_cast<float>(filter[n][i]);
  if (auto ok = gpu::upload(kernels_.layout, filter_, std::as_bytes(std::span(packed))); !ok)
    return ok;
  for (const auto& part : chunks_)
    if (auto ok = dispatch_rows(kernels_.precondition, part.set, part.rows, part.first_row); !ok)
      return ok;
  return {};
}

push_constants vulkan_system::constants_of(const chunk& part, std::uint32_t number) const {
  push_constants push{};
  push.nodes = static_cast<std::uint32_t>(problem_.node_count());
  push.elements = static_cast<std::uint32_t>(problem_.element_count());
  push.first_row = part.first_row;
  push.rows = part.rows;
  push.groups = groups_;
  push.chunk = number;
  push.chunks = static_cast<std::uint32_t>(chunks_.size());
  return push;
}

/// The commands of one batch of iterations, recorded once: three kernels an iteration, their group
/// counts read from a buffer that the last one zeroes when the loop is done.
expected<gpu::commands*> vulkan_system::batch() {
  if (batch_)
    return &*batch_;
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return fail(work.error());
  for (int i = 0; i < iterations_per_batch; ++i) {
    for (std::uint32_t number = 0; number < chunks_.size(); ++number) {
      auto push = constants_of(chunks_[number], number);
      push.parity = static_cast<std::uint32_t>(i % 2);
      work->use(chunks_[number].set);
      work->dispatch_indirect(kernels_.cg_apply, counts_, &push);
    }
    auto push = constants_of(chunks_.front(), 0);
    push.parity = static_cast<std::uint32_t>(i % 2);
    work->use(chunks_.front().set);
    work->dispatch_indirect(kernels_.cg_update, counts_, &push);
    work->dispatch_indirect(kernels_.cg_direction, counts_, &push);
  }
  if (auto ok = work->end(); !ok)
    return fail(ok.error());
  batch_.emplace(std::move(*work));
  return &*batch_;
}

expected<void> vulkan_system::upload_vector(gpu::buffer& to, std::span<const double> values,
                                            double scale, bool trailing) {
  std::vector<float4> packed(values.size() / 3);
  for (std::size_t n = 0; n < packed.size(); ++n)
    for (int i = 0; i < 3; ++i) {
      const double value = scale * values[3 * n + i];
      const auto leading = static_cast<float>(value);
      packed[n][i] = trailing ? static_cast<float>(value - static_cast<double>(leading)) : leading;
    }
  return gpu::upload(kernels_.layout, to, std::as_bytes(std::span(packed)));
}

expected<inner_result> vulkan_system::solve(std::span<const double> residual,
                                            std::span<double> correction, double reduction,
                                            int max_iterations, const execution& run) {
  inner_result result;
  const double length = norm_of(residual);
  std::ranges::fill(correction, 0.0);
  if (!(length > 0)) {
    result.recurrence_reduction = 0;
    result.broke_down = length != 0;
    return result;
  }
  if (auto ok = upload_vector(q_, residual, 1 / length, false); !ok)
    return fail(ok.error());
  auto first = gpu::commands::begin(kernels_.layout);
  if (!first)
    return fail(first.error());
  auto push = constants_of(chunks_.front(), 0);
  push.reduction2 = static_cast<float>(reduction * reduction);
  first->use(chunks_.front().set);
  first->dispatch(kernels_.cg_start, groups_, &push);
  first->dispatch(kernels_.cg_begin, 1, &push);
  if (auto ok = first->end(); !ok)
    return fail(ok.error());
  if (auto ok = first->run(); !ok)
    return fail(ok.error());
  auto work = batch();
  if (!work)
    return fail(work.error());
  std::array<float, TEDIT_SCALAR_PARTIALS> scalars{};
  do {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    if (auto ok = (*work)->run(); !ok)
      return fail(ok.error());
    if (auto ok =
          gpu::download(kernels_.layout, scalars_, std::as_writable_bytes(std::span(scalars)));
        !ok)
      return fail(ok.error());
    result.iterations = static_cast<int>(scalars[TEDIT_SCALAR_ITERATIONS]);
  } while (scalars[TEDIT_SCALAR_STATE] == 0 && result.iterations < max_iterations);
  result.broke_down = scalars[TEDIT_SCALAR_STATE] == 2;
  result.recurrence_reduction =
    reduction * std::sqrt(std::abs(scalars[TEDIT_SCALAR_DELTA + result.iterations % 2]) /
                          std::max(scalars[TEDIT_SCALAR_THRESHOLD], 1e-37F));
  std::vector<float4> packed(problem_.node_count());
  if (auto ok = gpu::download(kernels_.layout, u_, std::as_writable_bytes(std::span(packed))); !ok)
    return fail(ok.error());
  // K = size * stiffness * (what the device holds).
  const double back = length / (size_ * stiffness_);
  for (std::size_t n = 0; n < packed.size(); ++n)
    for (int i = 0; i < 3; ++i)
      correction[3 * n + i] = back * static_cast<double>(packed[n][i]);
  return result;
}

expected<void> vulkan_system::multiply(std::span<const double> x, std::span<double> y) {
  const double length = norm_of(x);
  if (!(length > 0)) {
    std::ranges::fill(y, 0.0);
    return {};
  }
  if (auto ok = upload_vector(c_, x, 1 / length, false); !ok)
    return ok;
  auto work = gpu::commands::begin(kernels_.layout);
  if (!work)
    return fail(work.error());
  for (std::uint32_t number = 0; number < chunks_.size(); ++number) {
    auto push = constants_of(chunks_[number], number);
    push.parity = 2;
    work->use(chunks_[number].set);
    work->dispatch(kernels_.cg_apply, groups_, &push);
  }
  if (auto ok = work->end(); !ok)
    return ok;
  if (auto ok = work->run(); !ok)
    return ok;
  std::vector<float4> packed(problem_.node_count());
  if (auto ok = gpu::download(kernels_.layout, q_, std::as_writable_bytes(std::span(packed))); !ok)
    return ok;
  for (std::size_t n = 0; n < packed.size(); ++n)
    for (int i = 0; i < 3; ++i)
      y[3 * n + i] = length * size_ * stiffness_ * static_cast<double>(packed[n][i]);
  return {};
}

expected<void> vulkan_system::element_stress(std::span<const double> displacement,
                                             std::span<double> stress) {
  double largest = 1e-300;
  for (const double value : displacement)
    largest = std::max(largest, std::abs(value));
  if (auto ok = upload_vector(u_, displacement, 1 / largest, false); !ok)
    return ok;
  if (auto ok = upload_vector(r_, displacement, 1 / largest, true); !ok)
    return ok;
  if (!stress_set_) {
    auto set = bind(slices_, element_stresses_, nodal_);
    if (!set)
      return fail(set.error());
    stress_set_ = *set;
  }
  const auto elements = static_cast<std::uint32_t>(problem_.element_count());
  if (auto ok = dispatch_rows(kernels_.element_stress, stress_set_, elements); !ok)
    return ok;
  std::vector<std::array<float, 8>> packed(elements);
  if (auto ok = gpu::download(kernels_.layout, element_stresses_,
                              std::as_writable_bytes(std::span(packed)));
      !ok)
    return ok;
  const double back = largest / size_ * stiffness_;
  for (std::size_t e = 0; e < packed.size(); ++e)
    for (int i = 0; i < 6; ++i)
      stress[6 * e + i] = back * static_cast<double>(packed[e][i]);
  return {};
}

expected<void> vulkan_system::nodal_stress(std::span<const double> element_stress,
                                           std::span<double> nodal) {
  double largest = 1e-300;
  for (const double value : element_stress)
    largest = std::max(largest, std::abs(value));
  std::vector<std::array<float, 8>> packed(problem_.element_count());
  for (std::size_t e = 0; e < packed.size(); ++e)
    for (int i = 0; i < 6; ++i)
      packed[e][i] = static_cast<float>(element_stress[6 * e + i] / largest);
  if (auto ok = gpu::upload(kernels_.layout, element_stresses_, std::as_bytes(std::span(packed)));
      !ok)
    return ok;
  if (!stress_set_) {
    auto set = bind(slices_, element_stresses_, nodal_);
    if (!set)
      return fail(set.error());
    stress_set_ = *set;
  }
  const auto nodes = static_cast<std::uint32_t>(problem_.node_count());
  if (auto ok = dispatch_rows(kernels_.nodal_stress, stress_set_, nodes); !ok)
    return ok;
  std::vector<std::array<float, 8>> means(nodes);
  if (auto ok = gpu::download(kernels_.layout, nodal_, std::as_writable_bytes(std::span(means)));
      !ok)
    return ok;
  for (std::size_t n = 0; n < means.size(); ++n)
    for (int i = 0; i < 6; ++i)
      nodal[6 * n + i] = largest * static_cast<double>(means[n][i]);
  return {};
}

}  // namespace tedit::fem
