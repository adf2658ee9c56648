// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <unordered_map>

#include "fem/multilevel/node_smoother.hpp"
#include "fem/multilevel/rigid_levels.hpp"

namespace tedit::fem {

namespace {

void sort_unique(std::vector<std::uint32_t>& list) {
  std::ranges::sort(list);
  list.erase(std::ranges::unique(list).begin(), list.end());
}

/// One step upwards: the prolongation of changed rows, and the coarser rows that they touch.
class level_update {
public:
  level_update(std::size_t l, hierarchy& h)
      : level_(h.levels[l]),
        coarser_(h.levels[l + 1]),
        memory_(h.memory->levels[l]),
        above_(h.memory->levels[l + 1]) {}

  /// Returns the changed rows of the coarser level; `reframed` becomes those with other motions.
  std::vector<std::uint32_t> run(std::span<const std::uint32_t> rows,
                                 std::vector<std::uint32_t>& reframed) {
    for (const auto i : rows)
      renew_prolongation(i);
    auto around = with_neighbours(rows);
    for (const auto i : around)
      note_parents(i);
    sort_unique(parents_);
    reframed.clear();
    for (const auto parent : parents_)
      if (renew_row(parent))
        reframed.push_back(parent);
    return std::move(parents_);
  }

private:
  struct sparse_row {
    std::vector<std::uint32_t> column;
    std::vector<matrix6> block;
  };

  [[nodiscard]] matrix6 modes(std::size_t i) const { return parent_modes(memory_, above_, i); }

  void note_parents(std::uint32_t i) {
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

  void unlink(std::uint32_t i) {
    auto& places = level_.prolongation_rows;
    for (auto s = places.begin(i); s < places.end(i); ++s) {
      const auto parent = level_.prolongation_column[s];
      const auto old = level_.entries.of(parent);
      std::vector<std::uint32_t> left;
      std::ranges::copy_if(old, std::back_inserter(left),
                           [&](std::uint32_t entry) { return entry != s; });
      level_.entries.replace(parent, left);
    }
  }

  void renew_prolongation(std::uint32_t i) {
    auto& places = level_.prolongation_rows;
    if (i < places.size()) {
      note_parents(i);
      unlink(i);
    }
    while (i >= places.size())
      places.add(0);
    sparse_row row;
    const auto begin = level_.rows.begin(i);
    const double omega = static_cast<double>(chebyshev_start(level_.lambda));
    prolongation_row(
      i, level_.rows.of(i, level_.column),
      [&](std::size_t s) { return wide(level_.block[begin + s]); }, omega * wide(level_.inverse[i]),
      memory_.group, [&](std::size_t j) { return modes(j); }, row.column, row.block);
    const auto at = places.replace(i, static_cast<std::uint32_t>(row.column.size()));
    level_.prolongation_column.resize(places.room());
    level_.prolongation.resize(places.room());
    level_.entry_row.resize(places.room());
    for (std::uint32_t s = 0; s < row.column.size(); ++s) {
      level_.prolongation_column[at + s] = row.column[s];
      level_.entry_row[at + s] = i;
      store(row.block[s], level_.prolongation[at + s]);
      const auto old = level_.entries.of(row.column[s]);
      std::vector<std::uint32_t> more(old.begin(), old.end());
      more.push_back(at + s);
      std::ranges::sort(more);
      level_.entries.replace(row.column[s], more);
    }
  }

  /// Row i of A P, remembered: several parents ask for it.
  const sparse_row& product_row(std::uint32_t i) {
    auto& row = products_[i];
    if (!row.column.empty())
      return row;
    row_sum sum;
    for (auto s = level_.rows.begin(i); s < level_.rows.end(i); ++s) {
      const auto k = level_.column[s];
      const matrix6 block = wide(level_.block[s]);
      for (auto t = level_.prolongation_rows.begin(k); t < level_.prolongation_rows.end(k); ++t)
        sum.at(level_.prolongation_column[t]).noalias() += block * wide(level_.prolongation[t]);
    }
    sum.finish(row.column, row.block);
    return row;
  }

  /// True when the motions of the parent changed.
  bool renew_row(std::uint32_t parent) {
    row_sum sum;
    matrix6 gram = matrix6::Zero();
    for (const auto entry : level_.entries.of(parent)) {
      const auto i = level_.entry_row[entry];
      const matrix6 up = wide(level_.prolongation[entry]).transpose();
      const auto& row = product_row(i);
      for (std::size_t t = 0; t < row.column.size(); ++t)
        sum.at(row.column[t]).noalias() += up * row.block[t];
      if (memory_.group[i] == parent) {
        const matrix6 m = modes(i);
        gram += m.transpose() * m;
      }
    }
    const matrix6 keep = remove_null_motions(gram, sum.at(parent));
    sparse_row row;
    sum.finish(row.column, row.block);
    replace_row(coarser_, parent, row.column, row.block);
    const bool changed = (keep - above_.keep[parent]).norm() > 1e-6;
    above_.keep[parent] = keep;
    return changed;
  }

  rigid_level& level_;
  rigid_level& coarser_;
  level_memory& memory_;
  level_memory& above_;
  std::vector<std::uint32_t> parents_;
  std::unordered_map<std::uint32_t, sparse_row> products_;
};

}  // namespace

void replace_row(rigid_level& level, std::uint32_t row, std::span<const std::uint32_t> column,
                 std::span<const matrix6> block) {
  while (row >= level.rows.size()) {
    level.rows.add(0);
    level.inverse.emplace_back();
  }
  const auto at = level.rows.replace(row, static_cast<std::uint32_t>(column.size()));
  level.column.resize(level.rows.room());
  level.block.resize(level.rows.room());
  for (std::size_t s = 0; s < column.size(); ++s) {
    level.column[at + s] = column[s];
    store(block[s], level.block[at + s]);
    if (column[s] == row)
      store(inverse_of(block[s]), level.inverse[row]);
  }
}

void update_rigid_levels(std::vector<std::uint32_t> rows, hierarchy& h) {
  std::vector<std::uint32_t> reframed;
  for (std::size_t l = 0; l + 1 < h.levels.size(); ++l) {
    rows = level_update(l, h).run(rows, reframed);
    // Other motions of a parent change the prolongation of its neighbours, too.
    for (const auto parent : reframed) {
      const auto columns = h.levels[l + 1].rows.of(parent, h.levels[l + 1].column);
      rows.insert(rows.end(), columns.begin(), columns.end());
    }
    sort_unique(rows);
  }
  h.coarsest = factor(h.levels.back());
}

}  // namespace tedit::fem
