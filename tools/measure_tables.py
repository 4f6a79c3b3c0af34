"""The table of what tools/measure measures: one entry per table of docs/measurements.md, and who measures it.

A row of the page that is a command is what runs. `measure(run)` yields rows with their figures.
"""

import dataclasses
import math
import re
import sys

from measure_page import number
from measure_run import ROOT, Unavailable, least
import measure_gpu as gpu
import measure_scenes as scenes

sys.path.insert(0, str(ROOT / "tools"))


@dataclasses.dataclass
class Table:
    rows: tuple
    columns: tuple
    measure: callable
    targets: tuple = ("nacre-cli",)  # what is built for it
    ratios: dict = dataclasses.field(default_factory=dict)  # column -> the two of which it is the ratio
    slow: bool = False  # measured where it is named alone
    by_device: bool = False  # the page has rows of several devices, each called "ROW, DEVICE"


COMMANDS = ("`nacre --help`", "`nacre info 1crn.pdb`", "`nacre render sample:dna`", "`nacre render sample:dna --supersample 1`",
            "`nacre render sample:dna --supersample 1 --size 64x64`", "`nacre render 4hhb.cif.gz --style spacefill`",
            "`nacre render 4hhb.cif.gz --cache off --style spacefill`", "`nacre render 4hhb.cif.gz --cache off --style cartoon`",
            "`nacre render 4hhb.cif.gz --cache off --style surface`")
EFFECTS = {"plain": "", "`--halos 6`": "", "`--contours 2 --contour-weights 3`": "",
           "`--style surface --surface-opacity 0.5`": "--style surface", "`--depth-of-field 10`": "",
           "`--visibility encoded`": "", "`--visibility fragdepth`": "", "`--visibility encoded --halos 6`": "",
           "`--visibility encoded --depth-of-field 10`": "", "`--visibility fragdepth --depth-of-field 10`": "",
           "`--contours 2 --contour-weights 3 --depth-of-field 10`": ""}
PATHS = ("encoded", "fragdepth", "deferred", "raster-order", "tiles")
FRAMES = {"1BNA": "1bna.pdb", "4HHB": "4hhb.cif.gz", "1AON": "1aon-groel.pdb.gz"}
BAKES = {"1BNA": "1BNA", "4HHB": "4HHB", "1AON": "1AON", "3J6R, 16 directions": "3J6R capsid"}
BAKED = {"1BNA": "1bna.pdb", "4HHB": "4hhb.cif.gz", "4V5A": "4v5a-ribosome.mmtf"}
DIRECTIONS = ("16", "44", "128", "512", "44, the original's")
SHAPES = {"none, octagon": ("off", "octagon"), "square, octagon": ("square", "octagon"),
          "octagon, octagon": ("octagon", "octagon"), "dome of 3, octagon": ("dome of 3", "octagon"),
          "dome of 3, pyramid": ("dome of 3", "pyramid")}
SHAPED = {"1BNA": "1bna.pdb", "4HHB": "4hhb.pdb", "1AON": "1aon-groel.pdb.gz", "pump": "neon-pump.pdb"}
LADDER = {"1BNA": "1bna.pdb", "4HHB": "4hhb.pdb", "pump": "neon-pump.pdb"}
FORMATS = {"RGBA16F": "rgba16f", "RG16F": "rg16f", "A2B10G10R10": "a2b10g10r10", "RGBA8": "rgba8"}
MESHES = {"4HHB, cartoon": ("4hhb.cif.gz", "cartoon"), "4HHB, surface": ("4hhb.cif.gz", "surface"),
          "4V5A, cartoon": ("4v5a-ribosome.mmtf", "cartoon")}
READ = {"4HHB, PDB": "4hhb.pdb", "1AON, PDB": "1aon-groel.pdb.gz", "1F2N's half, PDB": "1f2n-halfcapsid-hybrid36.pdb.gz",
        "neon pump, PDB, a CONECT each": "neon-pump.pdb", "4HHB, mmCIF": "4hhb.cif.gz", "1IGY, mmCIF": "1igy.cif.gz",
        "3J6R's capsid, mmCIF": "3j6r-capsid-expanded.cif.gz",
        "3J6R's capsid, BinaryCIF": "3j6r-capsid-expanded.cif.gz as BinaryCIF", "1IGY, BinaryCIF": "1igy.bcif",
        "4V5A, MMTF": "4v5a-ribosome.mmtf"}
