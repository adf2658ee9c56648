// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/named_arrays.hpp"
#include "compare/comparison.hpp"

namespace tedit::client {

/// What two versions differ in (message `tedit.v1.VersionsCompared`).
struct comparison {
  std::uint32_t before = 0;  ///< Their numbers.
  std::uint32_t after = 0;
  version_comparison what;  ///< `not_compared` says of which load cases there is no difference.
  std::string load_case;    ///< Whose difference follows; empty: none was asked for.
  /// Slots of the version after, ascending: those of its boundary. Empty when there is no
  /// difference of the load case.
  std::vector<std::uint32_t> vertices;
  std::vector<difference_mark> marks;  ///< Of each vertex.
  /// After minus before by the names of `fem::result_arrays`, SI, rows as `vertices`:
  /// displacement, von Mises stress, and what is watched as far as both results have it. 0 where a
  /// mark is `outside`.
  named_arrays<float> differences;
};

}  // namespace tedit::client
