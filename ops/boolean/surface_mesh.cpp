// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tedit::ops {

namespace {

/// A crease that bends by more than 40 degrees has a corner there.
constexpr double straight_cosine = -0.766;

}  // namespace

void surface_mesh::connect() {
  at_.assign(vertices.size(), {});
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (const auto v : faces[f].v)
      at_[v].push_back(f);
  for (const auto& f : faces)
    if (f.frozen)
      for (const auto v : f.v)
        vertices[v].fixed = true;
  for (const auto& f : faces)
    side_count_ = std::max({side_count_, f.sides[0] + 1, f.sides[1] + 1});
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    for (std::int32_t side = 0; side < side_count_; ++side)
      if (!is_regular(v, side))
        vertices[v].fixed = true;
}

/// Are the faces of that region at v one fan, with two of them at each edge?
bool surface_mesh::is_regular(std::uint32_t v, std::int32_t side) const {
  std::vector<std::uint32_t> own;
  std::map<std::uint32_t, int> edges;
  for (const auto f : at_[v]) {
    const auto& row = faces[f];
    if (row.sides[0] != side && row.sides[1] != side)
      continue;
    own.push_back(f);
    for (const auto w : row.v)
      edges[w] += w != v;
  }
  edges.erase(v);
  return std::ranges::all_of(edges, [](const auto& row) { return row.second == 2; }) &&
         is_one_fan(std::move(own));
}

/// Do these faces at a vertex hang together over edges?
bool surface_mesh::is_one_fan(std::vector<std::uint32_t> left) const {
  if (left.empty())
    return true;
  std::vector<std::uint32_t> open{left.back()};
  left.pop_back();
  while (!open.empty()) {
    const auto f = open.back();
    open.pop_back();
    const auto beside = std::partition(left.begin(), left.end(), [&](std::uint32_t g) {
      return std::ranges::count_if(faces[g].v, [&](auto w) { return has(f, w); }) < 2;
    });
    open.insert(open.end(), beside, left.end());
    left.erase(beside, left.end());
  }
  return left.empty();
}

std::vector<std::uint32_t> surface_mesh::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> result;
  for (const auto f : at_[v])
    for (const auto w : faces[f].v)
      if (w != v && std::ranges::find(result, w) == result.end())
        result.push_back(w);
  return result;
}

bool surface_mesh::faces_of_edge(std::uint32_t a, std::uint32_t b,
                                 std::array<std::uint32_t, 2>& found) const {
  int count = 0;
  for (const auto f : at_[a])
    if (has(f, b)) {
      if (count < 2)
        found[count] = f;
      ++count;
    }
  return count == 2;
}

std::vector<std::uint32_t> surface_mesh::all_faces_of_edge(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> result;
  if (is_edge(a, b))
    for (const auto f : at_[a])
      if (has(f, b))
        result.push_back(f);
  return result;
}

bool surface_mesh::is_edge(std::uint32_t a, std::uint32_t b) const {
  const auto count = std::ranges::count_if(at_[a], [&](auto f) { return has(f, b); });
  return count == 2 || (count > 2 && side_count_ > 1);
}

bool surface_mesh::bends(std::uint32_t f, std::uint32_t g) const {
  const auto& one = faces[f];
  const auto& other = faces[g];
  // Facets of one round wall are one face of it, however finely bends are looked at.
  const double limit = one.slack > 0 && other.slack > 0 ? sharp : crease_cosine;
  return one.label != other.label || one.frozen != other.frozen ||
         dot(one.normal, other.normal) < limit;
}

bool surface_mesh::is_crease(std::uint32_t a, std::uint32_t b) const {
  std::array<std::uint32_t, 2> at{};
  return !faces_of_edge(a, b, at) || bends(at[0], at[1]);
}

std::vector<std::uint32_t> surface_mesh::creases_at(std::uint32_t v) const {
  auto result = neighbours(v);
  std::erase_if(result, [&](auto w) { return !is_crease(v, w); });
  return result;
}

surface_mesh::freedom surface_mesh::freedom_of(std::uint32_t v) const {
  if (vertices[v].fixed)
    return freedom::fixed;
  const auto creases = creases_at(v);
  if (creases.empty())
    return freedom::face;
  if (creases.size() != 2)
    return freedom::corner;
  const vec3 p = vertices[v].position;
  const vec3 one = normalized(vertices[creases[0]].position - p);
  const vec3 other = normalized(vertices[creases[1]].position - p);
  return dot(one, other) < straight_cosine ? freedom::crease : freedom::corner;
}

bool surface_mesh::may_go(std::uint32_t a, std::uint32_t b) const {
  std::size_t count = 0;
  for (const auto f : at_[a])
    if (has(f, b)) {
      if (faces[f].frozen)
        return false;
      ++count;
    }
  if (!is_edge(a, b))
    return false;
  const auto near_b = neighbours(b);
  auto common = neighbours(a);
  std::erase_if(common, [&](auto w) { return std::ranges::find(near_b, w) == near_b.end(); });
  if (common.size() != count)
    return false;
  return side_count_ == 1 || ((count > 2 || !is_at_interface_end(a) || !is_at_interface_end(b)) &&
                              !closes_pocket(a, b, common));
}

