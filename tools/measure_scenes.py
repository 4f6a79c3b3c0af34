"""Frames that tools/measure times in turns: beside Jmol's, and styles and larger scenes beside 4HHB's own."""

import gzip
import math

from measure_run import ROOT

SIZES = ("640x960", "2048x1536")
JMOL = {"1BNA": "1bna.mmtf", "4HHB": "4hhb.pdb", "4V5A": "4v5a-ribosome.mmtf"}
STYLES = {"perspective": ["--projection", "perspective"], "ball and stick": ["--style", "ball-and-stick"],
          "licorice": ["--style", "licorice"], "`--zoom 10`": ["--zoom", "10"], "16 samples at edges": ["--supersample", "auto"]}
LARGE = ("1AON", "3J6R's capsid", "16 capsids")


def sized(names):
    return tuple(f"{name}, {size}" for name in names for size in SIZES)


JMOL_ROWS, STYLE_ROWS, LARGE_ROWS = sized(JMOL), sized(STYLES), sized(LARGE)
JMOL_COLUMNS = ("ms", "CPU, ms", "Jmol, ms", "Jmol, CPU, ms", "ratio", "CPU ratio")
JMOL_RATIOS = {"ratio": ("ms", "Jmol, ms"), "CPU ratio": ("CPU, ms", "Jmol, CPU, ms")}
STYLE_COLUMNS = ("times space-filling", "per covered pixel")
MESOSCALE_ROWS = tuple(f"{count:,}" for count in (1_000, 10_000, 100_000, 1_000_000))
MESOSCALE_COLUMNS = ("million atoms", "opened after, s", "ms", "CPU, ms", "resident, MB")
MOVIE_ROWS = ("load and bake", "a frame", "1,079 frames")
MOVIE_COLUMNS = ("CPU, s",)
LARGE_COLUMNS = ("ms", "CPU, ms", "times 4HHB", "CPU, times 4HHB", "resident, MB")


def jmol(run):
    for name, file in JMOL.items():
        path = run.file(file)
        for size in SIZES:
            best = run.turns({"jmol": lambda: run.jmol(path, size, 36),
                              "nacre": lambda: run.bench(path, "--size", size, "--frames", "72")})
            a, b = best["nacre"], best["jmol"]
            yield f"{name}, {size}", {"ms": a["wall"], "CPU, ms": a["cpu"], "Jmol, ms": b["wall"], "Jmol, CPU, ms": b["cpu"],
                                      "ratio": a["wall"] / b["wall"], "CPU ratio": a["cpu"] / b["cpu"]}


def beside_hemoglobin(run, size, count, *arguments):
    """4HHB's space-filling frame and another in turns. @returns both"""
    best = run.turns({"4HHB": lambda: run.bench(run.file("4hhb.pdb"), "--size", size, "--frames", "20"),
                      "scene": lambda: run.bench(*arguments, "--size", size, "--frames", str(count))})
    return best["scene"], best["4HHB"]


def styles(run):
    for name, options in STYLES.items():
        for size in SIZES:
            a, b = beside_hemoglobin(run, size, 20, run.file("4hhb.pdb"), *options)
            times = a["cpu"] / b["cpu"]
            yield f"{name}, {size}", {"times space-filling": times, "per covered pixel": times * b["pixels"] / a["pixels"]}


def place_capsids(run, shifts):
    """A file whose assembly is 3J6R's capsid, 60 copies, at each of the shifts. @returns its path"""
    lines, operators, at = [], [], None
    for line in gzip.open(run.file("3j6r-hpv16.pdb.gz"), "rt"):
        if line.startswith("REMARK 350   BIOMT"):
            at = len(lines) if at is None else at
            operators.append([float(word) for word in line[24:].split()])
        else:
            lines.append(line)
    placed = []
    for cell, shift in enumerate(shifts):
        for i, (x, y, z, t) in enumerate(operators):
            copy = (cell * len(operators) + i) // 3 + 1
            placed.append(f"REMARK 350   BIOMT{i % 3 + 1} {copy:3d}{x:10.6f}{y:10.6f}{z:10.6f}{t + shift[i % 3]:15.5f}\n")
    lines[at:at] = placed
    path = run.folder / "capsids.pdb"
    path.write_text("".join(lines))
    return path


def movie(run):
    """Three capsids of 3J6R turn. The time of a frame is the difference of two movies."""
    run.needs("ffmpeg")
    turns = [cell * math.tau / 3 for cell in range(3)]
    path = place_capsids(run, [(370 * math.cos(turn), 370 * math.sin(turn), 0) for turn in turns])

    def seconds(frames):
        command = [run.nacre, "movie", path, "--assembly", "1", "--style", "spacefill", "--size", "1920x1080", "--spin",
                   "y", "--fps", "30", "--seconds", str(frames / 30), "--cache", "off", "-o", run.folder / "movie.mp4"]
        return run.timed(*command)["cpu"]

    few, more = seconds(2), seconds(32)
    frame = (more - few) / 30
    begin = few - 2 * frame
    for name, figure in zip(MOVIE_ROWS, (begin, frame, begin + 1079 * frame)):
        yield name, {"CPU, s": figure}


def large(run):
    few = ["--assembly", "1", "--occlusion", "16"]
    grid = [(640 * (cell % 4), 640 * (cell // 4), 0) for cell in range(16)]
    arguments = {"1AON": [run.file("1aon-groel.pdb.gz")], "3J6R's capsid": [run.file("3j6r-hpv16.pdb.gz"), *few],
                 "16 capsids": [place_capsids(run, grid), *few]}
    for name in LARGE:
        for size in SIZES:
            a, b = beside_hemoglobin(run, size, 5, *arguments[name])
            yield f"{name}, {size}", {"ms": a["wall"], "CPU, ms": a["cpu"], "times 4HHB": a["wall"] / b["wall"],
                                      "CPU, times 4HHB": a["cpu"] / b["cpu"], "resident, MB": a["resident"] >> 20}


def mesoscale(run):
    """Scenes of tests/benchmark/large_scene.py, of the proteins of the test data's PDB files."""
    files = [*sorted(run.data.glob("*.pdb")), run.file("1eve-acetylcholinesterase.pdb.gz"), run.file("1igy.pdb.gz")]
    for name in MESOSCALE_ROWS:
        path = run.folder / "large.cif"
        run.text(ROOT / "tests/benchmark/large_scene.py", "--instances", name.replace(",", ""), "-o", path, *files)
        best = run.bench(path, "--assembly", "1", "--occlusion", "off", "--size", "640x960", "--frames", "10")
        yield name, {"million atoms": best["atoms"] / 1e6, "opened after, s": best["open"] / 1e3, "ms": best["wall"],
                     "CPU, ms": best["cpu"], "resident, MB": best["resident"] >> 20}
