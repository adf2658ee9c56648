// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/parameters.hpp"

#include "base/attachment.hpp"

namespace tedit::cli {

expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs) {
  ops::parameters result;
  for (const auto& pair : pairs) {
    const auto split = pair.find('=');
    if (split == std::string::npos || split == 0)
      return fail(ec::usage, "\"" + pair + "\" is no parameter", "Write NAME=VALUE");
    result[pair.substr(0, split)] = pair.substr(split + 1);
  }
  return result;
}

expected<ops::parameters> with_files(const ops::operation_description& about,
                                     ops::parameters given) {
  for (const auto& p : about.parameters) {
    const auto found = given.find(p.id);
    if (p.type != ops::parameter_type::file || found == given.end())
      continue;
    auto& text = std::get<std::string>(found->second);
    if (text.empty() || is_attachment_text(text))
      continue;
    auto content = attach_file(text);
    if (!content)
      return fail(content.error());
    text = std::move(*content);
  }
  return given;
}

}  // namespace tedit::cli
