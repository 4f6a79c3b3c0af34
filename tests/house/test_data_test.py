#!/usr/bin/env python3
"""No judge is skipped where the test data are: test_data_test.py SOURCE_FOLDER"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop())
PROGRAMS = {"beside_plip.py": "plipcmd", "beside_mdtraj.py": "mdtraj", "beside_rdkit.py": "rdkit"}


def judge(name, data):
    """A run of a judge that finds neither its program nor its modules."""
    with tempfile.TemporaryDirectory() as empty:
        env = dict(os.environ, PATH=empty, NACRE_DATA=str(data), PYTHONPATH=empty)
        for module in ("mdtraj", "rdkit", "openbabel"):
            (pathlib.Path(empty) / f"{module}.py").write_text("raise ImportError\n")
        return subprocess.run([sys.executable, "-B", SOURCE / "tests/molecule" / name, "no-program"], env=env,
                              capture_output=True, text=True)


class TestData(unittest.TestCase):
    def test_judges_without_their_program_fail_beside_the_data(self):
        with tempfile.TemporaryDirectory() as folder:
            data = pathlib.Path(folder)
            (data / "expected.json").write_text("{}")
            for name, program in PROGRAMS.items():
                done = judge(name, data)
                self.assertEqual(done.returncode, 1, f"{name} without {program}: {done.stdout}{done.stderr}")
                self.assertIn("not installed", done.stdout)

    def test_a_folder_without_data_is_no_reason_to_skip(self):
        with tempfile.TemporaryDirectory() as folder:
            done = judge("beside_literature.py", folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("holds no test data", done.stderr)


if __name__ == "__main__":
    unittest.main()
