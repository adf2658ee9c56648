// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ostream>

#include "bench/peers/system.hpp"
#include "bench/peers/system_magic.hpp"
#include "fem/element_operator.hpp"
#include "fem/incidence.hpp"
#include "fem/quadratic.hpp"
#include "mesh/io/file.hpp"

namespace tedit::bench {

namespace {

using matrix3 = std::array<double, 9>;  // by rows

constexpr std::uint32_t left_out = ~std::uint32_t{0};

matrix3 full(const std::array<double, 6>& s) {
  return {s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5]};
}

matrix3 product(const matrix3& a, const matrix3& b) {
  matrix3 c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return c;
}

std::array<double, 3> components(const vec3& v) {
  return {v.x, v.y, v.z};
}

/// Gradients of the shape functions at the four corners, between which they are linear.
using corner_gradients = std::array<std::array<vec3, 10>, 4>;

corner_gradients shape_gradients(const fem::tet_gradients& g, int order) {
  corner_gradients result{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t b = 0; b < 4; ++b)
      result[k][b] = order == 1 ? g.gradient[b] : (b == k ? 3.0 : -1.0) * g.gradient[b];
    if (order == 2)
      for (const int b : fem::other_corners[k])
        result[k][static_cast<std::size_t>(fem::mid_node_of[k][static_cast<std::size_t>(b)])] =
          4.0 * g.gradient[static_cast<std::size_t>(b)];
  }
  return result;
}

/// Integral of grad N_a (x) grad N_b: V/20 (sum_k + the product of the sums), exact for the product
/// of two linear functions.
matrix3 gradient_product(const corner_gradients& g, double volume, std::size_t a, std::size_t b) {
  matrix3 m{};
  vec3 sum_a;
  vec3 sum_b;
  const auto add = [&m](const vec3& left, const vec3& right) {
    const auto l = components(left);
    const auto r = components(right);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        m[3 * i + j] += l[i] * r[j];
  };
  for (const auto& at : g) {
    add(at[a], at[b]);
    sum_a += at[a];
    sum_b += at[b];
  }
  add(sum_a, sum_b);
  for (auto& value : m)
    value *= volume / 20;
  return m;
}

/// K_ab = lambda M + mu M^T + mu tr(M) I of one element.
void add_stiffness(const matrix3& m, const fem::lame_constants& c, double* block) {
  const double trace = m[0] + m[4] + m[8];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      block[3 * i + j] +=
        c.lambda * m[3 * i + j] + c.mu * m[3 * j + i] + (i == j ? c.mu * trace : 0);
}

/// Rows of K, gathered from the elements around a node.
class row_gatherer {
public:
  explicit row_gatherer(const fem::problem& p) : problem_(p), around_(p) {}

  /// Fills `columns`, ascending; values with `gather`.
  void list(std::size_t node) {
    columns.clear();
    const auto per_element = static_cast<std::size_t>(problem_.nodes_per_element);
    for (const auto entry : around_.of_node(node)) {
      const auto* n = &problem_.element_nodes[entry / per_element * per_element];
      columns.insert(columns.end(), n, n + per_element);
    }
    std::ranges::sort(columns);
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  }

  /// Fills `columns` and `blocks`: row `node` of K.
  void gather(std::size_t node) {
    list(node);
    blocks.assign(9 * columns.size(), 0);
    const auto per_element = static_cast<std::size_t>(problem_.nodes_per_element);
    for (const auto entry : around_.of_node(node)) {
      const std::size_t e = entry / per_element;
      const auto g = fem::gradients_of(problem_, e);
      const auto shapes = shape_gradients(g, problem_.element_order);
      for (std::size_t b = 0; b < per_element; ++b) {
        const auto column = problem_.element_nodes[e * per_element + b];
        const auto at = std::ranges::lower_bound(columns, column) - columns.begin();
        add_stiffness(gradient_product(shapes, g.volume, entry % per_element, b),
                      problem_.constants[problem_.element_materials[e]], &blocks[9 * at]);
      }
    }
  }

  std::vector<std::uint32_t> columns;
  std::vector<double> blocks;

private:
  const fem::problem& problem_;
  fem::incidence around_;
};

/// Which nodes stay, and what their number is.
std::vector<std::uint32_t> number_nodes(const fem::problem& p) {
  std::vector<std::uint32_t> number(p.node_count(), left_out);
  std::uint32_t next = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n)
    if (std::ranges::any_of(p.filter[n], [](double s) { return s != 0; }))
      number[n] = next++;
  return number;
}