BATCHES = ("`--thumbnail 256`", "`--size 256x256 --occlusion-detail 12`", "`--size 256x256`", "`--size 256x256 --occlusion off`")
LEVELS = ("`level_benchmark maps/3nzd.cif maps/3nzd.ccp4.gz focus,20`",
          "`level_benchmark maps/3nzd.cif maps/3nzd.ccp4.gz focus,20 surface`",
          "`level_benchmark maps/3nzd.cif maps/3nzd.ccp4.gz`", "`level_benchmark 256`")
WINDOWS = {"1BNA": ["1bna.pdb"], "1AON, cartoon": ["1aon-groel.pdb.gz", "--style", "cartoon"]}


def commands(run):
    for row in COMMANDS:
        words = run.words(row)
        words += ["-o", run.folder / "a.png"] if "render" in words else []
        run.timed(*words)  # warms the caches
        best = least([run.timed(*words) for _ in range(5 if "off" in words else 10)])
        yield row, {"clock, s": best["wall"], "CPU, s": best["cpu"]}


def effects(run):
    for row, plain in EFFECTS.items():
        style = "" if "--style" in row else "--style spacefill"
        picture = run.words(f"nacre render 4hhb.cif.gz {style} --size 1024x1024 -o {run.folder}/a.png")
        base = picture + run.words(plain)
        if row == "plain":
            best = least([run.timed(*base) for _ in range(4)])
            yield row, {"CPU, s": best["cpu"], "plain, s": best["cpu"], "ratio": 1.0, "dB": decibels(run, base)}
            continue
        drawn = picture + run.words(row)
        for words in (base, drawn):
            run.timed(*words)
        best = run.turns({"plain": lambda: run.timed(*base), "now": lambda: run.timed(*drawn)}, run.rounds + 1)
        now, before = best["now"]["cpu"], best["plain"]["cpu"]
        yield row, {"CPU, s": now, "plain, s": before, "ratio": now / before, "dB": decibels(run, drawn)}


def decibels(run, words):
    """Signal to noise of a picture against 8 x 8 samples per pixel everywhere."""
    import numpy
    from compare_pictures import rows
    pictures = []
    for more in ([], ["--supersample", "8"]):
        run.timed(*words, *more)
        pictures.append(numpy.array([list(row) for row in rows(run.folder / "a.png")[2]], float))
    return float(10 * math.log10(255 ** 2 / numpy.mean((pictures[0] - pictures[1]) ** 2)))


def frames(run):
    for path in PATHS:
        yield f"`{path}`", {name: run.bench(run.file(file), "--frames", "15", path=path)["wall"] for name, file in FRAMES.items()}


def batches(run):
    for row in BATCHES:
        count = 300
        best = run.batch(row, count=count)
        yield row, {"CPU, ms per picture": 1000 * best["cpu"] / count, "pictures per second": count / best["wall"]}


def python(run):
    module = run.build / "python/nacre"
    if not list(module.glob("_nacre*")):
        raise Unavailable(f"{module} is not built")
    env = dict(run.env, PYTHONPATH=str(module.parent))
    script = ROOT / "tests/benchmark/python_turns.py"
    for row, figures in run.json("/usr/bin/python3", script, run.file("4hhb.cif.gz"), run.file("1crn.pdb"), env=env).items():
        yield row, {"CPU, ms per picture": figures["cpu"], "pictures per second": figures["rate"]}


def windows(run):
    for row, (file, *options) in WINDOWS.items():
        shown = [run.window(run.file(file), *options, seconds=6)["start_ms"]["first_picture"] for _ in range(run.rounds + 1)]
        yield row, {"first picture, ms": min(shown)}


def playing(run):
    said = run.text(run.program("play_benchmark"))
    yield "100,000 atoms of a DCD trajectory", {"CPU, ms per frame": number(re.search(r"([\d.]+) of processor time", said)[1]),
                                                "frames per second": number(re.search(r"(\d+) frames per second", said)[1])}


def levels(run):
    for row in LEVELS:
        program, *rest = run.words(row)
        found = re.search(r", (\d+) lines or triangles at most: ([\d.]+) ms .*?\(at most ([\d.]+)\)", run.text(run.program(program), *rest))
        yield row, {"lines or triangles": int(found[1]), "CPU, ms": float(found[2]), "at most, ms": float(found[3])}


