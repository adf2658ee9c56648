#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""previews.py MESH SURFACE OPERATION PARAMETER FROM TO [--set NAME=VALUE ...] [--draft] [--steps 30] [--rounds 3] [--program P ...]

Previews of an edit over the socket, one after the other, without the window: PARAMETER goes from FROM to TO (SI; places as
x,y,z). Programs take turns, each with a server of its own. Prints for each the medians, ms, of the whole, of the operation, of
the improvement and of the checks as the report says them, and of the rest (between processes, pages, the surface on its way);
and a sum over all versions that were shown, which must be the same for programs that make the same of the same edit.
"""
import argparse
import hashlib
import os
import pathlib
import statistics
import sys
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "clients/python/tests"))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("surface", type=int)
    parser.add_argument("operation")
    parser.add_argument("parameter")
    parser.add_argument("first")
    parser.add_argument("last")
    parser.add_argument("--set", action="append", default=[], dest="others", metavar="NAME=VALUE")
    parser.add_argument("--draft", action="store_true", help="as while a handle is dragged")
    parser.add_argument("--unit", default="mm", help="of the mesh")
    parser.add_argument("--steps", type=int, default=30)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--program", action="append", type=pathlib.Path)
    return parser.parse_args()


def value_of(text):
    numbers = [float(n) for n in text.split(",")]
    return numbers if len(numbers) > 1 else numbers[0]


def play(wanted, part, rows, seen):
    others = {name: value_of(text) for name, text in (row.split("=") for row in wanted.others)}
    ends = [numpy.array(value_of(text)) for text in (wanted.first, wanted.last)]
    how = {"draft": True} if wanted.draft else {}
    for share in numpy.linspace(0, 1, wanted.steps):
        value = ends[0] + share * (ends[1] - ends[0])
        values = {**others, wanted.parameter: value.tolist()}
        began = time.perf_counter()
        made = part.preview(wanted.operation, [wanted.surface], values, **how)
        whole = 1e3 * (time.perf_counter() - began)
        report = made.report
        inside = [report.operation_ms, report.improve_ms, report.check_ms]
        rows.append([whole, *inside, whole - sum(inside)])
        seen.append(report.to_version)


def main():
    wanted = arguments()
    programs = wanted.program or [pathlib.Path("build/release/bin/tedit")]
    os.environ.update(TEDIT_PROGRAM=str(programs[0].resolve()), TEDIT_SOURCE=str(pathlib.Path(__file__).parent.parent.resolve()))
    import serving

    rows, seen, servers, parts = {}, {}, [], []
    for program in programs:
        serving.PROGRAM = str(program.resolve())
        servers.append(serving.Server())
        parts.append(servers[-1].connect().open())
        parts[-1].import_mesh(wanted.mesh, unit=wanted.unit)
        rows[program], seen[program] = [], []
    for round_number in range(wanted.rounds + 1):  # The first one warms up.
        for program, part in zip(programs, parts):
            ours, versions = ([], []) if round_number == 0 else (rows[program], seen[program])
            play(wanted, part, ours, versions)
    print("| program | whole, ms (p50, worst) | operation | improvement | checks | rest | versions |\n|" + "---|" * 7)
    for program in programs:
        middle = [statistics.median(column) for column in zip(*rows[program])]
        worst = max(row[0] for row in rows[program])
        digest = hashlib.sha256("".join(seen[program]).encode()).hexdigest()[:12]
        cells = [f"{middle[0]:.0f}, {worst:.0f}", *(f"{m:.0f}" for m in middle[1:]), digest]
        print(f"| {program} | " + " | ".join(cells) + " |")
    for server in servers:
        server.stop()


if __name__ == "__main__":
    main()
