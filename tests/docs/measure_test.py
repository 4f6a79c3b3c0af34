#!/usr/bin/env python3
"""Figures of docs/measurements.md are those that tools/measure measures: measure_test.py SOURCE_FOLDER BUILD_FOLDER."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCE / "tools"))
import measure_page
from measure_tables import SUMMARY, TABLES

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

PAGE = measure_page.tables(measure_page.PAGE.read_text())


def room(text):
    """By how much a rounded number may be off."""
    return 0.5 * 10.0 ** -len(text.partition(".")[2])


class Measure(unittest.TestCase):
    def test_every_figure_is_measured(self):
        self.assertEqual(set(PAGE), set(TABLES) | {"summary"})
        for name, table in TABLES.items():
            rows = tuple(PAGE[name])
            if table.by_device:
                shown = dict.fromkeys(row.rpartition(", ")[0] for row in rows)  # in the page's order; some may be missing
                self.assertEqual(tuple(shown), tuple(row for row in table.rows if row in shown), name)
            else:
                self.assertEqual(rows, table.rows, name)
            for row, cells in PAGE[name].items():
                self.assertEqual(tuple(cells), table.columns, name)

    def test_tables_with_numbers_are_measured(self):
        lines = measure_page.PAGE.read_text().splitlines()
        for at, line in enumerate(lines):
            if line.startswith("|-"):
                self.assertRegex(lines[at - 2], measure_page.MARK, f"line {at + 1}: a table without a mark")

    def test_figures_that_stand_twice_are_the_same(self):
        self.assertEqual(set(PAGE["summary"]), set(SUMMARY))
        for row, source in SUMMARY.items():
            shown, kept = measure_page.number(PAGE["summary"][row]["result"]), measure_page.figure(PAGE, *source)
            self.assertEqual(shown, kept, row)

    def test_ratios_are_those_of_their_numbers(self):
        for name, table in TABLES.items():
            for column, (over, under) in table.ratios.items():
                for row, cells in PAGE[name].items():
                    texts = [cells[c] for c in (column, over, under)]
                    shown, a, b = map(measure_page.number, texts)
                    if shown is None or a is None or b is None:
                        continue
                    most = (a + room(texts[1])) / (b - room(texts[2])) + room(texts[0])
                    least = (a - room(texts[1])) / (b + room(texts[2])) - room(texts[0])
                    self.assertTrue(least - 1e-9 <= shown <= most + 1e-9, f"{name}, {row}: {shown} of {a} and {b}")

    def test_it_writes_what_it_measured(self):
        page = "<!-- measured: a -->\n| of | x | y |\n|---|---|---|\n| `b` | 1 | |\n| c | 2 | 3 |\n\n| b | 4 |\n|---|---|\n"
        figures = {("a", "`b`", "x"): 12.345, ("a", "`b`", "y"): 0.0123, ("a", "c", "y"): 1234567}
        new = measure_page.with_figures(page, figures)
        self.assertEqual(new, page.replace("| 1 | |", "| 12.3 | 0.012 |").replace("| 2 | 3 |", "| 2 | 1,234,567 |"))
        self.assertEqual(measure_page.figure(measure_page.tables(new), "a", "c", "y"), 1234567)
        whole = measure_page.PAGE.read_text()
        self.assertEqual(measure_page.with_figures(whole, {}), whole)

    def test_rows_of_another_device_stand_beside_those_of_the_same_scene(self):
        page = "<!-- measured: a -->\n| of | x |\n|---|---|\n| b, one | 1 |\n| b, tube, one | 2 |\n\n"
        figures = {("a", "b, two", "x"): 3.0, ("a", "b, tube, one", "x"): 4.0, ("a", "c, two", "x"): 5.0}
        new = page.replace("| b, one | 1 |\n", "| b, one | 1 |\n| b, two | 3.00 |\n").replace("| 2 |\n", "| 4.00 |\n| c, two | 5.00 |\n")
        self.assertEqual(measure_page.with_figures(page, figures), new)
        self.assertEqual(measure_page.with_figures(new, figures), new)

    def test_a_device_is_measured_by_the_program_alone(self):
        if not test_data.folder():
            self.skipTest(test_data.ABSENT)
        with tempfile.TemporaryDirectory() as folder:
            data, build = pathlib.Path(folder, "data"), pathlib.Path(folder, "build/bin")
            data.mkdir(), build.mkdir(parents=True)
            (data / "1bna.pdb").symlink_to(test_data.folder() / "1bna.pdb")
            (build / "nacre").symlink_to(BUILD / "bin/nacre")
            env = dict(os.environ, NACRE_NO_BUILD="1")
            env["NACRE_DATA"] = str(data)
            done = subprocess.run([SOURCE / "tools/measure", "gpu", "--build", build.parent, "--rounds", "1"], env=env,
                                  capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = [measure_page.cells(line) for line in done.stdout.splitlines()[2:]]
        self.assertEqual([(row.rpartition(", ")[0], column) for _, row, column, *_ in found],
                         [("1BNA", column) for column in TABLES["gpu"].columns], done.stderr)
        self.assertTrue(all(measure_page.number(now) > 0 for _, _, _, now, *_ in found), found)
        self.assertRegex(done.stderr, r"not measured: gpu: 4V5A, .*: no .*/4v5a-ribosome.mmtf")
        self.assertRegex(done.stderr, r"not measured: gpu-batches: no .*/1crn.pdb")

    def test_a_table_is_measured_beside_the_page(self):
        env = dict(os.environ, NACRE_NO_BUILD="1")
        done = subprocess.run([SOURCE / "tools/measure", "meshes", "--build", BUILD, "--rounds", "1"], env=env, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        if "not measured" in done.stderr and not test_data.folder():
            self.skipTest(done.stderr)
        found = [measure_page.cells(line) for line in done.stdout.splitlines()[2:]]
        self.assertEqual({(row, column) for _, row, column, *_ in found}, {(r, c) for r in TABLES["meshes"].rows for c in TABLES["meshes"].columns})
        for name, row, column, now, page, ratio in found:
            self.assertEqual(page, PAGE[name][row][column])
            if not column.endswith("ms"):
                self.assertEqual((now, ratio), (page, "1.00"), f"{row}, {column}")

    def test_a_name_that_is_none_is_refused(self):
        done = subprocess.run([SOURCE / "tools/measure", "nothing"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no such table: nothing", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
