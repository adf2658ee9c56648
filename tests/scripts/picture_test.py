#!/usr/bin/env python3
"""usage: picture_test.py TEDIT_BIN PART.msh LOAD_CASE.json: pictures of a tall part, from all sides: heading and small
print stand on bare ground, and the part is whole."""
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib


def rows_of(png):
    """The picture's rows, each a list of (red, green, blue)."""
    data = png.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", data[at + 8:at + 18])
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    assert depth == 8 and colours in (2, 6), (depth, colours)
    step = 3 if colours == 2 else 4
    raw, before, rows = zlib.decompress(packed), bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(raw[start + 1:start + 1 + width * step])
        for i, value in enumerate(row):
            left = row[i - step] if i >= step else 0
            up = before[i]
            corner = before[i - step] if i >= step else 0
            row[i] = (value + (0, left, up, (left + up) // 2, paeth(left, up, corner))[raw[start]]) & 255
        rows.append([tuple(row[x:x + 3]) for x in range(0, width * step, step)])
        before = row
    return rows


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def is_bare(row):
    """The ground's colour changes from row to row only."""
    return all(max(abs(a - b) for a, b in zip(pixel, row[0])) <= 2 for pixel in row)


def main():
    folder, part, loads = sys.argv[1:]
    tedit = folder + "/tedit"
    with tempfile.TemporaryDirectory() as work:
        field = work + "/field.vtu"
        subprocess.run([tedit, "solve", part, "--load-case", loads, "--order", "1", "--device", "cpu", "-o", field],
                       check=True, stdout=subprocess.DEVNULL)
        faults = []
        for view in ("iso", "x", "-y", "z"):
            picture = pathlib.Path(work, view + ".png")
            subprocess.run([tedit, "render", field, "-o", str(picture), "--view", view, "--size", "480x300",
                            "--title", "T", "--caption", "c"], check=True)
            rows = rows_of(picture)
            # Right of the texts, which are one letter each, and left of the legend.
            middle = [is_bare(row[48:430]) for row in rows]
            if not all(middle[:20]) or not all(middle[-20:]):
                faults.append(f"{view}: the part runs over heading or small print")
            if sum(not bare for bare in middle) < 60:
                faults.append(f"{view}: there is no part to be seen")
        print("\n".join(faults) or "4 pictures")
        return 1 if faults else 0


sys.exit(main())
