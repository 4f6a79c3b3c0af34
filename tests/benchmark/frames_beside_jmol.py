#!/usr/bin/env python3
"""Nacre's frames beside Jmol's in one sitting, and larger scenes beside 4HHB's own: docs/measurements.md has the table.

usage: NACRE_DATA=FOLDER tests/benchmark/frames_beside_jmol.py PROGRAM [--rounds N] [--only jmol|large|looks] [--sizes WxH,...]

Programs take turns, so that the machine's moods meet all of them; the least of all rounds counts, on the clock and in
processor time of all threads. Nacre draws the whole look, occlusion included, of one sample a pixel; Jmol draws no
occlusion. Needs Debian's jmol, default-jdk and xvfb.
"""

import argparse
import gzip
import json
import os
import subprocess
import sys
import tempfile

DATA = os.environ.get("NACRE_DATA", "../shared/data")
HERE = os.path.dirname(os.path.abspath(__file__))


def nacre(program, *arguments):
    """The report of `nacre bench` about the path that `auto` takes on software devices."""
    command = [program, "bench", *arguments, "--visibility", "tiles", "--json"]
    report = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return {"atoms": report["atoms"]["drawn"], "covered_pixels": report["covered_pixels"],
            "wall": report["times"]["frame"]["min"], "processor": report["times"]["frame_processor"]["min"],
            "resident": report["memory"]["resident_peak"]}


def jmol(path, size, frames):
    command = ["xvfb-run", "-a", "java", "-Xmx3g", "-cp", "/usr/share/java/Jmol.jar",
               os.path.join(HERE, "JmolTurn.java"), path, *size.split("x"), str(frames)]
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return json.loads(next(line for line in out.splitlines() if line.startswith("{")))


def least(rows):
    best = dict(rows[0])
    for row in rows[1:]:
        best.update({key: min(best[key], row[key]) for key in ("wall", "processor")})
    return best


def take_turns(rounds, programs):
    """@param programs  name -> function that times it. @returns name -> the least of all rounds"""
    rows = {name: [] for name in programs}
    for _ in range(rounds):
        for name, time in programs.items():
            rows[name].append(time())
    return {name: least(list_) for name, list_ in rows.items()}


def grid_of_capsids(folder, across=4, apart=640):
    """A file whose assembly is a grid of 3J6R's capsids: across x across x 60 copies. @returns its path"""
    lines, operators, at = [], [], None
    for line in gzip.open(os.path.join(DATA, "3j6r-hpv16.pdb.gz"), "rt"):
        if line.startswith("REMARK 350   BIOMT"):
            at = len(lines) if at is None else at
            operators.append([float(word) for word in line[24:].split()])
        else:
            lines.append(line)
    placed = []
    for cell in range(across * across):
        shift = (cell % across * apart, cell // across * apart, 0)
        for i, (x, y, z, t) in enumerate(operators):
            number = (cell * len(operators) + i) // 3 + 1
            placed.append(f"REMARK 350   BIOMT{i % 3 + 1} {number:3d}{x:10.6f}{y:10.6f}{z:10.6f}{t + shift[i % 3]:15.5f}\n")
    lines[at:at] = placed
    path = os.path.join(folder, "capsids.pdb")
    with open(path, "w") as file:
        file.writelines(lines)
    return path


def say(*cells):
    print("| " + " | ".join(c if isinstance(c, str) else f"{c:.2f}" if isinstance(c, float) else str(c) for c in cells) + " |",
          flush=True)


def beside_jmol(program, sizes, rounds):
    say("molecule", "size", "Nacre, clock", "processor", "Jmol, clock", "processor", "ratio, clock", "processor",
        "covered, Nacre", "Jmol")
    for name, file in (("1BNA", "1bna.mmtf"), ("4HHB", "4hhb.pdb"), ("4V5A", "4v5a-ribosome.mmtf")):
        path = os.path.join(DATA, file)
        for size in sizes:
            best = take_turns(rounds, {"jmol": lambda: jmol(path, size, 36),
                                       "nacre": lambda: nacre(program, path, "--size", size, "--frames", "72")})
            a, b = best["nacre"], best["jmol"]
            say(name, size, a["wall"], a["processor"], b["wall"], b["processor"], a["wall"] / b["wall"],
                a["processor"] / b["processor"], a["covered_pixels"], b["covered_pixels"])


def beside_hemoglobin(program, sizes, rounds, rows, frames):
    """Rows of (name, arguments of bench), each in times of 4HHB's own frame, whole and a covered pixel."""
    say("scene", "size", "atoms", "clock", "processor", "times 4HHB, clock", "processor", "processor a covered pixel",
        "resident, MB")
    reference = [os.path.join(DATA, "4hhb.pdb"), "--frames", "20"]
    for name, arguments in rows:
        for size in sizes:
            best = take_turns(rounds, {
                "4HHB": lambda: nacre(program, *reference, "--size", size),
                "scene": lambda: nacre(program, *arguments, "--size", size, "--frames", str(frames))})
            a, b = best["scene"], best["4HHB"]
            pixel = (a["processor"] / a["covered_pixels"]) / (b["processor"] / b["covered_pixels"])
            say(name, size, a["atoms"], a["wall"], a["processor"], a["wall"] / b["wall"], a["processor"] / b["processor"],
                pixel, a["resident"] >> 20)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", choices=["jmol", "large", "looks"])
    parser.add_argument("--sizes", default="640x960,2048x1536")
    options = parser.parse_args()
    sizes = options.sizes.split(",")
    print("load", *os.getloadavg(), file=sys.stderr)
    wants = lambda part: options.only in (None, part)
    if wants("jmol"):
        beside_jmol(options.program, sizes, options.rounds)
    in_data = lambda file: os.path.join(DATA, file)
    if wants("looks"):
        hemoglobin = in_data("4hhb.pdb")
        beside_hemoglobin(options.program, sizes, options.rounds, [
            ("perspective", [hemoglobin, "--projection", "perspective"]),
            ("ball and stick", [hemoglobin, "--style", "ball-and-stick"]),
            ("licorice", [hemoglobin, "--style", "licorice"]),
            ("zoom 10", [hemoglobin, "--zoom", "10"]),
            ("edges", [hemoglobin, "--supersample", "auto"])], 20)
    if wants("large"):
        with tempfile.TemporaryDirectory() as folder:
            few = ["--occlusion", "16"]
            beside_hemoglobin(options.program, sizes, options.rounds, [
                ("1AON", [in_data("1aon-groel.pdb.gz")]),
                ("3J6R's capsid", [in_data("3j6r-hpv16.pdb.gz"), "--assembly", "1", *few]),
                ("16 capsids", [grid_of_capsids(folder), "--assembly", "1", *few])], 5)
    print("load", *os.getloadavg(), file=sys.stderr)


main()
