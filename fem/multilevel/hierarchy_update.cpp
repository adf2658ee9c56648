// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <unordered_map>

#include "fem/multilevel/cluster_inverse.hpp"
#include "fem/multilevel/galerkin.hpp"
#include "fem/multilevel/lanczos.hpp"
#include "fem/multilevel/node_smoother.hpp"

namespace tedit::fem {

namespace {

using index_list = std::vector<std::uint32_t>;

/// Some rows of a matrix as a matrix of their own: what couples them to other nodes, which stay at
/// zero, is in the diagonal.
class small_matrix {
public:
  small_matrix(const block_matrix& k, index_list nodes) : k_(k), nodes_(std::move(nodes)) {
    for (const auto n : nodes_)
      for (auto s = k.begin(n); s < k.end(n); ++s)
        local_.push_back(place(k.column[s]));
  }

  [[nodiscard]] std::size_t rows() const { return nodes_.size(); }
  [[nodiscard]] const index_list& nodes() const { return nodes_; }

  [[nodiscard]] std::uint32_t place(std::uint32_t node) const {
    const auto found = std::ranges::lower_bound(nodes_, node);
    return found == nodes_.end() || *found != node
             ? no_id
             : static_cast<std::uint32_t>(found - nodes_.begin());
  }

  /// y = K x; both have three values a row and one more.
  void multiply(const float* x, float* y) const {
    std::size_t at = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const float4 own = load4(x + 3 * i);
      float4 sum{};
      for (auto s = k_.begin(nodes_[i]); s < k_.end(nodes_[i]); ++s, ++at) {
        const float4 d =
          (local_[at] == no_id ? float4{} : load4(x + 3 * std::size_t{local_[at]})) - own;
        sum += entry_product<exact_values>(k_, s, d);
      }
      store3(sum, y + 3 * i);
    }
  }

  /// Calls `visit(local row, local column, entry)` for the entries within.
  template <class Visit>
  void for_inner_entries(std::uint32_t row, Visit&& visit) const {
    const auto n = nodes_[row];
    for (auto s = k_.begin(n); s < k_.end(n); ++s)
      if (const auto j = place(k_.column[s]); j != no_id)
        visit(j, s);
  }

private:
  const block_matrix& k_;
  index_list nodes_;
  index_list local_;  ///< Column of each entry among `nodes_`, or `no_id`.
};

class hierarchy_update {
public:
  hierarchy_update(const problem& p, const incidence& corners, const block_matrix& k,
                   filter_span filter, const multilevel_settings& settings, hierarchy& h)
      : p_(p),
        corners_(corners),
        k_(k),
        filter_(filter),
        settings_(settings),
        h_(h),
        first_(h.memory->levels.front()) {}

  expected<void> run(std::span<const std::uint32_t> nodes) {
    const auto touched = renew_smoother(nodes);
    h_.aggregate.resize(k_.rows(), no_id);
    h_.arm.resize(k_.rows());
    if (!h_.filter.empty())
      h_.filter.resize(k_.rows(), {1, 0, 0, 1, 0, 1});
    index_list rows = renew_aggregates(touched);
    make_galerkin_rows(k_, rows, h_);
    return update_rigid_levels(std::move(rows), h_);
  }

private:
  index_list renew_smoother(std::span<const std::uint32_t> nodes) {
    const auto per = static_cast<std::uint32_t>(p_.nodes_per_element);
    const smoother_source source{
      p_,
      filter_,
      [&](std::uint32_t n) {
        index_list elements;
        for (const auto corner : corners_.of_node(n))
          elements.push_back(corner / per);
        return elements;
      },
      [&](std::uint32_t n) { return diagonal_block(k_, n); },
      [&](std::span<const std::uint32_t> members) { return cluster_matrix(k_, members); },
      64,
      settings_.sliver_condition};
    auto touched = update_smoother(source, nodes, h_.memory->cluster_of, h_.smoother);
    mark_exact_rows(k_, h_);
    // Large eigenvalues sit at single bad places: those that are new are found here.
    const small_matrix local(k_, with_neighbours(touched));
    const auto lambda = largest_ritz_value(
      3 * local.rows(), 1, settings_.lambda_steps,
      [&](const float* x, float* y) { local.multiply(x, y); },
      [&](const float* x, float* y) {
        for (std::size_t i = 0; i < local.rows(); ++i)
          store3(multiply_symmetric(h_.smoother.inverse[local.nodes()[i]], load4(x + 3 * i)),
                 y + 3 * i);
      });
    h_.smoother.lambda = std::max(h_.smoother.lambda, settings_.lambda_safety * lambda);
    return touched;
  }

