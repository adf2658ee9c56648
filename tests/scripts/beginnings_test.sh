#!/usr/bin/env bash
# Walks the two beginnings of docs/plugins.md from a clean copy of the tree, with what scripts/run.sh builds and nothing
# else: installed, and from the build tree. The commands are those of the manual, steps 1 to 3.
# usage: beginnings_test.sh BUILD     (a build of the same tree: what run.sh would build is taken from there)
set -euo pipefail
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset TEDIT_LIBEXEC TEDIT_PLUGIN_PATH XDG_DATA_HOME XDG_CONFIG_HOME TEdit_DIR
export HOME=$work/home XDG_CACHE_HOME=$work/cache CMAKE_BUILD_PARALLEL_LEVEL=2
mkdir -p "$HOME" "$work/tree"

git -C "$source" rev-parse --git-dir >/dev/null 2>&1 || { echo "skipped: this tree is no git repository"; exit 77; }
(cd "$source" && git ls-files -z --cached --others --exclude-standard | tar -c --null --ignore-failed-read -T - 2>/dev/null) |
  tar -x -C "$work/tree"

# What scripts/run.sh builds.
cd "$work/tree"
read -r preset target <<<"$(sed -nE 's|^scripts/build.sh (\w+) ([a-z-]+)$|\1 \2|p' scripts/run.sh | tail -1)"
[ -n "$target" ] || { echo "scripts/run.sh does not say what it builds" >&2; exit 1; }
cmake --preset "$preset" >"$work/log" 2>&1 || { tail -20 "$work/log" >&2; exit 1; }
cd "build/$preset"
while read -r file; do
  mkdir -p "$(dirname "$file")"
  [ ! -f "$build/$file" ] || cp "$build/$file" "$file"
done < <(ninja -t commands "$target" | grep -oE '(-o|ar qc) (bin/|[^ ]+\.(so|a)\b)[^ ]*' | sed -E 's/^(-o|ar qc) //' | sort -u)
[ -x bin/tedit ] && [ -e lib/tedit/plugins/fill_hole.so ] || { echo "nothing was built in $build" >&2; exit 1; }
cd "$work/tree"

# The commands between two steps of the manual: lines of sh blocks, lines with a prompt of console blocks.
commands() {
  sed -n "/^\*\*$1\. /,/^\*\*$2\. /p" docs/plugins.md |
    awk '/^```/ { kind = inside ? "" : substr($0, 4); inside = !inside; next }
         inside && kind == "sh" { print }
         inside && kind == "console" && sub(/^\$ /, "") { print }'
}
walk() {
  bash -euo pipefail -c "$1" >"$work/log" 2>&1 || { echo "the beginning \"$2\" fails:" >&2; tail -40 "$work/log" >&2; exit 1; }
  grep -q "100% tests passed" "$work/log" && grep -q "conformance.offset" "$work/log" ||
    { echo "the beginning \"$2\" tested nothing" >&2; exit 1; }
}

install=$(commands 1 2)
make_and_test=$(commands 2 4)
grep -q "cmake --install" <<<"$install" && grep -q "tedit plugin new" <<<"$make_and_test" && grep -q ctest <<<"$make_and_test" ||
  { echo "docs/plugins.md has no commands where they are looked for" >&2; exit 1; }

walk "$install
test -x ~/tedit/bin/tedit
mkdir -p ~/installed
cd ~/installed
$make_and_test" "installed"

# From the build tree; with the warnings that a careful author turns on.
export CXXFLAGS="-Wall -Wextra -Werror"
walk "export PATH=\$PWD/build/$preset/bin:\$PATH
mkdir -p ~/from_build
cd ~/from_build
$make_and_test" "from the build tree"
echo "both beginnings of docs/plugins.md lead to a tested plugin"
