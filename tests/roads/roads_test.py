"""One road from a description to pixels: the command line, batches, Python, the server and the window's own key save the
same bytes for the same description. Arguments: nacre, and window_pictures (tests/roads), or none where windows are not built."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "serve"))
import served

# Of the window's size, with its anti-aliasing; a zoom, since a window never fits the molecule again; an em size, since that of
# windows goes by the display.
COMMON = {"size": "320x240", "supersample": 2, "zoom": 1, "text-size": 9, "occlusion": 16}
DNA, GLUCOSE, BALL = ({"input": f"sample:{name}"} for name in ("dna", "glucose", "buckyball"))
DESCRIPTIONS = {
    "plain": DNA,
    "cartoon": DNA | {"style": "cartoon", "color": "chain"},
    "surface": DNA | {"style": "surface", "surface-opacity": 0.6},
    "sticks": GLUCOSE | {"style": "ball-and-stick", "rotate": "20,30,40"},
    "perspective": DNA | {"projection": "perspective", "fov": 50, "style": "licorice"},
    "closer": DNA | {"zoom": 2.5, "pan": "4,-2"},
    "outlines": DNA | {"contours": 2, "contour-weights": 3},
    "halos": DNA | {"halos": 3, "background": "navy"},
    "shadow": DNA | {"shadow": 0.6, "ambient": 0.4},
    "fog": DNA | {"fog": "auto", "lighting": False},
    "lens": DNA | {"depth-of-field": 0.4},
    "clipped": DNA | {"clip": "-2,3", "style": "spacefill"},
    "dark": BALL | {"occlusion": "off", "background": "black"},
    "rules": DNA | {"rules": [{"hide": "chain B"}, {"show": "resi 3=ball-and-stick"}, {"color-by": "resi 5=#ff8000"}]},
    "title": DNA | {"title": "DNA", "scale-bar": "nm"},
    "legend": DNA | {"color": "residue", "legend": True, "title": "A dodecamer of DNA, in the colours of its residues"},
    "labels": DNA | {"label": ["chain A and resi 1={residue}", "chain B and resi 20={residue}"], "show-labels": "seen"},
    "measures": GLUCOSE | {"measure": ["id 1,id 5", "id 1,id 2,id 3"], "style": "licorice"},
    "uncovered": DNA | {"uncover": "chain A and resi 6", "style": "spacefill"},
    "two": {"input": ["ball=sample:buckyball", "strands=sample:dna"]},
}


def jobs():
    return {name: COMMON | description | {"output": name + ".png"} for name, description in DESCRIPTIONS.items()}


def pairs(key, value):
    """One per use of an option."""
    if key == "rules":
        return [pair for rule in value for pair in rule.items()]
    return [(key, each) for each in value] if isinstance(value, list) else [(key, value)]


def words(job):
    """Of the command line."""
    line = []
    for key, value in job.items():
        for name, each in pairs(key, value):
            line.append(each if name == "input" else f"--{name}" if each is True else f"--{name}={'off' if each is False else each}")
    return line


class Roads(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="nacre-roads-")
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.environment = os.environ | {"NACRE_CACHE": "off"}
        cls.expected = {}
        for name, job in jobs().items():
            folder = cls.road("command line")
            subprocess.run([PROGRAM, "render", *words(job)], check=True, cwd=folder, env=cls.environment)
            cls.expected[name] = (folder / job["output"]).read_bytes()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def road(cls, name):
        folder = cls.folder / name
        folder.mkdir(exist_ok=True)
        return folder

    def same(self, folder):
        for name, expected in self.expected.items():
            with self.subTest(description=name):
                self.assertEqual((folder / (name + ".png")).read_bytes(), expected)

    def test_descriptions_differ(self):
        self.assertEqual(len(set(self.expected.values())), len(DESCRIPTIONS))

    def test_batch(self):
        folder = self.road("batch")
        lines = "".join(json.dumps(job) + "\n" for job in jobs().values())
        subprocess.run([PROGRAM, "batch", "-"], input=lines, text=True, check=True, cwd=folder, env=self.environment,
                       stdout=subprocess.DEVNULL)
        self.same(folder)

    def test_python(self):
        folder = self.road("python")
        script = "import json, sys, nacre\n" \
                 "for job in map(json.loads, sys.stdin):\n" \
                 "    structure, output = nacre.open(job.pop('input')), job.pop('output')\n" \
                 "    structure.save(output, **{key.replace('-', '_'): value for key, value in job.items()})\n"
        lines = "".join(json.dumps(job) + "\n" for job in jobs().values())
        subprocess.run([sys.executable, "-B", "-c", script], input=lines, text=True, check=True, cwd=folder, env=self.environment)
        self.same(folder)

    def test_server(self):
        folder = self.road("server")
        server = served.Server(PROGRAM, folder)
        try:
            for name, job in jobs().items():
                query = [("format", "png")]
                for key, value in job.items():
                    if key != "output":
                        query += [(name, ("off", "on")[each] if isinstance(each, bool) else each) for name, each in pairs(key, value)]
                status, _, body = server.ask("picture?" + urllib.parse.urlencode(query))
                self.assertEqual(status, 200, (name, body[:200]))
                (folder / job["output"]).write_bytes(body)
        finally:
            server.stop()
        self.same(folder)

    @unittest.skipUnless(len(sys.argv) > 2, "no window is built")
    def test_window(self):
        folder = self.road("window")
        (folder / "jobs").write_text("".join(json.dumps(job) + "\n" for job in jobs().values()))
        ends = os.pipe()
        display = subprocess.Popen(["Xvfb", "-displayfd", str(ends[1]), "-screen", "0", "800x600x24"], pass_fds=[ends[1]],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(ends[1])
        try:
            with os.fdopen(ends[0]) as number:
                shown = ":" + number.readline().strip()
            state = {"XDG_STATE_HOME": str(folder), "XDG_CACHE_HOME": str(folder), "HOME": str(folder)}
            subprocess.run([WINDOW, "jobs"], check=True, cwd=folder, env=self.environment | state | {"DISPLAY": shown}, timeout=250)
        finally:
            display.terminate()
            display.wait()
        self.same(folder)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    WINDOW = sys.argv[2] if len(sys.argv) > 2 else ""
    unittest.main(argv=sys.argv[:1])
