#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Damages MED files at random places and has tedit read each: what is said, how often.

usage: bench/med_damage.py [--tedit PROGRAM] [--files N] [--seed FIRST] FILE.med ...

Exit status 1 where tedit ended otherwise than by reading or refusing the file, said no cause and remedy, or took more
than a second.
"""
import argparse
import collections
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

VALUES = [0, 1, 0x7F, 0x80, 0xFF]


def damaged(sound, seed):
    chance = random.Random(seed)
    content = bytearray(sound)
    for _ in range(chance.choice([1, 1, 2, 4, 16])):
        content[chance.randrange(len(content))] = chance.choice(VALUES + [chance.randrange(256)])
    return content


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tedit", default="build/release/bin/tedit")
    parser.add_argument("--files", type=int, default=500)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("sound", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    said = collections.Counter()
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "damaged.med"
        for sound in options.sound:
            for seed in range(options.seed, options.seed + options.files):
                file.write_bytes(damaged(sound.read_bytes(), seed))
                begin = time.monotonic()
                done = subprocess.run([options.tedit, "info", file], capture_output=True, timeout=300)
                took = time.monotonic() - begin
                words = done.stderr.decode(errors="replace")
                is_sound = done.returncode == 0 or (done.returncode in (1, 65) and f"[{file}" in words and "]. " in words)
                if took > 1 or not is_sound:
                    faults += 1
                    print(f"{sound}, seed {seed}: status {done.returncode} after {took:.2f} s: {words.strip()}")
                said["read" if done.returncode == 0 else re.sub(r"\d+", "N", words.split(" [")[0])[:100]] += 1
    for words, count in said.most_common():
        print(f"{count:6}  {words}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
