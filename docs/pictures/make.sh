#!/bin/sh
# Draws the pictures of docs/operations_on_parts.md again: docs/pictures/make.sh [BUILD_FOLDER]. Needs
# Xvfb and python3-vtk9. Run it in the repository's root.
set -eu
bin=${1:-build/release}/bin
parts=tests/data/parts
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# palette NAME: a picture of few colours is small.
palette() {
  /usr/bin/python3 docs/pictures/palette.py "$work/$1.png" "docs/pictures/$1.png"
}

# stress NAME MESH LOADS RENDER_OPTIONS...: von Mises stress of linear tets on a mesh.
stress() {
  shown=$1 on=$2 with=$3
  shift 3
  "$bin/tedit" solve "$on" --load-case "$with" --order 1 --device cpu -o "$work/$shown.vtu" > /dev/null 2>&1
  "$bin/tedit-render" "$work/$shown.vtu" -o "$work/$shown.png" --size 1120x760 --edges "$@"
  palette "$shown"
}

# pair NAME PART EDIT_OPTIONS -- RENDER_OPTIONS: before and after one edit.
pair() {
  name=$1 part=$2
  shift 2
  edit=
  while [ "$1" != -- ]; do edit="$edit $1"; shift; done
  shift
  mesh=$parts/$part/$part.coarse.msh
  loads=$parts/$part/load_case.json
  "$bin/tedit" edit "$mesh" $edit -o "$work/$name.msh" > /dev/null
  stress "${name}_before" "$mesh" "$loads" --title "before" "$@"
  stress "${name}_after" "$work/$name.msh" "$loads" --title "after" "$@"
}

# worst NAME MESH LOADS: the worst radius ratio around each vertex.
worst() {
  "$bin/tedit" solve "$2" --load-case "$3" --order 1 --device cpu -o "$work/$1.vtu" > /dev/null 2>&1
  /usr/bin/python3 docs/pictures/worst_ratio.py "$work/$1.vtu"
  "$bin/tedit-render" "$work/$1.vtu" -o "$work/$1.png" --size 1120x760 --edges --field worst_q --unit "worst q" --scale 1 \
    --range 0.2,0.7 --title "${1#improve_mesh_}"
  palette "$1"
}

pair fill_hole ctc01_plate --op fill_hole --surfaces 92,93 -- --range 0,4 --zoom 5 --focus 0.145,0.045,0
pair remove_surfaces heatsink_125 --op remove_surfaces --surfaces 45 -- --range 0,1 --zoom 2.2 --view z --focus -0.024,0.02,0.0175
pair erode heatsink_125 --op erode --surfaces 61 --param depth_mm=1.2 -- --range 0,1 --zoom 2.2 --view z --focus -0.012,0.02,0.0175
pair erode_round ctc01_plate --op erode --surfaces 92,93 --param depth_mm=8 -- --range 0,4 --zoom 5 --focus 0.145,0.045,0
pair thicken heatsink_125 --op thicken --surfaces 57,61 --param depth_mm=1.2 -- --range 0,1 --zoom 2.2 --view z --focus -0.012,0.02,0.0175
pair close inch_block --op close --surfaces 1,8 --param radius_mm=1.59 -- --view x --zoom 7 --focus 0.0254,0.0337,0.0254 --range 0.1,1
pair open inch_block --op open --surfaces 6 --param radius_mm=5 -- --range 0.1,1 --zoom 0.8
pair deform heatsink_125 --op deform --surfaces 61 --param distance_mm=1.5 -- --range 0,1 --zoom 2.2 --view z --focus -0.012,0.02,0.0175
pair deform_patch inch_block --op deform --param at_mm=0,25,38 --param radius_mm=8 --param distance_mm=8 --param reach_mm=22 -- --range 0.1,1 --zoom 1.2
pair refine ctc01_plate --op refine --surfaces 92,93 --param size_mm=2 -- --range 0,4 --zoom 4 --focus 0.145,0.045,0
pair coarsen heatsink_125 --op coarsen --surfaces 49 --param size_mm=4 -- --range 0,1 --zoom 1.5
plate=$parts/ctc01_plate/ctc01_plate.coarse.msh
"$bin/tedit" edit "$plate" --op improve_mesh --param surface_tolerance_mm=0.02 -o "$work/better.msh" > /dev/null
worst improve_mesh_before "$plate" $parts/ctc01_plate/load_case.json
worst improve_mesh_after "$work/better.msh" $parts/ctc01_plate/load_case.json
ls -l docs/pictures/*.png