/// An edge of v has more than two faces.
bool surface_mesh::is_at_interface_end(std::uint32_t v) const {
  return std::ranges::any_of(neighbours(v),
                             [&](auto w) { return all_faces_of_edge(v, w).size() > 2; });
}

/// Would two faces come to lie on each other, with what is between two interfaces gone?
bool surface_mesh::closes_pocket(std::uint32_t a, std::uint32_t b,
                                 const std::vector<std::uint32_t>& common) const {
  const auto opposite = [&](std::uint32_t v, std::uint32_t w, std::uint32_t x) {
    return std::ranges::any_of(at_[v], [&](auto f) { return has(f, w) && has(f, x); });
  };
  for (std::size_t i = 0; i < common.size(); ++i)
    for (std::size_t j = i + 1; j < common.size(); ++j)
      if (opposite(a, common[i], common[j]) && opposite(b, common[i], common[j]))
        return true;
  return false;
}

vec3 surface_mesh::normal_of(const triangle& t) const {
  const vec3 p = vertices[t[0]].position;
  return cross(vertices[t[1]].position - p, vertices[t[2]].position - p);
}

double surface_mesh::shape_of(const triangle& t) const {
  double squares = 0;
  for (int k = 0; k < 3; ++k) {
    const vec3 edge = vertices[t[(k + 1) % 3]].position - vertices[t[k]].position;
    squares += dot(edge, edge);
  }
  return squares > 0 ? 2 * std::sqrt(3.0) * norm(normal_of(t)) / squares : 0;
}

double surface_mesh::length(std::uint32_t a, std::uint32_t b) const {
  return norm(vertices[a].position - vertices[b].position);
}

double surface_mesh::volume() const {
  double sum = 0;
  for (const auto& f : faces)
    if (f.alive && f.sides[1] < 0)
      sum += dot(vertices[f.v[0]].position - vertices.front().position, normal_of(f.v)) / 6;
  return sum;
}

void surface_mesh::drop(std::uint32_t f) {
  faces[f].alive = false;
  for (const auto v : faces[f].v)
    std::erase(at_[v], f);
}

void surface_mesh::add(const triangle& t, std::uint32_t like) {
  auto f = faces[like];
  f.v = t;
  f.alive = true;
  const auto id = static_cast<std::uint32_t>(faces.size());
  faces.push_back(f);
  for (const auto v : t)
    at_[v].push_back(id);
}

void surface_mesh::merge(std::uint32_t u, std::uint32_t v) {
  const auto around = at_[u];
  for (const auto f : around) {
    auto t = faces[f].v;
    const bool goes = has(f, v);
    drop(f);
    if (goes)
      continue;
    std::ranges::replace(t, u, v);
    add(t, f);
  }
}

std::uint32_t surface_mesh::split(std::uint32_t a, std::uint32_t b, vec3 p) {
  const auto at = all_faces_of_edge(a, b);
  if (at.empty() || std::ranges::any_of(at, [&](auto f) { return faces[f].frozen; }))
    return no_id;
  const auto middle = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back({p, size(a, b), -1, false});
  at_.emplace_back();
  for (const auto f : at) {
    auto with_b = faces[f].v;
    auto with_a = faces[f].v;
    drop(f);
    std::ranges::replace(with_b, a, middle);
    std::ranges::replace(with_a, b, middle);
    add(with_b, f);
    add(with_a, f);
  }
  return middle;
}

bool surface_mesh::turned(std::uint32_t a, std::uint32_t b, const std::array<std::uint32_t, 2>& at,
                          std::array<triangle, 2>& result) const {
  if (bends(at[0], at[1]) || faces[at[0]].frozen || faces[at[1]].frozen)
    return false;
  const auto opposite = [&](std::uint32_t f) {
    for (const auto v : faces[f].v)
      if (v != a && v != b)
        return v;
    return a;
  };
  const auto c = opposite(at[0]);
  const auto d = opposite(at[1]);
  if (c == d || std::ranges::any_of(at_[c], [&](auto f) { return has(f, d); }))
    return false;
  const auto& t = faces[at[0]].v;
  const auto k = std::ranges::find(t, a) - t.begin();
  const bool forward = t[(k + 1) % 3] == b;
  result[0] = {forward ? a : b, d, c};
  result[1] = {d, forward ? b : a, c};
  return true;
}

void surface_mesh::turn(std::uint32_t a, std::uint32_t b, const std::array<std::uint32_t, 2>& at) {
  std::array<triangle, 2> next;
  if (!turned(a, b, at, next))
    return;
  const vec3 normal = normalized(faces[at[0]].normal + faces[at[1]].normal);
  drop(at[0]);
  drop(at[1]);
  for (const auto& t : next) {
    add(t, at[0]);
    faces.back().normal = normal;
  }
}

}  // namespace tedit::ops
