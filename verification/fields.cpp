// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/fields.hpp"

#include <algorithm>
#include <cmath>

#include "fem/element.hpp"
#include "fem/quadratic.hpp"

namespace tedit::verification {

namespace {

using barycentric = std::array<double, 4>;

struct tet_point {
  barycentric at;
  double weight = 0;  ///< Fraction of the volume.
};

/// Four Gauss-Legendre points on [0, 1]: exact for degree 7.
constexpr std::array<std::array<double, 2>, 4> line_rule{
  {{0.069431844202973712, 0.17392742256872693},
   {0.33000947820757187, 0.32607257743127307},
   {0.66999052179242813, 0.32607257743127307},
   {0.93056815579702629, 0.17392742256872693}}};

/// The cube's product rule collapsed to the tet (Stroud's conical product): the Jacobian takes two
/// of the seven degrees, so 5 remain.
const std::vector<tet_point>& tet_rule() {
  static const auto rule = [] {
    std::vector<tet_point> points;
    for (const auto& [a, wa] : line_rule)
      for (const auto& [b, wb] : line_rule)
        for (const auto& [c, wc] : line_rule) {
          const double rest = (1 - a) * (1 - b);
          points.push_back({{a, (1 - a) * b, rest * c, rest * (1 - c)},
                            6 * wa * wb * wc * (1 - a) * (1 - a) * (1 - b)});
        }
    return points;
  }();
  return rule;
}

/// The same on the face opposite a corner: degree 6.
std::vector<tet_point> face_rule(int opposite) {
  std::vector<tet_point> points;
  const auto& f = tet_faces[opposite];
  for (const auto& [a, wa] : line_rule)
    for (const auto& [b, wb] : line_rule) {
      tet_point point{{}, 2 * wa * wb * (1 - a)};
      point.at[f[0]] = a;
      point.at[f[1]] = (1 - a) * b;
      point.at[f[2]] = (1 - a) * (1 - b);
      points.push_back(point);
    }
  return points;
}

/// An element's nodes and what is needed to evaluate its fields.
class element_view {
public:
  element_view(const fem::problem& p, std::size_t e)
      : p_(p),
        count_(static_cast<std::size_t>(p.nodes_per_element)),
        nodes_(&p.element_nodes[count_ * e]),
        g_(fem::gradients_of(p, e)) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::uint32_t node(std::size_t a) const { return nodes_[a]; }
  [[nodiscard]] double volume() const { return g_.volume; }

  [[nodiscard]] vec3 position(const barycentric& l) const {
    vec3 x;
    for (int k = 0; k < 4; ++k)
      x += l[k] * p_.nodes[nodes_[k]];
    return x;
  }

  [[nodiscard]] double shape(std::size_t a, const barycentric& l) const {
    if (count_ == 4)
      return l[a];
    if (a < 4)
      return l[a] * (2 * l[a] - 1);
    const auto [i, j] = fem::ends_of_mid_node[a - 4];
    return 4 * l[i] * l[j];
  }

  [[nodiscard]] vec3 shape_gradient(std::size_t a, const barycentric& l) const {
    if (count_ == 4)
      return g_.gradient[a];
    if (a < 4)
      return (4 * l[a] - 1) * g_.gradient[a];
    const auto [i, j] = fem::ends_of_mid_node[a - 4];
    return 4 * (l[i] * g_.gradient[j] + l[j] * g_.gradient[i]);
  }

private:
  const fem::problem& p_;
  std::size_t count_;
  const std::uint32_t* nodes_;
  fem::tet_gradients g_;
};

void add_force(fem::problem& p, std::uint32_t node, vec3 force) {
  p.loads[3 * node] += force.x;
  p.loads[3 * node + 1] += force.y;
  p.loads[3 * node + 2] += force.z;
}

bool contains(std::span<const surface_id> surfaces, surface_id id) {
  return std::ranges::find(surfaces, id) != surfaces.end();
}

/// A facet as a face of an element.
struct element_face {
  std::size_t element = 0;
  int opposite = 0;  ///< Local corner that the face does not have.
  vec3 area;         ///< Outward normal times area, m^2.
};

std::vector<element_face> faces_of(const fem::problem& p, const mesh_version& mesh,
                                   std::span<const surface_id> surfaces) {
  std::vector<std::size_t> element_of(mesh.tet_slots());
  for (std::size_t e = 0; e < p.element_count(); ++e)
    element_of[p.element_tets[e]] = e;
  std::vector<element_face> faces;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f) || !contains(surfaces, mesh.facet(f).surface))
      continue;
    const auto& facet = mesh.facet(f);
    const auto e = element_of[facet.tet];
    const element_view element(p, e);
    for (int k = 0; k < 4; ++k)
      if (std::ranges::find(facet.v, p.node_vertices[element.node(k)]) == facet.v.end())
        faces.push_back({e, k, area_vector(mesh, facet)});
  }
  return faces;
}

double energy_density(const std::array<vec3, 3>& g, const fem::lame_constants& c) {
  const auto s = fem::stress_of(g, c);
  return s[0] * g[0].x + s[1] * g[1].y + s[2] * g[2].z + s[3] * (g[0].y + g[1].x) +
         s[4] * (g[1].z + g[2].y) + s[5] * (g[2].x + g[0].z);
}

}  // namespace

