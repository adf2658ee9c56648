// SPDX-License-Identifier: AGPL-3.0-or-later
// One tool at several places, as one edit.
#pragma once

#include "ops/tools/placement.hpp"

namespace tedit::ops {

/// A tool where it is to be.
struct placed_tool {
  tool_surface tool;
  vec3 at;          ///< m: the place that it was asked for.
  double size = 0;  ///< m: the part's mean edge there.
};

/// The parameter "places": more of the same, at most 200.
[[nodiscard]] parameter_description places_parameter(const std::string& help);

/// The values once for each place, which is "at" there: the one that was given, then those of
/// "places". The values as they are where no places were given, or the operation has none. Errors:
/// `invalid_parameter` with both numbers where a place is given twice.
[[nodiscard]] expected<std::vector<parameters>> at_each_place(const parameters& values);

/// What a maker of tools makes of the values, at each of their places. Errors: those of `make`,
/// with the number of the place and where it is.
template <class Make>
[[nodiscard]] expected<std::vector<placed_tool>> tools_at_places(const parameters& values,
                                                                 const Make& make);

/// All tools cut from the part or united with it, or none. The faces of the second are called like
/// those of the first with a number behind: "bore", "bore 2". Those whose boxes are apart are made
/// at once. Errors: those of `apply_tool`, with the number of the place and where it is.
[[nodiscard]] expected<edit_result> apply_tools(const version_ptr& mesh,
                                                std::vector<placed_tool> tools, boolean_mode mode,
                                                const std::vector<surface_id>& used, context& ctx);

// -- how that is done ----------------------------------------------------------------------------

/// "place 3 of 5 (10, 20, 5 mm): " before what is wrong; as it is where there is but one.
[[nodiscard]] error at_place(error e, std::size_t number, std::size_t count, vec3 at);

template <class Make>
expected<std::vector<placed_tool>> tools_at_places(const parameters& values, const Make& make) {
  const auto places = at_each_place(values);
  if (!places)
    return fail(places.error());
  std::vector<placed_tool> tools;
  for (std::size_t i = 0; i < places->size(); ++i) {
    expected<placed_tool> one = make((*places)[i]);
    if (!one)
      return fail(at_place(one.error(), i + 1, places->size(),
                           vector_of((*places)[i], "at").value_or(vec3{})));
    tools.push_back(std::move(*one));
  }
  return tools;
}

}  // namespace tedit::ops
