// SPDX-License-Identifier: AGPL-3.0-or-later
// How kernels and C++ share names. `X_bindings.h` names what the kernels of the stem X are bound to and the members of
// their push constants; its kernels include it, and C++ does through fem/vulkan/kernels.hpp. A binding `name` is at_name
// in a kernel, X_at::name in C++.
#ifndef TEDIT_BINDINGS_H
#define TEDIT_BINDINGS_H

#define TEDIT_BINDINGS 10  // of each kernel; what it does not name holds any buffer
#define TEDIT_GATES 17     // group counts that a dispatch of a loop can have: powers of two, at most 65535

#ifdef __cplusplus
#include <cstdint>
#define TEDIT_SHARED namespace tedit::fem::vulkan { using uint = std::uint32_t;
#define TEDIT_NAMES(scope) namespace tedit::fem::vulkan::scope {
#define TEDIT_BINDING(name, number) inline constexpr int name = number;
#define TEDIT_END }
#define TEDIT_PUSH(type)
#else
#define TEDIT_SHARED
#define TEDIT_NAMES(scope)
#define TEDIT_BINDING(name, number) const int at_##name = number;
#define TEDIT_END
#define TEDIT_PUSH(type) layout(push_constant) uniform pushed { type push; };
#endif

// Push constants of all kernels begin with `rows`, up to which a dispatch goes, `from`, where it starts, and, where it
// leaves partial sums, `first_sum`.
#endif