def bakes(run):
    found = run.google("occlusion_benchmark", "--benchmark_filter=bake/")
    for row, name in BAKES.items():
        one = next(value for key, value in found.items() if key.endswith(f"bake/{name}"))
        yield row, {"bake, ms": one["begin_ms"] + one["steps_ms"], "open texels, ms": one["begin_ms"],
                    "million questions": one["texel_directions"] / 1e6, "ns per question": one["ns_each"], "times the floor": one["of_floor"]}


def baked(run):
    for row, file in BAKED.items():
        words = [run.nacre, "render", run.file(file), "--style", "spacefill", "--cache", "off", "--supersample", "1", "-o", run.folder / "a.png"]
        best = run.turns({"with": lambda: run.timed(*words, "--occlusion", "128"), "without": lambda: run.timed(*words, "--occlusion", "off")})
        yield row, {"s": best["with"]["cpu"] - best["without"]["cpu"]}


def rays(run):
    for line in run.text(run.program("occlusion_table"), 5000, 4096).splitlines()[2:]:
        name, *values = [cell.strip() for cell in line.strip("|").split("|")]
        yield f"`{name}`" if ":" in name else name, dict(zip(DIRECTIONS, map(float, values)))


def fragments(run):
    found = {name: run.json(run.program("shape_benchmark"), run.file(file))[0]["shapes"] for name, file in SHAPED.items()}
    for row, (plates, impostor) in SHAPES.items():
        one = {name: next(s for s in shapes if (s["plates"], s["impostor"]) == (plates, impostor)) for name, shapes in found.items()}
        costly = ("depth encoding", "impostor colour")
        yield row, {name: sum(p["shaded_fragments"] for p in s["passes"] if p["name"] in costly) / 2 / s["visible"] for name, s in one.items()}


def ladder(run):
    said = run.text(run.program("test_renderer"), "--gtest_filter=*Ladder*", env=dict(run.env, NACRE_DATA=str(run.data)))
    for row, name in FORMATS.items():
        yield row, {column: int(re.search(rf"^{re.escape(file)} {name}: (\d+) of", said, re.MULTILINE | re.IGNORECASE)[1])
                    for column, file in LADDER.items()}


def meshes(run):
    for row, (file, style) in MESHES.items():
        options = [run.file(file), "--style", style, "--size", "640x960", "--mesh-error", "0.5"]
        levels = run.json(run.nacre, "plan", *options, "--json")["mesh_levels"]
        # The first run compiles shaders beside its frames.
        found = min((run.bench(*options, "--occlusion", "off") for _ in range(run.rounds)), key=lambda times: times["wall"])
        yield row, {"triangles drawn": sum(level["drawn"] for level in levels), "all": levels[0]["triangles"],
                    "ms": found["wall"], "CPU, ms": found["cpu"]}


def exports(run):
    for row, file in (("4HHB", "4hhb.cif.gz"), ("1AON", "1aon-groel.pdb.gz")):
        yield row, {"s": run.timed(run.nacre, "export", run.file(file), "-o", run.folder / "a.stl", "--style", "surface")["cpu"]}


def reading(run):
    files = [run.file(name) for name in READ.values() if " as " not in name]
    found = run.google("load_benchmark", *files)
    for row, name in READ.items():
        read, load, gemmi = (found.get(f"{name}/{what}") for what in ("read", "load", "gemmi"))
        values = {"read, ms": read["cpu_time"], "MB/s": read["bytes_per_second"] / 1e6, "with bonds, ms": load["cpu_time"]}
        yield row, values | ({"gemmi, ms": gemmi["cpu_time"], "ratio": read["cpu_time"] / gemmi["cpu_time"]} if gemmi else {})


def building(run):
    clone, path = run.folder / "clone", run.folder / "clone/build/test"
    run.text("git", "clone", "-q", ROOT, clone)
    run.env["CCACHE_DISABLE"] = "1"
    begun = run.timed("cmake", "-S", clone, "--preset", "test")["wall"]
    yield "clean build with tests", {"minutes": (begun + run.timed("ninja", "-C", path)["wall"]) / 60}
    yield "test suite", {"minutes": run.timed("ctest", "--test-dir", path, "--parallel", "3")["wall"] / 60}


