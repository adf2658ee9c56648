// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/load_glyphs.hpp"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "client-qt/model/document.hpp"
#include "client-qt/model/load_editing.hpp"
#include "client-qt/tools/results/field_panel.hpp"

namespace tedit::desktop {

namespace {

constexpr std::size_t most_places = 24;
constexpr std::size_t candidates_a_place = 12;
constexpr double arrow_part = 0.075;   // Of the part's diagonal.
constexpr double support_part = 0.02;  // Height of a pyramid.
constexpr int arrow_sides = 14;
// A pin presses hardly where its bore is seen almost along the force.
constexpr double nearly_along = 0.05;

vec3 unit(const vec3& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? (1 / size) * v : vec3{};
}

/// Two directions at right angles to a unit vector and to each other.
std::pair<vec3, vec3> across(const vec3& along) {
  const vec3 other = std::abs(along.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  const vec3 u = unit(cross(along, other));
  return {u, cross(along, u)};
}

struct triangle {
  std::array<vec3, 3> p;
  vec3 area;  ///< Twice, as a vector outward.
};

/// Positions as drawn.
class drawn_positions {
public:
  explicit drawn_positions(const shown_part& part) : part_(part) {
    moves_ = part.deform != 0 && part.field &&
             part.field->version_id() == part.surface->version_id() &&
             !part.field->values.of("displacement_m").empty();
  }

  [[nodiscard]] vec3 at(std::uint32_t slot) const {
    const vec3 rest = *part_.surface->positions().find(slot);
    if (!moves_)
      return rest;
    const auto& slots_of = part_.field->vertices;
    const auto found = std::ranges::lower_bound(slots_of, slot);
    if (found == slots_of.end() || *found != slot)
      return rest;
    const auto* u = &part_.field->values.of("displacement_m")[3 * (found - slots_of.begin())];
    return rest + part_.deform * vec3{u[0], u[1], u[2]};
  }

private:
  const shown_part& part_;
  bool moves_ = false;
};

std::vector<triangle> triangles_of(const shown_part& part,
                                   const std::vector<surface_id>& surfaces) {
  const std::set<surface_id> wanted(surfaces.begin(), surfaces.end());
  const drawn_positions drawn(part);
  std::vector<triangle> result;
  part.surface->facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
    if (!wanted.contains(f.surface))
      return;
    triangle t{{drawn.at(f.v[0]), drawn.at(f.v[1]), drawn.at(f.v[2])}, {}};
    t.area = cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
    result.push_back(t);
  });
  return result;
}

/// Even steps through the summed area: where there is more of it, there are more places.
std::vector<surface_place> by_area(const std::vector<triangle>& all, std::size_t count) {
  double total = 0;
  for (const auto& t : all)
    total += std::sqrt(dot(t.area, t.area));
  std::vector<surface_place> result;
  double passed = 0;
  for (const auto& t : all) {
    const double size = std::sqrt(dot(t.area, t.area));
    passed += size;
    // The first wanted place within this triangle; one a triangle is enough.
    const double next =
      (static_cast<double>(result.size()) + 0.5) * total / static_cast<double>(count);
    if (size > 0 && passed >= next)
      result.push_back({(1.0 / 3) * (t.p[0] + t.p[1] + t.p[2]), (1 / size) * t.area});
  }
  return result;
}

/// Collects triangles.
class shape {
public:
  vtkIdType point(const vec3& at) { return points_->InsertNextPoint(at.x, at.y, at.z); }
  void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
    const std::array<vtkIdType, 3> ids{a, b, c};
    cells_->InsertNextCell(3, ids.data());
  }

  /// A cone without or with its base, from the base's middle to the apex.
  void cone(const vec3& base, const vec3& apex, double radius, int sides) {
    const vec3 along = unit(apex - base);
    const auto ring = circle(base, along, radius, sides);
    const auto tip = point(apex);
    const auto middle = point(base);
    for (int i = 0; i < sides; ++i) {
      triangle(ring[i], ring[(i + 1) % sides], tip);
      triangle(ring[(i + 1) % sides], ring[i], middle);
    }
  }

  void tube(const vec3& from, const vec3& to, double radius, int sides) {
    const vec3 along = unit(to - from);
    const auto a = circle(from, along, radius, sides);
    const auto b = circle(to, along, radius, sides);
    const auto middle = point(from);
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      triangle(a[i], a[j], b[j]);
      triangle(a[i], b[j], b[i]);
      triangle(a[j], a[i], middle);
    }
  }

  void arrow(const vec3& from, const vec3& to) {
    const double length = std::sqrt(dot(to - from, to - from));
    const vec3 neck = from + 0.66 * (to - from);
    tube(from, neck, 0.035 * length, arrow_sides);
    cone(neck, to, 0.1 * length, arrow_sides);
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> take() {
    if (cells_->GetNumberOfCells() == 0)
      return nullptr;
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(points_);
    result->SetPolys(cells_);
    return result;
  }

private:
  std::vector<vtkIdType> circle(const vec3& middle, const vec3& along, double radius, int sides) {
    const auto [u, v] = across(along);
    std::vector<vtkIdType> ring;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
      ring.push_back(point(middle + radius * std::cos(angle) * u + radius * std::sin(angle) * v));
    }
    return ring;
  }

  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
};