  [[nodiscard]] index_list with_neighbours(const index_list& nodes) const {
    index_list result = nodes;
    for (const auto n : nodes) {
      const auto columns = k_.places.of(n, k_.column);
      result.insert(result.end(), columns.begin(), columns.end());
    }
    sort_unique(result);
    return result;
  }

  /// Forms the aggregates of `touched` nodes anew; returns the coarse rows that change.
  index_list renew_aggregates(const index_list& touched) {
    index_list old;
    for (const auto n : touched)
      if (h_.aggregate[n] != no_id)
        old.push_back(h_.aggregate[n]);
    sort_unique(old);
    index_list rows = beside(old);
    index_list nodes;
    aggregation fresh;
    for (int attempt = 0;; ++attempt) {
      nodes = free_nodes(touched, old);
      fresh = aggregate(nodes);
      index_list more = old;
      for (const auto a : neighbours_of_small(nodes, fresh))
        more.push_back(a);
      sort_unique(more);
      if (attempt == 3 || more.size() == old.size())
        break;
      old = std::move(more);
    }
    for (const auto a : beside(old))
      rows.push_back(a);
    for (const auto n : touched)
      h_.aggregate[n] = is_held(filter_[n]) ? no_id : h_.aggregate[n];
    for (const auto a : place_aggregates(nodes, fresh, old))
      rows.push_back(a);
    sort_unique(rows);
    h_.changed = touched;
    h_.changed.insert(h_.changed.end(), nodes.begin(), nodes.end());
    sort_unique(h_.changed);
    return rows;
  }

  /// The aggregates and those that their rows reach.
  [[nodiscard]] index_list beside(const index_list& aggregates) const {
    index_list result = aggregates;
    for (const auto a : aggregates) {
      const auto columns = h_.levels.front().rows.of(a, h_.levels.front().column);
      result.insert(result.end(), columns.begin(), columns.end());
    }
    return result;
  }

  [[nodiscard]] index_list free_nodes(const index_list& touched, const index_list& old) const {
    index_list nodes = touched;
    for (const auto a : old) {
      const auto members = h_.members.of(a);
      nodes.insert(nodes.end(), members.begin(), members.end());
    }
    sort_unique(nodes);
    std::erase_if(nodes, [&](std::uint32_t n) { return is_held(filter_[n]); });
    return nodes;
  }

  [[nodiscard]] aggregation aggregate(const index_list& nodes) const {
    const small_matrix local(k_, nodes);
    node_graph graph;
    graph.first.push_back(0);
    std::vector<float> scale;
    for (const auto n : nodes)
      scale.push_back(coupling_scale(k_, n));
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      local.for_inner_entries(i, [&](std::uint32_t j, std::uint32_t entry) {
        graph.column.push_back(j);
        graph.weight.push_back(block_norm(k_, entry) * scale[i] * scale[j]);
      });
      graph.first.push_back(static_cast<std::uint32_t>(graph.column.size()));
    }
    index_list cluster;
    for (const auto n : nodes)
      cluster.push_back(n < h_.memory->cluster_of.size() ? h_.memory->cluster_of[n] : no_id);
    return aggregate_mis2(graph, std::vector<std::uint8_t>(nodes.size(), 0), cluster,
                          settings_.weak_edge);
  }

