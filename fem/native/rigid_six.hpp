// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "fem/multilevel/lanes.hpp"

namespace tedit::fem {

/// The six rigid motions of one aggregate, for each case.
template <class L>
struct alignas(4 * L::width) rigid_six {
  using scalar = typename L::scalar;

  std::array<scalar, 6> v{};

  [[nodiscard]] TEDIT_INLINE static rigid_six load(const float* x, std::size_t i) {
    rigid_six result;
    for (std::size_t c = 0; c < 6; ++c)
      result.v[c] = L::load_scalar(x, 6 * i + c);
    return result;
  }
  TEDIT_INLINE void store(float* x, std::size_t i) const {
    for (std::size_t c = 0; c < 6; ++c)
      L::store_scalar(v[c], x, 6 * i + c);
  }
  /// Adds block * x.
  TEDIT_INLINE void add_product(const rigid_level::block6& block, const rigid_six& x) {
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t r = 0; r < 6; ++r)
        v[r] += block[6 * c + r] * x.v[c];
  }
  /// Adds block^T * x.
  TEDIT_INLINE void add_transposed(const rigid_level::block6& block, const rigid_six& x) {
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t r = 0; r < 6; ++r)
        v[c] += block[6 * c + r] * x.v[r];
  }
  /// Adds the components given.
  TEDIT_INLINE void add(scalar a, scalar b, scalar c, scalar d, scalar e, scalar f) {
    v[0] += a, v[1] += b, v[2] += c, v[3] += d, v[4] += e, v[5] += f;
  }

  TEDIT_INLINE friend rigid_six operator+(const rigid_six& a, const rigid_six& b) {
    rigid_six sum;
    for (std::size_t c = 0; c < 6; ++c)
      sum.v[c] = a.v[c] + b.v[c];
    return sum;
  }
  TEDIT_INLINE friend rigid_six operator-(const rigid_six& a, const rigid_six& b) {
    rigid_six sum;
    for (std::size_t c = 0; c < 6; ++c)
      sum.v[c] = a.v[c] - b.v[c];
    return sum;
  }
  TEDIT_INLINE friend rigid_six operator*(float s, const rigid_six& a) {
    rigid_six product;
    for (std::size_t c = 0; c < 6; ++c)
      product.v[c] = s * a.v[c];
    return product;
  }
};

/// One case: six floats are too few for lanes of their own, and Eigen's vectors are faster.
template <>
struct rigid_six<one_case> {
  using vector6 = Eigen::Matrix<float, 6, 1>;

  vector6 v = vector6::Zero();

  [[nodiscard]] static rigid_six load(const float* x, std::size_t i) {
    return {Eigen::Map<const vector6>(x + 6 * i)};
  }
  void store(float* x, std::size_t i) const { Eigen::Map<vector6>(x + 6 * i) = v; }
  void add_product(const rigid_level::block6& block, const rigid_six& x) {
    v.noalias() += matrix(block) * x.v;
  }
  void add_transposed(const rigid_level::block6& block, const rigid_six& x) {
    v.noalias() += matrix(block).transpose() * x.v;
  }
  void add(float a, float b, float c, float d, float e, float f) { v += vector6(a, b, c, d, e, f); }

  friend rigid_six operator+(const rigid_six& a, const rigid_six& b) { return {a.v + b.v}; }
  friend rigid_six operator-(const rigid_six& a, const rigid_six& b) { return {a.v - b.v}; }
  friend rigid_six operator*(float s, const rigid_six& a) { return {s * a.v}; }

private:
  static Eigen::Map<const Eigen::Matrix<float, 6, 6>> matrix(const rigid_level::block6& block) {
    return Eigen::Map<const Eigen::Matrix<float, 6, 6>>(block.data());
  }
};

}  // namespace tedit::fem
