#!/usr/bin/env python3
"""The examples of docs/batch do what they say: batch_examples_test.py SOURCE_FOLDER PROGRAM STRUCTURES."""
import concurrent.futures
import contextlib
import gzip
import importlib.util
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
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

    def run_example(self, *command, stdin=None, **environment):
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, stdin=stdin,
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

    def make_many(self, count, path):
        """Structures that differ, by number -> the paths."""
        atoms = (self.folder / self.structures[1]).read_text().splitlines(True)
        paths = []
        for number in range(count):
            paths.append(self.folder / path(number))
            paths[-1].parent.mkdir(parents=True, exist_ok=True)
            paths[-1].write_text(f"TITLE     {number}\n" + "".join(atoms))
        return paths

    def check_once(self, reports, outputs):
        """Every picture is there, and none was drawn twice."""
        drawn = [line["output"] for report in reports for line in map(json.loads, report.read_text().splitlines())
                 if line["status"] == "done"]
        self.assertEqual(len(drawn), len(set(drawn)), "drawn twice")
        for output in outputs:
            self.assertEqual(output.read_bytes()[1:4], b"PNG")
        # One whose report was cut off is there all the same.
        self.assertGreater(len(drawn), len(outputs) - 10)

    def interrupt(self, command, pictures, enough, **more):
        """Kills an example and all that it started once some pictures are there."""
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        run = subprocess.Popen(command, cwd=self.folder, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env=os.environ | {"PATH": path, "HOME": str(self.folder)}, **more)
        while run.poll() is None and sum(1 for _ in pictures()) < enough:
            time.sleep(0.02)
        self.assertIsNone(run.poll(), "it was done before it could be interrupted")
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        with contextlib.suppress(ProcessLookupError):  # what it started ends a moment later, and holds the lock until then
            while True:
                os.killpg(run.pid, 0)
                time.sleep(0.02)

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "python3-distributed is not installed")
    def test_dask(self):
        count = 2000 if os.environ.get("NACRE_LONG_TESTS") else 200
        (self.folder / "bin/nacre").write_text(
            f'#!/bin/sh\nexec "{PROGRAM}" "$@" --size 32x32 --occlusion off --cache off --model 1\n')
        paths = self.make_many(count, lambda number: f"many/{number:04}.pdb")
        out = self.folder / "out"
        command = [sys.executable, EXAMPLES / "dask_pictures.py", out]
        (self.folder / "list").write_text("".join(f"{path}\n" for path in paths))
        with open(self.folder / "list") as names:
            self.interrupt(command, lambda: out.glob("*.png"), count // 7, stdin=names)
        with open(self.folder / "list") as names:
            run = self.run_example(*command, stdin=names)
        self.assertIn(f"{count} of {count} pictures are there, 0 of {count // 100} tasks failed", run.stdout)
        outputs = [out / f"{path.name}.png" for path in paths]
        self.check_once(list(out.glob("report-*.jsonl")), outputs)
        times = [output.stat().st_mtime_ns for output in outputs]
        with open(self.folder / "list") as names:
            self.run_example(*command, stdin=names)
        self.assertEqual(times, [output.stat().st_mtime_ns for output in outputs])

    def test_object_store(self):
        count, store = 200, self.folder / "store"
        (self.folder / "bin/nacre").write_text(
            f'#!/bin/sh\nexec "{PROGRAM}" "$@" --size 32x32 --occlusion off --cache off\n')
        def key(number):
            name = f"{number % 10}{chr(97 + number // 40)}{chr(97 + number // 2 % 20)}{number % 2}"
            return f"store/structures/divided/mmCIF/{name[1:3]}/{name}.cif.gz"
        paths = sorted({self.folder / key(number) for number in range(count)})
        cif = next(iter(sorted(STRUCTURES.glob("**/glucose*.cif")))).read_bytes()
        for path in paths:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(gzip.compress(cif, 1))
        pictures = lambda: store.glob("pictures/divided/*/*.png")  # noqa: E731
        command = [sys.executable, EXAMPLES / "object_store.py", store, "--shard"]
        self.interrupt([*command, "1/2"], pictures, 20)
        with concurrent.futures.ThreadPoolExecutor() as pool:  # two machines
            list(pool.map(lambda shard: self.run_example(*command, shard), ("1/2", "2/2")))
        outputs = [store / "pictures/divided" / path.parent.name / path.name.replace(".cif.gz", ".png") for path in paths]
        self.check_once(list(store.glob("pictures/divided/reports/*.jsonl")), outputs)
        self.assertEqual(sum(1 for _ in pictures()), len(paths))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
