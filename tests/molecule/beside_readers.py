#!/usr/bin/python3
"""What is read of a file beside another library: beside_readers.py JUDGE REPORT [FILE...].

JUDGE is mdanalysis, ase, openbabel, gsd or mdtraj. Compares the number of atoms and frames, names, elements, residues,
segments, bonds, charges, masses, types, positions and boxes, as far as both have them. REPORT is the program
read_report; a FILE that is not there is sought in the data folder. Judges also write files of their own and read them.
Fails if any value differs, or if nacre refuses a file that the judge reads.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

warnings.filterwarnings("ignore")


def pairs(bonds):
    return sorted({tuple(sorted(map(int, bond[:2]))) for bond in bonds})


class Mdanalysis:
    KINDS = {".lmp": "DATA", ".data": "DATA", ".lammpstrj": "LAMMPSDUMP", ".dump": "LAMMPSDUMP", ".parm7": "TOP",
             ".prmtop": "TOP", ".top": "ITP", ".itp": "ITP", ".txyz": "TXYZ", ".arc": "ARC"}

    def __init__(self):
        import MDAnalysis
        self.library = MDAnalysis

    def write(self, folder):
        return []

    def read(self, path):
        name = path.name.lower()
        kind = next((self.KINDS[end] for end in self.KINDS if name.endswith(end)), None)
        formats = {"topology_format": kind} if kind else {}
        if "tinker" in name:
            kind, formats = "TXYZ", {"topology_format": "TXYZ", "format": "TXYZ"}
        universe = self.library.Universe(str(path), **formats)
        atoms = universe.atoms
        found = {}
        for key in ("names", "resnames", "resids", "segids", "charges", "masses", "types"):
            if not hasattr(atoms, key) or (key == "masses" and kind in ("TXYZ", "ARC")):
                continue
            if key == "resids" and (kind in ("LAMMPSDUMP", "ITP") or name.endswith(".gsd")):  # it numbers them itself
                continue
            found[key] = list(getattr(atoms, key))
        if hasattr(universe, "bonds"):
            found["bonds"] = pairs(universe.bonds.indices)
        try:
            # Of a dump it moves the box to the origin.
            found["positions from corner" if kind == "LAMMPSDUMP" else "positions"] = atoms.positions
            found["frames"] = universe.trajectory.n_frames
        except (AttributeError, ValueError, self.library.exceptions.NoDataError):
            pass
        return len(atoms), found


class Ase:
    def __init__(self):
        import ase.build
        import ase.io
        self.ase = ase

    def write(self, folder):
        """A rattled crystal in three frames, of which the cell grows."""
        frames = []
        for i in range(3):
            salt = self.ase.build.bulk("NaCl", "rocksalt", a=5.64 + 0.1 * i, cubic=True)
            salt.rattle(0.05, seed=i)
            frames.append(salt)
        skewed = frames[0].copy()
        skewed.set_cell(skewed.cell[:] @ [[1, 0, 0], [0.2, 1, 0], [0.1, 0.3, 1]], scale_atoms=True)
        slab, none = skewed.copy(), skewed.copy()
        slab.set_pbc([True, True, False])
        none.set_pbc(False)
        moving = skewed.copy()
        moving.set_velocities(moving.get_positions() / 10)
        for name, what, options in (("slab.extxyz", slab, {}), ("none.extxyz", none, {}), ("slab.xsf", slab, {}),
                                    ("moving.extxyz", moving, {}), ("moving.vasp", moving, {"format": "vasp"}),
                                    ("POSCAR", frames[0], {"format": "vasp", "direct": True}),
                                    ("CONTCAR.vasp", skewed, {"format": "vasp", "vasp5": True}),
                                    ("XDATCAR", frames[:1] * 3, {"format": "vasp-xdatcar"}),
                                    ("one.xsf", skewed, {}), ("all.xsf", frames, {}),
                                    ("all.extxyz", frames, {}), ("box.gro", skewed, {}),
                                    ("cell.data", skewed, {"format": "lammps-data"})):
            self.ase.io.write(str(folder / name), what, **options)
            yield folder / name

    def read(self, path):
        format = {"cell.data": "lammps-data"}.get(path.name)
        options = {"style": "atomic"} if format else {}
        frames = self.ase.io.read(str(path), index=":", format=format, **options)
        first = frames[0]
        found = {"positions": first.get_positions(), "frames": len(frames)}
        if path.suffix not in (".sdf", ".data"):
            found["elements"] = first.get_chemical_symbols()
        if path.suffix == ".sdf":
            found.pop("frames")  # it reads the first record alone
        if first.cell.rank == 3:
            found["box"] = first.cell[:]
            if path.suffix in (".extxyz", ".xsf"):
                found["periodic"] = list(map(bool, first.pbc))
        return len(first), found


class Openbabel:
    def __init__(self):
        from openbabel import openbabel, pybel
        openbabel.obErrorLog.SetOutputLevel(0)
        self.openbabel, self.pybel = openbabel, pybel

    def write(self, folder):
        return []

    def read(self, path):
        ending = path.name.removesuffix(".gz").rsplit(".", 1)[-1].lower()
        if ending == "mae":  # the module crashes
            mol2 = subprocess.run(["obabel", str(path), "-omol2"], capture_output=True, text=True, check=True).stdout
            records, ending = [self.pybel.readstring("mol2", mol2)], "mol2"
        else:
            records = list(self.pybel.readfile(ending, str(path)))
        first = records[0]
        symbol = self.openbabel.GetSymbol
        found = {"elements": [symbol(atom.atomicnum) for atom in first.atoms],
                 "positions": [atom.coords for atom in first.atoms], "frames": len(records)}
        if ending in ("sdf", "mol2", "cml", "txyz"):
            found["bonds"] = pairs((bond.GetBeginAtomIdx() - 1, bond.GetEndAtomIdx() - 1)
                                   for bond in self.openbabel.OBMolBondIter(first.OBMol))
        return len(first.atoms), found


class Gsd:
    def __init__(self):
        import gsd.hoomd
        import numpy
        self.gsd, self.numpy = gsd.hoomd, numpy

    def write(self, folder):
        """A chain whose bonds have every number up to 300, in a tilted box; the second frame states positions alone."""
        path = folder / "chain.gsd"
        with self.gsd.open(str(path), "wb") as file:
            for step in range(3):
                frame = self.gsd.Snapshot()
                frame.configuration.step = step
                frame.configuration.box = [30, 31, 32, 0.1, 0.2, 0.3]
                frame.particles.N = 300
                frame.particles.types = ["A", "Bead"]
                frame.particles.typeid = [i % 2 for i in range(300)]
                frame.particles.mass = [1 + i % 3 for i in range(300)]
                frame.particles.charge = [0.5 * (i % 5) for i in range(300)]
                frame.particles.position = [[i % 10 - 5, i // 10 % 10 - 5, i // 100 + 0.1 * step] for i in range(300)]
                frame.bonds.N = 299
                frame.bonds.types = ["b"]
                frame.bonds.typeid = [0] * 299
                frame.bonds.group = [[i, i + 1] for i in range(299)]
                file.append(frame)
        yield path

    def read(self, path):
        frames = self.gsd.open(str(path), "rb")
        first = frames[0]
        particles = first.particles
        x, y, z, xy, xz, yz = map(float, first.configuration.box)
        box = [[x, 0, 0], [xy * y, y, 0], [xz * z, yz * z, z]]
        found = {"positions": particles.position, "types": [particles.types[i] for i in particles.typeid],
                 "charges": particles.charge, "bonds": pairs(first.bonds.group if first.bonds.N else []),
                 "frames": len(frames), "box": box, "corner": -self.numpy.sum(box, axis=0) / 2}
        return particles.N, found


class Mdtraj:
    def __init__(self):
        import mdtraj
        self.mdtraj = mdtraj

    def write(self, folder):
        source = test_data.folder()
        if source:
            self.mdtraj.load(str(source / "1l2y.pdb"))[:5].save(str(folder / "peptide.h5"))
            yield folder / "peptide.h5"

    def read(self, path):
        frames = self.mdtraj.load(str(path))
        topology = frames.topology
        return topology.n_atoms, {
            "names": [atom.name for atom in topology.atoms], "elements": [atom.element.symbol for atom in topology.atoms],
            "resnames": [atom.residue.name for atom in topology.atoms],
            "resids": [atom.residue.resSeq for atom in topology.atoms],
            "positions": frames.xyz[0] * 10, "frames": frames.n_frames,
            "bonds": pairs((a.index, b.index) for a, b in topology.bonds)}


def differences(report, count, found):
    import numpy
    if len(report["names"]) != count:
        yield f"{len(report['names'])} atoms, not {count}"
        return
    corner = report.get("box_origin", [0, 0, 0])
    for key, theirs in found.items():
        if key == "frames":
            if report["models"] != theirs:
                yield f"{report['models']} frames, not {theirs}"
            continue
        if key == "periodic":
            if report.get("periodic") != theirs:
                yield f"periodic along {report.get('periodic')}, not {theirs}"
            continue
        if key == "bonds":
            ours = pairs(report["bonds"])
            if ours != theirs:
                yield f"{len(ours)} bonds, not {len(theirs)}: {sorted(set(ours) ^ set(theirs))[:3]}"
            continue
        ours = {"positions from corner": numpy.asarray(report["positions"]) - corner,
                "corner": corner}.get(key, report.get(key))
        if ours is None or (key not in ("box", "corner") and len(ours) != count):
            continue
        if key in ("charges", "masses", "positions", "positions from corner", "box", "corner"):
            apart = numpy.abs(numpy.asarray(ours, float) - numpy.asarray(theirs, float)).max()
            if not apart < 2e-3:
                yield f"{key} differ by {apart}"
        else:
            for i, (a, b) in enumerate(zip(ours, theirs)):
                if str(a) and str(b) and str(a)[:8] != str(b)[:8] and str(b) != "SYSTEM":
                    yield f"{key} of atom {i + 1}: {a}, not {b}"
                    break


def main():
    judges = {"mdanalysis": Mdanalysis, "ase": Ase, "openbabel": Openbabel, "gsd": Gsd, "mdtraj": Mdtraj}
    judge, program, *files = sys.argv[1:]
    try:
        judge = judges[judge]()
    except ImportError as error:
        test_data.cannot_judge(f"{judge} is not installed: {error}")
    files = [path if pathlib.Path(path).exists() else test_data.needed_folder() / path for path in files]
    failed = compared = 0
    with tempfile.TemporaryDirectory() as folder:
        for path in [*map(pathlib.Path, files), *judge.write(pathlib.Path(folder))]:
            run = subprocess.run([program, str(path)], capture_output=True, text=True)
            try:
                count, found = judge.read(path)
            except Exception as error:
                result = "reads" if run.returncode == 0 else run.stderr.strip()[:120]
                print(f"{path.name}: the judge fails ({str(error)[:80]}); nacre: {result}")
                continue
            compared += 1
            said = [run.stderr.strip()[:200]] if run.returncode else list(
                differences(json.loads(run.stdout), count, found))
            failed += bool(said)
            print(f"{path.name}: {count} atoms, {', '.join(found)}: {'; '.join(said) if said else 'same'}")
    print(f"{compared} files compared, {failed} differ")
    sys.exit(1 if failed or not compared else 0)


main()
