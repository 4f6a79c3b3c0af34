#!/usr/bin/env python3
"""Counts and bytes that a page states are those that its command prints: figures_test.py SOURCE_FOLDER PROGRAM.

Figures of files of the test data are skipped without the data. Times are never judged.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]


def run(*words):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    assert done.returncode == 0, f"{words}: {done.stderr}"
    return done.stdout


def stats(folder, *words):
    return json.loads(run("render", *words, "-o", f"{folder}/a.png", "--style", "spacefill", "--occlusion", "off",
                          "--cache", "off", "--stats", "-"))


def page(name):
    return (SOURCE / "docs" / name).read_text()


class Figures(unittest.TestCase):
    def file(self, name):
        if not test_data.folder():
            self.skipTest(test_data.ABSENT)
        return test_data.folder() / name

    def says(self, name, text):
        self.assertIn(text, " ".join(page(name).split()), f"docs/{name} says something else")

    def test_translucent_layers_cost_bytes_per_pixel(self):
        costs = {}
        for opacity in ("1", "0.5"):
            plan = json.loads(run("plan", "sample:dna", "--style", "surface", "--surface-opacity", opacity,
                                  "--caps", "mali", "--json"))
            costs[opacity] = plan["memory_bytes"]["loaded"] + plan["memory_bytes"]["stored"]
            pixels = plan["size"][0] * plan["size"][1]
        self.says("pictures.md", f"{(costs['0.5'] - costs['1']) // pixels} bytes per pixel that leave the tile")

    def test_a_capture_lists_what_the_page_shows(self):
        if not shutil.which("renderdoccmd"):
            self.skipTest("RenderDoc is not installed")
        with tempfile.TemporaryDirectory() as folder:
            example = re.search(r"nacre (render .*?)-o \S+ (.*?) --capture", page("inspecting.md"))
            run(*example[1].split(), "-o", f"{folder}/a.png", *example[2].split(), "--capture", f"{folder}/a.rdc", "--cache", "off")
            listed = subprocess.run([SOURCE / "tools/inspect", f"{folder}/a.rdc"], capture_output=True, text=True, check=True).stdout
        shown = re.search(r"^```\n(submission.*?)^```", page("inspecting.md"), re.MULTILINE | re.DOTALL)[1]
        self.assertEqual(listed[listed.rindex("submission"):], shown)

    def test_drawn_atoms(self):
        for name, file in (("1BNA", "1bna.pdb"), ("4HHB", "4hhb.cif.gz"), ("1AON", "1aon-groel.pdb.gz"), ("the neon pump", "neon-pump.pdb")):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                self.says("measurements.md", f"{stats(folder, self.file(file), '--size', '16x16')['atoms']['drawn']:,} of {name}")

    def test_triangles(self):
        def levels(file, style, error):
            plan = run("plan", self.file(file), "--style", style, "--mesh-error", error, "--size", "640x960", "--json")
            return json.loads(plan)["mesh_levels"]
        for row, file, style in (("4HHB, cartoon", "4hhb.cif.gz", "cartoon"), ("4HHB, surface", "4hhb.cif.gz", "surface"),
                                 ("4V5A, cartoon", "4v5a-ribosome.mmtf", "cartoon")):
            with self.subTest(row):
                found = levels(file, style, "0.5")
                drawn, all_of_them = sum(level["drawn"] for level in found), found[0]["triangles"]
                self.says("measurements.md", f"| {row} | {drawn:,} | {all_of_them:,} |")
        with self.subTest("by error"):
            drawn = [sum(level["drawn"] for level in levels("4v5a-ribosome.mmtf", "cartoon", error)) for error in ("1", "0.25")]
            self.says("measurements.md", f"4V5A has {drawn[0]:,} triangles, with a quarter {drawn[1]:,}")

    def plan_on_mali(self, file, style, path):
        return json.loads(run("plan", self.file(file), "--caps", "mali", "--size", "1170x2532", "--style", style,
                              "--visibility", path, "--json"))

    def test_a_frame_on_mali(self):
        stages = json.loads(page("tilers.json"))["Mali-G610, Arm's driver"]["paths"]["encoded"]["pipelines"]
        drawn = {"opaque prepass": "spheres", "depth encoding": "spheres", "impostor colour": "fetched spheres"}
        each = {name: stages[f"{name}, {kind}, vertex"]["instructions"] for name, kind in drawn.items()}
        for name, file in (("4HHB", "4hhb.cif.gz"), ("1AON", "1aon-groel.pdb.gz"), ("4V5A", "4v5a-ribosome.mmtf")):
            for path in ("raster-order", "encoded"):
                with self.subTest(name, path=path):
                    plan = self.plan_on_mali(file, "spacefill", path)
                    geometry, stored = plan["geometry"], plan["memory_bytes"]["stored"]
                    instructions = sum(each[p["name"]] * p["vertices"] for p in geometry["passes"]) / 1e6
                    milliwatts = (2 * geometry["varying_bytes"] + stored) * 60 / 1e9 * 100
                    self.says("tilers.md", f"| {name} | `{path}` | {geometry['vertices']:,} | {geometry['varying_bytes']:,} | "
                                           f"{stored:,} | {instructions:.1f} | {milliwatts:.0f} |")

    def test_large_scenes_on_mali(self):
        for style, path, more in (("cartoon", "raster-order", 0), ("cartoon", "encoded", 8), ("surface", "encoded", 8)):
            with self.subTest(style, path=path):
                plan = self.plan_on_mali("1aon-groel.pdb.gz", style, path)
                each = " and ".join(f"{size:,}" for size in plan["vertex_bytes"]["render_passes"])
                added = plan["vertex_bytes"]["loaded_for_limit"] // (1170 * 2532)
                self.assertEqual(added, more)
                self.says("tilers.md", f"{each} | {f'{more}, {more} B per pixel' if more else 0} |")

    def test_a_window_at_rest(self):
        pixels = 1170 * 2532
        for caps, row in (("mali", "`mali`, `mali-late` | 20, 16 B"), ("adreno", "`adreno` | 20, 16 B"),
                          ("turnip", "`turnip` | 20, 16 B"), ("powervr", "`mali-old`, `powervr` | 20, 16 B"),
                          ("v3dv", "`apple-moltenvk`, `adreno-no-subpass`, `no-subpass`, `v3dv` | 20, 16 B")):
            with self.subTest(caps):
                rest = json.loads(run("plan", "--caps", caps, "--size", "1170x2532", "--json"))["rest"]
                now = ", ".join(str(rest["memory_bytes"][way] // pixels) for way in ("loaded", "stored"))
                now = "the same" if now == "20, 16" else f"{now} B"
                self.says("tilers.md", f"| {row} | {now} | {rest['render_passes']} | {rest['tile_bytes_per_pixel']} B |")

    def test_a_capsid_of_copies(self):
        with tempfile.TemporaryDirectory() as folder:
            told = stats(folder, self.file("3j6r-hpv16.pdb.gz"), "--assembly", "1", "--size", "256x256")
        self.says("robustness.md", f"3J6R's {told['atoms']['copies']} copies ({told['atoms']['drawn']:,} atoms) take "
                                   f"{round(told['memory']['device'] / 1e6)} MB of device memory at 256 x 256")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
