#!/usr/bin/env python3
"""What is installed for file managers and shells: share_test.py BUILD_FOLDER PROGRAM STRUCTURES."""
import configparser
import os
import pathlib
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

BUILD, PROGRAM, STRUCTURES = (pathlib.Path(a) for a in sys.argv[1:4])


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


def entry(path, section):
    parser = configparser.ConfigParser(interpolation=None, delimiters=["="])
    parser.optionxform = str
    parser.read(path)
    return parser[section]


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-share-"))
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.folder, "--component", "share"], check=True,
                       capture_output=True)
        cls.share = cls.folder / "share"

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_everything_is_there(self):
        for name in ("bash-completion/completions/nacre", "zsh/site-functions/_nacre", "man/man1/nacre.1",
                     "fish/vendor_completions.d/nacre.fish", "thumbnailers/nacre.thumbnailer",
                     "mime/packages/nacre.xml", "applications/nacre.desktop"):
            self.assertGreater((self.share / name).stat().st_size, 100, name)

    @needs("desktop-file-validate")
    def test_desktop_entry_is_valid(self):
        run = subprocess.run(["desktop-file-validate", self.share / "applications/nacre.desktop"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout + run.stderr), (0, ""))

    @needs("update-mime-database")
    @needs("xmllint")
    def test_types_are_known_by_their_files(self):
        subprocess.run(["xmllint", "--noout", self.share / "mime/packages/nacre.xml"], check=True)
        shutil.copy("/usr/share/mime/packages/freedesktop.org.xml", self.share / "mime/packages")
        run = subprocess.run(["update-mime-database", "-V", self.share / "mime"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("nacre.xml", run.stderr)
        globs = dict(reversed(line.split(":")[1:3]) for line in (self.share / "mime/globs2").read_text().splitlines()
                     if not line.startswith("#"))
        for ending, kind in {"pdb": "pdb", "ent": "pdb", "cif": "cif", "bcif": "bcif", "sdf": "mdl-sdfile", "gro": "gro"}.items():
            self.assertEqual(globs[f"*.{ending}"], f"chemical/x-{kind}")
        known = set(globs.values())
        for file, section in (("thumbnailers/nacre.thumbnailer", "Thumbnailer Entry"), ("applications/nacre.desktop", "Desktop Entry")):
            for kind in filter(None, entry(self.share / file, section)["MimeType"].split(";")):
                self.assertIn(kind, known, file)

    def test_thumbnailer_draws_as_a_file_manager_calls_it(self):
        structure = self.folder / "a name with 'quotes' and $.pdb"
        shutil.copy(sorted(STRUCTURES.glob("**/dna.pdb"))[0], structure)
        output = self.folder / "thumbnail without an ending"
        values = {"%i": str(structure), "%o": str(output), "%s": "64", "%u": structure.as_uri()}
        words = [values.get(w, w) for w in shlex.split(entry(self.share / "thumbnailers/nacre.thumbnailer", "Thumbnailer Entry")["Exec"])]
        environment = os.environ | {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}", "NACRE_CACHE": "off"}
        run = subprocess.run(words, env=environment, capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        picture = output.read_bytes()
        self.assertEqual(struct.unpack(">II", picture[16:24]), (64, 64))
        structure.write_text("no structure")
        self.assertNotEqual(subprocess.run(words, env=environment, capture_output=True).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
