#!/usr/bin/python3
"""Bond orders and hydrogens beside RDKit and Open Babel: beside_rdkit.py CHEMISTRY_REPORT [--details] [FILE...]

Orders: of each ligand of each file of the test data (or those named), perceived from its coordinates alone. Files that
state orders are judged by what they state, as RDKit and as Open Babel read them; ligands of structures by Open Babel's
perception from the same coordinates, and by RDKit's view of that. A bond is right if it is single, double, triple or
aromatic as one of them has it. Fails below 98 % of all bonds.

Hydrogens: RDKit adds them to heavy atoms of stated orders; those whose place the neighbours determine (no atom of one
neighbour that can turn) are compared. Fails above an RMS of 0.1 Å, or with fewer than 10 files.
"""

import argparse
import collections
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

try:
    from openbabel import openbabel, pybel
    from rdkit import Chem, RDLogger
except ImportError:
    test_data.cannot_judge("python3-rdkit or python3-openbabel is not installed")

LEAST_SHARE, MOST_RMS, LEAST_FILES = 0.98, 0.1, 10
LIGAND = 4  # ResidueKind::ligand
LARGEST = 200  # heavy atoms
TEMPLATES = {"HEM"}  # ligands whose orders a template states: component_orders_test.cpp judges them by their component
STATED = (".sdf", ".mol2", ".mol", ".cml")
STRUCTURES = (".pdb", ".cif", ".pdb.gz", ".cif.gz")


def report(program, path, *options):
    run = subprocess.run([program, path, *options], capture_output=True, text=True)
    return json.loads(run.stdout) if run.returncode == 0 else None


def kind_of_bond(order, aromatic):
    return "ar" if aromatic else {1: "1", 2: "2", 3: "3"}.get(order, "?")


def of_babel(molecule):
    """(a, b) of 0-based atoms -> kind."""
    return {tuple(sorted((bond.GetBeginAtomIdx() - 1, bond.GetEndAtomIdx() - 1))):
            kind_of_bond(bond.GetBondOrder(), bond.IsAromatic()) for bond in openbabel.OBMolBondIter(molecule)}


def of_rdkit(molecule):
    kinds = {Chem.BondType.SINGLE: "1", Chem.BondType.DOUBLE: "2", Chem.BondType.TRIPLE: "3",
             Chem.BondType.AROMATIC: "ar"}
    return {tuple(sorted((bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()))): kinds.get(bond.GetBondType(), "?")
            for bond in molecule.GetBonds()}


def rdkit_view(babel):
    """RDKit's aromaticity of Open Babel's orders."""
    text = pybel.Molecule(babel).write("mol")
    molecule = Chem.MolFromMolBlock(text, sanitize=False, removeHs=False)
    if molecule is None:
        return {}
    try:
        Chem.SanitizeMol(molecule, Chem.SANITIZE_ALL ^ Chem.SANITIZE_PROPERTIES)
    except Exception:
        return {}
    return of_rdkit(molecule)


def compare(name, bonds, judges, counts, details):
    for (a, b), kind in bonds.items():
        answers = {judge[(a, b)] for judge in judges if (a, b) in judge} - {"?"}  # of metals
        if not answers:
            continue
        counts["bonds"] += 1
        counts["right"] += kind in answers
        counts[f"of_{'ar' if 'ar' in answers else max(answers)}"] += 1
        if details and kind not in answers:
            print(f"  {name}: {a} {b} ours {kind}, theirs {sorted(answers)}")


def records_of(path):
    """Records of a file that states orders, as Open Babel and RDKit read them; and their coordinates."""
    kind = path.suffix[1:]
    kind = "mol" if kind == "sdf" and "v3000" in path.name else kind
    for index, molecule in enumerate(pybel.readfile("sdf" if kind == "mol" else kind, str(path))):
        yield index + 1, molecule


def judge_stated(program, path, counts, hydrogens, details):
    for index, molecule in records_of(path):
        atoms = molecule.OBMol.NumAtoms()
        flat = all(abs(atom.coords[2]) < 1e-4 for atom in molecule.atoms)
        if atoms < 3 or (flat and not planar(molecule)):
            continue
        ours = report(program, path, "--model", str(index), "--forget-orders")
        if ours is None or len(ours["atoms"]) != atoms:
            continue
        bonds = {(min(a, b), max(a, b)): kind_of_bond(order, aromatic) for a, b, order, aromatic, _ in ours["bonds"]}
        judges = [of_babel(molecule.OBMol), rdkit_view(molecule.OBMol)]
        before = counts["bonds"], counts["right"]
        compare(f"{path.name} {index}", bonds, judges, counts, details)
        if details and counts["bonds"] - before[0] != counts["right"] - before[1]:
            print(path.name, index, counts["right"] - before[1], "of", counts["bonds"] - before[0])


def planar(molecule):
    return molecule.OBMol.NumAtoms() <= 12 and molecule.OBMol.NumHvyAtoms() == molecule.OBMol.NumAtoms()


def components(atoms, bonds):
    """Groups of ligands' heavy atoms bonded to each other."""
    neighbours = collections.defaultdict(set)
    chosen = {i for i, atom in enumerate(atoms) if atom["kind"] == LIGAND and atom["present"]}
    for a, b, *_ in bonds:
        if a in chosen and b in chosen:
            neighbours[a].add(b)
            neighbours[b].add(a)
    seen, groups = set(), []
    for start in sorted(chosen):
        if start in seen:
            continue
        group, waiting = [], [start]
        seen.add(start)
        while waiting:
            atom = waiting.pop()
            group.append(atom)
            fresh = neighbours[atom] - seen
            seen |= fresh
            waiting += fresh
        groups.append(sorted(group))
    return groups