  /// Kept aggregates beside fresh ones that are too small: they are formed anew, too.
  [[nodiscard]] index_list neighbours_of_small(const index_list& nodes,
                                               const aggregation& fresh) const {
    index_list size(fresh.count, 0);
    for (const auto a : fresh.of)
      ++size[a];
    index_list result;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (size[fresh.of[i]] < 4)
        for (const auto j : k_.places.of(nodes[i], k_.column))
          if (h_.aggregate[j] != no_id)
            result.push_back(h_.aggregate[j]);
    return result;
  }

  /// Gives fresh aggregates numbers, those of `old` ones first, and says which numbers and which
  /// rows beside them are concerned.
  index_list place_aggregates(const index_list& nodes, const aggregation& fresh,
                              const index_list& old) {
    std::vector<index_list> members(fresh.count);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      members[fresh.of[i]].push_back(nodes[i]);
    const auto number = choose_numbers(members, old);
    for (const auto a : old)
      h_.members.replace(a, {});
    for (std::uint32_t f = 0; f < fresh.count; ++f) {
      const auto a = number[f];
      h_.members.replace(a, members[f]);
      first_.frames[a] = frame_of(p_, members[f]);
      for (const auto n : members[f]) {
        h_.aggregate[n] = a;
        store_transfer(p_, filter_, first_.frames[a], n, h_);
      }
    }
    index_list rows = old;
    for (const auto n : with_neighbours(nodes))
      if (h_.aggregate[n] != no_id)
        rows.push_back(h_.aggregate[n]);
    return rows;
  }

  /// Each fresh aggregate takes the number that most of its nodes had, if it is left, so that the
  /// groups of the next level stay groups of neighbours; others take a new one, in the same group.
  index_list choose_numbers(const std::vector<index_list>& members, const index_list& old) {
    index_list number(members.size(), no_id);
    std::map<std::uint32_t, bool> taken;
    for (const auto a : old)
      taken[a] = false;
    for (std::size_t f = 0; f < members.size(); ++f) {
      std::map<std::uint32_t, int> votes;
      for (const auto n : members[f])
        if (h_.aggregate[n] != no_id)
          ++votes[h_.aggregate[n]];
      std::uint32_t best = old.empty() ? 0 : old.front();
      int most = 0;
      for (const auto& [a, count] : votes)
        if (count > most) {
          best = a;
          most = count;
        }
      if (most == 0)
        best = near_aggregate(members[f], best);
      if (const auto slot = taken.find(best); slot != taken.end() && !slot->second) {
        slot->second = true;
        number[f] = best;
        continue;
      }
      number[f] = static_cast<std::uint32_t>(first_.frames.size());
      first_.frames.emplace_back();
      first_.keep.emplace_back(matrix6::Identity());
      if (!first_.group.empty())
        first_.group.push_back(std::uint32_t{first_.group[best]});
    }
    return number;
  }

  [[nodiscard]] std::uint32_t near_aggregate(const index_list& nodes, std::uint32_t none) const {
    for (const auto n : nodes)
      for (const auto j : k_.places.of(n, k_.column))
        if (h_.aggregate[j] != no_id)
          return h_.aggregate[j];
    return none;
  }

  const problem& p_;
  const incidence& corners_;
  const block_matrix& k_;
  filter_span filter_;
  const multilevel_settings& settings_;
  hierarchy& h_;
  level_memory& first_;
};

}  // namespace

expected<void> update_hierarchy(const problem& p, const incidence& corners, const block_matrix& k,
                                filter_span filter, std::span<const std::uint32_t> nodes,
                                const multilevel_settings& settings, hierarchy& h) {
  return hierarchy_update(p, corners, k, filter, settings, h).run(nodes);
}

}  // namespace tedit::fem
