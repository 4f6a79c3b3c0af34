#!/usr/bin/python3
"""Helices and strands beside Debian's mkdssp: beside_dssp.py PROGRAM [FILE...]

Each file of the test data that holds a protein, or those that are named, is read by Biopython (PDB,
MMTF), gemmi (mmCIF) or Open Babel (MOL2, GRO, PQR, PDBQT) and written as PDB without a word about helices; chains whose
names PDB has no room for are files of their own. mkdssp and PROGRAM then judge the same text, and the states are
counted: helix (H, G, I), strand (E, B), coil. Fails below 98 % of the residues of any file that mkdssp takes, and below
40 such files if none is named.
"""

import argparse
import collections
import concurrent.futures
import gzip
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import gemmi
from Bio.PDB import MMCIFIO, PDBParser
from Bio.PDB.mmtf import MMTFParser

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

LEAST_SHARE, LEAST_FILES = 0.98, 40
BABEL = (".mol2", ".gro", ".pqr", ".pdbqt")
FORMATS = (".pdb", ".cif", ".mmtf") + BABEL
LARGEST = 20000  # residues: what takes longer than its answer is worth
AMINO_ACIDS = 10  # fewer alpha carbons are no protein


def by_babel(path, folder):
    written = folder / "babel.pdb"
    subprocess.run(["obabel", path, "-O", written], check=True, capture_output=True)
    structure = gemmi.read_structure(str(written))
    for model in structure:
        for chain in model:
            chain.name = chain.name.strip() or "A"
    return structure


def by_biopython(path, folder):
    """PDB, too: gemmi 0.5.7 stops at what old files have beyond column 72."""
    written = folder / "biopython.cif"
    out = MMCIFIO()
    if path.suffix == ".mmtf":
        out.set_structure(MMTFParser.get_structure(str(path)))
    else:
        lines = gzip.open(path, "rt") if path.suffix == ".gz" else open(path)
        with lines:
            out.set_structure(PDBParser(QUIET=True).get_structure("1xxx", lines))
    out.save(str(written))
    return gemmi.read_structure(str(written))


def structure_of(path, folder):
    kind = path.suffix if path.suffix != ".gz" else pathlib.Path(path.stem).suffix
    if kind in (".pdb", ".mmtf"):
        return by_biopython(path, folder)
    return by_babel(path, folder) if kind in BABEL else gemmi.read_structure(str(path))


def is_amino_acid(residue):
    return any(atom.name == "CA" and atom.element.name == "C" for atom in residue) and any(
        atom.name == "N" for atom in residue
    )


def plain_name(name):
    """Of a modified residue the one that it comes from, since mkdssp knows no others."""
    letter = gemmi.find_tabulated_residue(name).one_letter_code.upper()
    return gemmi.expand_protein_one_letter(letter) if letter.strip() else name


def pieces(structure):
    """Structures whose chains have names of one letter, of amino acids alone, each in one conformation."""
    structure.remove_alternative_conformations()
    for model in structure:
        chains = collections.OrderedDict()
        for chain in model:
            kept = chains.setdefault(chain.name, gemmi.Chain(chain.name))
            for residue in chain:
                # At one place another may stand in its stead.
                if is_amino_acid(residue) and all(residue.seqid != other.seqid for other in kept):
                    kept.add_residue(residue)
        chains = [chain for chain in chains.values() if len(chain)]
        for chain in chains:
            for residue in chain:
                residue.name = plain_name(residue.name)
        together = all(len(chain.name) == 1 for chain in chains)
        for part in [chains] if together else [[chain] for chain in chains]:
            piece = gemmi.Structure()
            piece.add_model(gemmi.Model("1"))
            for chain in part:
                chain.name = chain.name if together else "A"
                piece[0].add_chain(chain)
            yield piece


def write(piece, path):
    text = piece.make_minimal_pdb()
    # mkdssp leaves out what stands as HETATM unless other records name it.
    lines = (line.replace("HETATM", "ATOM  ", 1) for line in text.splitlines())
    atoms = [line for line in lines if line.startswith(("ATOM", "TER"))]
    head = "HEADER    PROTEIN                                 01-JAN-00   1XXX"
    cell = "CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1"
    path.write_text("\n".join([head, cell, *atoms, "END", ""]))


def states_of_dssp(path):
    """By chain, number and insertion code; None where mkdssp fails."""
    out = path.with_suffix(".dssp")
    ran = subprocess.run(["mkdssp", "--output-format", "dssp", path, out], capture_output=True)
    if ran.returncode != 0:
        return None
    lines = out.read_text().splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("  #  RESIDUE"))
    states = {}
    for line in lines[start + 1 :]:
        if line[13] == "!":
            continue
        state = "helix" if line[16] in "HGI" else "strand" if line[16] in "EB" else "coil"
        states[line[11], int(line[5:10]), line[10].strip()] = state
    return states


def states_of_nacre(program, path):
    ran = subprocess.run([program, "info", path, "--residues", "--json"], check=True, capture_output=True, text=True)
    return {
        (r["chain"], r["number"], r["insertion"] or ""): r["secondary"] for r in json.loads(ran.stdout)[0]["residues"] if r["secondary"]
    }


def judge(program, path):
    """(name, residues, the same, what mkdssp did not take)"""
    count = same = refused = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number, piece in enumerate(pieces(structure_of(path, folder))):
            size = sum(len(chain) for chain in piece[0])
            if size < AMINO_ACIDS or size > LARGEST:
                continue
            text = folder / f"{number}.pdb"
            write(piece, text)
            wanted = states_of_dssp(text)
            if wanted is None:
                refused += 1
                continue
            ours = states_of_nacre(program, text)
            count += len(wanted)
            same += sum(ours.get(place) == state for place, state in wanted.items())
    return path.name, count, same, refused


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("files", nargs="*")
    given = arguments.parse_args()
    data = test_data.needed_folder()
    names = given.files or sorted(
        f.name for f in data.iterdir() if f.name.removesuffix(".gz").endswith(FORMATS) and f.is_file()
    )
    failed = files = residues = agreeing = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, count, same, refused in pool.map(lambda n: judge(given.program, data / n), names):
            if count == 0 and refused == 0:
                continue
            files += count > 0
            residues += count
            agreeing += same
            wrong = same < LEAST_SHARE * count or (count == 0 and name in given.files)
            failed += wrong
            note = f", mkdssp refused {refused}" if refused else ""
            print(f"{name}: {same} of {count} residues{note}{' TOO FEW' if wrong else ''}", flush=True)
    print(f"{files} files, {agreeing} of {residues} residues, {100 * agreeing / max(residues, 1):.2f} %")
    if not given.files and files < LEAST_FILES:
        print(f"fewer than {LEAST_FILES} files")
        failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
