#!/usr/bin/env python3
"""Counts vertices, fragments and their instructions of a phone's frame, for the table of docs/tilers.md.

usage: tests/benchmark/count_screens.py PROGRAM LAYER FILE...

PROGRAM is nacre, LAYER the folder of the phone layer's manifest (build/test/tests/phone_layer), FILE a structure. A software
device draws each in the guise of a Mali, 1170 x 2532; instructions are those of Mali-G610 in docs/tilers.json.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEVICE = "Mali-G610, Arm's driver"
PATHS = ("raster-order", "encoded", "fragdepth")
DRAWING = "--size 1170x2532 --zoom 1 --style spacefill --occlusion off --supersample 1 --cache off --stats - -o".split()


def instructions(pipelines, name, stage):
    kind = "fetched spheres" if f"{name}, fetched spheres, {stage}" in pipelines else "spheres"
    return pipelines[f"{name}, {kind}, {stage}"]["instructions"]


def row(program, layer, file, path, picture):
    env = dict(os.environ, VK_LAYER_PATH=layer, VK_INSTANCE_LAYERS="VK_LAYER_NACRE_phone", NACRE_PHONE="mali")
    stats = json.loads(subprocess.run([program, "render", file, "--visibility", path, *DRAWING, picture], env=env,
                                      check=True, capture_output=True, text=True).stdout)
    pipelines = json.loads((ROOT / "docs/tilers.json").read_text())[DEVICE]["paths"][path]["pipelines"]
    vertices = sum(p["vertices"] * instructions(pipelines, p["name"], "vertex") for p in stats["geometry"]["passes"])
    shaded = {p["name"]: p["shaded_fragments"] for p in stats["passes"] if p["shaded_fragments"] is not None}
    fragments = sum(count * instructions(pipelines, name, "fragment") for name, count in shaded.items())
    return [pathlib.Path(file).name, path, stats["geometry"]["vertices"], stats["geometry"]["varying_bytes"],
            round(vertices / 1e6, 1), shaded, round(fragments / 1e6, 1)]


def main():
    program, layer, *files = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            for path in PATHS:
                print(*row(program, layer, file, path, folder + "/screen.png"), sep=" | ", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main()
