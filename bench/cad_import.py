#!/usr/bin/env python3
"""cad_import.py FOLDER_OR_FILE ...: `tedit import` of CAD files at three sizes, as a table for bench/FIGURES.md.

Takes every .step, .stp, .iges, .igs and .brep in the folders and the folders in them. A refused file is a row with what was said.
"""

import json
import pathlib
import subprocess
import sys

TEDIT = "build/release/bin/tedit"
SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep"}
HEAD = (
    "| part | size | edge mm | tets | read s | mesh s | repair s | total s | q: worst, median | volume off | moved mm | regions | surfaces | with name | with colour |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
)


def files_of(places):
    for place in map(pathlib.Path, places):
        found = [place] if place.is_file() else sorted(place.rglob("*"))
        yield from (one for one in found if one.suffix.lower() in SUFFIXES)


def row(file, size):
    run = subprocess.run([TEDIT, "import", str(file), "--size", size, "--json"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    said = json.loads(run.stdout)
    if "error" in said:
        return f"| {file.stem} | {size} | {said['error']['message']} |"
    s = {stage: f"{ms / 1e3:.2f}" for stage, ms in said["timings_ms"].items()}
    q = said["radius_ratio"]
    surfaces = said["surfaces"]
    cells = [
        file.stem,
        size,
        f"{1e3 * said['edge_length_m']:.3g}",
        f"{said['tets']:,}",
        *(s[stage] for stage in ("read", "mesh", "repair", "total")),
        f"{q['min']:.3f}, {q['median']:.2f}",
        f"{100 * (said['volume_m3'] / said['cad_volume_m3'] - 1):+.2f} %",
        f"{1e3 * said['surface_moved_m']:.2g}",
        str(len(said["regions"])),
        str(len(surfaces)),
        str(sum(bool(one["name"]) for one in surfaces)),
        str(sum(bool(one["colour"]) for one in surfaces)),
    ]
    return "| " + " | ".join(cells) + " |"


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    print(HEAD)
    for file in files_of(sys.argv[1:]):
        for size in ("coarse", "medium", "fine"):
            print(row(file, size), flush=True)


if __name__ == "__main__":
    main()
