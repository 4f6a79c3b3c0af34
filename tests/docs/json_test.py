#!/usr/bin/python3
"""docs/json.md names the keys of every JSON output, and no others: json_test.py SOURCE_FOLDER PROGRAM"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop()
SOURCE = pathlib.Path(sys.argv.pop())
PAGE = (SOURCE / "docs/json.md").read_text()
SMALL = ["--size", "48x32", "--occlusion", "8", "--cache", "off", "-q"]
# Objects whose keys are names, or that the page explains once in words or elsewhere.
CLOSED = re.compile(r"(.*\.)?(ligands|ions|chain_names|component_names|angles)$|interactions\.(b|waters)$|"
                    r"interaction_frequencies\.[ab]$|choice\.\w+$|.*\b(frame|processor|frame_processor)$|paths\.passes\.ms$|"
                    r"paths\.geometry$|passes\.(binning|shading)_bytes$|memory_bytes\.\w*(images|buffers)$|"
                    r"driver_feedback\.\w+$")
OF_PLAN = re.compile(r"(choice|geometry|mesh_levels|copy_levels)$")  # those of --stats


def documented(title):
    """Keys that the section's tables name."""
    section = re.search(rf"^## {title}\n(.*?)(?=^## |\Z)", PAGE, re.M | re.S).group(1)
    cells = [row.split("|")[1] for row in section.splitlines() if row.startswith("| `")]
    return {key for cell in cells for key in re.findall(r"`([^`]+)`", cell)}


def keys_of(value, prefix="", closed=CLOSED):
    """Keys of an output with what stands before them; lists leave no trace."""
    found = set()
    for entry in value if isinstance(value, list) else []:
        found |= keys_of(entry, prefix, closed)
    for key, inner in value.items() if isinstance(value, dict) else []:
        path = prefix + key
        found |= {path} | (set() if closed.match(path) else keys_of(inner, path + ".", closed))
    return found


def whole(keys):
    """With the objects that hold them."""
    return {".".join(key.split(".")[:n]) for key in keys for n in range(1, key.count(".") + 2)}


class Keys(unittest.TestCase):
    def run_in(self, folder, *words):
        return subprocess.run([PROGRAM, *words], cwd=folder, check=True, capture_output=True, text=True).stdout

    def compare(self, title, outputs, closed=CLOSED):
        found = set().union(*(keys_of(output, closed=closed) for output in outputs))
        named = documented(title)
        self.assertFalse(found - whole(named), "not on the page")
        self.assertFalse(named - found, "on the page, but in no output")

    def test_info(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "a.cube").write_text(
                "a\nb\n 1 0 0 0\n 2 1 0 0\n 2 0 1 0\n 2 0 0 1\n 6 6 0 0 0\n 1 2 3 4 5 6 7 8\n")
            pathlib.Path(folder, "two.pdb").write_text(
                "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n" + "".join(
                    f"REMARK 350   BIOMT{i + 1}   1 {' '.join('1.000000' if i == j else '0.000000' for j in range(3))}        0.00000\n"
                    for i in range(3)) + "ATOM      1  C   ALA A   1       0.000   0.000   0.000\nEND\n")
            outputs = [json.loads(self.run_in(folder, "info", *words, "--json")) for words in (
                ["sample:dna", "two.pdb"], ["a.cube"], ["sample:dna", "--residues"],
                ["sample:dna", "--interactions", "chain A"], ["sample:dna", "--interactions", "chain A", "--frequencies"])]
            for output in outputs:
                self.assertIsInstance(output, list)
            entries = [entry for output in outputs[:2] for entry in output]
            self.assertEqual(len({tuple(entry) for entry in entries}), 1, "every entry has the same keys")
            self.compare("info", outputs)

    def test_stats(self):
        with tempfile.TemporaryDirectory() as folder:
            def stats(*words):
                self.run_in(folder, "render", *words, "-o", "a.png", "--stats", "s.json", *SMALL)
                return json.loads(pathlib.Path(folder, "s.json").read_text())
            outputs = [stats("sample:dna", "--style", "cartoon", "--visibility", "fragdepth", "--supersample", "1"), stats("sample:dna", "--zoom-to", "chain A and resi 3", "--stereo", "left")]
            outputs.append(stats("sample:dna", "--stereo", "side-by-side"))
            for output in outputs[1:]:
                self.assertEqual(set(outputs[0]), set(output))
                self.assertEqual(set(outputs[0]["choice"]), set(output["choice"]))
            # Copies that are far away have levels; no sample does.
            outputs.append({"atoms": {"levels": [{"error": 0, "copies": 0, "spheres": 0}]}})
            self.compare("render --stats", outputs)

    def test_bench(self):
        with tempfile.TemporaryDirectory() as folder:
            said = json.loads(self.run_in(folder, "bench", "sample:glucose", "--frames", "1", "--json", "--size", "48x32"))
            if not said["lacks"]:
                said["lacks"] = [{"visibility": "", "why": ""}]
            self.compare("bench", [said])

    def test_plan(self):
        with tempfile.TemporaryDirectory() as folder:
            plans = [json.loads(self.run_in(folder, "plan", *words, "--json")) for words in (
                ["sample:dna", "--caps", "mali"], ["--caps", "mali", "--shadow", "0.5"], ["sample:dna", "--style", "cartoon"],
                ["--device", "0", "--visibility", "tiles"])]
            self.assertEqual(len({tuple(plan) for plan in plans}), 1)
            self.compare("plan", plans, re.compile(f"{CLOSED.pattern}|{OF_PLAN.pattern}"))


if __name__ == "__main__":
    unittest.main()
