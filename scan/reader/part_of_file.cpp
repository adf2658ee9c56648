// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/reader/part_of_file.hpp"

#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "base/units.hpp"
#include "scan/reader/mend.hpp"

namespace tedit::scan {

namespace {

constexpr double metres_per_mm = 1e-3;
/// Smaller than an atom or larger than a town: a unit gone wrong.
constexpr double least_extent_mm = 1e-6;
constexpr double most_extent_mm = 1e9;

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

class part_maker {
public:
  part_maker(file_surface read, const std::function<void(double, const char*)>& stage)
      : read_(std::move(read)), stage_(stage) {
    made_.facts.notices = std::move(read_.notices);
  }

  expected<part_of_file> run(const std::string& unit) {
    if (const auto scaled = to_mm(unit); !scaled)
      return fail(scaled.error());
    if (const auto mended = mend_either_way(); !mended)
      return fail(mended.error());
    stage_(0.7, "finding planes, cylinders and free forms");
    divide();
    add_solids();
    made_.part.surface = std::move(read_.surface);
    return std::move(made_);
  }

private:
  void tell(std::string sentence) { made_.facts.notices.push_back(std::move(sentence)); }

  expected<void> to_mm(const std::string& asked) {
    const auto unit = read_.unit.empty() ? asked : read_.unit;
    const auto metres = metres_per_unit(unit);
    if (!metres)
      return fail(metres.error());
    made_.facts.length_unit = unit;
    if (!asked.empty() && unit != asked)
      tell("the file says that its lengths are in " + unit + "; they are read so, not in " + asked);
    for (auto& p : read_.surface.points)
      p = *metres / metres_per_mm * p;
    const double extent = extent_of(read_.surface);
    if (extent >= least_extent_mm && extent <= most_extent_mm)
      return {};
    return fail(ec::bad_input,
                "the surface measures " + format_number("%.3g", extent) + " mm across",
                "Check the unit and the coordinates of the file");
  }

  /// What fits together to the last bit stays as it is where that is sound: a tolerance closes
  /// narrow gaps, too. Else flat triangles and near points go, which may have been all that was
  /// wrong.
  expected<void> mend_either_way() {
    stage_(0.3, "mending the surface");
    const auto as_read = read_;
    const auto notices = made_.facts.notices;
    const auto exactly = mend(0);
    if (exactly)
      return exactly;
    read_ = as_read;
    made_.facts.notices = notices;
    stage_(0.4, "mending the surface within a tolerance");
    return mend(weld_tolerance(as_read.surface));
  }

  expected<void> mend(double tolerance) {
    const auto welded = weld(read_, tolerance);
    if (tolerance == 0 && !is_closed(read_.surface))
      return fail(ec::bad_input, "the surface is not closed to the last bit");
    if (welded.degenerate > 0)
      tell(counted(welded.degenerate, "triangle", "triangles") + " without area left out");
    if (welded.duplicate > 0)
      tell(counted(welded.duplicate, "triangle", "triangles") + " that were there twice left out");
    const auto sewn = sew(read_);
    if (!sewn)
      return fail(sewn.error());
    if (sewn->merged + sewn->split > 0 && sewn->widest_mm > 1e-6 * extent_of(read_.surface))
      tell("gaps up to " + format_number("%.3g", sewn->widest_mm) + " mm wide are closed (" +
           counted(sewn->merged + sewn->split, "point", "points") + ")");
    if (sewn->filled > 0)
      tell(counted(sewn->filled, "small hole", "small holes") + " filled");
    if (read_.surface.triangles.size() < 4)
      return fail(ec::bad_input, "the file's triangles enclose nothing",
                  "Check the unit and the coordinates of the file");
    if (const auto edges = check_edges(read_.surface); !edges)
      return fail(edges.error());
    auto shells = orient(read_.surface);
    if (!shells)
      return fail(shells.error());
    shells_ = std::move(*shells);
    tell_of_shells();
    return check_intersections(read_.surface);
  }

  void tell_of_shells() {
    if (shells_.turned > 0)
      tell(counted(shells_.turned, "triangle", "triangles") +
           " that looked another way than those around turned");
    if (shells_.inward > 0)
      tell("the surface looked inward: turned");
    if (shells_.cavities > 0)
      tell(counted(shells_.cavities, "inner surface is a cavity", "inner surfaces are cavities"));
    if (shells_.solids > 1)
      tell("the file holds " + std::to_string(shells_.solids) +
           " bodies that do not touch: each is a region of its own, and no force passes between "
           "them");
  }

  void divide() {
    auto& part = made_.part;
    auto found = segment_surface(read_.surface, limits_for(read_.surface), read_.group_of);
    part.patch_of = std::move(found.patch_of);
    part.shapes = std::move(found.shapes);
    std::vector<std::uint32_t> first(part.shapes.size(), no_id);
    for (std::uint32_t t = 0; t < part.patch_of.size(); ++t)
      if (first[part.patch_of[t]] == no_id)
        first[part.patch_of[t]] = t;
    number_groups();
    for (std::size_t i = 0; i < part.shapes.size(); ++i) {
      part.solid_of.push_back(shells_.solid_of[shells_.shell_of[first[i]]]);
      made_.facts.faces.push_back(face_at(i, first[i]));
    }
    for (std::size_t t = 0; t < part.patch_of.size(); ++t)
      made_.facts.faces[part.patch_of[t]].area_mm2 += area_of(t);
  }

  double area_of(std::size_t t) const {
    const auto& v = read_.surface.triangles[t];
    const vec3 a = read_.surface.points[v[0]];
    return 0.5 * norm(cross(read_.surface.points[v[1]] - a, read_.surface.points[v[2]] - a));
  }

  /// The ids that the file says where all groups have one of their own, else from 1.
  void number_groups() {
    std::set<surface_id> ids;
    for (const auto& group : read_.groups)
      ids.insert(group.id);
    if (ids.size() == read_.groups.size() && !ids.contains(0))
      return;
    surface_id next = 0;
    for (auto& group : read_.groups)
      group.id = ++next;
  }

  cad::face_facts face_at(std::size_t patch, std::uint32_t triangle) const {
    if (!read_.group_of.empty()) {
      const auto& group = read_.groups[read_.group_of[triangle]];
      return {group.name, group.looks, 0, {static_cast<int>(group.id)}};
    }
    const auto id = static_cast<int>(patch) + 1;
    return {tedit::name_of(made_.part.shapes[patch], id, 1), {}, 0, {id}};
  }

  void add_solids() {
    made_.facts.solids.resize(shells_.solids);
    for (std::size_t t = 0; t < read_.surface.triangles.size(); ++t) {
      auto& solid = made_.facts.solids[shells_.solid_of[shells_.shell_of[t]]];
      const auto& v = read_.surface.triangles[t];
      solid.area_mm2 += area_of(t);
      solid.volume_mm3 += dot(read_.surface.points[v[0]],
                              cross(read_.surface.points[v[1]], read_.surface.points[v[2]])) /
                          6;
      const std::size_t body = read_.body_of.empty() ? 0 : read_.body_of[t];
      if (solid.name.empty() && body < read_.bodies.size())
        solid.name = read_.bodies[body];
    }
  }

  file_surface read_;
  const std::function<void(double, const char*)>& stage_;
  shell_set shells_;
  part_of_file made_;
};

}  // namespace

expected<part_of_file> make_part(file_surface read, const std::string& unit,
                                 const std::function<void(double, const char*)>& stage) {
  return part_maker(std::move(read), stage).run(unit);
}

}  // namespace tedit::scan