/// Everything about one drawing.
struct drawing {
  const shown_part& part;
  vec3 low;
  vec3 high;
  double diagonal = 0;
  shape loads;
  shape supports;

  explicit drawing(const shown_part& what) : part(what) {
    low = {INFINITY, INFINITY, INFINITY};
    high = {-INFINITY, -INFINITY, -INFINITY};
    part.surface->facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
      for (const auto slot : f.v) {
        const vec3& p = *part.surface->positions().find(slot);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    });
    diagonal = std::sqrt(dot(high - low, high - low));
  }

  [[nodiscard]] std::vector<surface_place> places(const std::vector<surface_id>& surfaces,
                                                  double spacing) const {
    return spread(part, surfaces, most_places, spacing * diagonal);
  }

  [[nodiscard]] double area_of(const std::vector<surface_id>& surfaces) const {
    double sum = 0;
    for (const auto id : surfaces)
      if (const auto row = part.surface->surfaces().find(id); row != part.surface->surfaces().end())
        sum += row->second.area_m2;
    return sum;
  }

  /// What pushes on the part ends on it, what pulls begins there.
  void arrow_at(const surface_place& place, const vec3& along) {
    const double length = arrow_part * diagonal;
    if (dot(along, place.normal) <= 0)
      loads.arrow(place.at - length * along, place.at);
    else
      loads.arrow(place.at, place.at + length * along);
  }

  /// Of a draft it may have no size yet, so no direction.
  void same_way(const fem::load& load, const vec3& way) {
    if (way == vec3{})
      return;
    for (const auto& place : places(load.surfaces, 0.05))
      arrow_at(place, unit(way));
  }

  void draw(const fem::load& load) {
    if (const auto* force = std::get_if<fem::force>(&load.kind)) {
      same_way(load, force->total_n);
    } else if (const auto* traction = std::get_if<fem::traction>(&load.kind)) {
      same_way(load, traction->pa);
    } else if (const auto* pressure = std::get_if<fem::pressure>(&load.kind)) {
      along_normals(load, [&](const surface_place& place) {
        return pressure->pa + dot(pressure->gradient_pa_m, place.at - pressure->at_m);
      });
    } else if (const auto* push = std::get_if<fem::normal_force>(&load.kind)) {
      along_normals(load, [&](const surface_place&) { return push->total_n; });
    } else if (const auto* pin = std::get_if<fem::bearing_force>(&load.kind)) {
      along_normals(load, [&](const surface_place& place) {
        return std::max(0.0, -dot(unit(pin->total_n), place.normal) - nearly_along);
      });
    } else if (const auto* couple = std::get_if<fem::moment>(&load.kind)) {
      turning(load, couple->total_nm);
    } else if (const auto* far = std::get_if<fem::remote_force>(&load.kind)) {
      lever(load, *far);
    } else if (const auto* gravity = std::get_if<fem::gravity>(&load.kind)) {
      draw_gravity(unit(gravity->m_s2));
    }
  }

  /// Where the size is positive it pushes on the part, where it is zero nothing acts.
  template <class Size>
  void along_normals(const fem::load& load, const Size& size) {
    for (const auto& place : places(load.surfaces, 0.05))
      if (const double pushes = size(place); pushes != 0)
        arrow_at(place, (pushes > 0 ? -1.0 : 1.0) * place.normal);
  }

  /// Where the arrows of a moment stand they turn about its axis through their middle.
  void turning(const fem::load& load, const vec3& about) {
    if (about == vec3{})
      return;
    const auto all = places(load.surfaces, 0.05);
    vec3 middle{};
    for (const auto& place : all)
      middle += (1.0 / static_cast<double>(all.size())) * place.at;
    for (const auto& place : all)
      if (const vec3 way = cross(about, place.at - middle);
          norm(way) > 1e-9 * norm(about) * diagonal)
        loads.arrow(place.at - 0.5 * arrow_part * diagonal * unit(way),
                    place.at + 0.5 * arrow_part * diagonal * unit(way));
  }

  /// The force where it acts, and thin lines from there to the surfaces.
  void lever(const fem::load& load, const fem::remote_force& far) {
    const double length = arrow_part * diagonal;
    if (far.total_n != vec3{})
      loads.arrow(far.at_m - length * unit(far.total_n), far.at_m);
    for (const auto& place : places(load.surfaces, 0.2))
      if (const vec3 way = far.at_m - place.at; norm(way) > 1e-9 * diagonal)
        loads.cone(far.at_m, place.at, 0.004 * diagonal, 6);
    turning(load, far.moment_nm);
  }

  /// One long arrow that comes onto the part's box from outside.
  void draw_gravity(const vec3& along) {
    const vec3 half = 0.5 * (high - low);
    double reach = INFINITY;
    for (const auto& [size, way] :
         {std::pair{half.x, along.x}, {half.y, along.y}, {half.z, along.z}})
      if (std::abs(way) > 1e-9)
        reach = std::min(reach, size / std::abs(way));
    const vec3 tip = low + half - (reach + 0.03 * diagonal) * along;
    loads.arrow(tip - 2 * arrow_part * diagonal * along, tip);
  }

  void draw(const fem::constraint& held) {
    const auto all = places(held.surfaces, 0.045);
    // In a narrow bore they must not meet in the middle.
    const double room = std::sqrt(area_of(held.surfaces) / std::max<double>(1, all.size()));
    const double height = std::min(support_part * diagonal, 0.5 * room);
    for (const auto& place : all) {
      if (std::holds_alternative<fem::roller>(held.kind)) {
        const vec3 middle = place.at + 0.5 * height * place.normal;
        supports.cone(middle, place.at, 0.5 * height, 10);
        supports.cone(middle, place.at + height * place.normal, 0.5 * height, 10);
      } else if (const auto* given = std::get_if<fem::prescribed_displacement>(&held.kind)) {
        const std::pair<const std::optional<double>&, vec3> ways[] = {
          {given->x_m, {1, 0, 0}}, {given->y_m, {0, 1, 0}}, {given->z_m, {0, 0, 1}}};
        for (const auto& [component, way] : ways)
          if (component)
            supports.cone(place.at + (dot(way, place.normal) < 0 ? -height : height) * way,
                          place.at, 0.45 * height, 4);
      } else {
        supports.cone(place.at + height * place.normal, place.at, 0.6 * height, 4);
      }
    }
  }
};

}  // namespace

