// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/blocks.hpp"
#include "tests/support/random_edits.hpp"

namespace {

using namespace tedit;

/// A whole block, one with a bore and a pit, and a stair: a few hundred tets each, in mm.
const std::array<version_ptr, 3>& parts() {
  const auto small = [](vec3 p) { return 1e-3 * p; };
  static const std::array<version_ptr, 3> made{
    test::blocks(
      {2, 2, 2}, [](int, int, int) { return true; }, small),
    test::blocks(
      {5, 3, 3}, [](int x, int y, int z) { return y != 1 || (x != 1 && (x != 3 || z == 0)); },
      small),
    test::blocks(
      {3, 2, 3}, [](int x, int, int z) { return z <= 2 - x; }, small)};
  return made;
}

const ops::catalogue& plugins() {
  static const auto loaded = ops::load_default_catalogue(ops::plugin_source::built_in);
  return loaded;
}

/// One number of a byte: its low bits choose, and its place among 256 is the place in a range.
class byte_source {
public:
  byte_source(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  [[nodiscard]] bool empty() const { return left_ == 0; }

  std::uint64_t next() {
    if (left_ == 0)
      return 0;
    --left_;
    const std::uint64_t byte = *data_++;
    return byte << 56 | byte;
  }

private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace

/// Applies up to four edits, chosen by the bytes, to a small part: each gets a sound version or a
/// reason, and every promise of an edit holds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  byte_source bytes(data, size);
  auto mesh = parts()[bytes.next() % parts().size()];
  const double length = std::cbrt(total_volume(*mesh));
  for (int edits = 0; edits < 4 && !bytes.empty(); ++edits) {
    const auto edit = test::choose_edit(plugins(), *mesh, 4 * length, [&] { return bytes.next(); });
    const auto tried = test::try_edit(plugins(), mesh, edit);
    if (!tried.fault.empty()) {
      std::fprintf(stderr, "edit_fuzz: broken promise of %s: %s\n", edit.operation.c_str(),
                   tried.fault.c_str());
      std::abort();
    }
    if (tried.after)
      mesh = tried.after;
  }
  return 0;
}
