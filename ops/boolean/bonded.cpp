// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/bonded.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace tedit::ops {

namespace {

using triangle = std::array<std::uint32_t, 3>;
using edge = std::pair<std::uint32_t, std::uint32_t>;
using edge_set = std::set<edge>;

constexpr auto no_fit = "what the tool leaves of two regions does not fit together";

edge edge_of(const triangle& t, int k) {
  return std::minmax(t[k], t[(k + 1) % 3]);
}

/// The triangles of one share's result that lie where those of one other share may lie, too.
struct contact {
  std::vector<std::size_t> pieces;
  edge_set border;             ///< Edges with one of them only.
  std::set<triangle> triples;  ///< The corners of each, ascending.
};

class share_joiner {
public:
  share_joiner(const cavity& hollow, corefined cut)
      : hollow_(hollow), cut_(std::move(cut)), goes_(cut_.triangles.size()) {}

  expected<corefined> joined() {
    auto contacts = find_contacts();
    for (auto& [shares, one] : contacts)
      if (shares.first < shares.second)
        join(one, contacts[{shares.second, shares.first}], shares);
    join_flush();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < goes_.size(); ++i) {
      if (goes_[i])
        continue;
      cut_.triangles[kept] = cut_.triangles[i];
      cut_.parent[kept] = cut_.parent[i];
      cut_.sides[kept++] = cut_.sides[i];
    }
    cut_.triangles.resize(kept);
    cut_.parent.resize(kept);
    cut_.sides.resize(kept);
    if (!all_closed())
      return fail(ec::mesher_failed, no_fit);
    return std::move(cut_);
  }

private:
  using pair_of_shares = std::pair<std::int32_t, std::int32_t>;

  /// The same for both sides of an interface.
  [[nodiscard]] std::uint32_t place_of(std::size_t i) const {
    const auto parent = static_cast<std::uint32_t>(cut_.parent[i]);
    return std::min(parent, hollow_.sides[parent].twin);
  }