vec3 traction_of(const std::array<double, 6>& s, vec3 n) {
  return {s[0] * n.x + s[3] * n.y + s[5] * n.z, s[3] * n.x + s[1] * n.y + s[4] * n.z,
          s[5] * n.x + s[4] * n.y + s[2] * n.z};
}

void clear_conditions(fem::problem& p) {
  std::ranges::fill(p.loads, 0.0);
  std::ranges::fill(p.prescribed, 0.0);
  p.filter.assign(p.node_count(), {1, 0, 0, 1, 0, 1});
  p.holders.clear();
}

void prescribe(fem::problem& p, std::size_t node, int axis, double value) {
  constexpr std::array diagonal{0, 3, 5};
  p.filter[node][diagonal[axis]] = 0;
  p.prescribed[3 * node + axis] = value;
}

std::vector<std::size_t> nodes_on(const fem::problem& p, const mesh_version& mesh,
                                  std::span<const surface_id> surfaces) {
  std::vector<std::size_t> nodes;
  for (const auto& face : faces_of(p, mesh, surfaces)) {
    const element_view element(p, face.element);
    // A node lies on the face when it does not belong to the opposite corner in any way.
    barycentric middle;
    middle.fill(1.0 / 3);
    middle[face.opposite] = 0;
    for (std::size_t a = 0; a < element.count(); ++a)
      if (element.shape(a, middle) != 0)
        nodes.push_back(element.node(a));
  }
  std::ranges::sort(nodes);
  const auto rest = std::ranges::unique(nodes);
  nodes.erase(rest.begin(), rest.end());
  return nodes;
}

void prescribe(fem::problem& p, const mesh_version& mesh, std::span<const surface_id> surfaces,
               const vector_field& u) {
  for (const auto node : nodes_on(p, mesh, surfaces)) {
    const vec3 value = u(p.nodes[node]);
    prescribe(p, node, 0, value.x);
    prescribe(p, node, 1, value.y);
    prescribe(p, node, 2, value.z);
  }
}

void add_traction(fem::problem& p, const mesh_version& mesh, std::span<const surface_id> surfaces,
                  const stress_field& stress) {
  for (const auto& face : faces_of(p, mesh, surfaces)) {
    const element_view element(p, face.element);
    for (const auto& point : face_rule(face.opposite)) {
      const vec3 force = point.weight * traction_of(stress(element.position(point.at)), face.area);
      for (std::size_t a = 0; a < element.count(); ++a)
        add_force(p, element.node(a), element.shape(a, point.at) * force);
    }
  }
}

void add_body_force(fem::problem& p, const vector_field& density) {
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const element_view element(p, e);
    for (const auto& point : tet_rule()) {
      const vec3 force = (point.weight * element.volume()) * density(element.position(point.at));
      for (std::size_t a = 0; a < element.count(); ++a)
        add_force(p, element.node(a), element.shape(a, point.at) * force);
    }
  }
}

void add_initial_stress(fem::problem& p, const stress_field& stress) {
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const element_view element(p, e);
    for (const auto& point : tet_rule()) {
      const auto at_point = stress(element.position(point.at));
      const double weight = point.weight * element.volume();
      for (std::size_t a = 0; a < element.count(); ++a)
        add_force(p, element.node(a),
                  weight * traction_of(at_point, element.shape_gradient(a, point.at)));
    }
  }
}

std::size_t nearest_node(const fem::problem& p, vec3 at, bool corners_only) {
  std::size_t best = 0;
  for (std::size_t n = 0; n < (corners_only ? p.corner_count : p.node_count()); ++n)
    if (norm(p.nodes[n] - at) < norm(p.nodes[best] - at))
      best = n;
  return best;
}

vec3 node_value(std::span<const double> values, std::size_t node) {
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}

double largest_error(const fem::problem& p, std::span<const double> displacement,
                     const vector_field& u) {
  double error = 0;
  double scale = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const vec3 exact = u(p.nodes[n]);
    error = std::max(error, norm(node_value(displacement, n) - exact));
    scale = std::max(scale, norm(exact));
  }
  return error / scale;
}

field_errors errors_of(const fem::problem& p, std::span<const double> displacement,
                       const vector_field& u,
                       const std::function<std::array<vec3, 3>(vec3)>& gradient) {
  field_errors error;
  field_errors size;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const element_view element(p, e);
    const auto& c = p.constants[p.element_materials[e]];
    for (const auto& point : tet_rule()) {
      const vec3 x = element.position(point.at);
      const double weight = point.weight * element.volume();
      const vec3 exact = u(x);
      const auto exact_gradient = gradient(x);
      vec3 rest = -exact;
      auto rest_gradient = exact_gradient;
      for (std::size_t a = 0; a < element.count(); ++a) {
        const vec3 value = node_value(displacement, element.node(a));
        const vec3 slope = element.shape_gradient(a, point.at);
        rest += element.shape(a, point.at) * value;
        rest_gradient[0] += -value.x * slope;
        rest_gradient[1] += -value.y * slope;
        rest_gradient[2] += -value.z * slope;
      }
      error.l2 += weight * dot(rest, rest);
      size.l2 += weight * dot(exact, exact);
      error.energy += weight * energy_density(rest_gradient, c);
      size.energy += weight * energy_density(exact_gradient, c);
    }
  }
  return {std::sqrt(error.l2 / size.l2), std::sqrt(error.energy / size.energy)};
}

}  // namespace tedit::verification
