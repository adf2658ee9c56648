#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TEXT
usage: scripts/test.sh [options] [-- ctest options]

Installs missing Debian packages, checks the sources, builds the release preset with
warnings as errors, and runs every test. Safe to repeat.

  --preset NAME   build and test another preset: dev, asan, tsan (default: release)
  --no-install    do not install packages
  --no-checks     skip format and include checks
  --help          this text

examples:
  scripts/test.sh
  scripts/test.sh --preset asan
  scripts/test.sh -- -L fem --output-on-failure
TEXT
}

preset=ci
install=yes
checks=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --preset) preset=${2:?--preset needs a name}; shift 2 ;;
    --no-install) install=no; shift ;;
    --no-checks) checks=no; shift ;;
    --help | -h) usage; exit 0 ;;
    --) shift; break ;;
    *) echo "unknown option $1 (see --help)" >&2; exit 2 ;;
  esac
done
[ "$preset" = release ] && preset=ci

started=$SECONDS
[ "$install" = yes ] && scripts/install_deps.sh
[ "$checks" = yes ] && scripts/check.sh
scripts/build.sh "$preset"
built=$SECONDS
build="build/$preset"
[ "$preset" = ci ] && build=build/release
export TEDIT_VULKAN_VALIDATION=1
if [ "$preset" = tsan ]; then
  scripts/build_caf_tsan.sh
  export LD_LIBRARY_PATH="$PWD/build/caf-tsan/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
  export TSAN_OPTIONS="suppressions=$PWD/tests/support/tsan.supp history_size=4 ${TSAN_OPTIONS:-}"
elif [ "$preset" = asan ]; then
  export LSAN_OPTIONS="suppressions=$PWD/tests/support/lsan.supp ${LSAN_OPTIONS:-}"
fi
# One more than processors: many a test mostly waits.
ctest --test-dir "$build" --output-on-failure -j$(($(nproc) + 1)) "$@"
echo "install, checks and build $((built - started)) s, tests $((SECONDS - built)) s"
