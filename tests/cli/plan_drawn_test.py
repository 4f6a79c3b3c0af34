#!/usr/bin/env python3
"""What `nacre plan` says of a frame is what `nacre render` draws: plan_drawn_test.py PROGRAM."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]

PATHS = ["auto", "encoded", "fragdepth", "deferred", "raster-order", "tiles"]
LOOKS = {
    "plain": [],
    "sticks": ["--style", "ball-and-stick"],
    "outlines": ["--contours", "2"],
    "groups": ["--contours", "2", "--contour-weights", "3"],
    "halos": ["--halos", "4", "--shadow", "0.5"],
    "clipped": ["--clip", "0", "--style", "licorice"],
    "lens": ["--depth-of-field", "20"],
    "translucent": ["--style", "surface", "--surface-opacity", "0.5"],
    "translucent atoms": ["--style", "ball-and-stick", "--atom-opacity", "0.5"],
    "lines": ["--style", "lines"],
    "perspective": ["--projection", "perspective", "--fog", "auto"],
}


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)


class PlanAndPicture(unittest.TestCase):
    def compare(self, path, options, samples):
        common = ["sample:glucose", "--size", "64x48", "--visibility", path, *options]
        with tempfile.TemporaryDirectory() as folder:
            stats = pathlib.Path(folder, "stats.json")
            drawn = run("render", "-q", *common, "--supersample", samples, "--occlusion", "off", "--cache", "off", "-o",
                        str(pathlib.Path(folder, "a.png")), "--stats", str(stats))
            planned = run("plan", *common, "--supersample", samples, "--json")
            self.assertEqual(drawn.returncode, planned.returncode, drawn.stderr + planned.stderr)
            if drawn.returncode != 0:
                self.assertEqual(drawn.stderr, planned.stderr)
                return None
            picture, plan = json.loads(stats.read_text()), json.loads(planned.stdout)
        self.assertEqual(picture["choice"], plan["choice"])
        choice = plan["choice"]
        if not re.search("blocks|then|lens", choice["samples"]["is"] + choice["effects"]["is"]):  # else of the last frame
            passes = picture["geometry"]["passes"], (plan["geometry"] or {"passes": []})["passes"]
            self.assertEqual(*([p["name"] for p in side] for side in passes))
            if choice["host"]["is"] == "nothing":
                self.assertEqual(*passes)
            self.assertEqual(picture["tile_bytes_per_pixel"], plan["tile_bytes_per_pixel"])
        return choice

    def test_every_path_and_look(self):
        met = set()
        cases = [(path, "plain", samples) for path in PATHS for samples in ["auto", "1"]]
        cases += [(path, look, "auto") for path in ["auto", "encoded"] for look in LOOKS]
        for path, look, samples in cases:
            with self.subTest(path=path, look=look, samples=samples):
                choice = self.compare(path, LOOKS[look], samples)
                if choice:
                    met.add((choice["path"]["is"], choice["samples"]["is"]))
        # The list meets all paths that a software device has, and each way to have samples.
        self.assertGreaterEqual({path for path, _ in met}, {"encoded", "fragdepth", "deferred", "tiles"})
        self.assertGreaterEqual(len({samples for _, samples in met}), 4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
