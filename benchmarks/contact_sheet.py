#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Lay pictures of one size out in rows: contact_sheet.py -o sheet.png --columns 5 first.png second.png ...

Reads what `counterpart render` writes: PNG of 8 bits per channel, red, green, blue. Needs nothing but Python.
"""

import argparse
import struct
import zlib
from pathlib import Path

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def unfiltered(kind: int, line: bytes, above: bytes) -> bytes:
    """One line of bytes, as it was before PNG's filter of this kind; `above` is the line above it."""
    result = bytearray(line)
    for i, value in enumerate(line):
        left, up, corner = (result[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
        if kind == 4:  # Paeth: whichever is nearest to left + up - corner
            far = (abs(up - corner), abs(left - corner), abs(left + up - 2 * corner))
            guess = (left, up, corner)[far.index(min(far))]
        else:
            guess = (0, left, up, (left + up) // 2)[kind]
        result[i] = (value + guess) & 255
    return bytes(result)


def read_png(file: Path) -> list[bytes]:
    """The lines of a picture, three bytes per pixel."""
    data = file.read_bytes()
    packed, at, width, height = b"", len(SIGNATURE), 0, 0
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at : at + 8])
        chunk = data[at + 8 : at + 8 + length]
        if name == b"IHDR":
            width, height, *kind = struct.unpack(">IIBBBBB", chunk)
            if kind != [8, 2, 0, 0, 0]:
                raise SystemExit(f"{file}: not 8 bits per channel, red, green, blue")
        elif name == b"IDAT":
            packed += chunk
        at += length + 12
    raw, stride, lines = zlib.decompress(packed), 3 * width, []
    for row in range(height):
        start = row * (stride + 1)
        above = lines[-1] if lines else bytes(stride)
        line = raw[start + 1 : start + 1 + stride]
        lines.append(line if raw[start] == 0 else unfiltered(raw[start], line, above))
    return lines


def write_png(lines: list[bytes], file: Path) -> None:
    """Write lines of three bytes per pixel."""

    def chunk(name: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    header = struct.pack(">IIBBBBB", len(lines[0]) // 3, len(lines), 8, 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + line for line in lines))
    file.write_bytes(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", body) + chunk(b"IEND", b""))


def contact_sheet(pictures: list[Path], columns: int, file: Path) -> None:
    """Write the pictures, all of one size, from left to right and down."""
    tiles = [read_png(picture) for picture in pictures]
    blank = [b"\xff" * len(line) for line in tiles[0]]
    lines: list[bytes] = []
    for first in range(0, len(tiles), columns):
        row = tiles[first : first + columns]
        row += [blank] * (columns - len(row))
        lines += [b"".join(tile[y] for tile in row) for y in range(len(blank))]
    write_png(lines, file)


def main() -> None:
    """Read the command line and write the sheet."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--columns", type=int, default=5)
    parser.add_argument("pictures", type=Path, nargs="+")
    arguments = parser.parse_args()
    contact_sheet(arguments.pictures, arguments.columns, arguments.output)


if __name__ == "__main__":
    main()
