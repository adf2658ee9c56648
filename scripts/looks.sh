#!/usr/bin/env bash
# Pictures of the whole window in its states, to be looked at one by one.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TEXT
usage: scripts/looks.sh OUT [VARIANT...]

Opens the shipped plate in build/release/bin/tedit-qt, goes through the states of
tests/data/looks/steps.json and writes a picture of each to OUT/VARIANT/.

VARIANT is SIZE-LOOK-LANGUAGE: SIZE one of 1280x720, 1600x1000, 4k (3840x2160 at twice
the size), LOOK light or dark, LANGUAGE en or de. Without one: all twelve.

examples:
  scripts/looks.sh /tmp/looks
  scripts/looks.sh /tmp/looks 1280x720-light-de
TEXT
}

case "${1:-}" in
  "" | --help | -h) usage; exit $([ $# -gt 0 ] && echo 0 || echo 2) ;;
esac
out=$(realpath -m "$1")
shift
variants=("$@")
if [ $# -eq 0 ]; then
  for size in 1280x720 1600x1000 4k; do
    for look in light dark; do
      for language in en de; do variants+=("$size-$look-$language"); done
    done
  done
fi

client=build/release/bin/tedit-qt
plate=examples/ctc01_plate
[ -x "$client" ] || { echo "$client is not there: scripts/build.sh release" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for variant in "${variants[@]}"; do
  IFS=- read -r size look language <<<"$variant"
  factor=1
  [ "$size" = 4k ] && { size=1920x1080; factor=2; }
  to="$out/$variant"
  mkdir -p "$to"
  sed "s|OUT/|$to/|" tests/data/looks/steps.json >"$work/steps.json"
  options=(--size "$size" --language "$language")
  [ "$look" = dark ] && options+=(--dark)
  QT_SCALE_FACTOR=$factor XDG_CONFIG_HOME="$work/config-$variant" \
    "$client" "${options[@]}" --state "$work/state-$variant" --open "$plate/ctc01_plate.coarse.msh" \
    --load-case "$plate/load_case.json" --script "$work/steps.json"
  printf '[{"screenshot": "%s/00-start-page.png", "window": true}]' "$to" >"$work/start.json"
  QT_SCALE_FACTOR=$factor XDG_CONFIG_HOME="$work/config-$variant" "$client" "${options[@]}" --state "$work/state-$variant" \
    --script "$work/start.json"
  echo "$variant: $(find "$to" -name '*.png' | wc -l) pictures in $to"
done
