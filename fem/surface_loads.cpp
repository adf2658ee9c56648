// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/surface_loads.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include <Eigen/Dense>

#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

Eigen::Vector3d eigen(vec3 v) {
  return {v.x, v.y, v.z};
}

vec3 plain(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string newtons(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g N", value);
  return text;
}

/// Second moments of a patch's area about its centroid: the integral of |r|^2 - r r^T, m^4.
struct area_moments {
  vec3 centroid;
  Eigen::Matrix3d about_centroid = Eigen::Matrix3d::Zero();
};

area_moments moments_of(const loaded_patch& patch) {
  area_moments result;
  patch.for_each([&](const surface_triangles::triangle& t, vec3 area) {
    const auto c = patch.corners(t);
    result.centroid += (norm(area) / (3 * patch.area())) * (c[0] + c[1] + c[2]);
  });
  patch.for_each([&](const surface_triangles::triangle& t, vec3 area) {
    // Over a triangle the integral of r r^T is area/12 (sum r_i r_i^T + s s^T), s the sum of r_i.
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto corner : patch.corners(t)) {
      const auto r = eigen(corner - result.centroid);
      products += r * r.transpose();
      sum += r;
    }
    products += sum * sum.transpose();
    result.about_centroid +=
      (norm(area) / 12) * (products.trace() * Eigen::Matrix3d::Identity() - products);
  });
  return result;
}

}  // namespace

loaded_patch::loaded_patch(const surface_triangles& triangles, const problem& p,
                           const std::vector<surface_id>& surfaces)
    : p_(p) {
  for (const auto id : surfaces)
    for (const auto& t : triangles.of(id)) {
      triangles_.push_back(&t);
      area_ += norm(area_of(p, t));
      if (t.interface && !interface_)
        interface_ = id;
    }
}

void loaded_patch::for_each(
  const std::function<void(const surface_triangles::triangle&, vec3)>& visit) const {
  polled_for(
    triangles_.size(), [&](std::size_t i) { visit(*triangles_[i], area_of(p_, *triangles_[i])); },
    triangles_between);
}

std::array<vec3, 3> loaded_patch::corners(const surface_triangles::triangle& t) const {
  return {p_.nodes[t.nodes[0]], p_.nodes[t.nodes[1]], p_.nodes[t.nodes[2]]};
}

expected<linear_traction> spread_evenly(const loaded_patch& patch, vec3 force_n, vec3 moment_nm,
                                        vec3 at_m, const std::string& name) {
  const auto moments = moments_of(patch);
  const Eigen::Vector3d about_centroid =
    eigen(moment_nm) + eigen(at_m - moments.centroid).cross(eigen(force_n));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.about_centroid);
  constexpr double narrow = 1e-12;  // A strip a million times as long as it is wide.
  if (!(axes.eigenvalues()[0] > narrow * axes.eigenvalues()[2]))
    return fail(ec::invalid_load, name + " has a moment, and its surfaces are only a line",
                "Put it on surfaces with a width");
  const vec3 turn = plain(axes.eigenvectors() * axes.eigenvalues().cwiseInverse().asDiagonal() *
                          axes.eigenvectors().transpose() * about_centroid);
  return [even = force_n / patch.area(), turn, centroid = moments.centroid](vec3 place) {
    return even + cross(turn, place - centroid);
  };
}

vec3 bearing_pressure::on(vec3 area_vector) const {
  if (!(dot(area_vector, direction) < 0))
    return {};
  const vec3 n = normalized(area_vector);
  return dot(n, slope_pa) * n + rest_pa;
}

namespace {

/// What n (n . slope) on the triangles that look against `direction` must have as its slope.
struct pin_slope {
  vec3 slope_pa;
  vec3 rest_n;          ///< What such a wall cannot take: along a straight bore.
  double carrying = 0;  ///< m^2.
};

pin_slope slope_for(const loaded_patch& patch, vec3 force_n, vec3 direction) {
  pin_slope result;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // The resultant by the slope, m^2.
  patch.for_each([&](const surface_triangles::triangle&, vec3 area) {
    if (!(dot(area, direction) < 0))
      return;
    const auto n = eigen(normalized(area));
    stiffness += norm(area) * n * n.transpose();
    result.carrying += norm(area);
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(stiffness);
  // A wall whose slope is below 2 degrees is straight: it cannot push along its axis.
  constexpr double straight = 1e-3;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  Eigen::Vector3d carried = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = axes.eigenvectors().col(i);
    const double part = axis.dot(eigen(force_n));
    if (!(axes.eigenvalues()[i] > straight * axes.eigenvalues()[2]))
      continue;
    slope += (part / axes.eigenvalues()[i]) * axis;
    carried += part * axis;
  }
  result.slope_pa = plain(slope);
  result.rest_n = force_n - plain(carried);
  return result;
}

}  // namespace

expected<bearing_pressure> press_like_a_pin(const loaded_patch& patch, vec3 force_n,
                                            const std::string& name) {
  // Where the wall ends before the half that the force faces does, the pressure leans to the other
  // side; what it would pull at then is left out, and the rest carries.
  vec3 direction = force_n;
  auto now = slope_for(patch, force_n, direction);
  constexpr int most_turns = 20;
  for (int turn = 0; turn < most_turns && now.carrying > 0; ++turn) {
    const auto next = slope_for(patch, force_n, now.slope_pa);
    const bool same = next.carrying == now.carrying;
    if (!(next.carrying > 0))
      break;
    direction = std::exchange(now, next).slope_pa;
    if (same)
      break;
  }
  if (!(now.carrying > 0))
    return fail(ec::invalid_load, name + " presses on no wall: none of its surfaces faces it",
                "Turn the force round, or put it on the wall of a bore");
  constexpr double along = 1e-2;
  if (norm(now.rest_n) > along * norm(force_n))
    return fail(ec::invalid_load,
                name + " has " + newtons(norm(now.rest_n)) +
                  " along the bore, where its wall cannot take a pin's pressure",
                "Give that part as a force of its own");
  return bearing_pressure{direction, now.slope_pa, now.rest_n / now.carrying};
}

}  // namespace tedit::fem
