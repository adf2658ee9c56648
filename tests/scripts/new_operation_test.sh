#!/usr/bin/env bash
# What scripts/new_operation.sh makes and what it refuses; builds nothing.
set -uo pipefail
script=$(cd "$(dirname "$0")/../.." && pwd)/scripts/new_operation.sh
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/ops/sdk"
faults=0

check() {  # check CLAIM COMMAND...
  local claim=$1
  shift
  if ! "$@"; then
    echo "failed: $claim" >&2
    faults=$((faults + 1))
  fi
}

status_is() {  # status_is STATUS ARGUMENT...
  local wanted=$1 got=0
  shift
  "$script" "$@" >"$copy/out" 2>"$copy/err" || got=$?
  [ "$got" = "$wanted" ] || { echo "status $got, not $wanted: $*" >&2; cat "$copy/err" >&2; return 1; }
}

says() { grep -q -- "$1" "$copy/err"; }
no_placeholder() { ! grep -rn '@[A-Z]*@' "$copy/ops"; }
only() { [ "$(cd "$copy/ops" && find . -type f | sort | tr '\n' ' ')" = "$1" ]; }

files="./my_op/CMakeLists.txt ./my_op/README.md ./my_op/operation.cpp ./my_op/tests/my_op_test.cpp "
check "a new operation is made" status_is 0 my_op --root "$copy"
check "it has these files and no other" only "$files"
check "no placeholder is left" no_placeholder
check "CMake knows it by its name" grep -q "NAME my_op$" "$copy/ops/my_op/CMakeLists.txt"
check "the plugin has its name" grep -q 'TEDIT_PLUGIN("my_op", ' "$copy/ops/my_op/operation.cpp"
check "people read a title" grep -q '"My op"' "$copy/ops/my_op/operation.cpp"
check "the test suite has its name" grep -q 'TEST(MyOp, ' "$copy/ops/my_op/tests/my_op_test.cpp"

echo mine >>"$copy/ops/my_op/operation.cpp"
check "a second run is refused" status_is 1 my_op --root "$copy"
check "and says why" says "already"
check "and leaves the file alone" grep -q '^mine$' "$copy/ops/my_op/operation.cpp"
check "a room is no free name" status_is 1 sdk --root "$copy"

check "a name is needed" status_is 2 --root "$copy"
check "one name is enough" status_is 2 one two --root "$copy"
long=$(printf 'a%.0s' {1..41})
for name in MyOp my-op 1op my__op _op op_ ../op "my op" é "" "$long"; do
  check "\"$name\" is refused" status_is 2 "$name" --root "$copy"
done
check "an unknown option is refused" status_is 2 my_op --force
check "and is named" says "--force"
check "--root needs a folder" status_is 2 my_op --root
check "that holds a tree" status_is 2 my_op --root "$copy/nowhere"
check "help is there" status_is 0 --help
check "and shows the usage" grep -q "usage: scripts/new_operation.sh NAME" "$copy/out"
check "refusals leave nothing behind" only "$files"

if command -v clang-format >/dev/null; then
  cp "$(dirname "$script")/../.clang-format" "$copy/"
  long=$(printf 'a%.0s' {1..40})
  check "the longest name is taken" status_is 0 "$long" --root "$copy"
  mapfile -t made < <(find "$copy/ops" -name '*.cpp' -not -path '*/my_op/operation.cpp')
  check "generated code is formatted" clang-format --dry-run --Werror "${made[@]}"
fi

[ "$faults" = 0 ] || { echo "$faults claims failed" >&2; exit 1; }
echo "new_operation.sh: all claims hold"
