#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
# fuzz.sh SECONDS [TARGET...]: runs each libFuzzer target (or those named) for so long, one after the other, on one
# processor with low priority. New inputs go to build/fuzz/corpora/TARGET, what broke a promise to
# build/fuzz/crashes/TARGET-*, and what a run said to build/fuzz/logs. Exit status 1 when something broke.
# tests/fuzz/README.md says what to do then.
set -euo pipefail
cd "$(dirname "$0")/.."

all=(basp handshake certs config users wire gateway recipe surface dxf load_case msh)
usage() {
  echo "usage: scripts/fuzz.sh SECONDS [TARGET...]; targets: ${all[*]}" >&2
  exit 2
}
[[ ${1:-} =~ ^[1-9][0-9]{0,5}$ ]] || usage
seconds=$1
shift
targets=("${@:-${all[@]}}")
for target in "${targets[@]}"; do
  [[ " ${all[*]} " == *" $target "* ]] || usage
done

# Beyond these an input is slow or large for its target: bytes, seconds, MiB.
limits() {
  case $1 in
    gateway) echo "-max_len=4096 -timeout=20 -rss_limit_mb=4096" ;;
    load_case) echo "-max_len=4096 -timeout=60 -rss_limit_mb=4096" ;;
    msh) echo "-max_len=65536 -timeout=5 -rss_limit_mb=1024" ;;
    *) echo "-max_len=4096 -timeout=10 -rss_limit_mb=2048" ;;
  esac
}

[[ -f build/fuzz/build.ninja ]] || cmake --preset fuzz
cmake --build build/fuzz --target "${targets[@]/%/_fuzz}"
mkdir -p build/fuzz/crashes build/fuzz/logs
broken=0
for target in "${targets[@]}"; do
  kept=tests/fuzz/${target}_corpus
  [[ $target == msh ]] && kept="tests/fuzz/corpus tests/data/bad"
  mkdir -p "build/fuzz/corpora/$target"
  log=build/fuzz/logs/$target.log
  # shellcheck disable=SC2046,SC2086  # Several options and folders each.
  if nice -n 10 build/fuzz/bin/"${target}_fuzz" $(limits "$target") -max_total_time="$seconds" -print_final_stats=1 \
    -artifact_prefix="build/fuzz/crashes/$target-" "build/fuzz/corpora/$target" $kept >"$log" 2>&1; then
    echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs, nothing broke"
  else
    echo "$target: BROKE; see $log" >&2
    grep -m 3 -E 'broken promise|ERROR|runtime error|SUMMARY' "$log" >&2 || tail -3 "$log" >&2
    broken=1
  fi
done
exit $broken
