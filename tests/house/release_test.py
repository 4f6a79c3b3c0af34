#!/usr/bin/env python3
"""The release workflow calls scripts that are there, in an order that holds; what of them runs anywhere is run. release_test.py TREE"""
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

TREE = pathlib.Path(sys.argv.pop())
WORKFLOW = yaml.safe_load((TREE / ".github/workflows/release.yml").read_text())
VERSION = re.search(r"project\(nacre VERSION (\S+)", (TREE / "CMakeLists.txt").read_text())[1]
# What prepares a machine, and is no work of ours.
PREPARES = r"apt-get |git config |brew install |gh release download |lintian "


def release(*words):
    return subprocess.run([TREE / "tools/release", *words], capture_output=True, text=True)


class Release(unittest.TestCase):
    def test_steps_are_scripts_of_tools(self):
        called = set()
        for name, job in WORKFLOW["jobs"].items():
            for step in job["steps"]:
                if "run" not in step or re.match(PREPARES, step["run"]):
                    continue
                script = re.match(r"(?:[A-Z_]+=\S+ )*(tools/\w+)", step["run"])
                self.assertTrue(script, f"{name}: {step['run']}")
                self.assertTrue(os.access(TREE / script[1], os.X_OK), script[1])
                called.add(script[1])
        self.assertLessEqual({"tools/package", "tools/try_package", "tools/release", "tools/setup"}, called)

    def test_what_is_built_is_of_the_tag_and_published_once(self):
        jobs = WORKFLOW["jobs"]
        for name, job in jobs.items():
            runs = [step.get("run", "") for step in job["steps"]]
            if name != "publish":
                self.assertTrue(any(run.startswith("tools/release check") for run in runs), name)
        self.assertEqual(set(jobs["publish"]["needs"]), set(jobs) - {"publish"})
        # Only the last job may write.
        self.assertEqual(WORKFLOW["permissions"], {"contents": "read"})
        self.assertEqual([name for name, job in jobs.items() if "write" in str(job.get("permissions"))], ["publish"])

    def test_the_tag_is_the_version(self):
        self.assertEqual(release("check", f"v{VERSION}").returncode, 0)
        for wrong in ("", VERSION, f"v{VERSION}1", "v9.9.9"):
            run = release("check", wrong)
            self.assertEqual(run.returncode, 1, wrong)
            self.assertIn("version", run.stderr)
        self.assertEqual(release("nothing").returncode, 2)

    def test_checksums(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(release("sums", folder).returncode, 1)
            pathlib.Path(folder, "a b.whl").write_text("x")
            for _ in range(2):  # the list is not in the list
                self.assertEqual(release("sums", folder).returncode, 0)
            self.assertEqual(pathlib.Path(folder, "SHA256SUMS").read_text(), f"{hashlib.sha256(b'x').hexdigest()}  a b.whl\n")


if __name__ == "__main__":
    unittest.main()
