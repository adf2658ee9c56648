"""operations_table.py PARTS_FOLDER MEDIUM_FOLDER WORK_FOLDER: every listed feature of every part, coarse and medium.

Runs build/release/bin/feature_sweep where WORK_FOLDER does not hold its output yet, and puts the tables into
docs/operations_on_parts.md, between its two markers. MEDIUM_FOLDER holds PART.medium.msh.
"""

import pathlib
import subprocess
import sys

SWEEP = "build/release/bin/feature_sweep"
PAGE = pathlib.Path("docs/operations_on_parts.md")
BEGIN, END = "<!-- tables: begin -->\n", "<!-- tables: end -->\n"
HEAD = (
    "| operation | feature | result | CPU ms | tets | worst q | median q | volume | surfaces |\n"
    "|---|---|---|---|---|---|---|---|---|\n"
)


def output(part, mesh, place, *mode):
    if not place.exists():
        run = subprocess.run([SWEEP, part, mesh, *mode], stdout=subprocess.PIPE, text=True)
        place.write_text(run.stdout + (f"status {run.returncode}\n" if run.returncode else ""))
    return place.read_text().splitlines()


def readable(cells):
    """Milliseconds without exponents; a volume that is exact to rounding has no error."""
    result, ms, tets, worst, median, volume, surfaces = cells
    ms = f"{float(ms):,.0f}"
    if volume and abs(float(volume.rstrip(" %"))) < 1e-6:
        volume = "0 %"
    return [result, ms, tets, worst, median, volume, surfaces]


def rows(lines):
    """Cells by operation and feature; other lines say what broke."""
    found, broken = {}, []
    for line in lines:
        if line.startswith("| "):
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            found[tuple(cells[:2])] = readable(cells[2:])
        else:
            broken.append(line)
    return found, broken


def joined(coarse, medium):
    return coarse if coarse == medium else f"{coarse or '-'} / {medium or '-'}"


def table(coarse, medium):
    text = ""
    for key in list(coarse) + [key for key in medium if key not in coarse]:
        absent = ["not there"] + [""] * 6
        pair = zip(coarse.get(key, absent), medium.get(key, absent))
        text += "| " + " | ".join(list(key) + [joined(*cells) for cells in pair]) + " |\n"
    return text


def main():
    parts, finer, work = (pathlib.Path(argument) for argument in sys.argv[1:4])
    text = ""
    for part in sorted(folder for folder in parts.iterdir() if (folder / "features.json").exists()):
        meshes = {"coarse": part / f"{part.name}.coarse.msh", "medium": finer / f"{part.name}.medium.msh"}
        found, said = {}, []
        for level, mesh in meshes.items():
            found[level], broken = rows(output(part, mesh, work / f"{part.name}.{level}.txt"))
            said += [f"- {level}: {line.strip()}" for line in broken]
            summary = output(part, mesh, work / f"{part.name}.{level}.seq", "--sequence")[-1]
            if " 0 of 0 " not in summary:
                said.append(f"- {level}: {summary}")
        text += f"\n### {part.name}\n\n{HEAD}{table(found['coarse'], found['medium'])}\n" + "".join(
            line + "\n" for line in said
        )
    page = PAGE.read_text()
    PAGE.write_text(page[: page.index(BEGIN) + len(BEGIN)] + text + "\n" + page[page.index(END) :])


if __name__ == "__main__":
    main()
