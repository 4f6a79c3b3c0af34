#!/usr/bin/env python3
"""Says by how much two PNG files of 8 bits a channel differ: compare_pictures.py A.png B.png"""

import struct
import sys
import zlib


def rows(path):
    """Width, channels, and the picture's rows as bytes."""
    data = open(path, "rb").read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        sys.exit(f"{path}: no PNG")
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += length + 12
    if depth != 8 or color not in (2, 6) or interlaced:
        sys.exit(f"{path}: not 8-bit RGB or RGBA")
    channels = 3 if color == 2 else 4
    flat, stride = zlib.decompress(packed), width * channels
    above, found = bytes(stride), []
    for y in range(height):
        start = y * (stride + 1)
        above = unfiltered(flat[start], bytearray(flat[start + 1:start + 1 + stride]), above, channels)
        found.append(above)
    return width, channels, found


def unfiltered(kind, row, above, channels):
    for x in range(len(row)):
        left = row[x - channels] if x >= channels else 0
        corner = above[x - channels] if x >= channels else 0
        up = above[x]
        if kind == 4:
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(guess - value))
        row[x] = (row[x] + (0, left, up, (left + up) // 2, nearest if kind == 4 else 0)[kind]) & 255
    return bytes(row)


def main():
    a, b = rows(sys.argv[1]), rows(sys.argv[2])
    if a[:2] != b[:2] or len(a[2]) != len(b[2]):
        sys.exit("the pictures differ in size or channels")
    steps = [abs(p - q) for one, other in zip(a[2], b[2]) for p, q in zip(one, other)]
    print(f"{sum(s > 0 for s in steps)} of {len(steps)} values differ, by at most {max(steps)} of 255")


if __name__ == "__main__":
    main()
