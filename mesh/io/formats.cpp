// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/formats.hpp"

#include "base/text.hpp"
#include "mesh/io/foreign_file.hpp"

namespace tedit {

namespace {

struct format_functions {
  file_writer* write = nullptr;
  file_reader* read = nullptr;
  file_recogniser* recognises = nullptr;
};

template <class Format>
constexpr format_functions functions_of() {
  format_functions result;
  if constexpr (requires { Format::write; })
    result.write = Format::write;
  if constexpr (requires { Format::read; })
    result.read = Format::read;
  if constexpr (requires { Format::recognises; })
    result.recognises = Format::recognises;
  return result;
}

template <class... Format>
constexpr auto functions_of(const std::tuple<Format...>*) {
  return std::array{functions_of<Format>()...};
}

/// In the order of `file_formats`.
constexpr auto functions = functions_of(static_cast<formats::all*>(nullptr));

}  // namespace

expected<void> write_as(std::string_view format, const file_target& to, const mesh_version& mesh,
                        const file_terms& terms) {
  const auto* found = find_format(format);
  if (!found || !found->writes)
    return fail(no_such_format(format, written_formats()));
  return functions[static_cast<std::size_t>(found - file_formats.data())].write(to, mesh, terms);
}

expected<read_mesh> read_any(std::span<const char> bytes) {
  bytes = without_mark(bytes);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (!functions[i].recognises || !functions[i].recognises(bytes))
      continue;
    if (functions[i].read)
      return functions[i].read(bytes);
    return fail(ec::unsupported_format,
                "this is " + std::string(file_formats[i].kind) + ", not a Gmsh mesh",
                file_formats[i].keeps.tets ? "Choose a .msh file"
                                           : "Mesh its volume first, for example with Gmsh");
  }
  if (auto foreign = foreign_file(bytes))
    return fail(std::move(*foreign));
  return formats::msh::read(bytes);
}

}  // namespace tedit
