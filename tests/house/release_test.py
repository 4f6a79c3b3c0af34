#!/usr/bin/env python3
"""The workflows call scripts that are there, in an order that holds; what of the release runs anywhere is run. release_test.py TREE"""
import hashlib
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

TREE = pathlib.Path(sys.argv.pop())
FOLDER = TREE / ".github/workflows"
WORKFLOWS = {file.name: yaml.safe_load(file.read_text()) for file in sorted(FOLDER.glob("*.yml"))}
JOBS = WORKFLOWS["release.yml"]["jobs"]
CALLED = "./.github/workflows/"
VERSION = re.search(r"project\(nacre VERSION (\S+)", (TREE / "CMakeLists.txt").read_text())[1]
# What prepares a machine, or builds what a script of tools/ has prepared.
PREPARES = r"apt-get |git config |cmake |ninja "


def release(*words):
    return subprocess.run([TREE / "tools/release", *words], capture_output=True, text=True)


def rows(job):
    """The values of `matrix` in each run of a job."""
    matrix = job.get("strategy", {}).get("matrix", {})
    if "include" in matrix:
        return matrix["include"]
    return [dict(zip(matrix, values)) for values in itertools.product(*matrix.values())]


def filled(text, row):
    return re.sub(r"\$\{\{ matrix\.([\w-]+)(?: \|\| [^}]*)? \}\}", lambda match: str(row.get(match[1], "")), text)


def commands(workflow):
    """(job, line of a shell) of a workflow, each run of a matrix, what it hands to another workflow included."""
    for name, job in workflow["jobs"].items():
        texts = [step.get("run", "") for step in job.get("steps", [])] + [job.get("with", {}).get("run", "")]
        for row in rows(job):
            for text in texts:
                for line in re.split(r"&&|\n", filled(text, row)):
                    if line.strip() and not line.strip().startswith("${{ inputs."):
                        yield name, line.strip()


class Workflows(unittest.TestCase):
    def test_steps_are_scripts_of_tools(self):
        scripts = set()
        for file, workflow in WORKFLOWS.items():
            if file == "phones.yml":
                continue  # its steps need an NDK or Xcode, which no script here could try
            for job, line in commands(workflow):
                if re.match(PREPARES, line):
                    continue
                script = re.match(r"(tools/\w+|\.ci/run)(?: |$)", line)
                self.assertTrue(script, f"{file}, {job}: {line}")
                self.assertTrue(os.access(TREE / script[1], os.X_OK), f"{file}: {script[1]}")
                scripts.add(script[1])
        self.assertLessEqual({".ci/run", "tools/test", "tools/nacre", "tools/release"}, scripts)

    def test_workflows_that_are_called_take_what_they_are_given(self):
        called = set()
        for file, workflow in WORKFLOWS.items():
            for name, job in workflow["jobs"].items():
                if "uses" not in job:
                    continue
                self.assertTrue(job["uses"].startswith(CALLED), job["uses"])
                target = WORKFLOWS[job["uses"].removeprefix(CALLED)]
                inputs = target[True]["workflow_call"]["inputs"]  # YAML 1.1 reads "on" as a truth value
                given = job["with"]
                self.assertLessEqual(set(given), set(inputs), f"{file}, {name}")
                self.assertLessEqual({key for key, one in inputs.items() if one.get("required")}, set(given))
                called.add(job["uses"])
                used = set(re.findall(r"matrix\.([\w-]+)", str(job)))
                for row in rows(job):
                    self.assertLessEqual(set(row), used, f"{file}, {name}: {row}")
        self.assertEqual(called, {CALLED + "debian.yml"})
        text = (FOLDER / "debian.yml").read_text()
        for name in WORKFLOWS["debian.yml"][True]["workflow_call"]["inputs"]:
            self.assertRegex(text, rf"inputs\.{name}\b")


class Release(unittest.TestCase):
    def test_what_is_built_is_of_the_tag_and_published_once(self):
        lines = list(commands(WORKFLOWS["release.yml"]))
        for name in JOBS.keys() - {"publish"}:
            own = [line for job, line in lines if job == name]
            self.assertEqual(own[::2], ['tools/release check "$GITHUB_REF_NAME"'] * (len(own) // 2), name)
        self.assertLessEqual({"linux", "container", "android", "mac", "ios", "sums", "publish"}, {line.split()[1] for _, line in lines})
        self.assertEqual(set(JOBS["publish"]["needs"]), set(JOBS) - {"publish"})
        # Only the last job may write.
        for workflow in WORKFLOWS.values():
            self.assertEqual(workflow["permissions"], {"contents": "read"})
            for name, job in workflow["jobs"].items():
                self.assertEqual("write" in str(job.get("permissions")), name == "publish", name)

    def test_every_call_has_words_that_are_taken(self):
        kinds = re.search(r"^case.*?\n(.*?)\) ", (TREE / "tools/release").read_text(), re.MULTILINE)[1]
        calling = set()
        for file, workflow in WORKFLOWS.items():
            for job, line in commands(workflow):
                if call := re.search(r"tools/release (.*)", line):
                    words = call[1].split()
                    self.assertIn(f"{words[0]}:{len(words)}", re.split(r"[ |]+", kinds.strip()), f"{file}: {line}")
                    calling.add(file)
        self.assertLessEqual({"ci.yml", "phones.yml", "release.yml"}, calling)

    def test_the_tag_is_the_version(self):
        self.assertEqual(release("check", f"v{VERSION}").returncode, 0)
        for wrong in ("", VERSION, f"v{VERSION}1", "v9.9.9"):
            run = release("check", wrong)
            self.assertEqual(run.returncode, 1, wrong)
            self.assertIn("version", run.stderr)

    def test_usage(self):
        for words in ((), ("nothing",), ("linux",), ("apple", "mac", "x")):
            run = release(*words)
            self.assertEqual(run.returncode, 2, words)
            self.assertEqual(len(re.findall(r"^  tools/release", run.stderr, re.MULTILINE)), 8, run.stderr)

    def test_checksums(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(release("sums", folder).returncode, 1)
            pathlib.Path(folder, "a b.whl").write_text("x")
            for _ in range(2):  # the list is not in the list
                self.assertEqual(release("sums", folder).returncode, 0)
            self.assertEqual(pathlib.Path(folder, "SHA256SUMS").read_text(), f"{hashlib.sha256(b'x').hexdigest()}  a b.whl\n")


if __name__ == "__main__":
    unittest.main()
