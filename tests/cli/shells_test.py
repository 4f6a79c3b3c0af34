#!/usr/bin/env python3
"""Completions in real shells, the manual page by real readers, help topics: shells_test.py PROGRAM."""
import fcntl
import os
import pathlib
import pty
import re
import select
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

PROGRAM = pathlib.Path(sys.argv[1])


def nacre(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


# What is typed, what must be offered, what must not.
CASES = [
    ("re", ["render"], ["info"]),
    ("render --occlusion-d", ["--occlusion-detail"], ["--occlusion"]),
    ("render --style ", ["spacefill", "ball-and-stick", "licorice"], ["in", "or"]),
    ("render --color pl", ["plddt"], ["element"]),
    ("render --lighting ", ["on", "off"], ["times"]),
    ("batch --res", ["--resume"], ["--output"]),
    ("movie --easing s", ["smooth", "stops"], ["linear", "structure.pdb"]),
    ("render --look s", ["structure.pdb"], ["other.txt"]),
    ("render --look def", ["default"], ["structure.pdb"]),
    ("movie --views pic", ["picture.png"], ["other.txt"]),
    ("movie --views picture.png,oth", ["picture.png,other.txt"], ["structure.pdb"]),
    ("plan --caps ma", ["mali"], ["adreno"]),
    ("render -o pic", ["picture.png"], ["other.txt"]),
    ("render str", ["structure.pdb"], ["picture.png"]),
    ("render --size ", [], ["structure.pdb", "each"]),
    ("completion ", ["bash", "zsh", "fish"], ["structure.pdb"]),
    ("help se", ["selections"], ["render"]),
]


class Completion(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-shells-"))
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ("picture.png", "structure.pdb", "other.txt"):
            (self.folder / name).touch()

    def check(self, complete, shell):
        script = nacre("completion", shell)
        self.assertEqual(script.returncode, 0, script.stderr)
        file = self.folder / f".completion.{shell}"
        file.write_text(script.stdout)
        for typed, offered, not_offered in CASES:
            words = complete(file, typed)
            for word in offered:
                self.assertIn(word, words, f"{shell}: nacre {typed}")
            for word in not_offered:
                self.assertNotIn(word, words, f"{shell}: nacre {typed}")

    def run_shell(self, *command, **more):
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True,
                             env=os.environ | {"HOME": str(self.folder), "TERM": "dumb"}, **more)
        self.assertEqual(run.stderr, "")
        return run.stdout

    @needs("bash")
    def test_bash(self):
        def complete(file, typed):
            words = ["nacre", *typed.split(" ")]
            quoted = " ".join(f"'{w}'" for w in words)
            return self.run_shell("bash", "--norc", "-c", f"""source {file}
                COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _nacre; printf '%s\\n' "${{COMPREPLY[@]}}\"""").split()
        self.check(complete, "bash")

    @needs("fish")
    def test_fish(self):
        def complete(file, typed):
            lines = self.run_shell("fish", "--no-config", "-c", f"source {file}; complete -C 'nacre {typed}'").splitlines()
            return [line.split("\t")[0] for line in lines]
        self.check(complete, "fish")

    @needs("zsh")
    def test_zsh(self):
        """Through a pseudo-terminal: zsh completes in its line editor alone."""
        ours, theirs = pty.openpty()
        termios.tcsetwinsize(theirs, (500, 300)) if hasattr(termios, "tcsetwinsize") else fcntl.ioctl(
            theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 500, 300, 0, 0))
        shell = subprocess.Popen(["zsh", "-f", "-i"], cwd=self.folder, stdin=theirs, stdout=theirs, stderr=theirs,
                                 env=os.environ | {"HOME": str(self.folder), "TERM": "dumb"}, start_new_session=True)
        self.addCleanup(shell.wait)
        self.addCleanup(shell.kill)

        def until(mark):
            text, end = "", time.monotonic() + 60
            while mark not in text and time.monotonic() < end:
                if select.select([ours], [], [], 1)[0]:
                    text += os.read(ours, 65536).decode("utf-8", "replace")
            self.assertIn(mark, text)
            return text

        def complete(file, typed):
            if not complete.begun:
                os.write(ours, b"PS1=; unsetopt prompt_cr prompt_sp\nautoload -U compinit; compinit -u -D; LISTMAX=0\n"
                         b"setopt no_list_beep no_list_ambiguous; zle -N mark; mark() { print; print MA''RK }; bindkey '^T' mark; source %s\n"
                         b"print BEG''UN\n" % str(file).encode())
                until("BEGUN")
                complete.begun = True
            os.write(ours, f"nacre {typed}\t\x14".encode())  # the second key says that the first is done with
            text = until("MARK")
            os.write(ours, b"\x15")
            words = re.split(r"[\s\x00-\x1f]+", text)
            return [word.removesuffix(",") for word in words if word]  # a list goes on
        complete.begun = False
        self.check(complete, "zsh")

    def test_other_shells_are_refused(self):
        refused = nacre("completion", "tcsh")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("bash", refused.stderr)


