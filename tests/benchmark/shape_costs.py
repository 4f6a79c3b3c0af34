#!/usr/bin/env python3
"""What plates and impostors of each shape cost on tilers by the size of spheres: docs/tilers.md has the table.

usage: NACRE_DATA=FOLDER tests/benchmark/shape_costs.py BENCHMARK

BENCHMARK is shape_benchmark, built by the preset `benchmark`. Instructions as docs/tilers.json has them of each stage, times the vertices of 4HHB's spheres and the fragments that a
software device counts by each shape; then what each path costs Mali by Arm's driver. GPUs that bin vertices run them twice; to those that store varyings a byte,
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
        blending = pipelines.get(f"{one['name']}, blending, fragment", {"instructions": 0})["instructions"]
        total += one["shaded_fragments"] * blending
        if stores:
            total += 20 * BYTES[one["name"]] * corners
        else:  # positions alone, as those of the encoding
            total += corners * min(vertex, pipelines["depth encoding, spheres, vertex"]["instructions"])
    return total / 1e6


# Path of the table, and its passes: by early tests against plates, or late and without them.
ARM_PATHS = {"encoded, RGBA16F": ("encoded, RGBA16F", ("opaque prepass", "depth encoding", "impostor colour"), True),
             "encoded": ("encoded", ("opaque prepass", "depth encoding", "impostor colour"), True),
             "raster-order": ("raster-order", ("opaque prepass", "impostor colour"), True),
             "fragdepth, early": ("fragdepth", ("opaque prepass", "impostor colour"), True),
             "fragdepth, late": ("fragdepth", ("impostor colour",), False)}


def path_costs(kept, benches):
    print("\n| device | radius, pixels |" + "".join(f" {p} |" for p in ARM_PATHS))
    print("|---" * (2 + len(ARM_PATHS)) + "|")
    for device in ("Mali-G52, Arm's driver", "Mali-G610, Arm's driver"):
        for size, bench in benches:
            radius = size * 0.95 / 2 / SCENE_RADIUS * MEAN_RADIUS
            # As GPUs that store varyings are drawn.
            plates, impostor = "square" if radius < 9 else "octagon", "square"
            line = f"| {device} | {radius:.1f} |"
            for path, passes, early in ARM_PATHS.values():
                pipelines = kept[device]["paths"][path]["pipelines"]
                shape = next(s for s in bench["shapes"]
                             if (s["plates"], s["impostor"]) == (plates if early else "off", impostor))
                drawn = {**shape, "plates": plates, "passes": [p for p in shape["passes"] if p["name"] in passes]}
                line += f" {cost(pipelines, drawn, bench['atoms'], True):.1f} |"
            print(line)


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
    path_costs(kept, list(zip(SIZES, benches)))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
