// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include "bench/spmv.hpp"
#include "fem/block_matrix.hpp"
#include "fem/multilevel/block_rows.hpp"
#include "fem/native/quadratic.hpp"

namespace tedit::bench {

namespace {

using fem::float4;

/// Blocks as smoothers read them.
struct rounded_blocks {
  fem::block_matrix k;

  [[nodiscard]] std::size_t rows() const { return k.rows(); }
  [[nodiscard]] std::uint64_t bytes() const {
    return k.bytes() - k.low.size() * sizeof(fem::half_block);
  }
};

template <class L, class Sink>
void for_rows(const rounded_blocks& m, const float* x, const Sink& sink) {
  fem::for_rows<L>(fem::smoothed_matrix{m.k, {}}, x, sink);
}

template <class Operator>
class native_probe final : public product_probe {
public:
  native_probe(Operator k, std::uint64_t copy_bytes) : k_(std::move(k)) {
    const auto size = fem::padded3(k_.rows());
    x_.resize(size);
    y_.resize(size);
    for (std::size_t i = 0; i < size; ++i)
      x_[i] = static_cast<float>(std::sin(0.1 * static_cast<double>(i)));
    // The first product makes the room that patches need for their sums: written, then read.
    const auto before = k_.bytes();
    product();
    const auto between = k_.bytes() - before;
    bytes_ = static_cast<double>(k_.bytes() + between + 8 * size);
    from_.assign((copy_bytes ? copy_bytes : static_cast<std::uint64_t>(bytes_)) / 8, 1);
    to_.assign(from_.size(), 0);
  }

  double product_bytes() const override { return bytes_; }
  double copy_bytes() const override { return 8 * static_cast<double>(from_.size()); }

  expected<void> multiply(int times) override {
    for (int i = 0; i < times; ++i)
      product();
    return {};
  }

  expected<void> copy(int times) override {
    for (int i = 0; i < times; ++i)
      parallel_for(
        from_.size(),
        [this](std::size_t first, std::size_t last, std::size_t) {
          std::memcpy(&to_[first], &from_[first], (last - first) * sizeof(float));
        },
        copied_at_once);
    return {};
  }

private:
  /// 256 KiB: less than where memcpy goes around the caches.
  static constexpr std::size_t copied_at_once = std::size_t{1} << 16;

  void product() {
    float* y = y_.data();
    for_rows<fem::one_case>(
      k_, x_.data(), [y](std::size_t i, float4 row) TEDIT_INLINED { fem::store3(row, y + 3 * i); });
  }

  Operator k_;
  std::vector<float> x_, y_, from_, to_;
  double bytes_ = 0;
};

}  // namespace

std::unique_ptr<product_probe> probe_native(const fem::problem& p, std::uint64_t copy_bytes,
                                            bool rounded) {
  if (p.element_order == 1) {
    auto blocks = fem::assemble_blocks(p, fem::incidence(p));
    if (rounded)
      return std::make_unique<native_probe<rounded_blocks>>(rounded_blocks{std::move(blocks)},
                                                            copy_bytes);
    return std::make_unique<native_probe<fem::block_matrix>>(std::move(blocks), copy_bytes);
  }
  return std::make_unique<native_probe<fem::native::quadratic_operator>>(
    fem::native::quadratic_operator(p), copy_bytes);
}

}  // namespace tedit::bench
