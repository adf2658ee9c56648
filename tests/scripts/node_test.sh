#!/usr/bin/env bash
# Installs a build, builds the example nodes against it, and has them join the installed server: CalculiX solves as a
# device, and an observer hears of all that a client does.
# usage: node_test.sh BUILD. Without CalculiX (package calculix-ccx) it is skipped.
set -euo pipefail
build=$1
command -v ccx >/dev/null || { echo "calculix-ccx is not installed"; exit 77; }
work=$(mktemp -d)
pids=()
trap 'for one in "${pids[@]}"; do kill "$one" 2>/dev/null || true; done; wait; rm -rf "$work"' EXIT
. "$(dirname "$0")/installed.sh"
use_home "$work"
build_example "$build" node observer
for example in calculix_solver observer; do
  test "$(wc -l <"$shared/examples/node/$example.cpp")" -le 100
done

tedit=$work/prefix/bin/tedit
wait_for() { # wait_for FILE PATTERN
  for _ in $(seq 600); do
    grep -q "$2" "$1" && return
    sleep 0.1
  done
  echo "\"$2\" did not come:" >&2
  cat "$1" >&2
  exit 1
}

"$tedit" --quiet certs init "$work/ca" >"$work/log"
"$tedit" --quiet certs issue "$work/ca" --role server --name hall --host 127.0.0.1 -o "$work/hall" >"$work/log"
"$tedit" --quiet certs issue "$work/ca" --role solver --name ccx -o "$work/ccx" >"$work/log"
"$tedit" --quiet certs issue "$work/ca" --role observer --name eye -o "$work/eye" >"$work/log"
"$tedit" serve --port 0 --documents "$work/documents" --node-certificates "$work/hall" --node-port 0 \
  --ready-file "$work/ready" >"$work/server" 2>&1 &
pids+=($!)
touch "$work/ready"
wait_for "$work/ready" '"url"'
url=$(sed 's/.*"url":"\([^"]*\)".*/\1/' "$work/ready")
place=127.0.0.1:$(sed 's/.*"node_port":\([0-9]*\).*/\1/' "$work/ready")

"$work/made/calculix_solver" "$place" "$work/ccx" >"$work/solver" 2>&1 &
pids+=($!)
for _ in $(seq 600); do
  "$tedit" status --server "$url" >"$work/status"
  grep -q calculix "$work/status" && break
  sleep 0.1
done
grep -q calculix "$work/status"

# A job as its users would have it: close two holes and solve, on CalculiX and on the processor.
plate=$shared/examples/ctc01_plate
cat >"$work/recipe.json" <<JSON
[{"import": {"mesh": "$plate/ctc01_plate.coarse.msh"}},
 {"load_case": {"file": "$plate/load_case.json"}},
 {"edit": {"operation": "fill_hole", "surfaces": [1, 2]}},
 {"solve": {}}]
JSON
"$tedit" run "$work/recipe.json" --server "$url" --device nobodys >"$work/unknown" 2>&1 && exit 1
grep -q 'no device' "$work/unknown"
for device in cpu calculix; do
  "$tedit" run "$work/recipe.json" --server "$url" --device "$device" --json >"$work/$device.json"
done
/usr/bin/python3 - "$work/cpu.json" "$work/calculix.json" <<'PYTHON'
import json, sys

def report(name):
    found = []
    def seek(value):
        if isinstance(value, dict):
            if "max_von_mises_pa" in value and "true_relative_residual" in value:
                found.append(value)
            for one in value.values():
                seek(one)
        elif isinstance(value, list):
            for one in value:
                seek(one)
    seek(json.load(open(name)))
    return found[-1]

ours, theirs = (report(name) for name in sys.argv[1:])
for figure in ("max_von_mises_pa", "max_displacement_m"):
    off = abs(theirs[figure] / ours[figure] - 1)
    print(f"{figure}: {ours[figure]:.9g} and {theirs[figure]:.9g}, apart by {off:.1e}")
    assert off < 1e-5, figure
print("true residual of CalculiX's seven digits:", theirs["true_relative_residual"])
assert theirs["device"] == "calculix"
PYTHON

# The last document, as an observer sees it.
document=$("$work/made/observer" "$place" "$work/eye" | tail -1)
"$work/made/observer" "$place" "$work/eye" "$document" >"$work/seen" 2>&1 &
pids+=($!)
wait_for "$work/seen" '^result'
cat "$work/seen"
grep -q '^version 1 (head, made by fill_hole): [0-9]* tets, 1 load cases' "$work/seen"
grep -q '^result "ctc01_plate static" on calculix: ' "$work/seen"
"$work/made/observer" "$place" "$work/eye" nothing 2>"$work/refused" && exit 1
grep -q 'there is no document nothing' "$work/refused"
"$work/made/observer" "$place" "$work/ccx" 2>"$work/refused" && exit 1
grep -q 'not of an observer' "$work/refused"
