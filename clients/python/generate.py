#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes the messages of the protocol, tedit/v1, from its .proto files.

usage: generate.py PROTOCOL FOLDER

PROTOCOL is the folder that has tedit/v1/*.proto; FOLDER/tedit/v1 is made. Needs protoc (Debian: protobuf-compiler).
"""
import pathlib
import re
import subprocess
import sys


def protocol_version(protocol):
    """What a client says in Hello, as the comments of its fields have it."""
    text = (protocol / "tedit/v1/envelope.proto").read_text(encoding="utf-8")
    found = [re.search(rf"uint32 protocol_{part} = \d+;\s*// (\d+)\.", text) for part in ("major", "minor")]
    if None in found:
        sys.exit("envelope.proto does not say the protocol's version beside Hello.protocol_major and protocol_minor")
    return [int(number.group(1)) for number in found if number]


def generate(protocol, folder):
    made = folder / "tedit/v1"
    made.mkdir(parents=True, exist_ok=True)
    files = sorted(str(file.relative_to(protocol)) for file in (protocol / "tedit/v1").glob("*.proto"))
    subprocess.run(["protoc", "-I", str(protocol), f"--python_out={folder}", f"--pyi_out={folder}", *files], check=True)
    major, minor = protocol_version(protocol)
    (made / "__init__.py").write_text('"""Messages of the protocol; generated."""\n', encoding="utf-8")
    (made / "protocol_version.py").write_text(f"MAJOR = {major}\nMINOR = {minor}\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    generate(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
