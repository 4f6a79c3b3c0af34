"""The device that is there, the first of `nacre devices`: frames and bakes at 3840x2160, and pictures of a batch.

A row is called by what is drawn and by the device, so that the page keeps the rows of other devices.
"""

from measure_run import Unavailable

SCENES = {"1BNA": ("1bna.pdb", "--style", "spacefill"), "4HHB": ("4hhb.cif.gz", "--style", "spacefill"),
          "4HHB, cartoon": ("4hhb.cif.gz", "--style", "cartoon"), "4HHB, surface": ("4hhb.cif.gz", "--style", "surface"),
          "4V5A": ("4v5a-ribosome.mmtf", "--style", "spacefill"),
          "1F2N's capsid": ("1f2n-virus.cif.gz", "--assembly", "1", "--style", "spacefill"),
          "3J6R's capsid": ("3j6r-capsid-expanded.cif.gz", "--style", "spacefill")}
PATHS = {"fragdepth": {"`fragdepth`, ms": "wall"},
         "tiles": {"`tiles`, ms": "wall", "`tiles`: CPU, ms": "cpu", "`tiles`: bake, ms": "bake"}}
COLUMNS = tuple(column for columns in PATHS.values() for column in columns)
BATCHES = ("`--thumbnail 256`", "`--size 256x256 --occlusion off`")
JOBS = {"1 job": 1, "8 jobs": 8}
KNOWN = {"llvmpipe": "lavapipe"}  # by the driver's name, as everywhere in the documentation


def device(run):
    """@returns what `nacre devices` says of the first device, and its name in the page"""
    listed = run.json(run.nacre, "devices", "--json")
    if not listed:
        raise Unavailable("no Vulkan device")
    name = listed[0]["name"].partition(" (")[0].replace(",", "")
    return listed[0], KNOWN.get(name, name)


def frames(run):
    first, name = device(run)
    options = ["--device", first["number"], "--size", "3840x2160"]
    options += [] if first["type"] == "software" else ["--frames", "40"]  # else as many as fit into 3 s
    for scene, (file, *drawn) in SCENES.items():
        row, figures = f"{scene}, {name}", {}
        try:
            for path, columns in PATHS.items():
                told = run.paths(run.file(file), *drawn, *options, path=path)
                figures |= {column: told[key] for column, key in columns.items()}
        except Unavailable as reason:
            run.lacks(f"gpu: {row}: {reason}")
        yield row, figures


def batches(run):
    first, name = device(run)
    for options in BATCHES:
        rates = {jobs: 300 / run.batch(options, "--device", first["number"], "--jobs", count, count=300)["wall"]
                 for jobs, count in JOBS.items()}
        yield f"{options}, {name}", rates
