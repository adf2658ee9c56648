#!/usr/bin/env bash
# usage: desktop_unattended_test.sh BIN EXAMPLES: tedit-qt helps and makes a picture on a machine without a display,
# says why it cannot open a window or why a script failed, and stays open when what a person asked for fails.
set -euo pipefail
bin=$1
plate=$2/ctc01_plate
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
export XDG_CONFIG_HOME="$folder/config" XDG_RUNTIME_DIR="$folder"

"$bin/tedit-qt" --help | grep -q -e '--screenshot'
"$bin/tedit-qt" --version | grep -q '^tedit-qt [0-9]'
status=0
"$bin/tedit-qt" 2>"$folder/said" || status=$?
[ "$status" -eq 69 ] || { echo "without a display it ended with $status" >&2; cat "$folder/said" >&2; exit 1; }
grep -q 'no display' "$folder/said"
status=0
QT_QPA_PLATFORM=offscreen "$bin/tedit-qt" 2>"$folder/said" || status=$?
[ "$status" -eq 69 ] || { echo "without OpenGL it ended with $status" >&2; cat "$folder/said" >&2; exit 1; }
grep -q 'no OpenGL 3.2' "$folder/said"

"$bin/tedit-qt" --state "$folder/state" --size 800x600 --open "$plate/ctc01_plate.coarse.msh" \
  --load-case "$plate/load_case.json" --screenshot "$folder/plate.png" --report "$folder/report.json"
# What fails while a person works is said in the window, which stays.
Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp 3>"$folder/display" 2>/dev/null &
screen=$!
trap 'kill "$screen" 2>/dev/null || true; rm -rf "$folder"' EXIT
until [ -s "$folder/display" ]; do sleep 0.1; done
status=0
DISPLAY=":$(cat "$folder/display")" timeout 12 "$bin/tedit-qt" --state "$folder/alone" --open /nowhere.msh 2>"$folder/said" || status=$?
[ "$status" -eq 124 ] || { echo "a mesh that is not there ended the window with $status" >&2; cat "$folder/said" >&2; exit 1; }

size=$(stat -c %s "$folder/plate.png")
[ "$size" -gt 20000 ] || { echo "the picture has only $size bytes" >&2; exit 1; }
grep -q '"wait_p99_ms"' "$folder/report.json"

echo '[{"select": [98]}, {"apply": "erode", "parameters": {"depth": 0.5}}, {"wait": "ready"}]' >"$folder/steps.json"
status=0
"$bin/tedit-qt" --state "$folder/state" --open "$plate/ctc01_plate.coarse.msh" --script "$folder/steps.json" \
  2>"$folder/said" || status=$?
[ "$status" -eq 1 ] || { echo "a refused edit ended with $status" >&2; cat "$folder/said" >&2; exit 1; }
grep -q '^tedit-qt: ' "$folder/said"
grep -q 'step 2 (apply): ' "$folder/said"

# What cannot be read never opens a window.
echo '{"steps": [{"select": [98]}, {"selct": [98]}]}' >"$folder/steps.json"
status=0
"$bin/tedit-qt" --state "$folder/state" --script "$folder/steps.json" 2>"$folder/said" || status=$?
[ "$status" -eq 65 ] || { echo "a misspelt step ended with $status" >&2; cat "$folder/said" >&2; exit 1; }
grep -q 'step 2: there is no step "selct"' "$folder/said"
