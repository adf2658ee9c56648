// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/backend.hpp"

#include <algorithm>

#include "base/guard.hpp"
#include "base/memory.hpp"
#include "base/processors.hpp"
#include "fem/native/system.hpp"

namespace tedit::fem {

namespace {

class native_backend final : public backend {
public:
  explicit native_backend(const native_settings& settings) : settings_(settings) {
    info_.name = "cpu";
    info_.kind = "native";
    info_.driver = std::to_string(processors()) + " threads";
  }

  const device_info& info() const override { return info_; }

  expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                    const execution& run) override {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    if (auto ok = check_room(p); !ok)
      return fail(ok.error());
    return guarded(run, [&] { return native::make_system(p, settings_, run); });
  }

private:
  [[nodiscard]] expected<void> check_room(const problem& p) const {
    return check_memory(native_solve_bytes(p),
                        settings_.memory_limit
                          ? memory_room{settings_.memory_limit, "the backend's limit"}
                          : available_memory(),
                        "the solve of " + std::to_string(p.node_count()) + " nodes");
  }

  native_settings settings_;
  device_info info_;
};

}  // namespace

std::unique_ptr<backend> make_native_backend(const native_settings& settings) {
  return std::make_unique<native_backend>(settings);
}

std::uint64_t native_solve_bytes(const problem& p) {
  const std::uint64_t elements = p.element_count();
  const std::uint64_t nodes = p.node_count();
  return p.element_order == 1 ? 140 * elements + 860 * nodes : 170 * elements + 630 * nodes;
}

}  // namespace tedit::fem
