#!/usr/bin/env bash
# The checks that need no test run: include rules, the page made from the protocol, format, file sizes, and clang-tidy on changed files.
# usage: scripts/check.sh [--fix] [--tidy] [--tidy-all]
#   --fix       formats instead of complaining
#   --tidy      also runs clang-tidy on the C++ files that differ from the last commit (or from $TEDIT_TIDY_BASE)
#   --tidy-all  also runs it on all sources but the tests, without the analyzer (scripts/tidy_all.py, which takes rooms)
set -euo pipefail
cd "$(dirname "$0")/.."

fix=no
tidy=no
for option in "$@"; do
  case "$option" in
    --fix) fix=yes ;;
    --tidy) tidy=changed ;;
    --tidy-all) tidy=all ;;
    --help | -h) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    *) echo "unknown option $option (see --help)" >&2; exit 2 ;;
  esac
done

python3 scripts/check_includes.py
python3 scripts/protocol_reference.py --check

mapfile -t sources < <(git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' | grep -v '^tests/data/')
if [ "$fix" = yes ]; then
  clang-format -i "${sources[@]}"
else
  clang-format --dry-run --Werror "${sources[@]}"
fi

long=$(git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' '*.comp' '*.glsl' '*.h' '*.py' '*.sh' '*.cmake' '*.proto' 'clients/*.ts' '*.mjs' |
  xargs wc -l | awk '$1 > 500 && $2 != "total"')
if [ -n "$long" ]; then
  echo "files over 500 lines:" >&2
  echo "$long" >&2
  exit 1
fi

if [ "$tidy" = changed ]; then
  base=${TEDIT_TIDY_BASE:-HEAD}
  mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' | grep -v '^tests/' || true)
  if [ ${#changed[@]} -gt 0 ]; then
    clang-tidy-16 --quiet -p build/release "${changed[@]}"
  fi
elif [ "$tidy" = all ]; then
  scripts/tidy_all.py
fi
echo "checks passed: ${#sources[@]} files"
