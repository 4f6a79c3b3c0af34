"""How tools/measure runs what it measures: programs with their times, and programs in turns."""

import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
JMOL = "/usr/share/java/Jmol.jar"


class Unavailable(Exception):
    """What a figure needs is not here, in words."""


def least(rows):
    """The least of each number of several rows."""
    return {key: min(row[key] for row in rows) for key in rows[0]}


class Run:
    """Programs of one build, on the test files, with caches of their own that are warm from the second run on."""

    def __init__(self, build, rounds):
        self.build, self.rounds = build, rounds
        self.data = pathlib.Path(os.environ.get("NACRE_DATA", ROOT.parent / "shared/data"))
        self.nacre = str(build / "bin/nacre")

    def __enter__(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.env = dict(os.environ, XDG_CACHE_HOME=f"{self.folder}/cache", XDG_STATE_HOME=f"{self.folder}/state")
        return self

    def __exit__(self, *_):
        self.temporary.cleanup()

    def program(self, name):
        path = self.build / "bin" / name
        if not path.exists():
            raise Unavailable(f"{path} is not built")
        return str(path)

    def file(self, name):
        path = self.data / name
        if not path.exists():
            raise Unavailable(f"no {path}: set NACRE_DATA")
        return str(path)

    def lacks(self, what):
        """Tells of figures that are not measured, while others of their table are."""
        print(f"nacre: not measured: {what}", file=sys.stderr, flush=True)

    def needs(self, *programs):
        for program in programs:
            if not (shutil.which(program) or os.path.exists(program)):
                raise Unavailable(f"{program} is not installed")

    def words(self, command):
        """Words of a command as the page has it, `nacre render 4hhb.cif.gz`: test files get their folder."""
        words = [self.file(word) if (self.data / word).is_file() else word for word in shlex.split(command.strip("`"))]
        return [self.nacre if word == "nacre" else word for word in words]

    def text(self, *command, env=None):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=env or self.env)
        if done.returncode:
            raise Unavailable(f"{command[0]} fails: {done.stderr.strip() or done.stdout[-300:]}")
        return done.stdout

    def json(self, *command, env=None):
        return json.loads(self.text(*command, env=env))

    def timed(self, *command):
        """Seconds on the clock, and of CPU time of all threads, that a whole process takes."""
        start = time.perf_counter()
        with open(self.folder / "log", "w") as log:
            child = subprocess.Popen([str(word) for word in command], stdout=log, stderr=log, env=self.env)
            _, status, usage = os.wait4(child.pid, 0)
        wall = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            raise Unavailable(f"{shlex.join(map(str, command))}: {(self.folder / 'log').read_text().strip()}")
        return {"wall": wall, "cpu": usage.ru_utime + usage.ru_stime}

    def turns(self, programs, rounds=None):
        """@param programs  name -> function that times it, returning numbers by name
        @returns name -> the least of all rounds: programs take turns, so that the machine's load meets all"""
        rows = {name: [] for name in programs}
        for _ in range(rounds or self.rounds):
            for name, time_it in programs.items():
                rows[name].append(time_it())
        return {name: least(list_) for name, list_ in rows.items()}

    def bench(self, *arguments, path="tiles"):
        """What `nacre bench` reports of a frame by one path."""
        style = () if "--style" in arguments else ("--style", "spacefill")
        report = self.json(self.nacre, "bench", *arguments, *style, "--visibility", path, "--json")
        return {"wall": report["times"]["frame"]["min"], "cpu": report["times"]["frame_processor"]["min"],
                "pixels": report["covered_pixels"], "atoms": report["atoms"]["drawn"],
                "open": report["times"]["load"] + report["times"]["scene"], "resident": report["memory"]["resident_peak"]}

    def paths(self, *arguments, path):
        """What `nacre bench` reports of frames and bake by one path, whatever the default is: the least of all rounds."""
        found = [self.json(self.nacre, "bench", *arguments, "--visibility", path, "--json")["paths"][0] for _ in range(self.rounds)]
        return least([{"wall": one["frame"]["min"], "cpu": one["processor"]["min"], "bake": one["bake"]} for one in found])

    def batch(self, options, *more, count):
        """Times of `nacre batch` with three small molecules in turn. @param options  as the page has them"""
        jobs = self.folder / "jobs.jsonl"
        files = [self.file(name) for name in ("1crn.pdb", "1l2y.pdb", "1bna.pdb")]
        jobs.write_text("".join(f'{{"input": "{files[i % 3]}", "output": "{self.folder}/{i}.png"}}\n' for i in range(count)))
        words = [self.nacre, "batch", jobs, "--cache", "off", *self.words(options), *more]
        self.timed(*words)
        return least([self.timed(*words) for _ in range(self.rounds)])

    def jmol(self, path, size, frames):
        self.needs(JMOL, "xvfb-run", "java")
        out = self.text("xvfb-run", "-a", "java", "-Xmx3g", "-cp", JMOL, ROOT / "tests/benchmark/JmolTurn.java", path,
                        *size.split("x"), frames)
        row = json.loads(next(line for line in out.splitlines() if line.startswith("{")))
        return {"wall": row["wall"], "cpu": row["processor"]}

    def google(self, program, *arguments):
        """@returns name -> the row of a Google Benchmark program, of statistic "min", or its one run"""
        rows = self.json(self.program(program), *arguments, "--benchmark_format=json",
                         "--benchmark_enable_random_interleaving=true")["benchmarks"]
        return {row["run_name"].split("/iterations")[0].split("/repeats")[0]: row for row in rows
                if row.get("aggregate_name") == "min" or row["repetitions"] == 1}

    def window(self, *arguments, seconds):
        """What `nacre view --stats` reports of a window that is ended after some seconds."""
        self.needs("xvfb-run")
        stats = self.folder / "stats.json"
        stats.unlink(missing_ok=True)
        script = '"$@" & sleep "$SECONDS_SHOWN"; kill $!; wait $!'
        subprocess.run(["xvfb-run", "-a", "bash", "-c", script, "bash", self.nacre, "view", *map(str, arguments), "--stats", stats],
                       env=dict(self.env, SECONDS_SHOWN=str(seconds)), capture_output=True)
        if not stats.exists():
            raise Unavailable("no window opens")
        told = json.loads(stats.read_text())
        if "start_ms" not in told:
            raise Unavailable(f"no picture in {seconds} s")
        return told
