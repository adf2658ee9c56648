"""tool_operations.py [WORK_FOLDER]: operations with tools on the shipped parts, each solved beside CalculiX.

Makes each edit with build/release/bin/tedit, writes the new mesh with its part's load case to WORK_FOLDER, and has "tedit verify
--calculix" solve them all. Prints the table of bench/FIGURES.md, *Operations with tools*. Needs ccx; some minutes.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TEDIT = "build/release/bin/tedit"
PARTS = pathlib.Path("tests/data/parts")
LOGO = '<svg xmlns="http://www.w3.org/2000/svg"><circle cx="5" cy="5" r="5"/><path d="M2 4 H8 V6 H2 Z"/></svg>'
WEDGE = "ops/combine/tests/wedge.stl"
EDITS = [
    ("move", "ctc01_plate", [1], {"by_mm": "40,30,0"}),
    ("move", "holes_block", [98], {"by_mm": "2,0,0"}),
    ("move", "bracket_4040", [1], {"by_mm": "2,0,0"}),
    ("pattern", "ctc01_plate", [1], {"count": 3, "step_mm": "60,45,0"}),
    ("pattern", "inch_block", [8], {"count": 3, "step_mm": "0,9,0"}),
    ("pattern", "bracket_4040", [1], {"kind": "rows", "step_mm": "9,0,0"}),
    ("resize_bore", "ctc01_plate", [1], {"diameter_mm": 40}),
    ("resize_bore", "inch_block", [8], {"diameter_mm": 9}),
    ("resize_bore", "heatsink_125", [71], {"diameter_mm": 4}),
    ("combine", "inch_block", [], {"file": WEDGE, "at_mm": "0,0,20"}),
    ("combine", "ctc01_plate", [], {"file": WEDGE, "scale": 3, "mode": "cut", "at_mm": "-41,-63,-57"}),
    ("combine", "heatsink_125", [], {"file": WEDGE, "at_mm": "-40,-20,-25"}),
    ("hollow", "inch_block", [], {"thickness_mm": 5}),
    ("hollow", "ctc01_plate", [98], {"thickness_mm": 20}),
    ("hollow", "heatsink_125", [], {"thickness_mm": 1}),
    ("rib", "bracket_4040", [5, 10], {"thickness_mm": 3, "size_mm": 8}),
    ("emboss", "ctc01_plate", [98], {"file": "LOGO", "size_mm": 60, "height_mm": 4}),
    ("pocket", "inch_block", [5], {"profile": "file", "file": "LOGO", "size_mm": 15, "height_mm": 3}),
    ("emboss", "heatsink_125", [1], {"text": "No 7", "size_mm": 3, "height_mm": 0.5}),
]


def edit(number, operation, part, surfaces, values, work):
    """One row of the table, with the new mesh in a folder of its own."""
    name = f"e{number:02}_{operation}"
    folder = work / name
    folder.mkdir(parents=True)
    shutil.copy(PARTS / part / "load_case.json", folder / "load_case.json")
    call = [TEDIT, "edit", "--json", "-q", str(PARTS / part / f"{part}.coarse.msh"), "--op", operation]
    call += ["--surfaces", ",".join(map(str, surfaces))] if surfaces else []
    for key, value in values.items():
        call += ["--param", f"{key}={work / 'logo.svg' if value == 'LOGO' else value}"]
    done = subprocess.run(call + ["-o", str(folder / f"{name}.coarse.msh")], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if "error" in report:
        shutil.rmtree(folder)
        report = {"refused": report["error"]["message"]}
    return name, report


def agreement(work):
    """Largest difference of displacements by name of the edit, order 2."""
    said = subprocess.run([TEDIT, "verify", "--suite", "--calculix", "--parts", str(work), "-o", str(work / "page.md")],
                          capture_output=True, text=True)
    rows = {}
    for line in (work / "page.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if re.fullmatch(r"e\d\d_\w+", cells[0]) and cells[1] == "2":
            rows[cells[0]] = (cells[4], cells[7])
    if not rows:
        sys.exit("there is no comparison: " + said.stderr[-2000:])
    return rows


def main():
    work = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="tedit-tools-"))
    work.mkdir(exist_ok=True)
    (work / "logo.svg").write_text(LOGO)
    made = [(row, *edit(i, *row, work)) for i, row in enumerate(EDITS)]
    same = agreement(work)
    print("| operation | part | ms | tets | volume, mm3 | worst q | off CalculiX: displacement, compliance |\n|---|---|---|---|---|---|---|")
    for (operation, part, surfaces, values), name, report in made:
        asked = operation + " " + ", ".join(f"{key}={value}" for key, value in values.items())
        if "refused" in report:
            print(f"| {asked} | {part} | refused: {report['refused']} | | | | |")
            continue
        quality = report["radius_ratio_touched"]
        print(f"| {asked} | {part} | {report['timings_ms']['total']:.0f} | +{report['tets_added']} -{report['tets_removed']} "
              f"| {1e9 * report['volume_change_m3']:.6g} | {quality['after_min']:.3g} | {', '.join(same.get(name, ('-',)))} |")


if __name__ == "__main__":
    main()
