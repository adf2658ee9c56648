// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "base/stopwatch.hpp"
#include "fem/device_choice.hpp"
#include "fem/native/backend.hpp"
#include "fem/problem_parts.hpp"
#include "fem/solver.hpp"
#include "fem/vulkan/backend.hpp"

namespace tedit::fem {

namespace {

/// A bar of n x m x m cells with quadratic tets for the trial, solved in a blink.
problem trial_problem() {
  constexpr int n = 24;
  constexpr int m = 8;
  problem p;
  const auto index = [&](int x, int y, int z) {
    return static_cast<std::uint32_t>((x * (m + 1) + y) * (m + 1) + z);
  };
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= m; ++y)
      for (int z = 0; z <= m; ++z)
        p.nodes.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  // Kuhn's six tets of a cell; odd permutations have two corners swapped.
  constexpr std::array<std::array<int, 3>, 6> paths{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < m; ++y)
      for (int z = 0; z < m; ++z)
        for (std::size_t path = 0; path < paths.size(); ++path) {
          std::array<int, 3> at{x, y, z};
          std::array<std::uint32_t, 4> corner{index(x, y, z)};
          for (int step = 0; step < 3; ++step) {
            ++at[paths[path][step]];
            corner[step + 1] = index(at[0], at[1], at[2]);
          }
          if (path >= 3)
            std::swap(corner[2], corner[3]);
          p.element_nodes.insert(p.element_nodes.end(), corner.begin(), corner.end());
          p.element_tets.push_back(static_cast<tet_id>(p.element_tets.size()));
          p.element_materials.push_back(0);
        }
  p.constants = {{1, 1}};
  p.corner_count = p.node_count();
  p.densities = {0};
  p.yield_strengths = {0};
  add_mid_nodes(p);
  p.loads.assign(p.dofs(), 0);
  p.prescribed.assign(p.dofs(), 0);
  p.filter.assign(p.node_count(), {1, 0, 0, 1, 0, 1});
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    if (p.nodes[i].x == 0)
      p.filter[i] = {0, 0, 0, 0, 0, 0};
    if (p.nodes[i].x == n)
      p.loads[3 * i + 2] = 1;
  }
  return p;
}

expected<double> trial_ms(backend& device, const problem& p) {
  solve_settings settings;
  settings.tolerance = 1e-4;
  const stopwatch clock;
  if (const auto solved = solve(p, device, settings, {}); !solved)
    return fail(solved.error());
  return clock.milliseconds();
}

expected<std::unique_ptr<backend>> open_native_or_vulkan(const std::string& name) {
  if (name == "cpu")
    return make_native_backend();
  return open_vulkan(name);
}

chosen_device measure_fastest() {
  const auto devices = list_devices();
  if (devices.size() == 1)
    return {"cpu"};
  const auto p = trial_problem();
  std::vector<contestant> contestants;
  for (const auto& device : devices) {
    const auto opened =
      std::make_shared<expected<std::unique_ptr<backend>>>(open_native_or_vulkan(device.name));
    contestants.push_back({device.name, [opened, &p]() -> expected<double> {
                             return *opened ? trial_ms(***opened, p) : fail(opened->error());
                           }});
  }
  return choose_device(try_devices(contestants));
}

/// A device with what is to be told of its choice.
class noted_backend final : public backend {
public:
  noted_backend(std::unique_ptr<backend> device, const std::string& notice)
      : device_(std::move(device)), info_(device_->info()) {
    info_.notice = notice;
  }

  const device_info& info() const override { return info_; }

  expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                    const execution& run) override {
    return device_->assemble(p, run);
  }

private:
  std::unique_ptr<backend> device_;
  device_info info_;
};

expected<std::unique_ptr<backend>> open_chosen(const chosen_device& choice) {
  auto opened = open_native_or_vulkan(choice.name);
  if (!opened || choice.notice.empty())
    return opened;
  return std::make_unique<noted_backend>(std::move(*opened), choice.notice);
}

/// What was the fastest once; measured where nothing is known, or where that device is gone.
expected<std::unique_ptr<backend>> open_fastest() {
  const auto file = device_choice::of_this_machine();
  const auto kept = file.kept();
  auto opened = kept ? open_chosen(*kept) : fail(ec::device_unavailable, "none is kept");
  if (opened)
    return opened;
  auto choice = measure_fastest();
  file.keep(choice);
  if (kept)  // Told once: the choice that is kept now knows nothing of it.
    choice.notice += (choice.notice.empty() ? "" : "; ") + std::string("the device \"") +
                     kept->name + "\", which was the fastest, is gone: " + opened.error().message;
  return open_chosen(choice);
}

}  // namespace

std::vector<device_info> list_devices() {
  std::vector<device_info> result{make_native_backend()->info()};
  for (auto& device : list_vulkan_devices())
    result.push_back(std::move(device));
  return result;
}

expected<std::unique_ptr<backend>> open_backend(const std::string& name) {
  if (name == "cpu")
    return make_native_backend();
  if (name == "auto")
    return open_fastest();
  if (auto opened = open_vulkan(name); opened || opened.error().code != ec::device_unavailable)
    return opened;
  std::string known;
  for (const auto& device : list_devices())
    known += (known.empty() ? "" : ", ") + device.name;
  return fail(ec::device_unavailable, "there is no device \"" + name + "\" here",
              "Use auto or one of: " + known);
}

}  // namespace tedit::fem
