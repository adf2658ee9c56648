// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a kernel reads its operands: from storage, or from the same bytes as texels, which binding TEDIT_BINDINGS +
// number holds. A software device (Mesa 22.3) reads storage lane by lane with a branch for each number, texels with
// vectors: a product took 2.5 ms instead of 4. A graphics card has no need for it.
layout(constant_id = 5) const uint texels = 0;

// Declares binding `number` as `name`(place): four words there. A place that the same invocation writes must be read
// before, and only there.
#define TEDIT_WORDS(number, name)                                                                \
  layout(set = 0, binding = number) readonly buffer name##_storage { uvec4 name##_words[]; };    \
  layout(set = 0, binding = TEDIT_BINDINGS + number) uniform usamplerBuffer name##_texels; \
  uvec4 name(uint place) {                                                                       \
    if (texels == 1)                                                                             \
      return texelFetch(name##_texels, int(place));                                              \
    return name##_words[place];                                                                  \
  }

// Four floats.
#define TEDIT_FLOATS(number, name) \
  TEDIT_WORDS(number, name##_bits) \
  vec4 name(uint place) { return uintBitsToFloat(name##_bits(place)); }

// Two words.
#define TEDIT_PAIRS(number, name)                                                                \
  layout(set = 0, binding = number) readonly buffer name##_storage { uvec2 name##_pairs[]; };    \
  layout(set = 0, binding = TEDIT_BINDINGS + number) uniform usamplerBuffer name##_texels; \
  uvec2 name(uint place) {                                                                       \
    if (texels == 0)                                                                             \
      return name##_pairs[place];                                                                \
    const uvec4 two = texelFetch(name##_texels, int(place / 2));                                 \
    return place % 2 == 0 ? two.xy : two.zw;                                                     \
  }

// One word.
#define TEDIT_NUMBERS(number, name)                                                              \
  layout(set = 0, binding = number) readonly buffer name##_storage { uint name##_numbers[]; };   \
  layout(set = 0, binding = TEDIT_BINDINGS + number) uniform usamplerBuffer name##_texels; \
  uint name(uint place) {                                                                        \
    if (texels == 0)                                                                             \
      return name##_numbers[place];                                                              \
    const uvec4 four = texelFetch(name##_texels, int(place / 4));                                \
    const uvec2 two = place % 4 < 2 ? four.xy : four.zw;                                         \
    return place % 2 == 0 ? two.x : two.y;                                                       \
  }
