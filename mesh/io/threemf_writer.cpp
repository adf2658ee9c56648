// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <ostream>

#include "base/units.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/threemf_model.hpp"
#include "mesh/io/zip_file.hpp"

namespace tedit {

namespace {

constexpr std::string_view content_types =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr std::string_view relationships =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

/// As the format calls it; empty for a unit that it does not have.
std::string_view name_of_unit(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
    {"um", "micron"}, {"mm", "millimeter"}, {"cm", "centimeter"},
    {"m", "meter"},   {"in", "inch"},       {"ft", "foot"}};
  for (const auto& [ours, theirs] : names)
    if (ours == unit)
      return theirs;
  return {};
}

zipped_file packed(std::string name, std::string_view text) {
  zip_packer packer(std::move(name));
  packer.add(text);
  return packer.finish();
}

}  // namespace

namespace formats {

bool threemf::recognises(std::span<const char> bytes) {
  // The names of an archive's files stand at its end.
  constexpr std::size_t directory = std::size_t{64} << 10;
  const std::string_view text(bytes.data(), bytes.size());
  return text.starts_with("PK\x03\x04") &&
         text.substr(text.size() - std::min(text.size(), directory)).find(".model") != text.npos;
}

expected<void> threemf::write(const file_target& to, const mesh_version& mesh,
                              const file_terms& terms) {
  const auto unit = metres_per_unit(terms.length_unit);
  if (!unit)
    return fail(unit.error());
  const auto unit_name = name_of_unit(terms.length_unit);
  if (unit_name.empty())
    return fail(ec::invalid_argument, "a 3MF file cannot be in " + terms.length_unit,
                "Take um, mm, cm, m, in or ft as its unit");
  const std::array files{packed("[Content_Types].xml", content_types),
                         packed("_rels/.rels", relationships),
                         threemf_model(mesh, terms, unit_name, *unit)};
  if (!fits_zip(files))
    return fail(ec::invalid_argument, "the part is too large for a 3MF file, which ends at 4 GiB",
                "Write it as .stl, or make the mesh coarser");
  return to.write([&](std::ostream& out) { write_zip(out, files); });
}

}  // namespace formats

}  // namespace tedit
