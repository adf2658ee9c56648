#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job on a shipped real part.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TEXT
usage: scripts/run.sh [options]

Installs missing Debian packages, builds the release preset, then opens the NIST plate
(examples/ctc01_plate), solves its load case, closes two drill holes with the field
solved again after each, takes the second back, and prints a table. Fields (VTU) and
pictures (PNG) are left in out/. Safe to repeat: a second run starts within seconds.

  --device NAME   cpu, auto or part of a device's name (default: auto)
  --out DIR       where fields and pictures go (default: out)
  --smoke         the same job, then check that every file is there
  --no-install    do not install packages
  --help          this text
TEXT
}

device=auto
out=out
smoke=no
install=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --device) device=${2:?--device needs a name}; shift 2 ;;
    --out) out=${2:?--out needs a folder}; shift 2 ;;
    --smoke) smoke=yes; shift ;;
    --no-install) install=no; shift ;;
    --help | -h) usage; exit 0 ;;
    *) echo "unknown option $1 (see --help)" >&2; exit 2 ;;
  esac
done

[ "$install" = yes ] && scripts/install_deps.sh
scripts/build.sh release tedit
build/release/bin/tedit run examples/ctc01_plate/recipe.json --out "$out" --device "$device"

if [ "$smoke" = yes ]; then
  for file in plate_v0.vtu plate_v0.png plate_v1.vtu plate_v1.png plate_v2.vtu plate_v2.msh; do
    [ -s "$out/$file" ] || { echo "missing: $out/$file" >&2; exit 1; }
  done
  echo "smoke test passed"
fi
