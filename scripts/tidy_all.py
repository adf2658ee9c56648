#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs clang-tidy over all sources of the product, or over those of some rooms.

usage: tidy_all.py [ROOM...]   (base, mesh, ops, client-qt, ...)

build/release must be built. There several sources are one unit, and each unit is looked at once: four times as quick as
source by source. The analyzer, which sees into functions of a unit's own file only, is left to `check.sh --tidy`. Each
finding is printed once; a unit that cannot be compiled is one. Exit status: 0 nothing found, 1 findings, 2 usage.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
LEFT_OUT = {"tests", "generated"}
# A unit includes sources: that is its purpose.
CHECKS = "--checks=-clang-analyzer-*,-bugprone-suspicious-include"
FINDING = re.compile(r"^(?:/\S+?:\d+:\d+: )?(?:error|warning): .*\[", re.M)


def units():
    """(room, file) of each unit of the product."""
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        place = file.relative_to(BUILD if file.is_relative_to(BUILD) else ROOT)
        if place.parts[0] not in LEFT_OUT and not re.search(r"_autogen|_tests\.dir|/tests/", str(place)):
            yield place.parts[0], file


def look_at(file):
    """What is found in a unit: each finding with the lines that belong to it."""
    done = subprocess.run(["clang-tidy-16", "--quiet", "-p", BUILD, CHECKS, file], cwd=ROOT, capture_output=True, text=True)
    starts = [found.start() for found in FINDING.finditer(done.stdout)]
    findings = [done.stdout[a:b] for a, b in zip(starts, starts[1:] + [None])]
    if done.returncode != 0 and not findings:
        findings.append(f"{file}: {done.stderr[-2000:]}\n")
    return findings


def main():
    if any(option.startswith("-") for option in sys.argv[1:]) or not (BUILD / "compile_commands.json").exists():
        print(__doc__.strip(), file=sys.stderr)
        return 2
    all_units = list(units())
    wanted = set(sys.argv[1:]) or {room for room, _ in all_units}
    if unknown := wanted - {room for room, _ in all_units}:
        print("no such room: " + ", ".join(sorted(unknown)), file=sys.stderr)
        return 2
    files = [file for room, file in all_units if room in wanted]
    said = set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for findings in pool.map(look_at, files):
            for finding in findings:
                if finding not in said:
                    said.add(finding)
                    print(finding, end="", flush=True)
    print(f"clang-tidy: {len(files)} units, {len(said)} findings")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
