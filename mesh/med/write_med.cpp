// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstring>

#include "mesh/med/med_file.hpp"
#include "mesh/med/med_jobs.hpp"

namespace tedit::med {

namespace {

void check(med_err done, const char* what) {
  if (done < 0)
    refuse(ec::internal, std::string("libmed cannot write ") + what, "Try again, or write .unv");
}

/// Fields of a fixed width one behind the other, as libmed wants several texts.
std::string in_fields(const std::vector<std::string>& texts, std::size_t width, char filled_with) {
  std::string result;
  for (auto text : texts) {
    text.resize(width, filled_with);
    result += text;
  }
  return result;
}

void write_elements(med_idt id, const char* mesh, med_geometry_type kind,
                    const med_content::elements& all) {
  const auto count = static_cast<med_int>(all.families.size());
  if (count == 0)
    return;
  check(MEDmeshElementConnectivityWr(id, mesh, MED_NO_DT, MED_NO_IT, MED_UNDEF_DT, MED_CELL, kind,
                                     MED_NODAL, MED_FULL_INTERLACE, count, all.nodes.data()),
        "elements");
  check(MEDmeshEntityFamilyNumberWr(id, mesh, MED_NO_DT, MED_NO_IT, MED_CELL, kind, count,
                                    all.families.data()),
        "families of elements");
}

void write_families(med_idt id, const char* mesh, const med_content& content) {
  // The one of all that is in no group: readers look for it.
  check(MEDfamilyCr(id, mesh, "FAMILLE_ZERO", 0, 0, ""), "the family zero");
  for (const auto& one : content.families)
    check(
      MEDfamilyCr(id, mesh, one.name.c_str(), one.number, static_cast<med_int>(one.groups.size()),
                  in_fields(one.groups, MED_LNAME_SIZE, '\0').c_str()),
      "a family");
}

}  // namespace

std::vector<char> write_med(const med_content& content) {
  med_file file;
  const char* mesh = content.name.c_str();
  const std::vector<std::string> axes{"x", "y", "z"};
  const std::vector<std::string> units(3, content.unit);
  check(MEDmeshCr(file.id(), mesh, 3, 3, MED_UNSTRUCTURED_MESH, "", "", MED_SORT_DTIT,
                  MED_CARTESIAN, in_fields(axes, MED_SNAME_SIZE, ' ').c_str(),
                  in_fields(units, MED_SNAME_SIZE, ' ').c_str()),
        "the mesh");
  check(MEDmeshNodeCoordinateWr(
          file.id(), mesh, MED_NO_DT, MED_NO_IT, MED_UNDEF_DT, MED_FULL_INTERLACE,
          static_cast<med_int>(content.coordinates.size() / 3), content.coordinates.data()),
        "coordinates");
  if (const auto& nodes = content.node_families; !nodes.empty())
    check(MEDmeshEntityFamilyNumberWr(file.id(), mesh, MED_NO_DT, MED_NO_IT, MED_NODE, MED_NONE,
                                      static_cast<med_int>(nodes.size()), nodes.data()),
          "families of nodes");
  write_elements(file.id(), mesh, MED_TETRA4, content.tets);
  write_elements(file.id(), mesh, MED_TETRA10, content.tets10);
  write_elements(file.id(), mesh, MED_TRIA3, content.triangles);
  write_families(file.id(), mesh, content);
  return file.close();
}

}  // namespace tedit::med
