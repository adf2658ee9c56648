// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_strips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/place_text.hpp"
#include "ops/shapes/rounding/smooth_joint.hpp"

namespace tedit::ops {

namespace {

/// More triangles than this are the sign of a radius far below the part's size.
constexpr std::size_t most_triangles = 12'000;
constexpr int most_segments = 48;

/// Points and centres across the arc at one end of a chain, from wall a to wall b.
struct end_row {
  std::vector<std::uint32_t> points;
  std::vector<vec3> centres;
};

class strip_maker {
public:
  strip_maker(const mesh_version& mesh, const round_plan& plan, const round_settings& settings)
      : mesh_(mesh), plan_(plan), settings_(settings) {
    for (const auto& chain : plan.chains) {
      balls_.emplace_back(plan.shapes.at(chain.a), plan.shapes.at(chain.b), settings.radius,
                          plan.side);
      ends_.emplace_back();
    }
  }

  expected<round_surface> make() {
    if (auto ok = choose_segments(); !ok)
      return fail(ok.error());
    for (const auto& corner : plan_.corners)
      if (auto ok = end_at(corner); !ok)
        return fail(ok.error());
    for (std::size_t c = 0; c < plan_.chains.size(); ++c)
      if (auto ok = lay_strip(c); !ok)
        return fail(ok.error());
    for (std::size_t i = 0; i < plan_.corners.size(); ++i)
      if (plan_.corners[i].type == round_corner::kind::ball)
        if (auto ok = lay_ball(i); !ok)
          return fail(ok.error());
    return std::move(made_);
  }

private:
  [[nodiscard]] tl::unexpected<error> too_large(std::size_t c, const std::string& why,
                                                vec3 at) const {
    return fail(
      ec::invalid_argument,
      plan_.chains[c].name(mesh_) + " cannot be rounded so far at " + place_text(at) + ": " + why);
  }

  std::uint32_t add(vec3 p) {
    made_.points.push_back(p);
    return static_cast<std::uint32_t>(made_.points.size() - 1);
  }

  [[nodiscard]] vec3 vertex(std::size_t c, bool last) const {
    const auto& path = plan_.chains[c].path;
    return mesh_.position(last ? path.back() : path.front());
  }

  /// A ball that is larger than the round wall it runs in.
  [[nodiscard]] expected<void> check_walls(std::size_t c) const {
    for (const auto id : {plan_.chains[c].a, plan_.chains[c].b}) {
      const auto& wall = plan_.shapes.at(id);
      const double own = wall.radius_at(vertex(c, false));
      if (wall.shape.side * plan_.side < 0 && settings_.radius >= 0.99 * own)
        return too_large(
          c, "surface " + std::to_string(id) + " itself has a radius of " + length_name(own),
          vertex(c, false));
    }
    return {};
  }

  expected<void> choose_segments() {
    double arcs = 0;
    for (std::size_t c = 0; c < plan_.chains.size(); ++c) {
      if (auto ok = check_walls(c); !ok)
        return ok;
      const auto& chain = plan_.chains[c];
      const vec3 p = mesh_.position(chain.path[chain.path.size() / 2]);
      const auto centre = balls_[c].centre(p);
      if (!centre)
        return too_large(c, "the ball does not fit between the walls", p);
      const double arc = balls_[c].arc(*centre);
      const double wanted = std::max(settings_.segments * arc / (std::numbers::pi / 2),
                                     arc * settings_.radius / chain.mean_edge);
      made_.segments = std::max(made_.segments, static_cast<int>(std::ceil(wanted - 1e-6)));
      made_.widest = std::max(made_.widest, norm(balls_[c].on_arc(*centre, 0) - p));
      arcs += arc * settings_.radius / static_cast<double>(plan_.chains.size());
    }
    made_.segments = std::clamp(made_.segments, 2, most_segments);
    made_.arc_step = arcs / made_.segments;
    return {};
  }

  [[nodiscard]] double share(int j) const { return static_cast<double>(j) / made_.segments; }

  // -- ends ---------------------------------------------------------------------------

