"""Draws the icon of the iOS app as an asset catalog: draw_icon.py ANDROID_RES CATALOG. From the circles of Android's
vector, so that both apps have one icon. One picture of 1024 pixels, from which Xcode makes the other sizes; opaque, as the
App Store asks."""

import json
import pathlib
import re
import struct
import sys
import zlib

SIZE = 1024
SAMPLES = 4  # per pixel side
SHOWN = 72  # of the vector's 108 points: launchers crop the rest


def color(text):
    return tuple(bytes.fromhex(text.lstrip("#")))


def circles(vector):
    """(x, y, radius, colour) in the vector's order; its paths are circles that begin at their left end."""
    found = re.findall(r'fillColor="(#\w{6})" android:pathData="M([\d.]+),([\d.]+)a([\d.]+),', vector)
    return [(float(x) + float(r), float(y), float(r), color(c)) for c, x, y, r in found]


def picture(shapes, background):
    """Rows of RGB bytes, each pixel the mean of SAMPLES x SAMPLES."""
    scale, first = SHOWN / SIZE, (108 - SHOWN) / 2
    steps = [(i + 0.5) / SAMPLES for i in range(SAMPLES)]
    rows = []
    for j in range(SIZE):
        row = bytearray(bytes(background) * SIZE)
        y = first + (j + 0.5) * scale
        near = [s for s in shapes if abs(y - s[1]) < s[2] + scale]
        for i in range(SIZE) if near else ():
            x = first + (i + 0.5) * scale
            hits = [(s, ((x - s[0]) ** 2 + (y - s[1]) ** 2) ** 0.5 - s[2]) for s in near]
            hits = [(s, d) for s, d in hits if d < scale]
            if not hits:
                continue
            if hits[-1][1] < -scale:  # inside the frontmost shape
                row[3 * i:3 * i + 3] = bytes(hits[-1][0][3])
                continue
            total = [0, 0, 0]
            for dy in steps:
                for dx in steps:
                    at = (first + (i + dx) * scale, first + (j + dy) * scale)
                    seen = background
                    for (cx, cy, r, c), _ in hits:
                        if (at[0] - cx) ** 2 + (at[1] - cy) ** 2 < r * r:
                            seen = c
                    total = [t + s for t, s in zip(total, seen)]
            row[3 * i:3 * i + 3] = bytes(round(t / SAMPLES**2) for t in total)
        rows.append(b"\0" + bytes(row))
    return b"".join(rows)


def png(pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels, 9)) + chunk(b"IEND", b"")


def main():
    resources, catalog = map(pathlib.Path, sys.argv[1:])
    shapes = circles((resources / "drawable/icon_water.xml").read_text())
    background = color(re.search(r'name="icon_background">(#\w+)<', (resources / "values/colors.xml").read_text()).group(1))
    if not shapes:
        sys.exit("no circles in icon_water.xml")
    icon = catalog / "AppIcon.appiconset"
    icon.mkdir(parents=True, exist_ok=True)
    info = {"author": "xcode", "version": 1}
    image = {"filename": "icon.png", "idiom": "universal", "platform": "ios", "size": "1024x1024"}
    (catalog / "Contents.json").write_text(json.dumps({"info": info}))
    (icon / "Contents.json").write_text(json.dumps({"images": [image], "info": info}))
    (icon / "icon.png").write_bytes(png(picture(shapes, background)))


main()
