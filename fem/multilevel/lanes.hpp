// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>

#include "base/parallel.hpp"
#include "fem/wide.hpp"

/// How many load cases a vector holds side by side. The kernels of the native solver are written
/// once over a lane type: `one_case`, three floats a node that live in a `float4`, or
/// `cases_of<W>`, W numbers for each of the three components, so that one read of the matrix serves
/// W cases. Lanes never meet: a case has the same bits whatever the other lanes hold.
namespace tedit::fem {

/// A sum of each case.
template <class L>
using case_sums = std::array<double, L::width>;

/// One case: 3 floats a node and one of padding behind the last.
struct one_case {
  static constexpr std::size_t width = 1;
  using scalar = float;  ///< A number of each case.
  using node = float4;   ///< The three numbers of a node, and one lane unused.
  using sum = double;    ///< `case_sums` in registers.

  [[nodiscard]] static constexpr std::size_t size(std::size_t nodes) { return padded3(nodes); }

  TEDIT_INLINE static float load_scalar(const float* x, std::size_t i) { return x[i]; }
  TEDIT_INLINE static void store_scalar(float s, float* x, std::size_t i) { x[i] = s; }
  TEDIT_INLINE static float4 load(const float* x, std::size_t i) { return load4(x + 3 * i); }
  /// For vectors that other threads change beside the node.
  TEDIT_INLINE static float4 load_own(const float* x, std::size_t i) { return load3(x + 3 * i); }
  TEDIT_INLINE static void store(float4 v, float* x, std::size_t i) { store3(v, x + 3 * i); }
  TEDIT_INLINE static float component(float4 v, int c) { return v[c]; }
  TEDIT_INLINE static float4 node_of(float x, float y, float z) { return float4{x, y, z, 0}; }
  TEDIT_INLINE static float dot(float4 a, float4 b) {
    const float4 d = a * b;
    return d[0] + d[1] + d[2];
  }
  TEDIT_INLINE static void add(float s, double& to) { to += static_cast<double>(s); }
  TEDIT_INLINE static void add_product(float a, float b, double& to) {
    to += static_cast<double>(a) * static_cast<double>(b);
  }
};

/// The vectors of W cases.
template <std::size_t W>
struct lane_vectors;

template <>
struct lane_vectors<4> {
  using single [[gnu::vector_size(16)]] = float;
  using anywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
  using wide [[gnu::vector_size(32)]] = double;
};

template <>
struct lane_vectors<8> {
  using single [[gnu::vector_size(32)]] = float;
  using anywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
  using wide [[gnu::vector_size(64)]] = double;
};

/// Three numbers of each of W cases: the components of a node, or a column of a tensor there. The
/// alignment is said, for the compiler's own differs between a body for AVX2 and one for any
/// machine.
template <std::size_t W>
struct alignas(4 * W) node_lanes {
  using scalar = typename lane_vectors<W>::single;

  scalar x, y, z;

  TEDIT_INLINE friend node_lanes operator+(const node_lanes& a, const node_lanes& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  TEDIT_INLINE friend node_lanes operator-(const node_lanes& a, const node_lanes& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  TEDIT_INLINE friend node_lanes operator*(float s, const node_lanes& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  TEDIT_INLINE friend node_lanes operator*(const node_lanes& a, float s) { return s * a; }
  TEDIT_INLINE node_lanes& operator+=(const node_lanes& b) { return *this = *this + b; }
  TEDIT_INLINE node_lanes& operator-=(const node_lanes& b) { return *this = *this - b; }
};

/// W cases side by side: component c of node i is at x[W * (3 * i + c)], case by case.
template <std::size_t W>
struct cases_of {
  static constexpr std::size_t width = W;
  using scalar = typename lane_vectors<W>::single;
  using node = node_lanes<W>;
  using sum = typename lane_vectors<W>::wide;

  [[nodiscard]] static constexpr std::size_t size(std::size_t nodes) { return 3 * W * nodes; }

  TEDIT_INLINE static scalar load_scalar(const float* x, std::size_t i) {
    return *reinterpret_cast<const typename lane_vectors<W>::anywhere*>(x + W * i);
  }
  TEDIT_INLINE static void store_scalar(scalar s, float* x, std::size_t i) {
    *reinterpret_cast<typename lane_vectors<W>::anywhere*>(x + W * i) = s;
  }
  TEDIT_INLINE static node load(const float* x, std::size_t i) {
    return {load_scalar(x, 3 * i), load_scalar(x, 3 * i + 1), load_scalar(x, 3 * i + 2)};
  }
  TEDIT_INLINE static node load_own(const float* x, std::size_t i) { return load(x, i); }
  TEDIT_INLINE static void store(const node& v, float* x, std::size_t i) {
    store_scalar(v.x, x, 3 * i);
    store_scalar(v.y, x, 3 * i + 1);
    store_scalar(v.z, x, 3 * i + 2);
  }
  TEDIT_INLINE static scalar component(const node& v, int c) {
    return c == 0 ? v.x : c == 1 ? v.y : v.z;
  }
  TEDIT_INLINE static node node_of(scalar x, scalar y, scalar z) { return {x, y, z}; }
  TEDIT_INLINE static scalar dot(const node& a, const node& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  TEDIT_INLINE static void add(scalar s, sum& to) { to += __builtin_convertvector(s, sum); }
  TEDIT_INLINE static void add_product(scalar a, scalar b, sum& to) {
    to += __builtin_convertvector(a, sum) * __builtin_convertvector(b, sum);
  }
};

/// y = B x for a symmetric block.
template <std::size_t W>
TEDIT_INLINE node_lanes<W> multiply_symmetric(const std::array<float, 6>& b,
                                              const node_lanes<W>& v) {
  return {b[0] * v.x + b[1] * v.y + b[2] * v.z, b[1] * v.x + b[3] * v.y + b[4] * v.z,
          b[2] * v.x + b[4] * v.y + b[5] * v.z};
}

// -- loops -------------------------------------------------------------------------

/// Calls body(first, last), which is inlined, for all chunks of [0, items) on all cores.
template <class L, class Body>
void for_lanes(std::size_t items, const Body& body, std::size_t chunk_items = parallel_chunk) {
  parallel_for(
    items,
    [&](std::size_t first, std::size_t last, std::size_t) {
      run_widest([&]() TEDIT_INLINED { body(first, last); });
    },
    chunk_items);
}

/// The sums over all chunks of what body(first, last, sum) adds to `sum`, in a fixed order.
template <class L, class Body>
[[nodiscard]] case_sums<L> sum_lanes(std::size_t items, const Body& body) {
  std::vector<case_sums<L>> partial(chunk_count(items));
  parallel_for(items, [&](std::size_t first, std::size_t last, std::size_t chunk) {
    run_widest([&]() TEDIT_INLINED {
      typename L::sum sum{};
      body(first, last, sum);
      if constexpr (L::width == 1)
        partial[chunk][0] = sum;
      else
        for (std::size_t c = 0; c < L::width; ++c)
          partial[chunk][c] = sum[c];
    });
  });
  case_sums<L> total{};
  for (const auto& one : partial)
    for (std::size_t c = 0; c < L::width; ++c)
      total[c] += one[c];
  return total;
}

/// Hands row i of a product to a sink, and what that returns, if anything, to `sum`.
template <class L, class Sink>
TEDIT_INLINE void take_row(const Sink& sink, std::size_t i, const typename L::node& row,
                           typename L::sum& sum) {
  if constexpr (std::is_void_v<decltype(sink(i, row))>)
    sink(i, row);
  else
    L::add(sink(i, row), sum);
}

}  // namespace tedit::fem
