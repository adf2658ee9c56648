// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/system.hpp"

#include <bit>
#include <cmath>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"

namespace tedit::fem::vulkan {

namespace {

/// A dense inverse of more rows would not be worth its bytes. Only meshes of hundreds of separate
/// pieces have so coarse a level.
constexpr std::uint32_t most_coarsest = 800;

constexpr std::size_t most_cases = 8;  ///< At once, as natively.

/// The number of places side by side that so many cases take.
std::uint32_t width_of(std::size_t cases) {
  return static_cast<std::uint32_t>(std::bit_ceil(cases));
}

double norm_of(std::span<const double> x) {
  double sum = 0;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(sum);
}

/// Bytes that a system will need on the device, from measured means: 17 blocks a row with padding;
/// aggregates of 13 nodes with 25 blocks a row, the coarser levels a fifth of that.
std::uint64_t estimated_bytes(const problem& p) {
  const std::uint64_t corners = p.corner_count;
  const std::uint64_t nodes = p.node_count();
  const std::uint64_t elements = p.element_count();
  constexpr std::uint64_t vectors = 8 * 16;      // of the Krylov method and a smoother
  constexpr std::uint64_t blocks = 2 * 32 + 16;  // inverse, filter, arm or edge
  const std::uint64_t linear = corners * (18 * 40 + 25 * 148 * 6 / (13 * 5) + vectors + blocks);
  const std::uint64_t rest =
    p.element_order == 1 ? 0 : nodes * (vectors + blocks) + elements * (96 + 10 * 16 + 10 * 4);
  return (linear + rest) * 17 / 16;  // and room for edits
}

}  // namespace

system::system(std::shared_ptr<gpu::device> on, std::shared_ptr<kernel_store> kernels,
               const problem& p, const vulkan_settings& settings)
    : device_(std::move(on)),
      problem_(p),
      settings_(settings.for_order(p.element_order)),
      scale_(p),
      kernels_(std::move(kernels)) {}

expected<std::unique_ptr<system>> system::make(std::shared_ptr<gpu::device> on,
                                               std::shared_ptr<kernel_store> kernels,
                                               const problem& p, const vulkan_settings& settings,
                                               const execution& run) {
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the solve was cancelled");
  const stopwatch clock;
  std::unique_ptr<system> result(new system(std::move(on), std::move(kernels), p, settings));
  if (auto ok = result->check_memory(); !ok)
    return fail(ok.error());
  if (auto ok = result->build(); !ok)
    return fail(ok.error());
  result->assembly_ms_ = clock.milliseconds();
  if (auto ok = result->prepare(p.filter, run); !ok)
    return fail(ok.error());
  result->uploaded_bytes_ = result->memory_->take_uploaded();
  return result;
}

expected<void> system::check_memory() const {
  const auto estimate = estimated_bytes(problem_);
  const auto memory = device_->limits().memory_bytes;
  if (memory == 0 || estimate <= memory)
    return {};
  return fail(ec::out_of_memory,
              "the system needs about " + std::to_string(estimate >> 20) + " MiB, the device has " +
                std::to_string(memory >> 20),
              "Take a coarser mesh, or use --device cpu");
}

expected<void> system::build() {
  const auto& kernels = kernels_->for_one();
  memory_ = std::make_unique<device_memory>(kernels.layout, settings_);
  setup_.emplace(problem_, settings_.multilevel);
  matrix_ = std::make_unique<sliced_matrix>(kernels, *memory_, setup_->blocks(), scale_);
  if (is_quadratic())
    quadratic_ = std::make_unique<quadratic_operator>(kernels, *memory_, problem_, scale_);
  const row_operator& k = is_quadratic() ? static_cast<const row_operator&>(*quadratic_) : *matrix_;
  krylov_.emplace(kernels, *memory_, k);
  return memory_->status();
}

expected<void> system::set_filter(filter_span filter) {
  static_cast<void>(memory_->take_uploaded());
  auto done = guarded([&] { return prepare(filter, {}); });
  uploaded_bytes_ = memory_->take_uploaded();
  return done;
}

expected<void> system::prepare(filter_span filter, const execution& run) {
  ready_ = false;
  quadratic_cycle_.reset();
  cycle_.reset();
  memory_->forget(std::exchange(cycle_bytes_, 0));
  const auto before = memory_->bytes();
  if (auto ok = setup_->prepare(filter, product(), run); !ok)
    return ok;
  if (const auto coarsest = setup_->levels().levels.back().nodes(); coarsest > most_coarsest)
    return fail(ec::device_unavailable,
                "the part is in too many separate pieces for this device: its coarsest level has " +
                  std::to_string(coarsest) + " aggregates, the device takes " +
                  std::to_string(most_coarsest),
                "Use the device cpu, or mesh the part in fewer pieces");
  if (auto ok = matrix_->read_exactly(setup_->levels().exact_rows); !ok)
    return ok;
  cycle_.emplace(*memory_, *matrix_, setup_->levels(), setup_->at_corners(filter), settings_.cycle,
                 scale_.matrix());
  if (is_quadratic())
    quadratic_cycle_.emplace(*memory_, *quadratic_, setup_->smoother(), setup_->edges(), filter,
                             *cycle_, settings_.cycle.quadratic_degree, scale_.matrix());
  cycle_bytes_ = memory_->bytes() - before;
  if (auto ok = memory_->status(); !ok)
    return ok;
  return record();
}

/// K x of quadratic tets on the device, as the host's numbers.
multilevel_setup::product system::product() {
  return [this, packed = std::vector<device_float4>()](const float* x,
                                                       float* y) mutable -> expected<void> {
    packed.resize(problem_.node_count());
    const auto back = static_cast<float>(scale_.matrix());
    for (std::size_t n = 0; n < packed.size(); ++n)
      packed[n] = {back * x[3 * n], back * x[3 * n + 1], back * x[3 * n + 2], 0};
    auto done = krylov_->multiply(packed, packed);
    for (std::size_t n = 0; n < packed.size(); ++n)
      std::copy_n(packed[n].begin(), 3, y + 3 * n);
    return done;
  };
}

preconditioner system::cycle() {
  return [this](device_program& program, const gpu::buffer& right, const gpu::buffer& z) {
    if (quadratic_cycle_)
      quadratic_cycle_->add(program, right, z);
    else
      cycle_->add(program, right, z);
  };
}

const gpu::buffer& system::filter_buffer() const {
  return quadratic_cycle_ ? quadratic_cycle_->filter() : cycle_->filter();
}

expected<void> system::record() {
  ready_ = false;
  auto recorded = krylov_->prepare(cycle(), filter_buffer());
  ready_ = recorded.has_value();
  return recorded;
}

// -- following an edit -------------------------------------------------------------------

expected<bool> system::update(const problem_change& change, const incidence& corners) {
  if (!ready_)
    return false;
  ready_ = false;
  static_cast<void>(memory_->take_uploaded());
  auto followed = guarded([&] { return follow(change, corners); });
  uploaded_bytes_ = memory_->take_uploaded();
  ready_ = followed && *followed;
  return followed;
}

expected<bool> system::follow(const problem_change& change, const incidence& corners) {
  const auto old_edges = setup_->edges().ends.size();
  if (!setup_->update(change, corners) || setup_->levels().levels.back().nodes() > most_coarsest)
    return false;
  auto changes = update_device(change, corners, old_edges);
  if (!changes.fits())
    return false;
  if (auto ok = memory_->send(changes); !ok)
    return fail(ok.error());
  if (auto ok = krylov_->follow(cycle(), filter_buffer()); !ok)
    return fail(ok.error());
  return true;
}

device_changes system::update_device(const problem_change& change, const incidence& corners,
                                     std::size_t old_edges) {
  const filter_span filter = problem_.filter;
  const auto corner_nodes = setup_->changed_corners(change);
  device_changes changes;
  matrix_->update(setup_->blocks(), corner_nodes, setup_->levels().exact_rows, changes);
  cycle_->update(setup_->at_corners(filter), corner_nodes, changes);
  if (is_quadratic()) {
    quadratic_->update(problem_, corners, change, changes);
    quadratic_cycle_->update(filter, change.nodes, old_edges, changes);
  }
  return changes;
}

expected<void> system::check_ready() const {
  if (ready_)
    return {};
  return fail(ec::device_unavailable, "an earlier failure left this system incomplete",
              "Assemble it again, or use --device cpu");
}

// -- solving -----------------------------------------------------------------------------

expected<std::vector<inner_result>> system::solve_many(std::span<const inner_case> cases,
                                                       int max_iterations, const execution& run) {
  std::vector<inner_result> results;
  while (results.size() < cases.size()) {
    const auto left = cases.subspan(results.size());
    auto count = is_quadratic() ? 1 : std::min<std::size_t>(most_cases, left.size());
    while (count > 1 && !fits_on_device(width_of(count)))
      count /= 2;
    const auto some = guarded(run, [&] { return correct(left.first(count), max_iterations, run); });
    if (!some)
      return fail(some.error());
    results.insert(results.end(), some->begin(), some->end());
  }
  return results;
}

/// Whether vectors for so many cases would, beside all that is there.
bool system::fits_on_device(std::uint32_t cases) const {
  constexpr std::uint64_t vectors = 9 * 16;  // of the Krylov method, a smoother and coarser levels
  const auto more = std::uint64_t{cases} * vectors * with_spare(problem_.corner_count);
  const auto& limits = device_->limits();
  return krylov_->has_width(cases) ||
         (more / 9 <= limits.storage_buffer_range &&
          (limits.memory_bytes == 0 || memory_->bytes() + more <= limits.memory_bytes));
}

/// From now on so many cases may be solved at once.
expected<void> system::widen(std::uint32_t cases) {
  const auto kernels = kernels_->for_cases(cases);
  if (!kernels)
    return fail(kernels.error());
  // From here on a cancel would leave a system that is good for nothing.
  const cancel_token never;
  const cancel_scope scope(never);
  ready_ = false;
  const auto before = memory_->bytes();
  cycle_->widen(*memory_, std::max(cases, krylov_->width()));
  cycle_bytes_ += memory_->bytes() - before;
  krylov_->widen(**kernels);
  if (auto ok = memory_->status(); !ok)
    return ok;
  return record();
}

/// On the device the residual is r / length and the matrix K / scale.
expected<std::vector<inner_result>> system::correct(std::span<const inner_case> cases,
                                                    int max_iterations, const execution& run) {
  if (auto ok = check_ready(); !ok)
    return fail(ok.error());
  const auto width = width_of(cases.size());
  if (!krylov_->has_width(width))
    if (auto ok = widen(width); !ok)
      return fail(ok.error());
  if (std::exchange(distrusted_, false))
    if (auto ok = raise_bounds(); !ok)
      return fail(ok.error());
  std::vector<device_float4> packed(width * problem_.node_count());
  std::vector<inner_case> goals(cases.begin(), cases.end());
  std::vector<double> lengths;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    lengths.push_back(norm_of(cases[c].residual));
    if (!(lengths[c] > 0))
      continue;
    goals[c].energy /= lengths[c] / std::sqrt(scale_.matrix());
    pack3(cases[c].residual, 1 / lengths[c], packed, {c, width});
  }
  auto results = krylov_->solve(packed, packed, goals, max_iterations, run);
  if (!results)
    return results;
  bool broke_down = false;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    auto& result = (*results)[c];
    const double energy_scale = lengths[c] / std::sqrt(scale_.matrix());
    result.energy *= energy_scale;
    result.gained *= energy_scale * energy_scale;
    unpack3(packed, lengths[c] / scale_.matrix(), cases[c].correction, {c, width});
    if (!(lengths[c] > 0)) {
      std::ranges::fill(cases[c].correction, 0.0);
      result = {.recurrence_reduction = 0, .broke_down = lengths[c] != 0};
      continue;
    }
    broke_down = broke_down || result.broke_down;
  }
  if (broke_down)
    if (auto ok = raise_bounds(); !ok)
      return fail(ok.error());
  return results;
}

expected<void> system::raise_bounds() {
  setup_->raise_bounds();
  if (auto ok = matrix_->read_exactly(setup_->levels().exact_rows); !ok)
    return ok;
  return record();
}

expected<void> system::multiply(std::span<const double> x, std::span<double> y) {
  if (auto ok = check_ready(); !ok)
    return ok;
  const double length = norm_of(x);
  if (!(length > 0)) {
    std::ranges::fill(y, 0.0);
    return {};
  }
  std::vector<device_float4> packed(problem_.node_count());
  if (auto ok = krylov_->multiply(packed3(x, 1 / length), packed); !ok)
    return ok;
  unpack3(packed, length * scale_.matrix(), y);
  return {};
}

expected<void> system::precondition(std::span<const double> r, std::span<double> z) {
  if (auto ok = check_ready(); !ok)
    return ok;
  const double length = norm_of(r);
  std::vector<device_float4> packed(problem_.node_count());
  if (auto ok = krylov_->precondition(packed3(r, 1 / length), packed); !ok)
    return ok;
  unpack3(packed, length / scale_.matrix(), z);
  return {};
}

}  // namespace tedit::fem::vulkan
