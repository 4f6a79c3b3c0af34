#!/usr/bin/env python3
"""Counts the fragments that a frame of 4HHB shades by each shape of plates and impostors, for tools/tilers_costs.py.

usage: tests/benchmark/count_fragments.py BENCHMARK > docs/tilers_fragments.json

BENCHMARK is shape_benchmark, built by the preset `benchmark`.
"""

import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

SIZES = (64, 128, 192, 256, 320, 400, 480, 640, 960)
MEAN_RADIUS, SCENE_RADIUS = 1.72, 37.2  # of 4HHB, angstroms


def main():
    benches = json.loads(subprocess.run([sys.argv[1], test_data.needed_folder() / "4hhb.pdb", *(f"{size}x{size}" for size in SIZES)],
                                        check=True, capture_output=True, text=True).stdout)
    frames = [{"pixels": size, "radius": round(size * 0.95 / 2 / SCENE_RADIUS * MEAN_RADIUS, 1),
               "shapes": [{"plates": s["plates"], "impostor": s["impostor"],
                           "fragments": {p["name"]: p["shaded_fragments"] for p in s["passes"]}} for s in bench["shapes"]]}
              for size, bench in zip(SIZES, benches)]
    print(json.dumps({"file": "4hhb.pdb", "spheres": benches[0]["atoms"], "frames": frames}))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
