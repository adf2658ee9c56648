// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit {

/// The error with `name` wherever it says `path`: a person knows the file that was sent, not the
/// place where it lies meanwhile. @param path not empty.
[[nodiscard]] inline error named_error(error why, const std::string& path,
                                       const std::string& name) {
  for (auto* text : {&why.message, &why.remedy, &why.where})
    for (auto at = text->find(path); at != std::string::npos;
         at = text->find(path, at + name.size()))
      text->replace(at, path.size(), name);
  return why;
}

}  // namespace tedit
