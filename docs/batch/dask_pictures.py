#!/usr/bin/env python3
"""Thumbnails of many structures by Dask distributed: dask_pictures.py FOLDER_OUT [--scheduler ADDRESS] < LIST

LIST has a structure's path per line. Without --scheduler, two workers of this machine draw. Run it again after an
interruption: finished pictures are skipped, and none is drawn twice.
"""
import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import subprocess
import sys

CHUNK = 100  # pictures of a task: one process, one device


def draw(out, jobs):
    """One task. A task that runs again, since its worker is gone, waits for the process that the worker left."""
    text = "".join(json.dumps(job) + "\n" for job in jobs)
    name = hashlib.sha256(text.encode()).hexdigest()[:16]
    with open(out / f".{name}.lock", "w") as lock, open(out / f"report-{name}.jsonl", "a") as report:
        fcntl.flock(lock, fcntl.LOCK_EX)
        run = subprocess.run(["nacre", "batch", "-", "--resume", "--quiet", "--jobs", "1", "--thumbnail", "256"], input=text,
                             text=True, stdout=report, pass_fds=[lock.fileno()])
    return run.returncode


def main():
    from dask.distributed import Client, LocalCluster, as_completed

    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--scheduler", help="of a cluster whose workers see the same folders")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    structures = [os.path.abspath(line.strip()) for line in sys.stdin if line.strip()]
    jobs = [{"input": path, "output": str(out / f"{os.path.basename(path)}.png")} for path in structures]
    if len({job["output"] for job in jobs}) < len(jobs):
        sys.exit("dask_pictures.py: two structures have one name")
    cluster = arguments.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        chunks = [jobs[first:first + CHUNK] for first in range(0, len(jobs), CHUNK)]
        futures = [client.submit(draw, out, chunk, pure=False) for chunk in chunks]
        failed = sum(future.result() != 0 for future in as_completed(futures))
    missing = sum(not os.path.exists(job["output"]) for job in jobs)
    print(f"{len(jobs) - missing} of {len(jobs)} pictures are there, {failed} of {len(chunks)} tasks failed")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
