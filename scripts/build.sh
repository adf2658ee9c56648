#!/usr/bin/env bash
# Configures and builds one preset. usage: scripts/build.sh PRESET [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
build="build/$preset"
[ "$preset" = ci ] && build=build/release
log="$build/configure.log"
mkdir -p "$build"
if ! cmake --preset "$preset" >"$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "configuring failed; the whole log is $log" >&2
  exit 1
fi
targets=()
[ $# -gt 0 ] && targets=(--target "$@")
cmake --build "$build" "${targets[@]}"
