#!/usr/bin/env python3
"""What plates and impostors of each shape cost on tilers by the size of spheres: docs/tilers.md has the table.

usage: NACRE_DATA=FOLDER tests/benchmark/shape_costs.py BENCHMARK

BENCHMARK is shape_benchmark, built by the preset `benchmark`. Instructions as docs/tilers.json has them of each stage, times the vertices of 4HHB's spheres and the fragments that a
software device counts by each shape. GPUs that bin vertices run them twice; to those that store varyings a byte,
written and read, counts as twenty instructions (at 100 pJ a byte and 10 an instruction).
"""

import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = os.environ.get("NACRE_DATA", "../shared/data")
DEVICES = {"Adreno 618": False, "Adreno 740": False, "V3D 4.2": False, "V3D 7.1": False, "Mali-G52": True, "Mali-G610": True}
SIZES = (64, 128, 192, 256, 320, 480, 640, 960)
SHAPES = (("square", "square"), ("octagon", "square"), ("octagon", "octagon"), ("dome of 3", "pyramid"))
CORNERS = {"square": 4, "octagon": 8, "dome of 3": 24, "pyramid": 9}
BYTES = {"opaque prepass": 16, "depth encoding": 32, "impostor colour": 52}
MEAN_RADIUS, SCENE_RADIUS = 1.72, 37.2  # of 4HHB, angstroms


def cost(pipelines, shape, spheres, stores):
    """Million instructions of a frame."""
    total = 0
    for one in shape["passes"]:
        corners = spheres * CORNERS[shape["plates" if one["name"] == "opaque prepass" else "impostor"]]
        vertex, fragment = (pipelines[f"{one['name']}, spheres, {s}"]["instructions"] for s in ("vertex", "fragment"))
        total += corners * vertex + one["shaded_fragments"] * fragment
        if stores:
            total += 20 * BYTES[one["name"]] * corners
        else:  # positions alone, as those of the encoding
            total += corners * min(vertex, pipelines["depth encoding, spheres, vertex"]["instructions"])
    return total / 1e6


def main():
    kept = json.loads((ROOT / "docs/tilers.json").read_text())
    print("| device | radius, pixels |" + "".join(f" {p}, {i} |" for p, i in SHAPES))
    print("|---" * (2 + len(SHAPES)) + "|")
    benches = json.loads(subprocess.run([sys.argv[1], f"{DATA}/4hhb.pdb", *(f"{size}x{size}" for size in SIZES)],
                                        check=True, capture_output=True, text=True).stdout)
    for size, bench in zip(SIZES, benches):
        shapes = {(s["plates"], s["impostor"]): s for s in bench["shapes"]}
        radius = size * 0.95 / 2 / SCENE_RADIUS * MEAN_RADIUS
        for device, stores in DEVICES.items():
            pipelines = kept[device]["paths"]["encoded"]["pipelines"]
            costs = [cost(pipelines, shapes[s], bench["atoms"], stores) for s in SHAPES]
            print(f"| {device} | {radius:.1f} |" + "".join(f" {c:.1f} |" for c in costs))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