class ManualPage(unittest.TestCase):
    def setUp(self):
        self.page = nacre("man").stdout

    @needs("man")
    def test_man_reads_it_without_a_warning(self):
        run = subprocess.run(["man", "--warnings=all", "-l", "-"], input=self.page, capture_output=True, text=True,
                             env=os.environ | {"MANWIDTH": "100", "LC_ALL": "C.UTF-8"})
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        offered = [w for line in nacre("render", "--help").stdout.splitlines() for w in line.split(" ")[2:3] if w.startswith("-")]
        self.assertGreater(len(offered), 20)
        for names in offered:
            self.assertIn(names.split(",")[-1], run.stdout)
        self.assertIn("'not byres (within 5 of (ligand))'", run.stdout)  # as it is typed

    @needs("mandoc")
    def test_mandoc_finds_nothing_to_say(self):
        run = subprocess.run(["mandoc", "-T", "lint", "-W", "warning"], input=self.page, capture_output=True, text=True)
        said = [line for line in run.stdout.splitlines() if "missing date" not in line]
        self.assertEqual(said, [])


class Help(unittest.TestCase):
    def test_topics(self):
        text = nacre("--help").stdout
        said = nacre("help", "nothing").stderr
        topics = re.search("topics are (.*), every command and every option", said).group(1).split(", ")
        self.assertIn("interactions", topics)
        for topic in topics:
            self.assertIn(topic, text)
            run = nacre("help", topic)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn("--", run.stdout)
        self.assertIn("/NAME", nacre("help", "selections").stdout)
        devices = nacre("help", "devices").stdout  # a command and a topic
        self.assertIn("--self-test", devices)
        self.assertIn("Any Vulkan driver", devices)
        self.assertIn("--visibility", devices)
        self.assertEqual(nacre("help", "colours").stdout, nacre("help", "colors").stdout)
        self.assertEqual(nacre("help", "render").stdout, nacre("render", "--help").stdout)

    def test_what_is_misspelt(self):
        for arguments, meant in [(("help", "selectoins"), "selections"), (("help", "rendr"), "render"),
                                 (("rendr",), "render"), (("render", "--colr", "x"), "--color"),
                                 (("render", "sample:dna", "-o", "a.png", "--background", "navi"), "navy"),
                                 (("render", "sample:dna", "-o", "a.png", "--color", "chian"), "chain"),
                                 (("render", "sample:dna", "-o", "a.png", "--style", "licorce"), "licorice"),
                                 (("render", "sample:dna", "-o", "a.png", "--hide", "chian A"), "chain"),
                                 (("completion", "zhs"), "zsh")]:
            run = nacre(*arguments)
            self.assertEqual(run.returncode, 2, arguments)
            self.assertIn(f"'{meant}'", run.stderr, arguments)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
