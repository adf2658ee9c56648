#!/usr/bin/env bash
# Makes the folder of a new editing operation from scripts/templates/operation.
set -euo pipefail
templates=$(cd "$(dirname "$0")" && pwd)/templates/operation
root=$(cd "$(dirname "$0")/.." && pwd)

usage() {
  cat <<TEXT
usage: scripts/new_operation.sh NAME [options]

Makes ops/NAME/ with CMakeLists.txt, operation.cpp, README.md and tests/NAME_test.cpp: a
small operation that works (it moves a surface along its mean normal) and its test, to be
changed into yours. CMake finds the folder by itself. NAME is the operation's id and the
plugin's file name: snake_case, at most 40 characters, for example offset_surface.

  --root DIR   make the folder in another copy of the tree (default: this one)
  --help       this text

Exit status: 0 made, 1 the name is taken or the folder cannot be written, 2 usage.

example:
  scripts/new_operation.sh offset_surface
  scripts/build.sh release op_offset_surface_tests tedit_op_offset_surface
  ctest --test-dir build/release -L op_offset_surface --output-on-failure
TEXT
}

misuse() {
  echo "new_operation.sh: $1 (see --help)" >&2
  exit 2
}

refuse() {
  echo "new_operation.sh: $1" >&2
  exit 1
}

name=
while [ $# -gt 0 ]; do
  case "$1" in
    --root)
      [ $# -ge 2 ] || misuse "--root needs a folder"
      root=$2
      shift 2
      ;;
    --help | -h) usage; exit 0 ;;
    -*) misuse "unknown option $1" ;;
    *)
      [ -z "$name" ] || misuse "one name only: \"$name\" and \"$1\" were given"
      [ -n "$1" ] || misuse "the name is empty"
      name=$1
      shift
      ;;
  esac
done

export LC_ALL=C  # [a-z] must not take in letters of other languages
[ -n "$name" ] || misuse "NAME is missing"
[[ $name =~ ^[a-z][a-z0-9]*(_[a-z0-9]+)*$ ]] ||
  misuse "\"$name\" is not snake_case: small letters, digits and single underscores, a letter first"
[ ${#name} -le 40 ] || misuse "\"$name\" has ${#name} characters; at most 40"
[ -d "$root/ops" ] || misuse "$root is no copy of the tree: it has no folder ops"

target=$root/ops/$name
if [ -f "$target/operation.cpp" ]; then
  refuse "there is an operation $name already: $target; choose another name"
elif [ -e "$target" ] || [ -L "$target" ]; then
  refuse "the name $name is taken by $target; choose another name"
fi

title=${name//_/ }
title=${title^}  # "fill_hole" becomes "Fill hole"
suite=
for word in ${name//_/ }; do
  suite+=${word^}  # and "FillHole"
done

# mkdir fails when somebody else makes the same folder meanwhile; what is half made is taken back.
mkdir "$target" || refuse "cannot make $target"
trap 'rm -rf "$target"' EXIT
mkdir "$target/tests"
generate() {
  sed -e "s/@NAME@/$name/g" -e "s/@TITLE@/$title/g" -e "s/@SUITE@/$suite/g" \
    "$templates/$1" >"$target/$2"
}
generate CMakeLists.txt.in CMakeLists.txt
generate operation.cpp.in operation.cpp
generate README.md.in README.md
generate operation_test.cpp.in "tests/${name}_test.cpp"
trap - EXIT

cat <<TEXT
made ops/$name
  operation.cpp          what the operation is called, takes and does: change this
  tests/${name}_test.cpp
                         numbers that can be checked by hand: change them with it
  README.md              what it does, its parameters and its limits
build and test it:
  scripts/build.sh release op_${name}_tests tedit_op_$name
  ctest --test-dir build/release -L op_$name --output-on-failure
TEXT