  expected<void> end_at(const round_corner& corner) {
    using kind = round_corner::kind;
    return corner.type == kind::wall   ? end_at_wall(corner)
           : corner.type == kind::ball ? end_at_ball(corner)
                                       : join(corner);
  }

  [[nodiscard]] end_row& row_of(const chain_end& e) { return ends_[e.chain][e.last]; }

  /// Centres at which each point of the arc meets a surface.
  expected<std::vector<vec3>> centres_at(std::size_t c, vec3 at,
                                         const std::function<double(vec3)>& surface) const {
    const auto start = balls_[c].centre(at);
    std::vector<vec3> centres;
    for (int j = 0; start && j <= made_.segments; ++j) {
      const auto found = balls_[c].centre_where(share(j), surface, *start);
      if (!found)
        break;
      centres.push_back(*found);
    }
    if (centres.size() != static_cast<std::size_t>(made_.segments) + 1)
      return too_large(c, "the rounding does not end at the wall there", at);
    return centres;
  }

  expected<void> end_at_wall(const round_corner& corner) {
    const auto& end = corner.ends.front();
    const auto& chain = plan_.chains[end.chain];
    const auto other = *std::ranges::find_if(
      corner.fan.sectors, [&](surface_id s) { return s != chain.a && s != chain.b; });
    const auto& wall = plan_.shapes.at(other);
    auto centres =
      centres_at(end.chain, mesh_.position(corner.at), [&](vec3 p) { return wall.distance(p); });
    if (!centres)
      return fail(centres.error());
    auto& row = row_of(end);
    row.centres = std::move(*centres);
    for (int j = 0; j <= made_.segments; ++j)
      row.points.push_back(add(balls_[end.chain].on_arc(row.centres[j], share(j))));
    return {};
  }

  [[nodiscard]] surface_id shared_wall(const round_corner& corner) const {
    const auto& x = plan_.chains[corner.ends[0].chain];
    const auto& y = plan_.chains[corner.ends[1].chain];
    return x.a == y.a || x.a == y.b ? x.a : x.b;
  }

  /// Gives both chains of a corner the same points, from the shared wall outwards.
  expected<void> share_row(const round_corner& corner,
                           const std::array<std::vector<vec3>, 2>& centres) {
    const auto shared = shared_wall(corner);
    std::vector<std::uint32_t> points;
    for (int i = 0; i < 2; ++i) {
      const auto& end = corner.ends[i];
      const bool forward = plan_.chains[end.chain].a == shared;
      auto& row = row_of(end);
      row.centres = centres[i];
      row.points.resize(row.centres.size());
      for (int j = 0; j <= made_.segments; ++j) {
        const vec3 p = balls_[end.chain].on_arc(row.centres[j], share(j));
        const int outward = forward ? j : made_.segments - j;
        if (i == 0)
          row.points[j] = add(p);
        else
          row.points[j] = points[outward];
        if (i == 1 && norm(made_.points[row.points[j]] - p) > arcs_match * settings_.radius)
          return too_large(end.chain,
                           "the edges that meet there have different angles, and the corner "
                           "between them stays sharp",
                           mesh_.position(corner.at));
      }
      if (i == 0) {
        points = row.points;
        if (!forward)
          std::ranges::reverse(points);
      }
    }
    return {};
  }

  [[nodiscard]] std::optional<vec3> corner_centre(const round_corner& corner) const {
    const auto& s = corner.fan.sectors;
    const vec3 p = mesh_.position(corner.at);
    const auto& a = plan_.shapes.at(s[0]);
    const auto& b = plan_.shapes.at(s[1]);
    const auto& c = plan_.shapes.at(s[2]);
    return ball_in_corner(a, b, c, settings_.radius, plan_.side, p);
  }

  [[nodiscard]] joint_end smooth_end(const round_corner& corner, int end) const {
    const auto c = corner.ends[end].chain;
    return {balls_[c], plan_.chains[c].a == shared_wall(corner)};
  }

