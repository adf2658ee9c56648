// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "fem/multilevel/node_smoother.hpp"
#include "fem/multilevel/rigid_levels.hpp"
#include "fem/multilevel/six_by_six.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// One step upwards: the prolongation of rows, and the coarser rows that they touch. Works on the
/// stored single-precision blocks of the finer level, sums in double precision.
class step_up {
public:
  step_up(std::size_t l, hierarchy& h)
      : level_(h.levels[l]),
        coarser_(h.levels[l + 1]),
        memory_(h.memory->levels[l]),
        above_(h.memory->levels[l + 1]) {}

  /// All rows; the coarser level is empty, its frames are there.
  void build() {
    const auto count = static_cast<std::uint32_t>(above_.frames.size());
    modes_.resize(level_.nodes());
    for_each(modes_.size(),
             [&](std::size_t i, row_sum&) { modes_[i] = parent_modes(memory_, above_, i); });
    const auto rows = numbers(level_.nodes());
    auto fresh = prolongation_of(rows);
    std::size_t blocks = 0;
    for (const auto& row : fresh)
      blocks += row.column.size();
    reserve_for_edits(level_.prolongation_column, blocks);
    reserve_for_edits(level_.prolongation, blocks);
    reserve_for_edits(level_.entry_row, blocks);
    place_prolongation(rows, fresh);
    fresh = {};
    level_.entries = member_lists(level_.prolongation_column, count);
    parents_ = numbers(count);
    std::vector<std::uint32_t> reframed;
    renew_parents(reframed);
  }

  /// Some rows. Returns the changed rows of the coarser level; `reframed` becomes those with other
  /// motions.
  std::vector<std::uint32_t> update(std::span<const std::uint32_t> rows,
                                    std::vector<std::uint32_t>& reframed) {
    for (const auto i : rows)
      note_parents(i);
    place_prolongation(rows, prolongation_of(rows));
    for (const auto i : rows)
      note_parents(i);
    relink(rows);
    for (const auto i : with_neighbours(rows))
      note_parents(i);
    sort_unique(parents_);
    renew_parents(reframed);
    return std::move(parents_);
  }

private:
  struct sparse_row {
    std::vector<std::uint32_t> column;
    std::vector<matrix6> block;
  };
  struct parent_row {
    sparse_row row;
    matrix6 keep;
  };

  /// Calls work(i, sum) for every row; the sum is empty.
  template <class Work>
  static void for_each(std::size_t count, Work&& work) {
    constexpr std::size_t rows_per_chunk = 16;
    parallel_for(
      count,
      [&](std::size_t first, std::size_t last, std::size_t) {
        row_sum sum;
        for (std::size_t i = first; i < last; ++i)
          work(i, sum);
      },
      rows_per_chunk);
  }

  [[nodiscard]] static std::vector<std::uint32_t> numbers(std::uint32_t count) {
    std::vector<std::uint32_t> result(count);
    std::iota(result.begin(), result.end(), 0u);
    return result;
  }

  [[nodiscard]] matrix6 modes(std::size_t i) const {
    return modes_.empty() ? parent_modes(memory_, above_, i) : modes_[i];
  }

  void note_parents(std::uint32_t i) {
    if (i >= level_.prolongation_rows.size())
      return;
    const auto parents = level_.prolongation_rows.of(i, level_.prolongation_column);
    parents_.insert(parents_.end(), parents.begin(), parents.end());
  }

  [[nodiscard]] std::vector<std::uint32_t> with_neighbours(
    std::span<const std::uint32_t> rows) const {
    std::vector<std::uint32_t> result(rows.begin(), rows.end());
    for (const auto i : rows) {
      const auto columns = level_.rows.of(i, level_.column);
      result.insert(result.end(), columns.begin(), columns.end());
    }
    sort_unique(result);
    return result;
  }

  [[nodiscard]] std::vector<sparse_row> prolongation_of(std::span<const std::uint32_t> rows) const {
    std::vector<sparse_row> fresh(rows.size());
    for_each(rows.size(),
             [&](std::size_t at, row_sum& sum) { fresh[at] = prolongation_row(rows[at], sum); });
    return fresh;
  }

  /// Row i of (I - omega D^-1 A) P_0: rigid motions of the groups, with the energy at their rims
  /// smoothed away (Vanek, Mandel & Brezina 1996).
  [[nodiscard]] sparse_row prolongation_row(std::uint32_t i, row_sum& sum) const {
    for (auto s = level_.rows.begin(i); s < level_.rows.end(i); ++s) {
      const auto j = level_.column[s];
      const matrix6 up = modes(j);
      auto& to = sum.at(memory_.group[j]);
      run_widest([&]() TEDIT_INLINED { six_by_six(level_.block[s]).add_product(up.data(), to); });
    }
    sparse_row row;
    sum.finish(row.column, row.block);
    const matrix6 smooth =
      -static_cast<double>(chebyshev_start(level_.lambda)) * wide(level_.inverse[i]);
    for (std::size_t s = 0; s < row.block.size(); ++s) {
      row.block[s] = smooth * row.block[s];
      if (row.column[s] == memory_.group[i])
        row.block[s] += modes(i);
    }
    return row;
  }

  void place_prolongation(std::span<const std::uint32_t> rows, std::span<const sparse_row> fresh) {
    auto& places = level_.prolongation_rows;
    const auto at = make_room(places, rows, [&](std::size_t i) { return fresh[i].column.size(); });
    level_.prolongation_column.resize(places.room());
    level_.prolongation.resize(places.room());
    level_.entry_row.resize(places.room());
    for_each(rows.size(), [&](std::size_t i, row_sum&) {
      for (std::uint32_t s = 0; s < fresh[i].column.size(); ++s) {
        level_.prolongation_column[at[i] + s] = fresh[i].column[s];
        level_.entry_row[at[i] + s] = rows[i];
        store(fresh[i].block[s], level_.prolongation[at[i] + s]);
      }
    });
  }

