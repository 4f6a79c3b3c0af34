"""Area and enclosed volume of a map's surface as `nacre export --stats` tells them, beside numpy's: the volume as a count on
a finer grid, the area as the integral of the gradient's length over a thin shell of levels (coarea formula). skimage's
marching cubes judge, too, where they are installed.
area_and_volume.py NACRE"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

try:
    import mrcfile
    import numpy as np
except ImportError:
    test_data.cannot_judge("python3-mrcfile or python3-numpy is not installed")
try:
    from skimage import measure
except ImportError:
    measure = None

NACRE = sys.argv[1]
STEP = np.array([0.8, 1.0, 1.25])  # Å along x, y, z
SIZE = np.array([60, 52, 44])
random = np.random.default_rng(3)
PLACES = (random.uniform(0.35, 0.65, (12, 3)) * SIZE * STEP)
WIDTH = 3.0


def density(nodes):
    """Of places in nodes: (n, 3)."""
    total = np.zeros(len(nodes))
    for place in PLACES:
        total += np.exp(-(((nodes * STEP) - place) ** 2).sum(axis=1) / (2 * WIDTH ** 2))
    return total


def grid(fine):
    axes = [np.arange(0, n - 1 + 1e-9, 1 / fine) for n in SIZE]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    return density(nodes.reshape(-1, 3)).reshape(nodes.shape[:3])


fine, factor = grid(3), 3
gradient = np.sqrt(sum(g ** 2 for g in np.gradient(fine, *(STEP / factor))))
cell = STEP.prod() / factor ** 3
faults = []


def parts_of(values, step, level):
    """Of the surface at a level, as the program exports it."""
    with tempfile.TemporaryDirectory() as folder:
        path, stats = os.path.join(folder, "blobs.mrc"), os.path.join(folder, "stats.json")
        with mrcfile.new(path) as mrc:
            mrc.set_data(np.ascontiguousarray(values.transpose(2, 1, 0)))
            mrc.voxel_size = tuple(step)
        done = subprocess.run([NACRE, "export", "sample:glucose", "--map", path, "--map-level", str(level), "--hide", "all",
                               "-o", os.path.join(folder, "a.obj"), "--stats", stats, "--cache", "off"],
                              capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr)
        with open(stats) as file:
            return json.load(file)["parts"]


# Straight lines between nodes cut off what is round: the error is of the second order in the grid's step. At half the step
# it has to be a quarter.
for level in (0.6, 1.0, 1.6):
    shell = 0.15 * level  # whose levels count the less the farther: a sharp edge counts nodes by chance
    weight = np.clip(1 - np.abs(fine - level) / shell, 0, None) / shell
    wanted = {"volume": (fine > level).sum() * cell, "area": (gradient * weight).sum() * cell}
    for refined, most in ((1, 0.03), (2, 0.0075)):
        values = grid(refined).astype("f4")  # x, y, z
        parts = parts_of(values, STEP / refined, level)
        if len(parts) != 1:
            faults.append(f"level {level}: {len(parts)} parts")
            continue
        for key, value in wanted.items():
            error = parts[0][key] / value - 1
            print(f"level {level}, step 1/{refined}: {key} {parts[0][key]:.2f}, numpy {value:.2f}, {100 * error:.2f} %")
            if abs(error) > most:
                faults.append(f"level {level}, step 1/{refined}: {key} {parts[0][key]} instead of {value}")
        if measure:
            places, triangles, _, _ = measure.marching_cubes(values, level, spacing=tuple(STEP / refined))
            area = measure.mesh_surface_area(places, triangles)
            print(f"level {level}: area {parts[0]['area']:.2f}, skimage {area:.2f}")
            if abs(parts[0]["area"] / area - 1) > 0.005:
                faults.append(f"level {level}: area {parts[0]['area']}, skimage {area}")

for fault in faults:
    print(fault)
sys.exit(bool(faults))
