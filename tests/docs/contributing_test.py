"""docs/contributing.md lists every file of a task. Argument: the source tree. An example of each task stands in the listed files,
and in no others of the folders that it concerns."""
import pathlib
import re
import sys
import unittest

SOURCE = pathlib.Path(sys.argv[1])
PAGE = (SOURCE / "docs/contributing.md").read_text()

# Section: most files; what names an example of it outside comments; where that is searched.
TASKS = {
    "A format": (7, r"\bmol2\b|\bMOL2\b|\breadMol2\b", ["engine/molecule/read.h", "engine/molecule/formats", "app/apple", "app/android", "app/desktop",
                                                "app/download", "app/picture", "app/cli", "README.md"]),
    "A colour scheme": (4, r"ColorScheme::charge\b|\"charge\"|^ +charge, *$",
                        ["engine/scene/color", "app/picture", "app/annotation", "app/panel", "app/viewer", "app/drawing"]),
    "An option": (3, r"double meshError = |\bd\.meshError\b|settings\.meshError = ", ["app"]),
    "A page of the panel": (4, r"\bdrawPartsPage\b|\bshowPage\(\"Parts\"\)", ["app", "tests/panel/parts_page_test.cpp"]),
}
NAMES = {"An option": "output", "A page of the panel": "parts", "A format": "mol2"}


def listed(section):
    """The files of its table."""
    text = PAGE[PAGE.index(f"## {section}\n"):].split("\n## ", 1)[0]
    files = set()
    for row in re.findall(r"^\| (`.*?) \|", text, re.MULTILINE):
        files |= set(re.findall(r"`([^`]+)`", row))
    return {file.replace("NAME", NAMES.get(section, "NAME")) for file in files}


def sources(folder):
    path = SOURCE / folder
    files = [path] if path.is_file() else path.rglob("*")
    return [file for file in files if file.suffix in (".cpp", ".h", ".mm", ".md", ".xml", ".cmake", ".java")]


class Tasks(unittest.TestCase):
    def test_files_exist(self):
        for section in TASKS:
            for file in listed(section):
                with self.subTest(section=section, file=file):
                    self.assertTrue((SOURCE / file).is_file())

    def test_files_are_all(self):
        for section, (most, example, folders) in TASKS.items():
            found = {str(file.relative_to(SOURCE)) for folder in folders for file in sources(folder)
                     if re.search(example, re.sub("//.*", "", file.read_text()), re.MULTILINE)}
            with self.subTest(section=section):
                self.assertEqual(found, listed(section))
                self.assertLessEqual(len(found), most)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
