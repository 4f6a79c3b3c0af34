#!/usr/bin/env python3
"""The examples of docs/batch do what they say: batch_examples_test.py SOURCE_FOLDER PROGRAM STRUCTURES."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAM, STRUCTURES = (pathlib.Path(a) for a in sys.argv[1:4])
EXAMPLES = SOURCE / "docs/batch"
NAMES = ["dna", "glucose", "buckyball"]


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-examples-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "structures").mkdir()
        self.structures = []
        for name in NAMES:
            found = sorted(STRUCTURES.glob(f"**/{name}*.pdb"))
            self.assertTrue(found, f"no {name}*.pdb in {STRUCTURES}")
            self.structures.append(f"structures/{name}.pdb")
            shutil.copy(found[0], self.folder / self.structures[-1])
        # What the examples draw takes long on a loaded machine: this does, too, but smaller.
        wrapper = self.folder / "bin/nacre"
        wrapper.parent.mkdir()
        wrapper.write_text(f'#!/bin/sh\nexec "{PROGRAM}" "$@" --occlusion 4 --cache off\n')
        wrapper.chmod(0o755)

    def run_example(self, *command, **environment):
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True,
                             env=os.environ | {"PATH": path, "HOME": str(self.folder)} | environment)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        return run

    def statuses(self, *reports):
        lines = [line for report in reports for line in (self.folder / report).read_text().splitlines()]
        return sorted(json.loads(line)["status"] for line in lines)

    def check_pictures(self, folder, ending=".pdb.png"):
        for name in NAMES:
            self.assertEqual((self.folder / folder / f"{name}{ending}").read_bytes()[1:4], b"PNG")
        self.assertFalse(list((self.folder / folder).glob(".nacre-*")))

    @needs("parallel")
    def test_parallel(self):
        command = [EXAMPLES / "parallel.sh", "pictures", *self.structures]
        self.run_example(*command)
        self.check_pictures("pictures")
        self.assertEqual(self.statuses("pictures/report.jsonl"), ["done"] * 3)
        (self.folder / "pictures/dna.pdb.png").unlink()
        self.run_example(*command)
        self.check_pictures("pictures")
        self.assertEqual(self.statuses("pictures/report.jsonl"), ["done", "skipped", "skipped"])
        # One of another format has a picture of its own; two of one name have none.
        other = self.folder / "structures/dna.ent"
        shutil.copy(self.folder / self.structures[0], other)
        self.run_example(*command, "structures/dna.ent")
        self.assertTrue((self.folder / "pictures/dna.ent.png").exists())
        run = subprocess.run([*command, "other/dna.pdb"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr),
                         (2, "parallel.sh: other/dna.pdb and structures/dna.pdb would have one picture\n"))

    def test_slurm_array(self):
        """By the variables that Slurm sets for each task."""
        (self.folder / "pictures").mkdir()
        (self.folder / "jobs.jsonl").write_text("".join(
            json.dumps({"input": s, "output": f"pictures/{pathlib.Path(s).stem}.png", "size": "64x64"}) + "\n"
            for s in self.structures))
        for task in 1, 2:  # --array=1-2
            self.run_example(EXAMPLES / "slurm_array.sh", "jobs.jsonl", SLURM_ARRAY_TASK_COUNT="2",
                             SLURM_ARRAY_TASK_MIN="1", SLURM_ARRAY_TASK_MAX="2", SLURM_ARRAY_TASK_ID=str(task),
                             SLURM_CPUS_PER_TASK="2")
        self.check_pictures("pictures", ".png")
        self.assertEqual(self.statuses("jobs.1.report.jsonl", "jobs.2.report.jsonl"), ["done"] * 3)

    @needs("snakemake")
    def test_snakemake(self):
        command = ["snakemake", "--snakefile", EXAMPLES / "Snakefile", "--cores", "2", "--config",
                   "structures=structures", "pictures=pictures", "batch=2"]
        self.run_example(*command)
        self.check_pictures("pictures")
        (self.folder / "pictures/glucose.pdb.png").unlink()
        again = self.run_example(*command)
        self.assertIn("1 of 2 steps", again.stderr)  # the other batch is whole
        self.check_pictures("pictures")
        self.assertIn("Nothing to be done", self.run_example(*command).stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
