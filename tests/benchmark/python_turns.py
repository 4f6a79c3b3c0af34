"""CPU time and pictures per second of new views from Python, as JSON: python_turns.py 4HHB 1CRN. Arrays of 256 x 256."""

import json
import sys
import time

import nacre


def turned(structure, count, **options):
    """Milliseconds of CPU time per picture, and pictures per second; the first picture does not count."""
    structure.render(size=(256, 256), **options)
    start, cpu = time.perf_counter(), time.process_time()
    for turn in range(count):
        structure.render(size=(256, 256), rotate=(0, 360 * turn / count, 0), **options)
    return {"cpu": 1000 * (time.process_time() - cpu) / count, "rate": count / (time.perf_counter() - start)}


blood, crambin = nacre.open(sys.argv[1]), nacre.open(sys.argv[2])
print(json.dumps({"4HHB, spacefill": turned(blood, 100), "4HHB, cartoon": turned(blood, 20, style="cartoon"),
                  "1CRN, 1,000 turns": turned(crambin, 1000)}))
