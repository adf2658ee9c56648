// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/closed_loops.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/short_number.hpp"

namespace tedit::ops {

namespace {

/// Ends that lie this near are one place, as a share of the drawing's longer side.
constexpr double joined_share = 1e-4;

using cell = std::array<std::int64_t, 2>;

/// Numbers places; those within the tolerance of each other, also by steps, have the same one.
class place_numbers {
public:
  explicit place_numbers(double tolerance) : tolerance_(tolerance) {}

  std::size_t add(point2 p) {
    const std::size_t number = places_.size();
    places_.push_back(p);
    parents_.push_back(number);
    const cell own = cell_of(p);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        if (const auto found = cells_.find({own[0] + dx, own[1] + dy}); found != cells_.end())
          for (const auto other : found->second)
            if (gap_of(p, places_[other]) <= tolerance_)
              parents_[root(other)] = root(number);
    // One of each place is enough: a file with all its ends in one cell would cost their square.
    if (auto& near = cells_[own]; near.size() < 16)
      near.push_back(number);
    return number;
  }

  std::size_t root(std::size_t i) {
    while (parents_[i] != i)
      i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  [[nodiscard]] point2 at(std::size_t i) const { return places_[i]; }

private:
  [[nodiscard]] cell cell_of(point2 p) const {
    return {static_cast<std::int64_t>(std::floor(p[0] / tolerance_)),
            static_cast<std::int64_t>(std::floor(p[1] / tolerance_))};
  }

  double tolerance_;
  std::vector<point2> places_;
  std::vector<std::size_t> parents_;
  std::map<cell, std::vector<std::size_t>> cells_;
};

point2 middle_of(const plane_path& path) {
  const auto& curve = path.curves[path.curves.size() / 2];
  return point_of(curve, path.curves.size() % 2 == 1 ? 0.5 : 0);
}

/// Joins the paths of a drawing that are not closed.
class path_joiner {
public:
  path_joiner(const dxf_drawing& drawing, joined_outlines& made)
      : drawing_(drawing),
        made_(made),
        tolerance_(joined_share * made.box.longer_side()),
        numbers_(tolerance_) {}

  expected<void> run() {
    for (const auto& path : drawing_.paths) {
      const bool closed = path.closed || gap_of(path.start(), path.end()) <= tolerance_;
      if (closed && path.curves.size() == 1 && is_point(path))
        continue;
      if (is_repeated(path)) {
        ++made_.repeated;
        continue;
      }
      if (closed)
        made_.loops.push_back(path.curves);
      else
        open_.push_back({&path, numbers_.add(path.start()), numbers_.add(path.end())});
    }
    for (std::size_t i = 0; i < open_.size(); ++i)
      for (const auto end : {open_[i].from, open_[i].to})
        at_place_[numbers_.root(end)].push_back(i);
    if (auto ok = check_ends(); !ok)
      return ok;
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (!open_[i].used)
        follow(i);
    return {};
  }

private:
  struct open_path {
    const plane_path* path = nullptr;
    std::size_t from = 0;
    std::size_t to = 0;
    bool used = false;
  };

  /// Shorter than what ends are joined over.
  [[nodiscard]] bool is_point(const plane_path& path) const {
    plane_box box;
    add_to(box, path.curves.front());
    return box.longer_side() <= tolerance_;
  }

  /// The same ends and the same middle, either way round, as one before.
  bool is_repeated(const plane_path& path) {
    const auto rounded = [&](point2 p) {
      return cell{std::llround(p[0] / tolerance_), std::llround(p[1] / tolerance_)};
    };
    auto ends = std::array{rounded(path.start()), rounded(path.end())};
    std::ranges::sort(ends);
    // Of a circle the ends and the middle of another way round are the same.
    const auto middle = rounded(middle_of(path));
    return !seen_.insert({{ends[0], ends[1], middle}, path.curves.size()}).second;
  }

  expected<void> check_ends() {
    for (const auto& [place, paths] : at_place_) {
      const auto where = place_text(drawing_, numbers_.at(place));
      if (paths.size() > 2)
        return fail(ec::bad_input,
                    std::to_string(paths.size()) + " lines of the drawing meet at " + where +
                      ": which of them is the outline cannot be told",
                    "Put what is no outline on a layer that is frozen or off");
      if (paths.size() == 1)
        return open_end(paths.front(), place, where);
    }
    return {};
  }

  /// Names the other end of what begins there, too.
  tl::unexpected<error> open_end(std::size_t begin, std::size_t place, const std::string& where) {
    std::size_t at = place;
    std::size_t path = begin;
    while (true) {
      open_[path].used = true;
      const auto from = numbers_.root(open_[path].from);
      at = from == at ? numbers_.root(open_[path].to) : from;
      const auto& here = at_place_[at];
      const auto next = std::ranges::find_if(here, [&](auto i) { return !open_[i].used; });
      if (next == here.end())
        break;
      path = *next;
    }
    const auto gap = gap_of(numbers_.at(place), numbers_.at(at));
    return fail(ec::bad_input,
                "an outline of the drawing is open: it ends at " + where + " and at " +
                  place_text(drawing_, numbers_.at(at)) + ", " + short_number(gap, 8) + " apart",
                "Close it, or put what is no outline on a layer that is frozen or off",
                "line " + std::to_string(open_[begin].path->line));
  }

