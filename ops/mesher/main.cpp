// SPDX-License-Identifier: AGPL-3.0-or-later
// Meshes what is asked for on stdin: fills a closed surface with tets, or combines two surfaces.
// Both may end the process, crash or hang on some inputs; whoever starts this program expects that.
#include "ops/mesher/corefine_exchange.hpp"
#include "ops/mesher/jobs.hpp"
#include "ops/mesher/tets_exchange.hpp"
#include "sandbox/sandbox.hpp"

namespace {

/// It needs what it has open, and no file besides.
bool confine() {
  using namespace tedit;
  return !sandbox::is_wanted() ||
         (sandbox::confine_files({}) && sandbox::confine_calls(sandbox::calls::of_filters));
}

int run() {
  using namespace tedit::ops;
  std::uint32_t magic = 0;
  if (std::fread(&magic, sizeof(magic), 1, stdin) != 1)
    return 2;
  if (magic == exchange_header{}.magic)
    return fill_with_tets(magic);
  return magic == corefine_header{}.magic ? combine_surfaces(magic) : 2;
}

}  // namespace

int main() {
  if (!confine())
    return 5;
  try {
    return run();
  } catch (...) {
    return 3;  // TetGen throws an int for most of its failures, CGAL for surfaces that cut
               // themselves.
  }
}
