"""window_drag.py MESH SURFACE OPERATION HANDLE DX DY [--load-case F] [--before STEPS] [--program P] [--repeat N]

Drags a handle of an operation's form in the real window (Xvfb, a server of its own): real mouse events, about 50 a
second, over DX, DY pixels. Prints one row of a table: how often handles and ghost were drawn and previews shown while
the drag went on, and how long each took from the mouse move (medians of the runs; worst of all).
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("surface", type=int)
    parser.add_argument("operation")
    parser.add_argument("handle")
    parser.add_argument("dx", type=float)
    parser.add_argument("dy", type=float)
    parser.add_argument("--load-case")
    parser.add_argument("--before", type=json.loads, default=[], help="steps of a recipe before the drag, a JSON list")
    parser.add_argument("--moves", type=int, default=150)
    parser.add_argument("--program", default="build/release/bin/tedit-qt")
    parser.add_argument("--repeat", type=int, default=3)
    return parser.parse_args()


def drag_once(wanted, folder):
    steps = [{"view": "isometric"}, {"wait": "final" if wanted.load_case else "ready"}, {"select": [wanted.surface]}]
    steps += [{"choose": wanted.operation}, {"wait": "ready"}, *wanted.before, {"wait": "ready"}]
    steps += [{"drag_handle": wanted.handle, "by": [wanted.dx, wanted.dy], "moves": wanted.moves}, {"wait": "ready"}]
    recipe, report = folder / "steps.json", folder / "report.json"
    recipe.write_text(json.dumps(steps))
    runtime = folder / "run"
    runtime.mkdir(mode=0o700, exist_ok=True)
    homes = {f"XDG_{name}": str(runtime) for name in ("RUNTIME_DIR", "CONFIG_HOME", "STATE_HOME", "CACHE_HOME")}
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x720x24", wanted.program, "--open", wanted.mesh]
    command += ["--load-case", wanted.load_case] if wanted.load_case else []
    command += ["--script", str(recipe), "--size", "1280x720", "--report", str(report)]
    subprocess.run(command, check=True, env={**os.environ, **homes}, timeout=300)
    return json.loads(report.read_text())["last_drag"]


def row(wanted, runs):
    def median(read):
        return statistics.median(read(run) for run in runs)

    cells = [pathlib.Path(wanted.mesh).stem, f"{wanted.operation}, {wanted.handle}"]
    for kind in ("handles", "previews"):
        cells.append(f"{median(lambda r: r[kind]['count'] / r['seconds']):.1f}")
        cells.append(f"{median(lambda r: r[kind]['p50_ms']):.0f}, {max(r[kind]['worst_ms'] for r in runs):.0f}")
    return "| " + " | ".join(cells) + " |"


def main():
    wanted = arguments()
    with tempfile.TemporaryDirectory() as folder:
        runs = [drag_once(wanted, pathlib.Path(folder)) for _ in range(wanted.repeat)]
    print(row(wanted, runs))
    return 0


if __name__ == "__main__":
    sys.exit(main())
