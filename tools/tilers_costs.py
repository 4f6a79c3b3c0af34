"""What a frame of spheres costs: instructions of its stages (docs/tilers.json) times vertices and fragments of 4HHB, which
a software device counts (docs/tilers_fragments.json). For tools/tilers.

GPUs that bin vertices run them twice. For those that store vertex outputs a byte, written and read, counts as twenty
instructions: 100 pJ a byte and 10 an instruction.
"""

import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
CORNERS = {"off": 0, "square": 4, "octagon": 8, "dome of 3": 24, "pyramid": 9}
# Of a vertex: its position, the sphere, its colour and patch; a fetched sphere's colour and patch.
BYTES = {"opaque prepass": 16, "depth encoding": 32, "impostor colour": 52, "fetched": 32}
PER_BYTE = 20
COLOUR = "impostor colour"
SHAPES = (("square", "square"), ("octagon", "square"), ("octagon", "octagon"), ("dome of 3", "pyramid"))
SHAPE_DEVICES, SHAPE_RADII = ("Adreno 740", "V3D 4.2", "Mali-G610"), (2.8, 7.0, 14.1, 21.1)
MALI, MALI_RADII = ("Mali-G52, Arm's driver", "Mali-G610, Arm's driver"), (7.0, 14.1)
# A column of the table: the path, its passes, and whether depth is tested early, against plates.
PATHS = {"`encoded`, RGBA16F by MIN": ("encoded, RGBA16F", ("opaque prepass", "depth encoding", COLOUR), True),
         "`encoded`, in raster order": ("encoded", ("opaque prepass", "depth encoding", COLOUR), True),
         "`raster-order`": ("raster-order", ("opaque prepass", COLOUR), True),
         "`fragdepth`, tested early": ("fragdepth", ("opaque prepass", COLOUR), True),
         "`fragdepth`, tested late": ("fragdepth", (COLOUR,), False)}


def counted():
    return json.loads((ROOT / "docs/tilers_fragments.json").read_text())


def stages(pipelines, name):
    """Instructions of a vertex and of a fragment of a pass over spheres, and bytes of a vertex."""
    kind = "fetched spheres" if f"{name}, fetched spheres, vertex" in pipelines else "spheres"
    vertex, fragment = (pipelines[f"{name}, {kind}, {stage}"]["instructions"] for stage in ("vertex", "fragment"))
    blending = pipelines.get(f"{name}, blending, fragment", {"instructions": 0})["instructions"]
    return vertex, fragment + blending, BYTES["fetched" if kind != "spheres" else name]


def frame_cost(pipelines, shape, spheres, stores, passes=None):
    """Million instructions of a frame."""
    total = 0
    for name, fragments in shape["fragments"].items():
        if passes and name not in passes:
            continue
        corners = spheres * CORNERS[shape["plates" if name == "opaque prepass" else "impostor"]]
        vertex, fragment, size = stages(pipelines, name)
        again = PER_BYTE * size if stores else min(vertex, stages(pipelines, "depth encoding")[0])  # positions
        total += corners * (vertex + again) + fragments * fragment
    return total / 1e6


def shape_of(frame, plates, impostor):
    return next(s for s in frame["shapes"] if (s["plates"], s["impostor"]) == (plates, impostor))


def path_cost(rows, counts, frame, device, column):
    """By the shapes that cost least."""
    path, passes, early = PATHS[column]
    pipelines = rows[device]["paths"][path]["pipelines"]
    return min(frame_cost(pipelines, shape_of(frame, plates, impostor), counts["spheres"], True, passes)
               for plates, impostor in (SHAPES if early else (("off", "square"), ("off", "octagon"))))


def paths_table(rows, counts):
    lines = ["| device | radius, pixels | " + " | ".join(PATHS) + " |", "|---" * (2 + len(PATHS)) + "|"]
    for device in (d for d in MALI if d in rows):
        for frame in (f for f in counts["frames"] if f["radius"] in MALI_RADII):
            costs = [path_cost(rows, counts, frame, device, column) for column in PATHS]
            lines.append(f"| {device} | {frame['radius']} |" + "".join(f" {c:.1f} |" for c in costs))
    return lines


def shapes_table(rows, counts):
    lines = ["| device | radius, pixels |" + "".join(f" {p}, {i} |" for p, i in SHAPES), "|---" * (2 + len(SHAPES)) + "|"]
    for device in (d for d in SHAPE_DEVICES if d in rows):
        stores = rows[device]["driver"] == "panvk"
        for frame in (f for f in counts["frames"] if f["radius"] in SHAPE_RADII):
            costs = [frame_cost(rows[device]["paths"]["encoded"]["pipelines"], shape_of(frame, *shape), counts["spheres"],
                                stores) for shape in SHAPES]
            lines.append(f"| {device} | {frame['radius']} |" + "".join(f" {c:.1f} |" for c in costs))
    return lines


def sphere_instructions(pipelines, stage):
    """Of each pass over spheres, in order."""
    passes = ("opaque prepass", "depth encoding", COLOUR)
    found = [pipelines.get(f"{name}, {kind}, {stage}") for name in passes for kind in ("spheres", "fetched spheres")]
    return ", ".join(str(numbers["instructions"]) for numbers in found if numbers)


def eyes_table(rows):
    """Two frames of one eye each beside one frame of both."""
    lines = ["| device | path | instructions of a sphere's vertex: an eye, both | of its fragment: an eye, both | "
             "loaded, stored per pixel: two frames, one | draws: two frames, one |", "|---" * 6 + "|"]
    for device, row in rows.items():
        for path in ("encoded", "fragdepth", "raster-order"):
            one, both = (row["paths"].get(f"{path}, {eyes}", {}) for eyes in ("an eye", "two eyes"))
            if "pipelines" not in one or "pipelines" not in both:
                continue
            cells = ["; ".join(sphere_instructions(of["pipelines"], stage) for of in (one, both))
                     for stage in ("vertex", "fragment")]
            apart, together = one.get("stream"), both.get("stream")
            if apart and together:
                cells += [f"{2 * apart['loads']}, {2 * apart['stores']} B; {together['loads']}, {together['stores']} B",
                          f"{2 * apart['draws']}; {together['draws']}"]
            else:
                cells += ["not told", "not told"]
            lines.append(f"| {device} | `{path}` | " + " | ".join(cells) + " |")
    return lines


def tables(rows):
    """{"shapes": lines}: by the markers of docs/tilers.md."""
    counts = counted()
    return {"paths": paths_table(rows, counts), "shapes": shapes_table(rows, counts), "eyes": eyes_table(rows)}


if __name__ == "__main__":  # what tests/passes/plates_test.cpp has of it
    kept = json.loads((ROOT / "docs/tilers.json").read_text())
    SHAPE_RADII = tuple(frame["radius"] for frame in counted()["frames"])
    print("\n".join(shapes_table(kept, counted())))
