#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plants small faults in the sources and says which tests notice them.

usage: mutate.py [TREE] [--rooms actors,mesh,fem] [--count 150] [--seed 1] [--at FILE:LINE:KIND,...] [--labels REGEX]
                 [--targets ...] [--table FILE]

TREE (this one) is not changed: the faults are in a copy of it, TREE/build/mutants. A fault is a negated condition,
a bound that is off by one, a sign, a turned answer, a call that is left out. All are built into one program;
TEDIT_MUTANT=NUMBER makes one act (mutant.hpp). What the compiler warns of is left out. Tests that reach a fault run with it until the first one fails. What is
printed as "survived" was reached by tests and noticed by none; "not reached" says itself.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import planting

HITS = 4096
OPERAND = r"[A-Za-z_0-9][\w.]*(?:\(\))?"
SKIPPED = re.compile(r"^\s*(//|#|case |static_assert|template|using |friend |constexpr |///|\*)|requires|operator")


def closing(text, start):
    """The place of the bracket that closes the one at `start`."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    return -1


def condition(line):
    found = re.match(r"^(\s*(?:\} else )?if \()(.*)\)( \{)?$", line)
    if not found or closing(line, found.end(1) - 1) != found.end(2):
        return None
    inside = found.group(2)
    first, _, last = inside.rpartition("; ")
    if not first and re.match(r"^(const )?[\w:<>]+[&*]? \w+ = |^(const )?auto", inside):
        return None
    kept = first + "; " if first else ""
    return lambda n: f"{found.group(1)}{kept}bool({last}) != tedit::mutation::acts({n})){found.group(3) or ''}"


def bound(line):
    found = re.search(rf" (<|<=|>|>=|==) ({OPERAND})(?=\)|;| &&| \|\|| \?|$)", line)
    if not found or "<<" in line or found.group(2) in ("nullptr", "true", "false", "0"):
        return None
    return lambda n: (line[: found.start(2)] + f"tedit::mutation::bound({n}, {found.group(2)})" + line[found.end(2) :])


def sign(line):
    found = re.match(r"^(\s+[\w.\[\]>-]+ [+-]= )(.*);$", line)
    if not found:
        return None
    return lambda n: f"{found.group(1)}tedit::mutation::sign({n}, {found.group(2)});"


def answer(line):
    found = re.match(r"^(\s+return )(true|false);$", line)
    if not found:
        return None
    return lambda n: f"{found.group(1)}{found.group(2)} != tedit::mutation::acts({n});"


def call(line):
    found = re.match(r"^(\s+)((?!return\b|throw\b|delete\b|else\b)[a-z_][\w.:>-]*\(.*\));$", line)
    if not found or closing(line, line.index("(")) != found.end(2) - 1 or "assert" in line:
        return None
    return lambda n: f"{found.group(1)}(tedit::mutation::acts({n}) ? void() : void({found.group(2)}));"


KINDS = {"condition": condition, "bound": bound, "sign": sign, "answer": answer, "call": call}


def candidates(tree, rooms):
    """(file, line number, kind) of every place that a rule fits."""
    places = []
    for room in rooms:
        for file in sorted((tree / room).rglob("*.cpp")):
            lines = file.read_text().splitlines()
            for number, line in enumerate(lines):
                # A statement begins where the one before has ended.
                begins = number > 0 and re.search(r"[;{})]$|^$|else$|:$|//.*$", lines[number - 1])
                if SKIPPED.search(line) or not begins or "constexpr" in lines[number - 1]:
                    continue
                for kind, rule in KINDS.items():
                    if rule(line):
                        places.append((file.relative_to(tree), number, kind))
    return places


def choose(places, count, seed):
    """As many of each room and kind as there are, in turns, one a line."""
    groups = collections.defaultdict(list)
    for place in places:
        groups[(place[0].parts[0], place[2])].append(place)
    pick = random.Random(seed)
    for group in groups.values():
        pick.shuffle(group)
    chosen, lines = [], set()
    while len(chosen) < count and any(groups.values()):
        for key in sorted(groups):
            if groups[key] and len(chosen) < count:
                place = groups[key].pop()
                if place[:2] not in lines:
                    lines.add(place[:2])
                    chosen.append(place)
    return chosen


def asked_for(tree, texts):
    """The places that are named: to try again what survived and has a test since."""
    parts = [text.split(":") for text in texts]
    places = [(pathlib.Path(file), int(line) - 1, kind) for file, line, kind in parts]
    known = set(candidates(tree, {place[0].parts[0] for place in places}))
    if unknown := [place for place in places if place not in known]:
        sys.exit(f"no fault of this kind fits at {unknown[0][0]}:{unknown[0][1] + 1}")
    return places


def planted(originals, mutants):
    """The sources (path: text) with `mutants` (number: place), from the originals."""
    of_file = collections.defaultdict(dict)
    for number, (file, line, kind) in mutants.items():
        of_file[file][line] = (number, kind)
    changed = {}
    for file, of_line in of_file.items():
        lines = originals[file].splitlines()
        for line, (number, kind) in of_line.items():
            lines[line] = KINDS[kind](lines[line])(number)
        changed[file] = planting.with_switch("\n".join(lines) + "\n")
    return changed


def build(tree, copy, originals, mutants, targets):
    """Builds; what does not compile is taken out again. Returns what is left."""
    for _ in range(8):
        planting.copy_sources(tree, copy, planted(originals, mutants))
        folder = planting.configure(copy)
        said = planting.build(folder, targets)
        if not said:
            return mutants
        wrong = set()
        for file, line in re.findall(r"([\w./-]+\.cpp):(\d+):\d+: (?:error|  required)", said):
            path = pathlib.Path(os.path.relpath((folder / file).resolve(), copy))
            wrong.add((path, int(line) - 2))  # The include is a line more; lines count from 1.
        gone = [n for n, place in mutants.items() if (place[0], place[1]) in wrong]
        # What the compiler says of the flow ("may be used uninitialized") stands at another line than the fault.
        gone = gone or [n for n, place in mutants.items() if place[0] in {file for file, _ in wrong}]
        if not gone:
            sys.exit("the build fails for another reason:\n" + said[-3000:])
        print(f"{len(gone)} faults do not compile and are left out", flush=True)
        mutants = {n: place for n, place in mutants.items() if n not in gone}
    sys.exit("the build fails again and again")


def tests_of(copy, labels):
    """(program, gtest name, environment, folder) of each test of these labels."""
    listed = subprocess.run(["ctest", "--test-dir", copy / "build" / "release", "-L", labels, "--show-only=json-v1"],
                            capture_output=True, text=True, check=True)
    found = []
    for test in json.loads(listed.stdout)["tests"]:
        name = next((a.split("=", 1)[1] for a in test.get("command", []) if a.startswith("--gtest_filter=")), None)
        if name:
            folder = next((p["value"] for p in test["properties"] if p["name"] == "WORKING_DIRECTORY"), copy)
            found.append((test["command"][0], name, folder))
    return found


def run(program, names, folder, limit, **environment):
    """Whether all passed; gtest stops at the first that fails."""
    command = [program, "--gtest_filter=" + ":".join(names), "--gtest_fail_fast", "--gtest_brief=1"]
    process = subprocess.Popen(command, cwd=folder, env={**os.environ, **environment}, start_new_session=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        return process.wait(limit) == 0
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.wait()
        return False


def reach(test):
    """The faults that a test reaches, and whether it passes without any."""
    program, name, folder = test
    with tempfile.NamedTemporaryFile() as hits:
        hits.write(bytes(HITS))
        hits.flush()
        begun = time.monotonic()
        passed = run(program, [name], folder, 120, TEDIT_MUTANT_HITS=hits.name)
        took = time.monotonic() - begun
        return (*test, took), passed, {n for n, hit in enumerate(pathlib.Path(hits.name).read_bytes()) if hit}


def judge(number, tests):
    """The program of the test that noticed, or None."""
    programs = collections.defaultdict(list)
    for program, name, folder, took in tests:
        programs[(program, folder)].append((took, name))
    for (program, folder), timed in sorted(programs.items(), key=lambda item: sum(t for t, _ in item[1])):
        names = [name for _, name in sorted(timed)]
        if not run(program, names, folder, 20 + 5 * sum(t for t, _ in timed), TEDIT_MUTANT=str(number)):
            return pathlib.Path(program).name
    return None


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("tree", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).parents[2])
    options.add_argument("--rooms", default="actors,mesh,fem")
    options.add_argument("--count", type=int, default=150)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--at", default="", help="FILE:LINE:KIND,...: these too (with --count 0: only these), one a line; "
                                                  f"KIND: {', '.join(KINDS)}")
    options.add_argument("--labels", default="mesh|store|actors|gateway|simulation|fem|multilevel|client_actor|io|scenarios")
    options.add_argument("--targets", default="", help="of ninja; all when empty")
    options.add_argument("--table", type=pathlib.Path)
    given = options.parse_args()
    tree = given.tree.resolve()
    copy = tree / "build" / "mutants"
    asked = asked_for(tree, filter(None, given.at.split(",")))
    lines = {place[:2] for place in asked}
    others = choose(candidates(tree, given.rooms.split(",")), given.count, given.seed)
    chosen = asked + [place for place in others if place[:2] not in lines]
    originals = {place[0]: (tree / place[0]).read_text() for place in chosen}
    mutants = build(tree, copy, originals, dict(enumerate(chosen)), given.targets.split())
    print(f"{len(mutants)} faults planted", flush=True)

    reached = collections.defaultdict(list)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for test, passed, hits in pool.map(reach, tests_of(copy, given.labels)):
            if not passed:
                print(f"left out, fails by itself: {test[1]}", flush=True)
            for number in hits if passed else ():
                reached[number].append(test)
        print("each test has run once", flush=True)
        rows = []
        for number, noticed in zip(mutants, pool.map(lambda n: judge(n, reached[n]), mutants)):
            file, line, kind = mutants[number]
            verdict = f"noticed by {noticed}" if noticed else "SURVIVED" if reached[number] else "NOT REACHED"
            source = originals[file].splitlines()[line].strip()
            rows.append((number, f"{file}:{line + 1}", kind, source, len(reached[number]), verdict))
            print(*rows[-1], sep=" | ", flush=True)
    counts = collections.Counter(row[-1].split(" by ")[0] for row in rows)
    print(dict(counts))
    if given.table:
        given.table.write_text("".join("| " + " | ".join(map(str, row)) + " |\n" for row in rows))


if __name__ == "__main__":
    main()
