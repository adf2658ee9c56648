#!/usr/bin/env bash
# Installs a build, moves it, builds the C++ example of a client against it, and lets that and the one in Python drive
# the installed server: both must find and close the same holes.
# usage: integrate_test.sh BUILD
set -euo pipefail
build=$1
work=$(mktemp -d)
server=""
trap '[ -z "$server" ] || kill "$server" 2>/dev/null; wait; rm -rf "$work"' EXIT
. "$(dirname "$0")/installed.sh"
use_home "$work"
build_example "$build" integrate hole_study

"$work/prefix/bin/tedit" serve --port 0 --documents "$work/documents" >"$work/server" 2>&1 &
server=$!
for _ in $(seq 600); do
  grep -q '^listening on ' "$work/server" && break
  kill -0 "$server" || { cat "$work/server" >&2; exit 1; }
  sleep 0.1
done
url=$(sed -n 's/^listening on //p' "$work/server")
plate=$shared/examples/ctc01_plate
arguments=("$url" "$work/state/tedit/token" "$plate/ctc01_plate.coarse.msh" "$plate/load_case.json" 20 40)

"$work/made/hole_study" "${arguments[@]}" | tee "$work/cpp"
grep -q '^as it is: 13\.4[0-9]* MPa, 0\.0469' "$work/cpp"
test "$(grep -c '^hole of 35 mm: .*takes away surfaces' "$work/cpp")" = 4 # The supports are on them.
test "$(grep -c '^hole of 25 mm: 13\.4.* MPa, 0\.04' "$work/cpp")" = 4

python=/usr/bin/python3 # Debian's, which has Debian's modules.
if ! "$python" -c "import websockets, google.protobuf" 2>/dev/null; then
  echo "python3-websockets or python3-protobuf is not installed: the example in Python was not tried" >&2
  exit 77
fi
"$python" "$shared/examples/integrate/hole_study.py" "${arguments[@]}" | tee "$work/python"
test "$(wc -l <"$work/python")" = "$(wc -l <"$work/cpp")"
test "$(grep -c '^hole of 25 mm: 13\.4.* MPa, 0\.04' "$work/python")" = 4
test -x "$shared/examples/integrate/hole_study.py"

# Arrays of a stream, where the server says that they begin.
"$python" "$shared/examples/integrate/surface_area.py" "$url" "$work/state/tedit/token" \
  "$plate/ctc01_plate.coarse.msh" | tee "$work/area"
area=$(sed -n 's/.*area \([0-9.]*\) cm2.*/\1/p' "$work/area")
test -n "$area" && grep -q "says $area)" "$work/area"

# The Python package, where an installation has it.
if [ -d "$work/prefix/lib/python3/dist-packages/tedit" ]; then
  PYTHONPATH=$work/prefix/lib/python3/dist-packages "$python" - "$url" "$work/state/tedit/token" <<'PROGRAM' | tee "$work/package"
import sys
import tedit
with tedit.connect(sys.argv[1], tedit.read_token(sys.argv[2])) as server:
    print(tedit.__file__, server.welcome.server)
PROGRAM
  grep -q "^$work/prefix/.* tedit [0-9]" "$work/package"
fi
# Both over TLS, to a server of an authority of one's own.
tedit=$work/prefix/bin/tedit
"$tedit" certs init "$work/ca" >>"$work/log"
"$tedit" certs issue "$work/ca" --role server --name hall --host 127.0.0.1 -o "$work/hall" >>"$work/log"
kill "$server"
wait "$server" || true
"$tedit" serve --port 0 --documents "$work/documents" --certificates "$work/hall" >"$work/secure" 2>&1 &
server=$!
for _ in $(seq 600); do
  grep -q '^listening on ' "$work/secure" && break
  kill -0 "$server" || { cat "$work/secure" >&2; exit 1; }
  sleep 0.1
done
secure=$(sed -n 's/^listening on //p' "$work/secure")
SSL_CERT_FILE=$work/hall/ca.crt "$work/made/hole_study" "$secure" "${arguments[@]:1}" >"$work/cpp_secure"
test "$(wc -l <"$work/cpp_secure")" = "$(wc -l <"$work/cpp")"
SSL_CERT_FILE=$work/hall/ca.crt "$python" "$shared/examples/integrate/surface_area.py" "$secure" \
  "$work/state/tedit/token" "$plate/ctc01_plate.coarse.msh" | cmp - "$work/area"
"$work/made/hole_study" "$secure" "${arguments[@]:1}" 2>"$work/refused" && exit 1
grep -q "is not trusted here" "$work/refused"
url=$secure
export SSL_CERT_FILE=$work/hall/ca.crt

# Refusals are words, not traces.
"$python" "$shared/examples/integrate/hole_study.py" "$url" "$plate/load_case.json" "${arguments[@]:2}" 2>"$work/refused" &&
  exit 1
grep -q "token is wrong" "$work/refused"
