#!/usr/bin/python3
"""Hydrogen bonds by the file's hydrogens beside MDTraj: beside_mdtraj.py PROGRAM [FILE...]

The rules of Baker and Hubbard, and of Wernet and Nilsson, over the first frame of each file that has hydrogens. MDTraj
knows the hydrogens of standard residues alone (and of what CONECT records join), so bonds whose donor it does not know
are left out. Fails if any other triplet differs.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

try:
    import mdtraj
except ImportError:
    test_data.cannot_judge("python3-mdtraj is not installed")

FILES = ["1l2y.pdb", "2koc-rna-nmr.cif.gz", "md-lysozyme-solvated.gro", "1msh-nmr30.mmtf"]


def triplets_of_program(program, path, rules):
    run = subprocess.run([program, "info", path, "--interactions", "all", "--interaction-rules", rules, "--json", "-q"],
                         check=True, capture_output=True, text=True)
    found = set()
    for contact in json.loads(run.stdout)[0]["interactions"]:
        if contact["kind"] == "hydrogen-bond":
            donor, acceptor = ("a", "b") if contact["donor"] == "a" else ("b", "a")
            (d, h), a = contact[donor]["ids"], contact[acceptor]["ids"][0]
            found.add((d - 1, h - 1, a - 1))
    return found


def as_pdb(program, path, folder):
    """What MDTraj cannot read is written as PDB by gemmi, first model, in the same order."""
    import gemmi
    from Bio.PDB.mmtf import MMTFParser
    from Bio.PDB import PDBIO
    written = folder / "model.pdb"
    if path.name.endswith(".mmtf"):
        writer = PDBIO()
        writer.set_structure(MMTFParser.get_structure(str(path))[0])
        writer.save(str(written))
        return written
    structure = gemmi.read_structure(str(path))
    while len(structure) > 1:
        del structure[1]
    structure.write_minimal_pdb(str(written))
    return written


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    files = options.files or [test_data.needed_folder() / name for name in FILES]
    bad = 0
    with tempfile.TemporaryDirectory() as temporary:
        for path in files:
            source = path
            if path.name.endswith((".mmtf", ".cif.gz", ".cif")):
                source = as_pdb(options.program, path, pathlib.Path(temporary))
            frame = mdtraj.load(str(source))[0]
            known = {atom.index for bond in frame.topology.bonds for atom in bond if atom.element.symbol in "NO"
                     and {bond[0].element.symbol, bond[1].element.symbol} & {"H"}}
            for rules, judge in (("baker-hubbard", lambda: mdtraj.baker_hubbard(frame, periodic=False)),
                                 ("wernet-nilsson", lambda: mdtraj.wernet_nilsson(frame, periodic=False)[0])):
                theirs = {tuple(int(i) for i in triplet) for triplet in judge()}
                ours = triplets_of_program(options.program, source, rules)
                unknown = {triplet for triplet in ours if triplet[0] not in known}
                differ = theirs ^ (ours - unknown)
                print(f"{path.name} {rules}: {len(theirs)} of MDTraj, {len(theirs & ours)} the same, "
                      f"{len(differ)} differ, {len(unknown)} of donors that it does not know")
                for triplet in sorted(differ)[:10]:
                    print("   ", "missed" if triplet in theirs else "unconfirmed",
                          *[str(frame.topology.atom(i)) for i in triplet])
                bad += len(differ)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
