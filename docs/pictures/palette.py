"""palette.py IN.png OUT.png: half the size, and a palette of at most 64 colours instead of all."""

import struct
import sys
import zlib

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def read(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
    pixels = pixels[: height // 2 * 2, : width // 2 * 2].astype(float)
    return (pixels[0::2, 0::2] + pixels[1::2, 0::2] + pixels[0::2, 1::2] + pixels[1::2, 1::2]) / 4


def palette_of(pixels, colours):
    """Cuts the box with the widest spread at its middle until there are enough."""
    boxes = [pixels.reshape(-1, 3)]
    while len(boxes) < colours:
        spread = [0 if len(b) < 2 else numpy.ptp(b, axis=0).max() * len(b) ** 0.25 for b in boxes]
        box = boxes.pop(int(numpy.argmax(spread)))
        axis = int(numpy.argmax(numpy.ptp(box, axis=0)))
        low = box[:, axis] < (box[:, axis].min() + box[:, axis].max()) / 2
        boxes += [b for b in (box[low], box[~low]) if len(b)]
    return numpy.array([b.mean(axis=0) for b in boxes])


def write(path, indices, palette):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + row.tobytes() for row in indices.astype(numpy.uint8))
    header = struct.pack(">IIBBBBB", indices.shape[1], indices.shape[0], 8, 3, 0, 0, 0)
    colours = numpy.rint(palette).astype(numpy.uint8).tobytes()
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", colours))
        out.write(chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    pixels = read(sys.argv[1])
    palette = palette_of(pixels, 64)
    flat = pixels.reshape(-1, 3)
    nearest = numpy.concatenate(
        [numpy.argmin(((part[:, None] - palette) ** 2).sum(axis=2), axis=1) for part in numpy.array_split(flat, 64)]
    )
    write(sys.argv[2], nearest.reshape(pixels.shape[:2]), palette)


if __name__ == "__main__":
    main()
