#!/usr/bin/env bash
# Installs a build under a fresh prefix, moves it, and makes, builds and tests a plugin against it, far from the tree.
# usage: plugin_package_test.sh BUILD
set -euo pipefail
build=$1
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset TEDIT_LIBEXEC TEDIT_PLUGIN_PATH
export HOME=$work/home XDG_CACHE_HOME=$work/cache
unset XDG_DATA_HOME XDG_CONFIG_HOME

cmake --install "$build" --prefix "$work/first" >"$work/log" || { tail -20 "$work/log" >&2; exit 1; }
mv "$work/first" "$work/prefix" # what is installed may be moved
tedit=$work/prefix/bin/tedit
"$tedit" ops fill_hole | grep -q "^fill_hole " || { echo "the installed program has no operations" >&2; exit 1; }
"$tedit" plugin test "$work/prefix/lib/tedit/plugins/fill_hole.so" --json >"$work/kit.json" ||
  { echo "the installed plugin fails the kit" >&2; cat "$work/kit.json" >&2; exit 1; }

# Headers: those that the manual names and what these include; each is whole, also for who has all warnings on.
headers=$work/prefix/include/tedit
cd "$headers"
[ "$(find ops -type f | LC_ALL=C sort | tr '\n' ' ')" = "ops/mesher/mesher.hpp ops/sdk/description.hpp ops/sdk/operation.hpp\
 ops/services/host_services.hpp ops/tools/files/surface_file.hpp ops/tools/local_size.hpp ops/tools/sweep.hpp\
 ops/tools/text/text_outlines.hpp ops/tools/tools.hpp " ] ||
  { echo "other headers of operations are installed:" >&2; find ops -type f >&2; exit 1; }
for header in $(grep -oE '`(base|mesh|ops|tests)/[a-z_/]+\.hpp`' "$source/docs/plugins.md" | tr -d '`' | sort -u) \
  $(grep -rhoE '^#include "[^"]+"' . | cut -d'"' -f2 | sort -u); do
  [ -f "$header" ] || [ ! -f "$source/$header" ] || { echo "$header is not installed" >&2; exit 1; }
done
[ ! -e mesh/level_set.hpp ] || { echo "the mesh library's own headers are installed" >&2; exit 1; }
find base mesh ops tests -name '*.hpp' | sed 's/.*/#include "&"/' |
  c++ -std=c++20 -fsyntax-only -Wall -Wextra -Wshadow -Werror -I. -x c++ - || { echo "an installed header does not stand alone" >&2; exit 1; }
echo "$(find base mesh ops tests -name '*.hpp' | wc -l) headers of base, mesh, ops and tests"

"$tedit" plugin new probe_offset --dir "$work"
cd "$work/probe_offset"
{
  cmake -B build
  grep "TEdit_DIR:PATH=$work/prefix/lib/cmake/TEdit" build/CMakeCache.txt
  cmake --build build -j2
  ctest --test-dir build --output-on-failure --no-tests=error
  ctest --test-dir build -N | grep "conformance.probe_offset"
  ctest --test-dir build -N | grep "ProbeOffset.MovingTheEnd"
} >"$work/log" 2>&1 || { tail -40 "$work/log" >&2; exit 1; }
if grep -q "$build" build/build.ninja build/Makefile 2>/dev/null; then
  echo "the plugin was built against the build tree, not the installation" >&2
  exit 1
fi
cmake --install build --prefix "$HOME/.local" >/dev/null
"$tedit" ops probe_offset | grep -q "^probe_offset 0.1.0 "
"$tedit" edit "$source/tests/data/parts/holes_block/holes_block.coarse.msh" --op probe_offset --surfaces 1 --json >/dev/null ||
  [ $? = 1 ] # made, or refused by the host with a reason
echo "installed, moved, a plugin made, built, tested and used"
