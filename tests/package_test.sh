#!/usr/bin/env bash
# Packs the build as Debian packages, unpacks them elsewhere, and runs what is in them from there.
# usage: package_test.sh CPACK BUILD SOURCE
set -euo pipefail
cpack=$1 build=$2 source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$cpack" --config "$build/CPackConfig.cmake" -B "$work/packages" >"$work/log" 2>&1 || {
  cat "$work/log"
  exit 1
}
for package in "$work"/packages/*.deb; do
  dpkg-deb -x "$package" "$work/root"
  dpkg-deb -W --showformat='${Package} ${Version}, ${Installed-Size} KiB: ${Depends}\n' "$package"
done
test "$(ls "$work"/packages/*.deb | wc -l)" = 2

bin=$work/root/usr/bin
"$bin/tedit" --version
"$bin/tedit" --quiet edit "$source/examples/ctc01_plate/ctc01_plate.coarse.msh" \
  --op fill_hole --surfaces 1,2 -o "$work/closed.msh"
test -s "$work/closed.msh"
if [ -x "$build/bin/tedit-cad-reader" ]; then
  "$bin/tedit" --quiet import "$source/tests/data/cad/box.step" --size coarse -o "$work/box.msh"
  test -s "$work/box.msh"
fi
if [ -x "$build/bin/tedit-med" ]; then
  "$bin/tedit" --quiet convert "$source/tests/data/med/salome.med" -o "$work/salome.unv"
  test -s "$work/salome.unv"
fi
test -s "$work/root/usr/share/man/man1/tedit.1"
test -s "$work/root/usr/share/bash-completion/completions/tedit"
if [ -d "$build/share/doc/tedit/html" ]; then
  manual=$work/root/usr/share/doc/tedit/html
  python3 "$source/tests/scripts/manual_test.py" "$manual"
fi
test -s "$work/root/usr/lib/cmake/TEdit/TEditConfig.cmake"
test -s "$work/root/usr/lib/cmake/TEdit/TEditClientTargets.cmake"
test -s "$work/root/usr/lib/tedit/libtedit_client.a"
test -s "$work/root/usr/share/tedit/protocol/tedit/v1/envelope.proto"
test -s "$work/root/usr/lib/python3/dist-packages/tedit/v1/envelope_pb2.py"
if [ -x "$bin/tedit-qt" ]; then
  "$bin/tedit-qt" --version
  test -s "$work/root/usr/share/applications/org.tedit.TEdit.desktop"
  python3 -c "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])" \
    "$work/root/usr/share/metainfo/org.tedit.TEdit.metainfo.xml"
  if [ -d "$build/share/tedit/translations" ]; then
    test -s "$work/root/usr/share/tedit/translations/tedit_de.qm"
  fi
fi
# Only shared objects that other packages bring, and nothing of the build folder.
! grep -rl "$build" "$work/root/usr/bin" "$work/root/usr/lib/tedit/plugins"
