// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/native_backend.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

std::vector<device_info> list_devices() {
  return {make_native_backend()->info()};
}

expected<std::unique_ptr<backend>> open_backend(const std::string& name) {
  if (name == "cpu" || name == "auto")
    return make_native_backend();
  std::string known;
  for (const auto& device : list_devices())
    known += (known.empty() ? "" : ", ") + device.name;
  return fail(ec::device_unavailable, "there is no device \"" + name + "\" here",
              "Use auto or one of: " + known);
}

}  // namespace tedit::fem
