#!/usr/bin/env python3
"""How far pictures of translucent space-filling atoms are from all layers in their exact order.

translucent_layers.py NACRE FILE.pdb [OPACITY...]    mean difference of linear light over covered pixels, white is 1

Casts a ray through each pixel's centre, and blends all spheres that it meets, in float64. Lighting and occlusion are
off, and the file has no alternate locations. Beside the picture's difference stands that of its nearest two layers alone.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import PIL.Image

RADII = {"C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8, "FE": 1.26, "P": 1.8}
COLORS = {"C": "#7f7f7f", "N": "#3050f8", "O": "#ff0d0d", "S": "#d8c010", "FE": "#e06633", "P": "#ff8000"}
SIZE = 256


def atoms(path):
    for line in open(path):
        if line[:6] in ("ATOM  ", "HETATM") and line[17:20] != "HOH":
            yield [float(line[i : i + 8]) for i in (30, 38, 46)], line[76:78].strip()


def linear(color):
    v = numpy.array([int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    return numpy.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def layers(file, view):
    """Colours of each pixel's layers from near to far, padded, and their number."""
    found = list(atoms(file))
    centers = numpy.array([a[0] for a in found])
    radii = numpy.array([RADII[a[1]] for a in found])
    colors = numpy.array([linear(COLORS[a[1]]) for a in found])
    centers -= view["center"]
    centers[:, :2] += view["pan"]
    scale = view["pixels_per_angstrom"]
    at = [[] for _ in range(SIZE * SIZE)]
    for i, (center, radius) in enumerate(zip(centers, radii)):
        x = numpy.arange(SIZE)
        across = (x + 0.5 - SIZE / 2) / scale - center[0]
        down = (SIZE / 2 - x - 0.5) / scale - center[1]
        high = radius**2 - down[:, None] ** 2 - across[None, :] ** 2
        for place in numpy.flatnonzero(high > 0):
            at[place].append((-center[2] - high.flat[place] ** 0.5, i))
    counts = numpy.array([len(pixel) for pixel in at])
    mixed = numpy.zeros((SIZE * SIZE, counts.max(), 3))
    for place, pixel in enumerate(at):
        for k, (_, i) in enumerate(sorted(pixel)):
            mixed[place, k] = colors[i]
    return mixed, counts


def blend(colors, counts, opacity):
    """Over white."""
    light = numpy.ones((len(counts), 3))
    for k in reversed(range(colors.shape[1])):
        light = numpy.where((k < counts)[:, None], light + opacity * (colors[:, k] - light), light)
    return light


def picture(nacre, file, opacity):
    """Linear light of a picture, row by row, and its view."""
    with tempfile.TemporaryDirectory() as folder:
        raw, stats = pathlib.Path(folder) / "picture.png", pathlib.Path(folder) / "stats.json"
        command = [nacre, "render", file, "-o", str(raw), "--size", f"{SIZE}x{SIZE}", "--style", "spacefill"]
        command += ["--atom-opacity", str(opacity), "--supersample", "1", "--lighting", "off", "--occlusion", "off"]
        command += ["--stats", str(stats)]
        for element, color in COLORS.items():
            command += ["--color-by", f"elem {element}={color}"]
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
        coded = numpy.asarray(PIL.Image.open(raw).convert("RGB")).reshape(-1, 3) / 255
        light = numpy.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)
        return light, json.loads(stats.read_text())["view"]


def main(nacre, file, *opacities):
    colors, counts = layers(file, picture(nacre, file, "1")[1])
    covered = counts > 0
    print(f"{counts[covered].mean():.1f} layers per covered pixel")
    for opacity in opacities or ("0.25", "0.5", "0.75"):
        steps = round(float(opacity) * 128) / 128
        exact = blend(colors, counts, steps)[covered]
        ours = numpy.abs(picture(nacre, file, opacity)[0][covered] - exact)
        two = numpy.abs(blend(colors, numpy.minimum(counts, 2), steps)[covered] - exact)
        print(f"opacity {opacity}: {ours.mean():.4f}, 99 % of pixels below {numpy.quantile(ours.max(1), 0.99):.3f}; "
              f"two layers alone: {two.mean():.4f}")


main(*sys.argv[1:])
