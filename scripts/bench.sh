#!/usr/bin/env bash
# Everything that is measured beside others: cold solves of the same equations (bench/compare.py), then one product beside
# a copy (bench_spmv). Needs the packages of bench/README.md and a quiet machine; what was measured is kept.
# usage: scripts/bench.sh [options of bench/compare.py]
set -euo pipefail
shopt -s nullglob
cd "$(dirname "$0")/.."

case "${1:-}" in
  --help | -h) sed -n '2,4s/^# //p' "$0"; exec bench/compare.py --help ;;
esac

cmake --preset release -DTEDIT_BENCH_PEERS=ON >/dev/null
targets=(bench_solve bench_spmv tedit)
for peer in petsc cholmod eigen; do
  if ninja -C build/release -t query "peer_$peer" >/dev/null 2>&1; then
    targets+=("peer_$peer")
  fi
done
cmake --build build/release --target "${targets[@]}"

status=0
bench/compare.py "$@" || status=$?
work=build/release/peers
: >"$work/spmv.jsonl"
for mesh in "$work"/meshes/cantilever-*.msh; do
  for how in "--order 1" "--order 1 --cores 1" "--order 2" "--order 2 --cores 1" "--order 1 --device lavapipe" "--order 2 --device lavapipe"; do
    # $how is several words on purpose.
    build/release/bin/bench_spmv "$mesh" bench/peers/cantilever.json $how | tee -a "$work/spmv.jsonl"
  done
done
echo "figures: $work/comparison.md, $work/comparison.json, $work/spmv.jsonl"
exit "$status"
