#!/usr/bin/env bash
# Pictures of the whole window in its states, to be looked at one by one and kept.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TEXT
usage: scripts/looks.sh OUT [VARIANT...] [--check | --keep]

Opens the shipped plate in build/release/bin/tedit-qt, goes through the states of
tests/data/looks/steps.json and writes a picture of each to OUT/VARIANT/.

VARIANT is SIZE-LOOK-LANGUAGE: SIZE one of 1280x720, 1600x1000, 4k (3840x2160 at twice
the size), LOOK light or dark, LANGUAGE en or de. Without one: all twelve; with
--check or --keep those of which pictures are kept.

  --check   says which pictures do not look like those that are kept in
            tests/data/looks/VARIANT; status 1 when there are any
  --keep    keeps them there, once each was looked at

examples:
  scripts/looks.sh /tmp/looks
  scripts/looks.sh /tmp/looks 1280x720-light-de --check
TEXT
}

out=
after=
variants=()
for word in "$@"; do
  case "$word" in
    --help | -h) usage; exit 0 ;;
    --check | --keep) after=$word ;;
    -*) echo "unknown option $word (see --help)" >&2; exit 2 ;;
    *) if [ -z "$out" ]; then out=$(realpath -m "$word"); else variants+=("$word"); fi ;;
  esac
done
[ -n "$out" ] || { usage >&2; exit 2; }
all=()
for size in 1280x720 1600x1000 4k; do
  for look in light dark; do
    for language in en de; do all+=("$size-$look-$language"); done
  done
done
kept=(tests/data/looks/*/)
kept=("${kept[@]%/}")
if [ ${#variants[@]} = 0 ]; then
  variants=("${all[@]}")
  [ -z "$after" ] || variants=("${kept[@]##*/}")
fi
for variant in "${variants[@]}"; do
  [[ " ${all[*]} " == *" $variant "* ]] || { echo "$variant is no variant; there are: ${all[*]}" >&2; exit 2; }
done

client=build/release/bin/tedit-qt
compare=build/release/bin/looks_compare
plate=examples/ctc01_plate
[ -x "$client" ] || { echo "$client is not there: scripts/build.sh release" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Goes through the states in one variant.
take() {
  local variant=$1 to="$out/$1" factor=1 size look language options
  IFS=- read -r size look language <<<"$variant"
  [ "$size" = 4k ] && { size=1920x1080; factor=2; }
  rm -rf "$to"
  mkdir -p "$to"
  sed "s|OUT/|$to/|" tests/data/looks/steps.json >"$work/steps.json"
  printf '[{"screenshot": "%s/00-start-page.png", "window": true}]' "$to" >"$work/start.json"
  options=(--size "$size" --language "$language" --state "$work/state-$variant")
  [ "$look" = dark ] && options+=(--dark)
  export QT_SCALE_FACTOR=$factor XDG_CONFIG_HOME="$work/config-$variant"
  "$client" "${options[@]}" --open "$plate/ctc01_plate.coarse.msh" --load-case "$plate/load_case.json" \
    --script "$work/steps.json"
  "$client" "${options[@]}" --script "$work/start.json"
  echo "$variant: $(find "$to" -name '*.png' | wc -l) pictures in $to"
}

status=0
for variant in "${variants[@]}"; do
  take "$variant"
  if [ "$after" = --keep ]; then
    "$compare" --keep "tests/data/looks/$variant" "$out/$variant"
  elif [ "$after" = --check ]; then
    "$compare" "tests/data/looks/$variant" "$out/$variant" || status=1
  fi
done
exit $status
