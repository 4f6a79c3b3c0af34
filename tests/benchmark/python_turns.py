"""CPU time and pictures per second of new views from Python, as JSON: python_turns.py 4HHB 1CRN. Arrays of 256 x 256."""

import json
import sys
import time

import nacre

SIZE = {"size": (256, 256)}


def views(count):
    return ({"rotate": (0, 360 * turn / count, 0)} for turn in range(count))


def one_by_one(structure, count, **options):
    return (structure.render(**view, **SIZE, **options) for view in views(count))


def in_turn(structure, count, **options):
    return structure.pictures(views(count), **SIZE, **options)


def turned(draw, structure, count, **options):
    """Milliseconds of CPU time per picture, and pictures per second; the first picture does not count."""
    structure.render(**SIZE, **options)
    start, cpu = time.perf_counter(), time.process_time()
    for picture in draw(structure, count, **options):
        del picture
    return {"cpu": 1000 * (time.process_time() - cpu) / count, "rate": count / (time.perf_counter() - start)}


blood, crambin = nacre.open(sys.argv[1]), nacre.open(sys.argv[2])
print(json.dumps({"4HHB, spacefill": turned(one_by_one, blood, 100), "4HHB, cartoon": turned(one_by_one, blood, 20, style="cartoon"),
                  "1CRN, 1,000 calls of render()": turned(one_by_one, crambin, 1000),
                  "1CRN, 1,000 turns": turned(in_turn, crambin, 1000)}))
