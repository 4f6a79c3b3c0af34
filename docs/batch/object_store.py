#!/usr/bin/env python3
"""Pictures beside structures in an object store: object_store.py STORE [--shard I/N]

STORE is a folder with the store's layout: a mounted bucket, or its copy. The objects structures/divided/mmCIF/hh/4hhb.cif.gz,
as the PDB lays them out, get pictures/divided/hh/4hhb.png. Each of N machines draws the keys whose hash falls to it, so no
list is shared and no key is drawn by two. Run a shard again after an interruption: pictures that are there are skipped.
"""
import argparse
import fcntl
import json
import pathlib
import subprocess
import sys
import zlib

STRUCTURES, PICTURES = "structures/divided/mmCIF", "pictures/divided"


def shard_of(text):
    number, count = (int(part) for part in text.split("/"))
    if not 1 <= number <= count:
        raise argparse.ArgumentTypeError("expected I/N with I from 1 to N")
    return number, count


def jobs_of(store, number, count):
    """Keys in their order, those of this shard."""
    for path in sorted((store / STRUCTURES).glob("*/*.cif.gz")):
        if zlib.crc32(path.name.encode()) % count == number - 1:
            folder = store / PICTURES / path.parent.name
            folder.mkdir(parents=True, exist_ok=True)
            yield {"input": str(path), "output": str(folder / path.name.replace(".cif.gz", ".png"))}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("store", type=pathlib.Path)
    parser.add_argument("--shard", type=shard_of, default=(1, 1), metavar="I/N")
    arguments = parser.parse_args()
    number, count = arguments.shard
    reports = arguments.store / PICTURES / "reports"
    reports.mkdir(parents=True, exist_ok=True)
    name = f"{number}-of-{count}"
    with open(reports / f"{name}.lock", "w") as lock, open(reports / f"{name}.jsonl", "a") as report:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # the process that draws holds it, too
        except BlockingIOError:
            sys.exit(f"object_store.py: shard {number}/{count} is being drawn")
        batch = subprocess.Popen(["nacre", "batch", "-", "--resume", "--quiet", "--thumbnail", "256"], stdin=subprocess.PIPE,
                                 stdout=report, text=True, pass_fds=[lock.fileno()])
        for job in jobs_of(arguments.store, number, count):
            batch.stdin.write(json.dumps(job) + "\n")
        batch.stdin.close()
        return batch.wait()


if __name__ == "__main__":
    sys.exit(main())