class system_writer {
public:
  system_writer(const fem::problem& p, std::ostream& out)
      : problem_(p),
        out_(out),
        rows_(p),
        number_(number_nodes(p)),
        wave_(p.dofs()),
        image_(p.dofs()) {}

  system_header write() {
    for (std::size_t i = 0; i < wave_.size(); ++i)
      wave_[i] = std::sin(1.0 + 0.7 * static_cast<double>(i));
    write_head();
    for (std::size_t n = 0; n < number_.size(); ++n)
      if (number_[n] != left_out)
        write_row(n);
    return header_;
  }

  /// How far K times a vector lies from what the elements say; 0 but for rounding.
  [[nodiscard]] double error() const {
    std::vector<double> wanted(wave_.size());
    fem::element_operator(problem_).apply(wave_, wanted);
    double off = 0;
    double whole = 0;
    for (std::size_t n = 0; n < number_.size(); ++n)
      for (std::size_t i = 3 * n; number_[n] != left_out && i < 3 * n + 3; ++i) {
        off += (image_[i] - wanted[i]) * (image_[i] - wanted[i]);
        whole += wanted[i] * wanted[i];
      }
    return std::sqrt(off / whole);
  }

private:
  template <class T>
  void put(std::span<const T> values) {
    out_.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size_bytes()));
  }

  void write_head() {
    std::vector<std::uint64_t> first{0};
    std::vector<double> load;
    std::vector<double> positions;
    for (std::size_t n = 0; n < number_.size(); ++n) {
      if (number_[n] == left_out)
        continue;
      rows_.list(n);
      const auto kept =
        std::ranges::count_if(rows_.columns, [&](auto c) { return number_[c] != left_out; });
      first.push_back(first.back() + static_cast<std::uint64_t>(kept));
      const auto s = full(problem_.filter[n]);
      for (std::size_t i = 0; i < 3; ++i)
        load.push_back(s[3 * i] * problem_.loads[3 * n] + s[3 * i + 1] * problem_.loads[3 * n + 1] +
                       s[3 * i + 2] * problem_.loads[3 * n + 2]);
      const auto x = components(problem_.nodes[n]);
      positions.insert(positions.end(), x.begin(), x.end());
    }
    header_ = {system_magic, static_cast<std::uint64_t>(problem_.element_order),
               problem_.element_count(), first.size() - 1, first.back()};
    put(std::span<const system_header>(&header_, 1));
    put(std::span<const std::uint64_t>(first));
    put(std::span<const double>(load));
    put(std::span<const double>(positions));
  }

  void write_row(std::size_t n) {
    rows_.gather(n);
    kept_columns_.clear();
    kept_blocks_.clear();
    const auto own = full(problem_.filter[n]);
    for (std::size_t k = 0; k < rows_.columns.size(); ++k) {
      const auto column = rows_.columns[k];
      matrix3 block;
      std::copy_n(&rows_.blocks[9 * k], 9, block.begin());
      for (std::size_t i = 0; i < 9; ++i)
        image_[3 * n + i / 3] += block[i] * wave_[3 * column + i % 3];
      if (number_[column] == left_out)
        continue;
      const double mean = (block[0] + block[4] + block[8]) / 3;
      block = product(product(own, block), full(problem_.filter[column]));
      if (column == n)
        for (std::size_t i = 0; i < 9; ++i)
          block[i] += mean * ((i % 4 == 0 ? 1 : 0) - own[i]);
      kept_columns_.push_back(number_[column]);
      kept_blocks_.insert(kept_blocks_.end(), block.begin(), block.end());
    }
    put(std::span<const std::uint32_t>(kept_columns_));
    put(std::span<const double>(kept_blocks_));
  }

  const fem::problem& problem_;
  std::ostream& out_;
  row_gatherer rows_;
  std::vector<std::uint32_t> number_;
  std::vector<double> wave_, image_;  ///< Any vector, and K times it.
  std::vector<std::uint32_t> kept_columns_;
  std::vector<double> kept_blocks_;
  system_header header_;
};

}  // namespace

expected<system_header> write_system(const fem::problem& p, const std::filesystem::path& path) {
  if (std::ranges::any_of(p.prescribed, [](double z) { return z != 0; }))
    return fail(ec::invalid_argument, "a system file has no prescribed displacements",
                "Give a load case whose supports hold still");
  system_header header;
  double error = 0;
  const auto written = write_file(path, [&](std::ostream& out) {
    system_writer writer(p, out);
    header = writer.write();
    error = writer.error();
  });
  if (!written)
    return fail(written.error());
  if (!(error < 1e-12)) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return fail(ec::internal, "the written matrix differs from the elements' by " +
                                std::to_string(error) + " of its size");
  }
  return header;
}

}  // namespace tedit::bench
