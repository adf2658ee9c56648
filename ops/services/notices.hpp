// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Services that have something to tell people of the edits that they serve.
class telling_services : public services {
public:
  /// What was found worth telling on this thread since it was last taken: `run_operation` puts it
  /// to the edit's notices.
  [[nodiscard]] virtual std::vector<std::string> take_notices() = 0;
};

}  // namespace tedit::ops
