# SPDX-License-Identifier: AGPL-3.0-or-later
"""What scripts share that plant faults: a copy of a tree in which the faults are, and its build.

The tree itself is never changed, so that nothing is left in it whenever a script is ended. Every fault is in
the one program that is built; TEDIT_MUTANT=NUMBER makes one act (mutant.hpp).
"""
import os
import pathlib
import shutil
import subprocess


def with_switch(text):
    """A source in which tedit::mutation::acts is known; it has one line more, at its first include."""
    before, first, after = text.partition("#include")
    return f'{before}#include "tests/mutation/mutant.hpp"\n{first}{after}'


def copy_sources(tree, copy, changed):
    """The sources of `tree` in `copy`, with the text of `changed` (path: text) in place of some.

    What is there already is left alone, as are builds: so only what differs is compiled again.
    """
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            cwd=tree, capture_output=True, text=True, check=True)
    names = {pathlib.Path(name) for name in listed.stdout.split("\0") if name and (tree / name).is_file()}
    for name in names:
        wanted = changed[name].encode() if name in changed else (tree / name).read_bytes()
        target = copy / name
        if not target.exists() or target.read_bytes() != wanted:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(wanted)
            shutil.copymode(tree / name, target)
    for folder, inside, files in os.walk(copy):
        if pathlib.Path(folder) == copy and "build" in inside:
            inside.remove("build")
        for name in files:
            if pathlib.Path(folder, name).relative_to(copy) not in names:
                os.remove(os.path.join(folder, name))


def configure(copy):
    """Sets up the copy's build and returns its folder: named and set as ever, so that a compiler cache helps."""
    subprocess.run(["cmake", "--preset", "ci", "-DTEDIT_DESKTOP=OFF", "-DTEDIT_RENDER=OFF"], cwd=copy, check=True,
                   stdout=subprocess.DEVNULL)
    return copy / "build" / "release"


def build(folder, targets):
    """What ninja says where it fails, else nothing."""
    done = subprocess.run(["ninja", "-C", folder, "-j2", "-k0", *targets], capture_output=True, text=True)
    return done.stdout if done.returncode != 0 else ""