  /// The lists of entries of all parents that had or have some of `rows`.
  void relink(std::span<const std::uint32_t> rows) {
    sort_unique(parents_);
    std::vector<std::vector<std::uint32_t>> lists(parents_.size());
    for (std::size_t at = 0; at < parents_.size(); ++at)
      for (const auto entry : level_.entries.of(parents_[at]))
        if (!std::ranges::binary_search(rows, level_.entry_row[entry]))
          lists[at].push_back(entry);
    const auto& places = level_.prolongation_rows;
    for (const auto i : rows)
      for (auto s = places.begin(i); s < places.end(i); ++s) {
        const auto at = std::ranges::lower_bound(parents_, level_.prolongation_column[s]);
        lists[static_cast<std::size_t>(at - parents_.begin())].push_back(s);
      }
    for (std::size_t at = 0; at < parents_.size(); ++at) {
      std::ranges::sort(lists[at]);
      level_.entries.replace(parents_[at], lists[at]);
    }
  }

  void renew_parents(std::vector<std::uint32_t>& reframed) {
    make_products();
    std::vector<parent_row> fresh(parents_.size());
    for_each(fresh.size(),
             [&](std::size_t at, row_sum& sum) { fresh[at] = make_row(parents_[at], sum); });
    reframed.clear();
    above_.keep.resize(above_.frames.size(), matrix6::Identity());
    for (std::size_t at = 0; at < fresh.size(); ++at) {
      auto& keep = above_.keep[parents_[at]];
      if ((fresh[at].keep - keep).norm() > 1e-6)
        reframed.push_back(parents_[at]);
      keep = fresh[at].keep;
    }
    replace_rows(coarser_, parents_,
                 [&](std::size_t at) -> const sparse_row& { return fresh[at].row; });
    renew_inverses(coarser_, parents_);
  }

  /// The rows of A P that the parents ask for, several of them for each.
  void make_products() {
    for (const auto parent : parents_)
      for (const auto entry : level_.entries.of(parent))
        children_.push_back(level_.entry_row[entry]);
    sort_unique(children_);
    products_.resize(children_.size());
    for_each(children_.size(), [&](std::size_t at, row_sum& sum) {
      products_[at] = product_row(children_[at], sum);
    });
  }

  [[nodiscard]] sparse_row product_row(std::uint32_t i, row_sum& sum) const {
    run_widest([&]() TEDIT_INLINED {
      for (auto s = level_.rows.begin(i); s < level_.rows.end(i); ++s) {
        const auto k = level_.column[s];
        const six_by_six block(level_.block[s]);
        for (auto t = level_.prolongation_rows.begin(k); t < level_.prolongation_rows.end(k); ++t)
          block.add_product(level_.prolongation[t], sum.at(level_.prolongation_column[t]));
      }
    });
    sparse_row row;
    sum.finish(row.column, row.block);
    return row;
  }

  [[nodiscard]] parent_row make_row(std::uint32_t parent, row_sum& sum) const {
    matrix6 gram = matrix6::Zero();
    for (const auto entry : level_.entries.of(parent)) {
      const auto i = level_.entry_row[entry];
      const auto at = std::ranges::lower_bound(children_, i) - children_.begin();
      const auto& row = products_[static_cast<std::size_t>(at)];
      run_widest([&]() TEDIT_INLINED {
        const auto down = six_by_six::transposed(level_.prolongation[entry]);
        for (std::size_t t = 0; t < row.column.size(); ++t)
          down.add_product(row.block[t].data(), sum.at(row.column[t]));
      });
      if (memory_.group[i] == parent) {
        const matrix6 m = modes(i);
        gram.noalias() += m.transpose() * m;
      }
    }
    parent_row result;
    result.keep = remove_null_motions(gram, sum.matrix_at(parent));
    sum.finish(result.row.column, result.row.block);
    return result;
  }

  rigid_level& level_;
  rigid_level& coarser_;
  level_memory& memory_;
  level_memory& above_;
  std::vector<matrix6> modes_;  ///< Of all rows, when all are needed.
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint32_t> children_;  ///< Of all parents, ascending.
  std::vector<sparse_row> products_;     ///< Rows of A P of the children.
};

}  // namespace

void renew_inverses(rigid_level& level, std::span<const std::uint32_t> rows) {
  level.inverse.resize(level.rows.size());
  parallel_for(
    rows.size(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (const auto row : rows.subspan(first, last - first))
        for (auto s = level.rows.begin(row); s < level.rows.end(row); ++s)
          if (level.column[s] == row)
            store(inverse_of(wide(level.block[s])), level.inverse[row]);
    },
    64);
}

void build_coarser_level(hierarchy& h) {
  step_up(h.levels.size() - 2, h).build();
}

expected<void> update_rigid_levels(std::vector<std::uint32_t> rows, hierarchy& h) {
  std::vector<std::uint32_t> reframed;
  for (std::size_t l = 0; l + 1 < h.levels.size(); ++l) {
    h.levels[l].changed = rows;
    rows = step_up(l, h).update(rows, reframed);
    // Other motions of a parent change the prolongation of its neighbours, too.
    for (const auto parent : reframed) {
      const auto columns = h.levels[l + 1].rows.of(parent, h.levels[l + 1].column);
      rows.insert(rows.end(), columns.begin(), columns.end());
    }
    sort_unique(rows);
  }
  h.levels.back().changed = std::move(rows);
  auto solver = factor(h.levels.back());
  if (!solver)
    return fail(solver.error());
  h.coarsest = std::move(*solver);
  return {};
}

}  // namespace tedit::fem