  /// All places have two ends: the way on is the one that is not used.
  void follow(std::size_t first) {
    std::vector<plane_curve> loop;
    std::size_t at = numbers_.root(open_[first].from);
    std::size_t next = first;
    while (!open_[next].used) {
      auto& one = open_[next];
      one.used = true;
      const bool along = numbers_.root(one.from) == at;
      const auto& curves = one.path->curves;
      if (along)
        loop.insert(loop.end(), curves.begin(), curves.end());
      else
        std::transform(curves.rbegin(), curves.rend(), std::back_inserter(loop), reversed);
      at = numbers_.root(along ? one.to : one.from);
      const auto& here = at_place_[at];
      next = here.front() == next ? here.back() : here.front();
    }
    made_.loops.push_back(std::move(loop));
  }

  const dxf_drawing& drawing_;
  joined_outlines& made_;
  double tolerance_;
  place_numbers numbers_;
  std::vector<open_path> open_;
  std::map<std::size_t, std::vector<std::size_t>> at_place_;
  std::set<std::pair<std::array<cell, 3>, std::size_t>> seen_;
};

/// An edge of an outline, for the search for crossings.
struct plane_edge {
  point2 from;
  point2 to;
  std::size_t outline = 0;
  std::size_t index = 0;

  [[nodiscard]] double left() const { return std::min(from[0], to[0]); }
  [[nodiscard]] double right() const { return std::max(from[0], to[0]); }
};

/// The next edge turns back over this one.
bool turns_back(const plane_edge& a, const plane_edge& b) {
  const point2 one{a.to[0] - a.from[0], a.to[1] - a.from[1]};
  const point2 two{b.to[0] - b.from[0], b.to[1] - b.from[1]};
  const double across = one[0] * two[1] - one[1] * two[0];
  const double along = one[0] * two[0] + one[1] * two[1];
  return along < 0 && std::abs(across) <= 1e-9 * std::abs(along);
}

point2 where_met(const plane_edge& a, const plane_edge& b) {
  const double from = turn_of(b.from, b.to, a.from);
  const double to = turn_of(b.from, b.to, a.to);
  const double share = from == to ? 0.5 : from / (from - to);
  return {a.from[0] + share * (a.to[0] - a.from[0]), a.from[1] + share * (a.to[1] - a.from[1])};
}

}  // namespace

std::string place_text(const dxf_drawing& drawing, point2 at) {
  const auto text = "(" + short_number(at[0], 8) + ", " + short_number(at[1], 8) + ")";
  return drawing.unit.empty() ? text : text + " " + drawing.unit;
}

expected<joined_outlines> join_outlines(const dxf_drawing& drawing) {
  joined_outlines made;
  for (const auto& path : drawing.paths)
    for (const auto& curve : path.curves)
      add_to(made.box, curve);
  const auto& [low, high] = made.box;
  const double reach = std::max({-low[0], -low[1], high[0], high[1]});
  // Below that nothing is left of its digits.
  if (!drawing.paths.empty() && made.box.longer_side() > 1e-8 * reach)
    if (auto ok = path_joiner(drawing, made).run(); !ok)
      return fail(ok.error());
  if (made.loops.empty()) {
    std::string all = "the drawing has no closed outline";
    for (const auto& notice : drawing.notices)
      all += "; " + notice;
    return fail(ec::bad_input, all,
                "Draw it with lines, arcs, polylines, circles, ellipses or splines on layers that "
                "are shown");
  }
  return made;
}

std::optional<point2> first_crossing(const std::vector<std::vector<point2>>& outlines) {
  std::vector<plane_edge> edges;
  for (std::size_t o = 0; o < outlines.size(); ++o)
    for (std::size_t i = 0; i < outlines[o].size(); ++i)
      edges.push_back({outlines[o][i], outlines[o][(i + 1) % outlines[o].size()], o, i});
  std::ranges::sort(edges, {}, &plane_edge::left);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size() && edges[k].left() <= edges[i].right(); ++k) {
      const auto& a = edges[i];
      const auto& b = edges[k];
      const std::size_t n = outlines[a.outline].size();
      const bool follows = a.outline == b.outline && (a.index + 1) % n == b.index;
      const bool leads = a.outline == b.outline && (b.index + 1) % n == a.index;
      if (follows || leads) {
        if (follows ? turns_back(a, b) : turns_back(b, a))
          return follows ? a.to : b.to;
      } else if (edges_meet(a.from, a.to, b.from, b.to)) {
        return where_met(a, b);
      }
    }
  return std::nullopt;
}

}  // namespace tedit::ops
