#!/usr/bin/env bash
# Runs those checks of the conformance kit that could depend on how busy the machine is, again and again on every shipped
# plugin, while all processors are busy with other things: correct plugins must never fail.
# usage: kit_under_load_test.sh BUILD [RUNS] [PLUGIN...]      (RUNS of each check and plugin, default 3; by hand 500)
# $BUSY: how many processes keep the processors busy, twice the processors without it.
set -euo pipefail
build=$1
runs=${2:-3}
shift $(($# < 2 ? $# : 2))
checks=cancelled_at_start,cancelled_anywhere,polls_often,progress,two_at_once,thread_count,no_handles
unset TEDIT_LIBEXEC TEDIT_PLUGIN_PATH

busy=()
for _ in $(seq "${BUSY:-$((2 * $(nproc)))}"); do
  (exec sha256sum /dev/zero) &
  busy+=($!)
done
trap '[ ${#busy[@]} = 0 ] || kill "${busy[@]}" 2>/dev/null' EXIT

# The commands of the tests conformance.PLUGIN, which give some plugins a part to work on.
mapfile -t commands < <(ctest --test-dir "$build" -N -V -R '^conformance\.' | sed -nE 's/^[0-9]+: Test command: //p')
[ ${#commands[@]} -gt 0 ] || { echo "there are no plugins in $build" >&2; exit 1; }
failed=0
for command in "${commands[@]}"; do
  plugin=$(sed -E 's|.*/(\w+)\.so".*|\1|' <<<"$command")
  [ $# = 0 ] || grep -qw "$plugin" <<<"$*" || continue
  started=$SECONDS
  said=$(eval "$command --check $checks --repeat $runs --limit 120") || failed=$((failed + 1))
  grep '^FAIL' <<<"$said" >&2 || true
  echo "$plugin: $runs runs of each of $(tr ',' '\n' <<<"$checks" | wc -l) checks in $((SECONDS - started)) s: $(tail -1 <<<"$said")"
done
[ "$failed" = 0 ] || { echo "$failed plugins failed" >&2; exit 1; }
