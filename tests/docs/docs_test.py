#!/usr/bin/env python3
"""What the pages say of this tree is so: docs_test.py SOURCE_FOLDER PROGRAM."""
import pathlib
import re
import subprocess
import sys
import unittest

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
PAGES = sorted([SOURCE / "README.md", SOURCE / "third_party/README.md", *(SOURCE / "docs").glob("*.md")])
FOLDERS = "engine|app|shaders|tests|tools|docs|third_party"


def without_code(text):
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def anchor(heading):
    return re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")


class Pages(unittest.TestCase):
    def test_the_first_is_short(self):
        self.assertLessEqual(len((SOURCE / "README.md").read_text().splitlines()), 170)

    def test_links_lead_somewhere(self):
        for page in PAGES:
            text = without_code(page.read_text())
            links = re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r'<img src="([^"]+)"', text)
            for link in links:
                if re.match(r"[a-z]+:", link):
                    continue
                path, _, heading = link.partition("#")
                target = (page.parent / path).resolve() if path else page
                self.assertTrue(target.exists(), f"{page.name}: {link}")
                if heading:
                    headings = re.findall(r"^#+ (.+)$", without_code(target.read_text()), re.MULTILINE)
                    self.assertIn(heading, [anchor(h) for h in headings], f"{page.name}: {link}")

    def test_pages_and_pictures_are_reached(self):
        linked = {(page.parent / link.partition("#")[0]).resolve()
                  for page in PAGES for link in re.findall(r'(?:\]\(|<img src=")([^)"\s]+)', page.read_text())}
        for file in (SOURCE / "docs").iterdir():
            self.assertIn(file.resolve(), linked, "nothing leads there")

    def test_files_that_are_named_exist(self):
        # NAME stands for what the reader is to put there.
        for page in PAGES:
            for quoted in re.findall(r"`([^`\n]+)`", page.read_text()):
                for path in re.findall(rf"(?:^|\s)((?:{FOLDERS})/[\w./*-]+)", quoted):
                    if "NAME" not in path:
                        self.assertTrue(list(SOURCE.glob(path.rstrip("/."))), f"{page.name}: {path}")

    def test_the_reference_is_what_the_program_writes(self):
        written = subprocess.run([PROGRAM, "help", "reference"], capture_output=True, text=True, check=True).stdout
        self.assertEqual((SOURCE / "docs/reference.md").read_text(), written, "nacre help reference >docs/reference.md")
        help_text = subprocess.run([PROGRAM, "render", "--help"], capture_output=True, text=True, check=True).stdout
        offered = set(re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]+)", help_text, re.MULTILINE))
        self.assertEqual(offered - {"--help", "--quiet"}, set(re.findall(r"^\*\*`(--[a-z-]+)", written, re.MULTILINE)))

    def test_options_of_movies_are_those_of_the_program(self):
        named = set(re.findall(r"--[a-z][a-z-]+", (SOURCE / "docs/movies.md").read_text()))
        offered = {}
        for command in ("render", "movie"):
            help_text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
            offered[command] = set(re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]+)", help_text, re.MULTILINE))
        own = offered["movie"] - offered["render"]
        self.assertEqual(own - named, set())
        self.assertEqual(named - offered["movie"] - {"--help"}, set())

    def test_examples_name_options_that_exist(self):
        for page in PAGES:
            for line in re.findall(r"^(?:tools/|build/\S+/)?nacre (\w+) (.*)", page.read_text(), re.MULTILINE):
                command, rest = line
                help_text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
                for option in re.findall(r"(?:^|\s)(--[a-z][a-z-]+)", rest.partition("#")[0]):
                    self.assertIn(option, help_text, f"{page.name}: nacre {command} {rest}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
