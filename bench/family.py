#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A family of parts: one recipe on the NIST plate, one row for each customer.

Each row gives a drill hole another diameter, embosses the customer's name and solves for the
customer's load. Some of what customers want cannot be made: a hole that leaves the wall, a name that
the font has not. Prints the time, how many failed, and why.

usage: bench/family.py [--program build/release/bin/tedit] [--rows 200] [--jobs 2] [--out FOLDER]
"""
import argparse
import collections
import csv
import json
import pathlib
import random
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLATE = ROOT / "examples/ctc01_plate"
FIRST = ["Alba", "Brandt", "Cortez", "Dubois", "Eriksen", "Fischer", "Grün", "Horvat", "Ivanov", "Jensen"]
SECOND = ["Aero", "Bau", "Cycle", "Drive", "Energy", "Forge", "Gears", "Hydro", "Lift", "Motion"]


def recipe():
    loads = json.loads((PLATE / "load_case.json").read_text())
    loads["loads"][0]["force"]["total_n"]["z"] = "{{force_n}}"
    return {
        "name": "Plates of the customers",
        "device": "cpu",
        "steps": [
            {"import": {"mesh": str(PLATE / "ctc01_plate.coarse.msh")}},
            {"load_case": loads},
            {"edit": {"operation": "resize_bore", "surfaces": [1, 2], "parameters": {"diameter_mm": "{{hole_mm}}"}}},
            {"edit": {"operation": "emboss", "surfaces": [98],
                      "parameters": {"text": "{{name}}", "size_mm": 30, "height_mm": 1}}},
            {"solve": {}},
            {"export": {"stl": "{{name}}.stl", "msh": "{{name}}.msh", "range_mpa": [0, 40]}},
        ],
    }


def rows(count):
    """The same each time. One customer in ten wants a hole of 85 to 400 mm: the plate is 450 mm wide."""
    chance = random.Random(28)
    for i in range(count):
        name = f"{FIRST[i % 10]} {SECOND[i // 10 % 10]}" + (f" {i // 100 + 1}" if i >= 100 else "")
        wide = chance.random() < 0.1
        hole = chance.uniform(85, 400) if wide else chance.uniform(12, 60)
        yield {"name": name, "hole_mm": f"{hole:.1f}", "force_n": f"{-chance.uniform(5e3, 60e3):.0f}"}


def reason_of(row):
    text = re.sub(r"-?\d+(\.\d+)?(e[+-]\d+)?", "N", row["reason"])
    return f"step {row['step']['number']} ({row['step']['step']}): {text}" if "step" in row else text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tedit"))
    parser.add_argument("--rows", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=0, help="0: as tedit run chooses")
    parser.add_argument("--out", help="keeps recipe, table, parts and report there")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.out or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "recipe.json").write_text(json.dumps(recipe(), indent=1))
        with open(folder / "customers.csv", "w", newline="") as file:
            table = csv.DictWriter(file, ["name", "hole_mm", "force_n"])
            table.writeheader()
            table.writerows(rows(options.rows))
        command = [options.program, "run", str(folder / "recipe.json"), "--table", str(folder / "customers.csv"),
                   "--report", str(folder / "report.html"), "--out", str(folder / "parts"), "--json"]
        if options.jobs:
            command += ["--jobs", str(options.jobs)]
        done = subprocess.run(command, stdout=subprocess.PIPE, check=False)
        result = json.loads(done.stdout)
        if "rows" not in result:
            raise SystemExit(result)
        (folder / "report.json").write_text(json.dumps(result, indent=1))
        show(result, (folder / "report.html").stat().st_size)


def show(result, report_bytes):
    times = sorted(row["ms"] for row in result["rows"] if row["status"] == "passed")
    print(f"{len(result['rows'])} rows, {result['jobs']} at a time: {result['total_ms'] / 60e3:.1f} min; "
          f"{result['passed']} passed, {result['failed']} failed, {result['safety_factor_below_1']} below a safety factor of 1; "
          f"a part takes {times[len(times) // 2] / 1e3:.1f} s (median), {times[-1] / 1e3:.1f} s at most; "
          f"report {report_bytes / 1e6:.1f} MB")
    steps = collections.Counter()
    for row in result["rows"]:
        for step in row["steps"]:
            steps[step["step"].split(":")[0] + " " + str(step["number"])] += step.get("ms", 0)
    print("  s in all steps: " + ", ".join(f"{step} {ms / 1e3:.0f}" for step, ms in steps.items()))
    for reason, count in collections.Counter(map(reason_of, (r for r in result["rows"] if r["status"] == "failed"))).most_common():
        print(f"  {count} times: {reason}")


if __name__ == "__main__":
    main()