  /// Two roundings of the same angle meet where the ball goes from one of their walls to the other,
  /// else in the plane that halves the angle between their edges.
  expected<void> join(const round_corner& corner) {
    const vec3 p = mesh_.position(corner.at);
    if (corner.type == round_corner::kind::smooth)
      if (const auto at = centres_at_joint({smooth_end(corner, 0), smooth_end(corner, 1)}, p)) {
        const auto arc = static_cast<std::size_t>(made_.segments) + 1;
        return share_row(corner, {std::vector(arc, (*at)[0]), std::vector(arc, (*at)[1])});
      }
    vec3 across;
    for (int i = 0; i < 2; ++i) {
      const auto& end = corner.ends[i];
      const vec3 t = balls_[end.chain].along(p);
      const auto& path = plan_.chains[end.chain].path;
      const vec3 inward = mesh_.position(end.last ? path[path.size() - 2] : path[1]) - p;
      // Towards the corner on the first chain, away from it on the second.
      across += (dot(t, inward) < 0 ? 1 : -1) * (i == 0 ? 1 : -1) * t;
    }
    across = normalized(across);
    std::array<std::vector<vec3>, 2> centres;
    for (int i = 0; i < 2; ++i) {
      auto found = centres_at(corner.ends[i].chain, p, [&](vec3 q) { return dot(across, q - p); });
      if (!found)
        return fail(found.error());
      centres[i] = std::move(*found);
    }
    return share_row(corner, centres);
  }

  expected<void> end_at_ball(const round_corner& corner) {
    const vec3 p = mesh_.position(corner.at);
    const auto centre = corner_centre(corner);
    if (!centre)
      return too_large(corner.ends[0].chain, "no ball touches the three walls", p);
    std::map<surface_id, std::uint32_t> contacts;
    for (const auto s : corner.fan.sectors)
      contacts[s] = add(plan_.shapes.at(s).project(*centre));
    for (const auto& end : corner.ends) {
      auto& row = row_of(end);
      row.centres.assign(static_cast<std::size_t>(made_.segments) + 1, *centre);
      row.points.push_back(contacts.at(plan_.chains[end.chain].a));
      for (int j = 1; j < made_.segments; ++j)
        row.points.push_back(add(balls_[end.chain].on_arc(*centre, share(j))));
      row.points.push_back(contacts.at(plan_.chains[end.chain].b));
    }
    return {};
  }

  // -- strips -------------------------------------------------------------------------

  /// A point on the chain by its length from the start; beyond the ends straight on.
  [[nodiscard]] vec3 along_path(const round_chain& chain, double s) const {
    const std::size_t edges = chain.path.size() - (chain.closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
      const vec3 from = mesh_.position(chain.path[i]);
      const vec3 to = mesh_.position(chain.path[(i + 1) % chain.path.size()]);
      const double length = norm(to - from);
      if (s <= length || i + 1 == edges)
        return from + (s / length) * (to - from);
      s -= length;
    }
    return {};
  }

  [[nodiscard]] double length_of(const round_chain& chain) const {
    return chain.mean_edge * static_cast<double>(chain.path.size() - (chain.closed ? 0 : 1));
  }

  /// How far the end's centres lie along the path from where the end vertex' own would be, m.
  expected<std::vector<double>> offsets(std::size_t c, bool last) const {
    const auto& chain = plan_.chains[c];
    const vec3 p = vertex(c, last);
    const auto own = balls_[c].centre(p);
    if (!own)
      return too_large(c, "the ball does not fit between the walls", p);
    const double step = 1e-3 * chain.mean_edge;
    const double s = last ? length_of(chain) : 0;
    const vec3 t = normalized(along_path(chain, s + step) - along_path(chain, s - step));
    std::vector<double> result;
    for (const auto& centre : ends_[c][last].centres)
      result.push_back(dot(centre - *own, t));
    return result;
  }