std::vector<surface_place> spread(const shown_part& part, const std::vector<surface_id>& surfaces,
                                  std::size_t most, double spacing) {
  auto left = by_area(triangles_of(part, surfaces), most * candidates_a_place);
  std::vector<surface_place> result;
  std::vector<double> distance(left.size(), INFINITY);
  while (!left.empty() && result.size() < most) {
    // The one that is farthest from those taken; the first time the middle one of the list.
    const auto best =
      result.empty()
        ? left.size() / 2
        : static_cast<std::size_t>(std::ranges::max_element(distance) - distance.begin());
    if (!result.empty() && distance[best] < spacing)
      break;
    result.push_back(left[best]);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const vec3 way = left[i].at - result.back().at;
      distance[i] = std::min(distance[i], std::sqrt(dot(way, way)));
    }
  }
  return result;
}

load_glyphs make_glyphs(const shown_part& part, const std::vector<fem::load_case>& shown) {
  drawing all(part);
  for (const auto& one : shown) {
    for (const auto& load : one.loads)
      all.draw(load);
    for (const auto& held : one.constraints)
      all.draw(held);
  }
  return {all.loads.take(), all.supports.take()};
}

// -- in the view ---------------------------------------------------------------------

load_glyph_layer::load_glyph_layer(document& part, field_panel& fields, viewport& view)
    : QObject(&view), part_(part), fields_(fields), view_(view) {
  makers_.setMaxThreadCount(1);
  connect(&fields_, &field_panel::changed, this, &load_glyph_layer::refresh);
  connect(&part_.loads(), &load_requests::changed, this, &load_glyph_layer::refresh);
  for (auto signal : {&document::head_changed, &document::surface_changed, &document::closed})
    connect(&part_, signal, this, &load_glyph_layer::refresh);
}

load_glyph_layer::~load_glyph_layer() {
  makers_.clear();
  makers_.waitForDone();
}

void load_glyph_layer::show(bool on) {
  on_ = on;
  refresh();
}

void load_glyph_layer::set_drafts(std::vector<fem::load_case> drafts) {
  drafts_ = std::move(drafts);
  refresh();
}

void load_glyph_layer::refresh() {
  const int mine = ++generation_;
  makers_.clear();
  const auto* head = part_.head();
  const auto field = fields_.field();
  std::vector<fem::load_case> shown;
  auto all = part_.loads().all();
  for (const auto& draft : drafts_)
    if (std::ranges::find(all, draft.name, &fem::load_case::name) == all.end())
      shown.push_back(draft);
    else
      put(all, draft);
  for (const auto& one : all)
    if (!field || field->envelope || field->report.load_case == one.name)
      shown.push_back(one);
  if (!on_ || !head || !head->surface || shown.empty()) {
    view_.set_glyphs(nullptr, nullptr);
    return;
  }
  makers_.start([this, mine, shown, part = shown_part{head->surface, field, fields_.deform()}] {
    auto made = make_glyphs(part, shown);
    QMetaObject::invokeMethod(
      this,
      [this, mine, made] {
        if (mine == generation_)
          view_.set_glyphs(made.loads, made.supports);
      },
      Qt::QueuedConnection);
  });
}

}  // namespace tedit::desktop