  std::map<pair_of_shares, contact> find_contacts() {
    std::map<std::uint32_t, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i)
      if (cut_.parent[i] >= 0)
        at[place_of(i)].push_back(i);
    std::map<pair_of_shares, contact> result;
    for (const auto& [place, pieces] : at)
      for (const auto i : pieces)
        for (const auto other : shares_of(pieces))
          if (other != cut_.sides[i][0])
            add_to(result[{cut_.sides[i][0], other}], i);
    return result;
  }

  [[nodiscard]] std::set<std::int32_t> shares_of(const std::vector<std::size_t>& pieces) const {
    std::set<std::int32_t> result;
    for (const auto i : pieces)
      result.insert(cut_.sides[i][0]);
    return result;
  }

  void add_to(contact& at, std::size_t i) const {
    at.pieces.push_back(i);
    at.triples.insert(triple(i));
    for (int k = 0; k < 3; ++k)
      if (const auto [row, fresh] = at.border.insert(edge_of(cut_.triangles[i], k)); !fresh)
        at.border.erase(row);
  }

  /// Both contacts as patches that hang together within the borders of both: a patch that the other
  /// share has, too, is an interface.
  void join(const contact& one, const contact& other, pair_of_shares shares) {
    auto borders = one.border;
    borders.insert(other.border.begin(), other.border.end());
    for (const auto& patch : patches(one, borders))
      if (is_in(patch, other))
        for (const auto i : patch)
          cut_.sides[i][1] = shares.second;
    for (const auto& patch : patches(other, borders))
      if (is_in(patch, one))
        for (const auto i : patch)
          goes_[i] = 1;
  }

  /// A face of the tool that came to lie on another share has triangles of its own there.
  void join_flush() {
    std::map<triangle, std::size_t> bare;
    for (std::size_t i = 0; i < goes_.size(); ++i) {
      if (goes_[i] || cut_.sides[i][1] >= 0)
        continue;
      const auto [row, fresh] = bare.try_emplace(triple(i), i);
      const auto other = row->second;
      if (fresh || cut_.sides[other][0] == cut_.sides[i][0])
        continue;
      const bool stays = cut_.parent[i] >= 0;
      cut_.sides[stays ? i : other][1] = cut_.sides[stays ? other : i][0];
      goes_[stays ? other : i] = 1;
    }
  }

  [[nodiscard]] std::vector<std::vector<std::size_t>> patches(const contact& of,
                                                              const edge_set& borders) const {
    std::map<edge, std::vector<std::size_t>> at_edge;
    for (const auto i : of.pieces)
      for (int k = 0; k < 3; ++k)
        if (const auto e = edge_of(cut_.triangles[i], k); !borders.contains(e))
          at_edge[e].push_back(i);
    std::set<std::size_t> left(of.pieces.begin(), of.pieces.end());
    std::vector<std::vector<std::size_t>> result;
    while (!left.empty()) {
      std::vector<std::size_t> patch{*left.begin()};
      left.erase(left.begin());
      for (std::size_t n = 0; n < patch.size(); ++n)
        for (int k = 0; k < 3; ++k)
          if (const auto row = at_edge.find(edge_of(cut_.triangles[patch[n]], k));
              row != at_edge.end())
            for (const auto next : row->second)
              if (left.erase(next) > 0)
                patch.push_back(next);
      result.push_back(std::move(patch));
    }
    return result;
  }

  [[nodiscard]] vec3 corner(std::size_t i, int k) const {
    return cut_.points[cut_.triangles[i][k]];
  }

  [[nodiscard]] vec3 area_of(std::size_t i) const {
    return area_vector(corner(i, 0), corner(i, 1), corner(i, 2));
  }

  /// Does the other share have what the patch covers? It does where a triangle of both is the same:
  /// slivers of rounding errors are. Else looked at in the middle of the patch's largest triangle:
  /// a patch is covered as a whole or not at all.
  [[nodiscard]] bool is_in(const std::vector<std::size_t>& patch, const contact& other) const {
    if (std::ranges::any_of(patch,
                            [&](std::size_t i) { return other.triples.contains(triple(i)); }))
      return true;
    const auto largest = *std::ranges::max_element(
      patch, {}, [&](std::size_t i) { return std::pair(norm(area_of(i)), -double(i)); });
    const vec3 middle = (corner(largest, 0) + corner(largest, 1) + corner(largest, 2)) / 3;
    const auto place = place_of(largest);
    return std::ranges::any_of(
      other.pieces, [&](std::size_t i) { return place_of(i) == place && covers(i, middle); });
  }

  [[nodiscard]] triangle triple(std::size_t i) const {
    auto t = cut_.triangles[i];
    std::ranges::sort(t);
    return t;
  }

  /// The point lies in the plane of the triangle.
  [[nodiscard]] bool covers(std::size_t i, vec3 p) const {
    const vec3 normal = area_of(i);
    for (int k = 0; k < 3; ++k)
      if (dot(area_vector(corner(i, k), corner(i, (k + 1) % 3), p), normal) < 0)
        return false;
    return true;
  }

  /// Each share is bounded by as many triangles one way along an edge as the other way.
  [[nodiscard]] bool all_closed() const {
    std::map<std::tuple<std::int32_t, std::uint32_t, std::uint32_t>, int> balance;
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i)
      for (int way = 0; way < 2; ++way)
        for (int k = 0; k < 3; ++k) {
          const auto share = cut_.sides[i][way];
          const auto a = cut_.triangles[i][k];
          const auto b = cut_.triangles[i][(k + 1) % 3];
          const int sign = (a < b ? 1 : -1) * (way == 0 ? 1 : -1);
          balance[{share, std::min(a, b), std::max(a, b)}] += share < 0 ? 0 : sign;
        }
    return std::ranges::all_of(balance, [](const auto& row) { return row.second == 0; });
  }

  const cavity& hollow_;
  corefined cut_;
  std::vector<std::uint8_t> goes_;
};

}  // namespace

expected<corefined> join_shares(const cavity& hollow, corefined cut) {
  return share_joiner(hollow, std::move(cut)).joined();
}

}  // namespace tedit::ops
