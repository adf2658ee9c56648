#!/usr/bin/env bash
# Asks the completion of bash as the shell does.
# usage: completion_test.sh BIN SOURCE
set -euo pipefail
bin=$1 source=$2
PATH=$bin:$PATH
compopt() { :; } # Only while the shell completes.
source "$source/cli/completion.bash"

# complete_line WORD ... LAST: what would be offered for LAST.
complete_line() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
  _tedit "$1" "${@: -1}" "${@: -2:1}"
  printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' '
}
expect() {
  local wanted=$1 got
  shift
  got=$(complete_line "$@")
  [ "$got" = "$wanted" ] || { echo "after '$*': '$got' instead of '$wanted'" >&2; exit 1; }
}

expect "edit export " tedit e
expect "--json " tedit --j
expect "--load-case --loads " tedit edit a.msh --loa
expect "fill_hole " tedit edit a.msh --op fill
expect "depth= depth_mm= " tedit edit a.msh --op erode --param dep
expect "--mesh " tedit run recipe.json --me
expect "drop move refuse " tedit edit a.msh --loads ""
expect "move " tedit edit a.msh --loads m
expect "lavapipe " tedit solve a.msh --device l
expect "new test " tedit plugin ""
expect "check copy export gc list loads " tedit doc ""
expect "init issue list renew revoke " tedit certs ""
expect "--drop-unreachable --dry-run " tedit doc gc part.tedit --dr
cd "$source/examples/ctc01_plate"
expect "load_case.json load_case_sideways.json " tedit solve ctc01_plate.coarse.msh --load-case load
expect "ctc01_plate.coarse.msh " tedit info ctc01_plate.co
if [ -x "$bin/tedit-qt" ]; then
  expect "--screenshot --script " tedit-qt --scr
  expect "load_case_sideways.json " tedit-qt --load-case load_case_
fi