  expected<void> lay_strip(std::size_t c) {
    const auto& chain = plan_.chains[c];
    const int n = made_.segments;
    const double length = length_of(chain);
    std::vector<double> from(n + 1, 0.0);
    std::vector<double> to(n + 1, length);
    if (!chain.closed) {
      const auto start = offsets(c, false);
      const auto end = offsets(c, true);
      if (!start || !end)
        return fail(start ? end.error() : start.error());
      for (int j = 0; j <= n; ++j) {
        from[j] += (*start)[j];
        to[j] += (*end)[j];
      }
    }
    double shortest = 1e300;
    double mean = 0;
    for (int j = 0; j <= n; ++j) {
      shortest = std::min(shortest, to[j] - from[j]);
      mean += (to[j] - from[j]) / (n + 1);
    }
    const double spacing = std::clamp(chain.mean_edge, made_.arc_step, 2 * made_.arc_step);
    if (shortest < 0.3 * made_.arc_step)
      return too_large(
        c, "the edge is " + length_name(length) + " long, which leaves nothing between its ends",
        mesh_.position(chain.path.front()));
    const double wanted = std::max(chain.closed ? 3.0 : 1.0, std::round(mean / spacing));
    if (static_cast<double>(made_.triangles.size()) + wanted * n * 2 >
        static_cast<double>(most_triangles))
      return fail(
        ec::invalid_argument,
        "a radius of " + length_name(settings_.radius) + " on " + chain.name(mesh_) +
          " would need more than " + std::to_string(most_triangles) + " facets: the edge is " +
          length_name(length) + " long, the mesh's edges " + length_name(chain.mean_edge),
        "Take fewer segments or edges, or a radius of at least " +
          length_name(settings_.radius *
                      std::max(2.0, 2 * wanted * n / static_cast<double>(most_triangles))));
    return fill_rows(c, static_cast<int>(wanted), from, to);
  }

  expected<void> fill_rows(std::size_t c, int stations, const std::vector<double>& from,
                           const std::vector<double>& to) {
    const auto& chain = plan_.chains[c];
    const int n = made_.segments;
    auto& rows = made_.strips.emplace_back().rows;
    std::vector<vec3> middles;
    for (int k = 0; k < stations + (chain.closed ? 0 : 1); ++k) {
      const double f = static_cast<double>(k) / stations;
      auto& row = rows.emplace_back();
      middles.push_back(
        along_path(chain, 0.5 * ((1 - f) * (from[0] + from[n]) + f * (to[0] + to[n]))));
      if (!chain.closed && (k == 0 || k == stations)) {
        row = ends_[c][k > 0].points;
        continue;
      }
      for (int j = 0; j <= n; ++j) {
        const vec3 p = along_path(chain, (1 - f) * from[j] + f * to[j]);
        const auto centre = balls_[c].centre(p);
        if (!centre)
          return too_large(c, "the ball does not fit between the walls", p);
        row.push_back(add(balls_[c].on_arc(*centre, share(j))));
      }
    }
    if (chain.closed) {
      rows.push_back(rows.front());
      middles.push_back(middles.front());
    }
    return add_triangles(c, rows, middles);
  }

  expected<void> add_triangles(std::size_t c, const std::vector<std::vector<std::uint32_t>>& rows,
                               const std::vector<vec3>& middles) {
    const auto& p = made_.points;
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
      round_reach reach{middles[k], middles[k + 1], 0};
      for (int j = 0; j < made_.segments; ++j) {
        const auto q00 = rows[k][j];
        const auto q01 = rows[k][j + 1];
        const auto q10 = rows[k + 1][j];
        const auto q11 = rows[k + 1][j + 1];
        const bool rising = norm(p[q00] - p[q11]) <= norm(p[q01] - p[q10]);
        const std::array<std::array<std::uint32_t, 3>, 2> halves =
          rising ? std::array<std::array<std::uint32_t, 3>, 2>{{{q00, q01, q11}, {q00, q11, q10}}}
                 : std::array<std::array<std::uint32_t, 3>, 2>{{{q00, q01, q10}, {q01, q11, q10}}};
        for (const auto& t : halves)
          if (auto ok = add_triangle(c, t, c); !ok)
            return ok;
      }
      for (const auto* row : {&rows[k], &rows[k + 1]})
        for (const auto i : *row)
          reach.radius = std::max(reach.radius, distance_to(p[i], middles[k], middles[k + 1]));
      made_.reach.push_back(reach);
    }
    return {};
  }

  [[nodiscard]] static double distance_to(vec3 p, vec3 a, vec3 b) {
    const double length2 = dot(b - a, b - a);
    const double t = length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
    return norm(p - a - t * (b - a));
  }

