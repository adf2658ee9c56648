#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job on a shipped real part.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TEXT
usage: scripts/run.sh [options]

Installs missing Debian packages, builds the release preset, starts a server with its
worker processes and, as a client over WebSocket, opens the NIST plate
(examples/ctc01_plate), solves its load case, closes two drill holes, sees the new field
arrive after each, takes the second back, and prints a table. Fields (VTU) and pictures
(PNG) are left in out/. The server ends with the job. The first time, what the job needs
is built and the job is run; then the rest of the program is built. Safe to repeat: a
second run starts within seconds.

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

[ "$install" = yes ] && scripts/install_deps.sh --no-web
first=no
[ -x build/release/bin/tedit ] || first=yes
scripts/build.sh release tedit-main-job

# A server of its own, on a free port, whose documents and token go with it.
folder=$(mktemp -d)
build/release/bin/tedit serve --port 0 --documents "$folder/documents" --token-file "$folder/token" \
  --ready-file "$folder/ready" >"$folder/log" 2>&1 &
server=$!
stop() {
  kill "$server" 2>/dev/null || true
  wait "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap stop EXIT
for _ in $(seq 200); do
  [ -s "$folder/ready" ] && break
  kill -0 "$server" 2>/dev/null || { cat "$folder/log" >&2; exit 1; }
  sleep 0.05
done
[ -s "$folder/ready" ] || { echo "the server did not start:" >&2; cat "$folder/log" >&2; exit 1; }
url=$(sed 's/.*"url":"\([^"]*\)".*/\1/' "$folder/ready")

echo "server at $url, worker processes: $(cat /proc/"$server"/task/*/children 2>/dev/null | tr -s "\n " " ")"
build/release/bin/tedit run examples/ctc01_plate/recipe.json --out "$out" --device "$device" \
  --server "$url" --token-file "$folder/token" || { cat "$folder/log" >&2; exit 1; }

stop
trap - EXIT
if [ "$first" = yes ]; then
  echo
  echo "That was the main job. Now the rest is built (the other operations, CAD files, scans); Ctrl-C leaves it for later."
fi
scripts/build.sh release tedit-programs

if [ "$smoke" = yes ]; then
  for file in plate_v0.vtu plate_v0.png plate_v1.vtu plate_v1.png plate_v2.vtu plate_v2.msh; do
    [ -s "$out/$file" ] || { echo "missing: $out/$file" >&2; exit 1; }
  done
  echo "smoke test passed"
fi
