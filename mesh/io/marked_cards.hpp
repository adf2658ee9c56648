// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace tedit {

/// A load case beside the cards that stand for it in a deck, in comments: a deck has nodal forces
/// where the load case has a bearing force, and only with it the way back is exact. A hash of the
/// cards tells whether somebody changed them since, which counts more than the comment.
struct marked_case {
  std::string load_case;  ///< Empty: there is none, or the cards were changed.
  bool changed = false;   ///< There is one that stands for other cards than those of the file.
};

/// `cards` behind the load case (JSON) that they stand for. `comment` begins a comment line: "** ",
/// "$ ".
void write_marked_cards(std::ostream& out, std::string_view comment, const std::string& cards,
                        std::string_view load_case);

/// What `write_marked_cards` wrote somewhere in `text`. Cost: O(text).
[[nodiscard]] marked_case find_marked_case(std::string_view text, std::string_view comment);

}  // namespace tedit
