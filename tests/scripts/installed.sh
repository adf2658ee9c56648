# For scripts that use an installation as a stranger does: a home of their own, the build BUILD installed and moved to
# $work/prefix (its shared files: $shared), and the example of that name built against it into $work/made.
# usage: . installed.sh; use_home WORK; build_example BUILD EXAMPLE PROGRAM

use_home() {
  work=$1
  unset TEDIT_LIBEXEC TEDIT_PLUGIN_PATH XDG_DATA_HOME XDG_CONFIG_HOME
  export HOME=$work/home XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state
}

build_example() {
  local build=$1 example=$2 program=$3
  cmake --install "$build" --prefix "$work/first" >"$work/log" || { tail -20 "$work/log" >&2; exit 1; }
  mv "$work/first" "$work/prefix"
  shared=$work/prefix/share/tedit
  {
    cmake -S "$shared/examples/$example" -B "$work/made" -DTEdit_DIR="$work/prefix/lib/cmake/TEdit"
    cmake --build "$work/made"
  } >"$work/log" 2>&1 || { tail -40 "$work/log" >&2; exit 1; }
  if grep -rq "$build" "$work/made/CMakeFiles/$program.dir"; then
    echo "the example was built against the build tree, not the installation" >&2
    exit 1
  fi
}