TABLES = {
    "commands": Table(COMMANDS, ("clock, s", "CPU, s"), commands),
    "frames": Table(tuple(f"`{path}`" for path in PATHS), tuple(FRAMES), frames),
    "jmol": Table(scenes.JMOL_ROWS, scenes.JMOL_COLUMNS, scenes.jmol, ratios=scenes.JMOL_RATIOS),
    "styles": Table(scenes.STYLE_ROWS, scenes.STYLE_COLUMNS, scenes.styles),
    "large": Table(scenes.LARGE_ROWS, scenes.LARGE_COLUMNS, scenes.large),
    "movie": Table(scenes.MOVIE_ROWS, scenes.MOVIE_COLUMNS, scenes.movie, slow=True),
    "mesoscale": Table(scenes.MESOSCALE_ROWS, scenes.MESOSCALE_COLUMNS, scenes.mesoscale),
    "effects": Table(tuple(EFFECTS), ("CPU, s", "plain, s", "ratio", "dB"), effects, ratios={"ratio": ("CPU, s", "plain, s")}),
    "batches": Table(BATCHES, ("CPU, ms per picture", "pictures per second"), batches),
    "python": Table(("4HHB, spacefill", "4HHB, cartoon", "1CRN, 1,000 calls of render()", "1CRN, 1,000 turns"),
                    ("CPU, ms per picture", "pictures per second"), python, ("nacre_python",)),
    "window": Table(tuple(WINDOWS), ("first picture, ms",), windows),
    "playing": Table(("100,000 atoms of a DCD trajectory",), ("CPU, ms per frame", "frames per second"), playing, ("play_benchmark",)),
    "levels": Table(LEVELS, ("lines or triangles", "CPU, ms", "at most, ms"), levels, ("level_benchmark",)),
    "fragments": Table(tuple(SHAPES), tuple(SHAPED), fragments, ("shape_benchmark",)),
    "bakes": Table(tuple(BAKES), ("bake, ms", "open texels, ms", "million questions", "ns per question", "times the floor"), bakes,
                   ("occlusion_benchmark",)),
    "baked": Table(tuple(BAKED), ("s",), baked),
    "rays": Table(("`sample:dna`", "1BNA", "4HHB", "neon pump", "4TRA", "1CRN, ball and stick", "caffeine, ball and stick",
                   "4HHB, cartoon", "4HHB, surface", "1CRN, cartoon"), DIRECTIONS, rays, ("occlusion_table",)),
    "ladder": Table(tuple(FORMATS), tuple(LADDER), ladder, ("test_renderer",)),
    "meshes": Table(tuple(MESHES), ("triangles drawn", "all", "ms", "CPU, ms"), meshes),
    "exports": Table(("4HHB", "1AON"), ("s",), exports),
    "reading": Table(tuple(READ), ("read, ms", "MB/s", "gemmi, ms", "ratio", "with bonds, ms"), reading, ("load_benchmark",),
                     {"ratio": ("read, ms", "gemmi, ms")}),
    "gpu": Table(tuple(gpu.SCENES), gpu.COLUMNS, gpu.frames, slow=True, by_device=True),
    "gpu-batches": Table(gpu.BATCHES, tuple(gpu.JOBS), gpu.batches, slow=True, by_device=True),
    "build": Table(("clean build with tests", "test suite"), ("minutes",), building, slow=True),
}

# Rows of the page's first table, each another table's figure.
SUMMARY = {
    "first picture of a sample, warm, s on the clock": ("commands", "`nacre render sample:dna`", "clock, s"),
    "first picture of 4HHB, warm, s of CPU time": ("commands", "`nacre render 4hhb.cif.gz --style spacefill`", "CPU, s"),
    "frame of 4HHB, 640x960, ms": ("frames", "`tiles`", "4HHB"),
    "the same as a multiple of Jmol's": ("jmol", "4HHB, 640x960", "ratio"),
    "occlusion of 4HHB, 128 directions, ms of CPU time": ("bakes", "4HHB", "bake, ms"),
    "thumbnail of 256 x 256 pixels, ms of CPU time": ("batches", "`--thumbnail 256`", "CPU, ms per picture"),
    "turns of 1CRN per second, from Python": ("python", "1CRN, 1,000 turns", "pictures per second"),
    "reading 4HHB with bonds, mmCIF, ms of CPU time": ("reading", "4HHB, mmCIF", "with bonds, ms"),
    "clean build with tests, minutes": ("build", "clean build with tests", "minutes"),
}