def judge_structure(program, path, counts, details):
    ours = report(program, path)
    if ours is None:
        return
    seen = set()
    for group in components(ours["atoms"], ours["bonds"]):
        names = tuple(sorted((ours["atoms"][i]["residue"], ours["atoms"][i]["name"]) for i in group))
        heavy = sum(ours["atoms"][i]["element"] != "H" for i in group)
        if heavy < 3 or heavy > LARGEST or names in seen or ours["atoms"][group[0]]["residue"] in TEMPLATES:
            continue
        seen.add(names)
        index = {atom: i for i, atom in enumerate(group)}
        lines = [f"{ours['atoms'][i]['element']} {' '.join(map(str, ours['atoms'][i]['position']))}" for i in group]
        babel = pybel.readstring("xyz", f"{len(group)}\n\n" + "\n".join(lines) + "\n").OBMol
        bonds = {tuple(sorted((index[a], index[b]))): kind_of_bond(order, aromatic)
                 for a, b, order, aromatic, _ in ours["bonds"] if a in index and b in index}
        label = f"{path.name} {ours['atoms'][group[0]]['residue']}{ours['atoms'][group[0]]['number']}"
        before = counts["bonds"], counts["right"]
        if details:
            print(label, [ours["atoms"][i]["name"] for i in group])
        compare(label, bonds, [of_babel(babel), rdkit_view(babel)], counts, details)
        if details and counts["bonds"] - before[0] != counts["right"] - before[1]:
            print(label, counts["right"] - before[1], "of", counts["bonds"] - before[0])


def determined(molecule, parent):
    """Whether the neighbours of a heavy atom fix its hydrogens: it does not end a bond that can turn."""
    atom = molecule.GetAtomWithIdx(parent)
    heavy = [n for n in atom.GetNeighbors() if n.GetAtomicNum() > 1]
    if len(heavy) >= 3 or (len(heavy) == 2 and atom.GetAtomicNum() == 6):
        return True
    if len(heavy) == 2:
        return atom.GetHybridization() == Chem.HybridizationType.SP2
    return len(heavy) == 1 and atom.GetHybridization() == Chem.HybridizationType.SP2 and atom.GetAtomicNum() == 6


def judge_hydrogens(program, path, folder, details):
    """Squared distances of hydrogens from the nearest of RDKit's at the same atom."""
    squares = []
    for index, molecule in records_of(path):
        try:
            full = Chem.MolFromMolBlock(molecule.write("mol"), removeHs=False)
            bare = Chem.RemoveHs(full) if full else None
        except Exception:
            continue
        if bare is None or bare.GetNumAtoms() < 3 or not bare.GetConformer().Is3D():
            continue
        heavy = folder / "heavy.sdf"
        heavy.write_text(Chem.MolToMolBlock(bare) + "$$$$\n")
        theirs = Chem.AddHs(bare, addCoords=True)
        ours = report(program, heavy, "--add-hydrogens")
        if ours is None:
            continue
        own = collections.defaultdict(list)
        place = {tuple(round(x, 3) for x in ours["atoms"][i]["position"]): i for i in range(len(ours["atoms"]))}
        for a, b, *_ in ours["bonds"]:
            for parent, child in ((a, b), (b, a)):
                if ours["atoms"][child]["element"] == "H":
                    own[parent].append(ours["atoms"][child]["position"])
        positions = theirs.GetConformer()
        for atom in theirs.GetAtoms():
            hydrogens = [n.GetIdx() for n in atom.GetNeighbors() if n.GetAtomicNum() == 1]
            if atom.GetAtomicNum() == 1 or not hydrogens or not determined(theirs, atom.GetIdx()):
                continue
            at = positions.GetAtomPosition(atom.GetIdx())
            parent = place.get(tuple(round(x, 3) for x in (at.x, at.y, at.z)))
            if parent is None or len(own[parent]) != len(hydrogens):
                continue
            for h in hydrogens:
                p = positions.GetAtomPosition(h)
                squares.append(min(sum((x - y) ** 2 for x, y in zip((p.x, p.y, p.z), q)) for q in own[parent]))
    if details and squares:
        print(f"{path.name}: {len(squares)} hydrogens, RMS {math.sqrt(sum(squares) / len(squares)):.3f} Å")
    return squares


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--details", action="store_true", help="print each bond that differs")
    options = parser.parse_args()
    openbabel.obErrorLog.StopLogging()
    RDLogger.DisableLog("rdApp.*")
    files = options.files or sorted(path for folder in ("", "small", "interactions")
                                    for path in (test_data.needed_folder() / folder).glob("*"))
    stated = [path for path in files if path.name.endswith(STATED) and path.stat().st_size < 1_000_000]
    structures = [path for path in files if path.name.endswith(STRUCTURES) and path.stat().st_size < 500_000]
    counts, squares, measured = collections.Counter(), [], 0
    for path in stated:
        judge_stated(options.program, path, counts, squares, options.details)
    print("files that state orders:", dict(counts))
    rest = collections.Counter()
    for path in structures:
        judge_structure(options.program, path, rest, options.details)
    print("ligands of structures:", dict(rest))
    with tempfile.TemporaryDirectory() as temporary:
        for path in stated:
            found = judge_hydrogens(options.program, path, pathlib.Path(temporary), options.details)
            measured += bool(found)
            squares += found
    total, right = counts["bonds"] + rest["bonds"], counts["right"] + rest["right"]
    rms = math.sqrt(sum(squares) / max(1, len(squares)))
    print(f"{right} of {total} bonds ({100 * right / max(1, total):.2f} %), "
          f"{len(squares)} hydrogens of {measured} files, RMS {rms:.3f} Å")
    return 1 if right < LEAST_SHARE * total or rms > MOST_RMS else 0


if __name__ == "__main__":
    sys.exit(main())
