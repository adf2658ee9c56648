#!/usr/bin/env bash
# units_test.sh BUILD: the units for systemd are ones that systemd understands, without a warning, and expose little.
set -euo pipefail
build=$1
command -v systemd-analyze >/dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for unit in tedit.service tedit-worker@.service; do
  sed "s|@bin@|$build/bin|" "$build/systemd/$unit.in" >"$folder/$unit"
done
cp "$folder/tedit-worker@.service" "$folder/tedit-worker@rack-1.service"
cd "$folder"
said=$(systemd-analyze verify --man=no ./tedit.service ./tedit-worker@rack-1.service 2>&1 | grep -F "$folder" || true)
if [[ -n $said ]]; then
  echo "$said" >&2
  exit 1
fi
for unit in tedit.service tedit-worker@rack-1.service; do
  systemd-analyze security --offline=true --threshold=25 "./$unit" >/dev/null || {
    echo "$unit exposes more than 2.5 of 10" >&2
    exit 1
  }
done
