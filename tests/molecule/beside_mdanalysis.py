#!/usr/bin/python3
"""Topologies and coordinates beside MDAnalysis, or ASE for crystals: beside_mdanalysis.py REPORT FILE...

Compares the number of atoms, names, residues, segments, bonds, charges, masses, positions and boxes, as far as both have
them. REPORT is the program read_report; a FILE that is not there is sought in the data folder.
Fails if any value differs; values that only one of the two has are no difference.
"""

import json
import pathlib
import subprocess
import sys
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

warnings.filterwarnings("ignore")
try:
    import numpy
    import MDAnalysis
except ImportError:
    test_data.cannot_judge("python3-mdanalysis is not installed")


def of_mdanalysis(path):
    name = path.name.lower()
    kinds = {".lmp": "DATA", ".data": "DATA", ".lammpstrj": "LAMMPSDUMP", ".dump": "LAMMPSDUMP", ".parm7": "TOP",
             ".prmtop": "TOP", ".txyz": "TXYZ", ".arc": "ARC"}
    kind = next((kinds[end] for end in kinds if name.endswith(end)), None)
    formats = {"topology_format": kind} if kind else {}
    if "tinker" in name:
        formats = {"topology_format": "TXYZ", "format": "TXYZ"}
    universe = MDAnalysis.Universe(str(path), **formats)
    atoms = universe.atoms
    found = {}
    for ours, theirs in (("names", "names"), ("resnames", "resnames"), ("resids", "resids"), ("segids", "segids"),
                         ("charges", "charges"), ("masses", "masses"), ("types", "types")):
        if hasattr(atoms, theirs) and (ours != "masses" or not kind == "TXYZ"):
            found[ours] = list(getattr(atoms, theirs))
    if hasattr(universe, "bonds"):
        found["bonds"] = sorted(tuple(sorted(map(int, bond))) for bond in universe.bonds.indices)
    try:
        found["positions"] = atoms.positions
        found["frames"] = universe.trajectory.n_frames
    except (AttributeError, ValueError, MDAnalysis.exceptions.NoDataError):
        pass
    return len(atoms), found


def of_ase(path):
    import ase.io
    frames = ase.io.read(str(path), index=":")
    return len(frames[0]), {"elements": frames[0].get_chemical_symbols(), "positions": frames[0].get_positions(),
                            "frames": len(frames)}


def differences(report, count, found):
    if len(report["names"]) != count:
        yield f"{len(report['names'])} atoms, not {count}"
        return
    for key, theirs in found.items():
        ours = report["models"] if key == "frames" else report.get(key) or []
        if key == "frames":
            if ours != theirs:
                yield f"{ours} frames, not {theirs}"
        elif key == "bonds":
            ours = sorted(tuple(sorted(bond)) for bond in ours)
            if ours != sorted(set(theirs)):
                yield f"{len(ours)} bonds, not {len(theirs)}: {(set(ours) ^ set(theirs)).__iter__().__next__()}"
        elif len(ours) != count:
            continue
        elif key in ("charges", "masses", "positions"):
            apart = numpy.abs(numpy.asarray(ours, float) - numpy.asarray(theirs, float)).max()
            if not apart < 2e-3:
                yield f"{key} differ by {apart}"
        else:
            for i, (a, b) in enumerate(zip(ours, theirs)):
                if str(a) and str(b) and str(a)[:8] != str(b)[:8] and str(b) != "SYSTEM":
                    yield f"{key} of atom {i + 1}: {a}, not {b}"
                    break


def main():
    program, *files = sys.argv[1:]
    files = [path if pathlib.Path(path).exists() else test_data.needed_folder() / path for path in files]
    failed = 0
    for path in map(pathlib.Path, files):
        run = subprocess.run([program, str(path)], capture_output=True, text=True)
        try:
            plain = path.suffix.lower() in (".poscar", ".vasp", ".xsf", ".axsf") or "POSCAR" in path.name
            count, found = of_ase(path) if plain else of_mdanalysis(path)
        except Exception as error:
            print(f"{path.name}: the judge fails ({str(error)[:80]}); nacre: {'reads' if run.returncode == 0 else run.stderr.strip()[:120]}")
            continue
        said = [run.stderr.strip()[:200]] if run.returncode else list(differences(json.loads(run.stdout), count, found))
        failed += bool(said)
        print(f"{path.name}: {count} atoms, {', '.join(found)}: {'; '.join(said) if said else 'same'}")
    sys.exit(1 if failed else 0)


main()