  /// A triangle outward; one that looks the other way is the sign of rows that cross.
  expected<void> add_triangle(std::size_t c, const std::array<std::uint32_t, 3>& t,
                              std::size_t name) {
    const auto& p = made_.points;
    const vec3 middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3;
    const vec3 outward = balls_[c].a().normal(middle) + balls_[c].b().normal(middle);
    if (!(dot(area_vector(p[t[0]], p[t[1]], p[t[2]]), outward) > 0))
      return too_large(c, "the rounding would fold over", middle);
    made_.triangles.push_back(t);
    made_.chain.push_back(name);
    return {};
  }

  /// The spherical triangle between three arcs, in rows from the first contact to the other two.
  expected<void> lay_ball(std::size_t index) {
    const auto& corner = plan_.corners[index];
    const vec3 at = mesh_.position(corner.at);
    const vec3 centre = *corner_centre(corner);
    const int n = made_.segments;
    // The fan turns clockwise seen from outside.
    const std::array<surface_id, 3> s{corner.fan.sectors[0], corner.fan.sectors[2],
                                      corner.fan.sectors[1]};
    const auto arc = [&](surface_id from, surface_id to) {
      for (const auto& end : corner.ends) {
        const auto& chain = plan_.chains[end.chain];
        auto points = row_of(end).points;
        if (chain.a == from && chain.b == to)
          return points;
        std::ranges::reverse(points);
        if (chain.b == from && chain.a == to)
          return points;
      }
      return std::vector<std::uint32_t>{};
    };
    const auto left = arc(s[0], s[1]);
    const auto right = arc(s[0], s[2]);
    const auto bottom = arc(s[1], s[2]);
    if (left.empty() || right.empty() || bottom.empty())
      return too_large(corner.ends[0].chain, "its three edges have different walls", at);
    std::vector<std::vector<std::uint32_t>> rows;
    for (int i = 0; i <= n; ++i) {
      auto& row = rows.emplace_back();
      for (int j = 0; j <= i; ++j) {
        if (i == n)
          row.push_back(bottom[j]);
        else if (j == 0)
          row.push_back(left[i]);
        else if (j == i)
          row.push_back(right[i]);
        else {
          const vec3 d = (n - i) * (made_.points[left[0]] - centre) +
                         (i - j) * (made_.points[left[n]] - centre) +
                         j * (made_.points[right[n]] - centre);
          row.push_back(add(centre + settings_.radius * normalized(d)));
        }
      }
    }
    round_reach reach{at, at, 0};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) {
        made_.triangles.push_back({rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]});
        if (j < i)
          made_.triangles.push_back({rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]});
      }
    made_.chain.resize(made_.triangles.size(), plan_.chains.size() + index);
    for (const auto& row : rows)
      for (const auto i : row)
        reach.radius = std::max(reach.radius, norm(made_.points[i] - at));
    made_.reach.push_back(reach);
    return check_ball(corner, centre);
  }

  [[nodiscard]] expected<void> check_ball(const round_corner& corner, vec3 centre) const {
    const auto& p = made_.points;
    for (std::size_t i = 0; i < made_.triangles.size(); ++i) {
      if (made_.chain[i] < plan_.chains.size() ||
          &plan_.corners[made_.chain[i] - plan_.chains.size()] != &corner)
        continue;
      const auto& t = made_.triangles[i];
      if (-plan_.side * dot(area_vector(p[t[0]], p[t[1]], p[t[2]]), p[t[0]] - centre) <= 0)
        return too_large(corner.ends[0].chain, "the rounding would fold over", p[t[0]]);
    }
    return {};
  }

  const mesh_version& mesh_;
  const round_plan& plan_;
  const round_settings& settings_;
  std::vector<rolling_ball> balls_;
  std::vector<std::array<end_row, 2>> ends_;
  round_surface made_;
};

}  // namespace

std::string length_name(double metres) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", 1e3 * metres);
  return text;
}

expected<round_surface> make_strips(const mesh_version& mesh, const round_plan& plan,
                                    const round_settings& settings) {
  return strip_maker(mesh, plan, settings).make();
}

}  // namespace tedit::ops
