#!/usr/bin/env python3
"""What the pages say of this tree is so: docs_test.py SOURCE_FOLDER PROGRAM."""
import functools
import itertools
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
PAGES = sorted([SOURCE / "README.md", SOURCE / "third_party/README.md", *(SOURCE / "docs").glob("*.md")])
FOLDERS = "engine|app|shaders|tests|tools|docs|third_party"


def without_code(text):
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def lines_outside_code(page):
    """Lines with their numbers; those of code blocks are empty."""
    code = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        fence = line.startswith("```")
        code ^= fence
        yield number, "" if code or fence else line


def cells(row):
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", row.strip())[1:-1]]


@functools.cache
def program(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


def commands():
    return re.findall(r"^  ([a-z]+) ", program("--help").partition("Subcommands:")[2].partition("\n\n")[0], re.MULTILINE)


def anchor(heading):
    return re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")


class Pages(unittest.TestCase):
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

    def test_functions_of_the_walk_stand_in_their_files(self):
        rows = re.findall(r"^\| \d .*?\]\(\.\./([^)]+)\) \| `(\w+)` \|$", (SOURCE / "docs/frame.md").read_text(), re.MULTILINE)
        self.assertGreaterEqual(len(rows), 9)
        for file, function in rows:
            self.assertRegex((SOURCE / file).read_text(), rf"\b{function}\b", file)

    def test_pages_and_pictures_are_reached(self):
        linked = {(page.parent / link.partition("#")[0]).resolve()
                  for page in PAGES for link in re.findall(r'(?:\]\(|<img src=")([^)"\s]+)', page.read_text())}
        for file in (SOURCE / "docs").iterdir():
            self.assertIn(file.resolve(), linked, "nothing leads there")

    def test_tables_are_whole_and_their_cells_short(self):
        for page in PAGES:
            header = None  # of the table that the line stands in
            lines = list(lines_outside_code(page))
            for (number, line), (_, after) in zip(lines, lines[1:] + [(0, "")]):
                at = f"{page.name}:{number}"
                if not line.startswith("|"):
                    header = None
                    continue
                if header is None:
                    header = cells(line)
                    self.assertRegex(after, r"^\|(?:-+\|)+$", f"{at}: a table has no line below its head")
                self.assertEqual(len(cells(line)), len(header), f"{at}: cells of a row")
                for cell in cells(line):
                    self.assertLessEqual(len(cell), 200, f"{at}: {cell}")

    def test_options_that_are_named_exist(self):
        offered = set()
        for command in commands():
            offered |= set(re.findall(r"--[a-z][a-z-]+", program(command, "--help")))
        offered |= set(re.findall(r"--[a-z][a-z-]+", program("--help")))
        for page in PAGES:
            for quoted in re.findall(r"`([^`\n]+)`", without_code(page.read_text())):
                if not re.match(r"--|nacre ", quoted) or "nacre" in quoted and "|" in quoted:
                    continue  # of another program
                for option in re.findall(r"(?:^|\s)(--[a-z][a-z-]+)", quoted):
                    self.assertIn(option, offered, f"{page.name}: {quoted}")

    def test_the_phrase_book_is_understood(self):
        fragments = set()
        for _, line in lines_outside_code(SOURCE / "docs/phrase_book.md"):
            row = cells(line) if line.startswith("|") else [""]
            fragments |= set(re.findall(r"`(--[^`]+)`", row[-1]))
            if line.startswith("| ") and not re.search(r"`(?:--|nacre )", row[-1]) and len(row) == 4 and "atoms" not in row[0]:
                fragments |= {"--hide " + shlex.quote(text) for text in re.findall(r"`([a-z][^`.:]*)`", row[-1])}
        self.assertGreater(len(fragments), 45)
        with tempfile.TemporaryDirectory() as folder:
            jobs = []
            for fragment in sorted(fragments):
                job = {"input": "sample:dna", "output": f"{folder}/{len(jobs)}.png", "size": "16x16", "occlusion": "off"}
                words = shlex.split(fragment)
                for at, word in enumerate(words):
                    if word.startswith("--"):
                        values = list(itertools.takewhile(lambda text: not text.startswith("--"), words[at + 1:]))
                        job[word[2:]] = values[0] if len(values) == 1 else [values]
                jobs.append((fragment, job))
            lines = "\n".join(json.dumps(job) for _, job in jobs)
            report = subprocess.run([PROGRAM, "batch", "-", "--cache", "off"], input=lines, capture_output=True, text=True)
            for line in map(json.loads, report.stdout.splitlines()):
                # The sample has no ligand, no second chain of that name and no trajectory.
                if line["status"] != "done":
                    self.assertRegex(line["error"], "no such atoms|only atoms that are left out|none of its atoms|no assemblies|"
                                     "No such file|one INPUT on another|no atom is left|matches no atom", jobs[line["job"] - 1][0])

    def test_programs_of_tests_that_are_named_exist(self):
        lists = (SOURCE / "tests/CMakeLists.txt").read_text() + (SOURCE / "tests/suites.cmake").read_text()
        for page in PAGES:
            for name in re.findall(r"\btest_([a-z_]+)\b", page.read_text()):
                self.assertRegex(lists, rf"\b(?:test_)?{name}\b", f"{page.name}: test_{name}")

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
        self.assertEqual(offered - {"--help", "--quiet", "--verbose"}, set(re.findall(r"^\*\*`(--[a-z-]+)", written, re.MULTILINE)))

    def test_the_nodes_of_scenes_are_those_of_the_program(self):
        page = (SOURCE / "docs/molviewspec_nodes.md").read_text()
        written = page.partition("<!-- nodes -->\n")[2].partition("<!-- /nodes -->")[0]
        self.assertEqual(written.strip(), program("help", "molviewspec").strip(), "nacre help molviewspec")

    def test_every_node_and_parameter_of_the_schema_is_in_that_table(self):
        if not test_data.folder():
            self.skipTest(test_data.ABSENT)
        schema = test_data.folder() / "mvs/molviewspec-v1-openapi-schema.json"
        told = {tuple(cell.strip("`") for cell in cells(row)[:2])
                for row in program("help", "molviewspec").splitlines()[2:]}
        kinds = {"BallAndStick": "representation ball_and_stick", "Cartoon": "representation cartoon",
                 "Spacefill": "representation spacefill", "Surface": "representation surface",
                 "Carbohydrate": "representation carbohydrate", "PrimitiveLabel": "primitive label",
                 "AngleMeasurement": "primitive angle_measurement",
                 "DistanceMeasurement": "primitive distance_measurement",
                 "VolumeIsoSurface": "volume_representation isosurface"}
        for kind in ("Arrow", "Box", "Ellipse", "Ellipsoid", "Lines", "Mesh", "Tube"):
            kinds[kind] = "primitive " + kind.lower()
        for name, node in json.loads(schema.read_text())["components"]["schemas"].items():
            if not name.endswith("Params") or name.startswith("_"):
                continue
            plain = name.removesuffix("Params").removesuffix("Inline")
            kind = kinds.get(plain, re.sub(r"(?<=.)([A-Z])", r"_\1", plain).lower())
            self.assertIn((kind, ""), told, name)
            for parameter in node.get("properties", {}):
                self.assertIn((kind, parameter), told, f"{name}: {parameter}")

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
