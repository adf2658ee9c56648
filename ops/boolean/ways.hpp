// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "ops/boolean/clean.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What moves less than this share of the local size has stayed where it was asked to be; and of
/// the part's size: a millionth of that is what a CAD model is held against.
constexpr double exact_of_size = 1e-4;
constexpr double exact_of_part = 3e-7;

/// How a boolean is tried: rings of tets around what the tool crosses, steps from anything new
/// within which the part's triangles may change, and how the surface is cleaned. Where it is
/// cleaned finely, bonded regions beside are meshed anew, too.
struct boolean_way {
  int rings = 1;
  int steps = 2;
  clean_settings clean;
};
constexpr std::array boolean_ways{boolean_way{1, 2, {exact_of_size, 0.005, 0.05}},
                                  boolean_way{2, 4, {exact_of_size, 0.002, 0.02}},
                                  boolean_way{2, 4, {exact_of_size, 5e-4, 0.002, true}},
                                  boolean_way{1, 2, {exact_of_size, 0.06, 0.25}},
                                  boolean_way{1, 3, {5e-3, 0.03, 0.12}},
                                  boolean_way{2, 4, {2e-2, 0.06, 0.12}},
                                  boolean_way{2, 4, {2e-2, 0.1, 0.3}}};

/// Of the local size: what is thinner where the cut was made is not told of an edit that is done,
/// as cleaning merges what is so close.
inline constexpr double merged_share = 1e-3;

/// Tools of more triangles are tried twice only, fillings of more tets are not mended besides.
inline constexpr std::size_t many_triangles = 8000;
inline constexpr std::size_t many_tets = 30'000;

/// After so many tries a mesh that is worse than this share of what is taken ends them.
inline constexpr std::size_t hopeless_tries = 3;
inline constexpr double hopeless = 0.02;

/// Where the CAD model has the round walls, vertices are put on them in so many of the ways.
inline constexpr std::size_t ways_onto_walls = 2;

/// Worst q that is good enough to stop at, where the part had it.
constexpr double wanted_quality = 0.1;

[[nodiscard]] inline bool is_good(const boolean_result& made) {
  return made.worst_after >= std::min(wanted_quality, made.worst_before);
}

/// Of good ones that which is nearer to what was asked for; else by what they keep of the quality
/// that the part had there.
[[nodiscard]] inline bool is_better(const boolean_result& one, const boolean_result& other) {
  if (is_good(one) && is_good(other))
    return one.deviation < other.deviation;
  const auto kept = [](const boolean_result& r) {
    return r.worst_after / std::min(wanted_quality, std::max(r.worst_before, 1e-12));
  };
  return kept(one) > kept(other);
}

}  // namespace tedit::ops
