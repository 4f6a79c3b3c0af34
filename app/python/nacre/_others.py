"""Structures of other packages, files and addresses, for nacre.open(). A package is imported only for its own objects."""

from __future__ import annotations

import copy
import io
import os
import urllib.error
import urllib.parse
import urllib.request

import numpy

from . import _nacre
from ._given import kind
from ._nacre import Error, UsageError  # type: ignore

_MOST_BYTES = 1 << 30  # of a download


def file_bytes(file):
    """(name, bytes) of an open file."""
    data = file.read()
    name = getattr(file, "name", "")
    return name if isinstance(name, str) else "", data.encode() if isinstance(data, str) else bytes(data)


def is_address(source):
    return isinstance(source, str) and source.lower().startswith(("http://", "https://", "ftp://"))


def address_bytes(address):
    """(name, bytes) of what an address answers."""
    name = os.path.basename(urllib.parse.unquote(urllib.parse.urlsplit(address).path))
    request = urllib.request.Request(address, headers={"User-Agent": f"nacre/{_nacre.__version__}"})
    try:
        with urllib.request.urlopen(request, timeout=60) as answer:
            data = answer.read(_MOST_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "reason", error)
        raise Error(f"cannot download: {address}: {reason}") from None
    if len(data) > _MOST_BYTES:
        raise Error(f"cannot download: {address}: more than {_MOST_BYTES} bytes")
    return name, data


class Columns:
    """Arguments of from_arrays(), and positions(number from 0) -> (n, 3) Å of every frame."""

    def __init__(self, name, arguments, frames=1, positions=None):
        self.name, self.arguments, self.frames, self.positions = name, arguments, frames, positions


def from_mdanalysis(atoms):
    """A Universe or an AtomGroup, with the frames of its trajectory."""
    atoms = atoms.atoms
    if not len(atoms):
        raise UsageError("open(): the AtomGroup has no atoms")

    def column(name):
        try:
            return numpy.asarray(getattr(atoms, name))
        except Exception:  # MDAnalysis' NoDataError, whose class varies
            return None

    unknown = [""] * len(atoms)
    elements, residues = column("elements"), column("resnames")
    if elements is None or not all(elements):
        guessed = [element_of(name, residue) for name, residue in zip(atoms.names, unknown if residues is None else residues)]
        elements = [known or guess for known, guess in zip(unknown if elements is None else elements, guessed)]
    arguments = {"positions": atoms.positions, "elements": [str(element).capitalize() for element in elements]}
    chains = column("chainIDs")
    if chains is None or not any(chains):
        chains = column("segids")
    for key, values in (("names", column("names")), ("residue_names", residues), ("residue_numbers", column("resids")),
                        ("chains", chains), ("b_factors", column("tempfactors")), ("occupancies", column("occupancies"))):
        if values is not None:
            arguments[key] = values
    if (bonds := bonds_within(atoms)) is not None:
        arguments["bonds"] = bonds
    trajectory = atoms.universe.trajectory

    def positions(number):
        shown = trajectory.frame
        trajectory[number]
        places = atoms.positions
        trajectory[shown]  # the caller's universe keeps its frame
        return places

    return Columns(os.path.basename(str(atoms.universe.filename or "MDAnalysis")), arguments, len(trajectory), positions)


def bonds_within(atoms):
    """Bonds between atoms of an AtomGroup as rows of their places in it; None if the topology has none."""
    try:
        pairs = atoms.universe.bonds.indices
    except Exception:
        return None
    place = numpy.full(len(atoms.universe.atoms), -1)
    place[atoms.indices] = numpy.arange(len(atoms))
    rows = place[numpy.asarray(pairs, dtype=int).reshape(-1, 2)]
    return rows[(rows >= 0).all(axis=1)]


_IONS = ("NA", "CL", "K", "MG", "CA", "ZN", "FE", "MN", "CU", "NI", "CO", "CD", "HG", "LI", "BR")


def element_of(name, residue):
    """The element of an atom by its name, for topologies without elements: CA is carbon, except in residue CA."""
    letters = "".join(letter for letter in str(name) if letter.isalpha()).upper()
    if letters in _IONS and str(residue).strip().upper().rstrip("+-0123456789") in (letters, "SOD" if letters == "NA" else "CLA"):
        return letters.capitalize()
    if letters[:2] in ("CL", "BR"):
        return letters[:2].capitalize()
    return letters[:1] or "X"


def from_mdtraj(trajectory):
    """An mdtraj Trajectory, with its frames."""
    if not trajectory.n_frames:
        raise UsageError("open(): the Trajectory has no frames")
    atoms = list(trajectory.topology.atoms)
    orders = {None: 1, 1: 1, 2: 2, 3: 3}
    bonds = [(bond[0].index, bond[1].index, orders.get(getattr(bond, "order", None), 1)) for bond in trajectory.topology.bonds]
    chains = [chr(ord("A") + atom.residue.chain.index % 26) for atom in atoms]
    arguments = {"positions": trajectory.xyz[0] * 10,  # nm
                 "elements": [atom.element.symbol if atom.element is not None and atom.element.symbol != "VS" else "X" for atom in atoms],
                 "names": [atom.name for atom in atoms], "residue_names": [atom.residue.name for atom in atoms],
                 "residue_numbers": [atom.residue.resSeq for atom in atoms], "chains": chains}
    if bonds:
        arguments["bonds"] = bonds
    return Columns("mdtraj", arguments, trajectory.n_frames, lambda number: trajectory.xyz[number] * 10)


def from_rdkit(molecule):
    """An RDKit Mol; its conformers are frames. @returns (name, mol block); Columns for several conformers, or atoms of residues"""
    from rdkit import Chem  # type: ignore

    if not molecule.GetNumConformers():
        raise UsageError("open(): the Mol has no conformer: AllChem.EmbedMolecule(mol) makes one")
    conformers = [conformer.GetId() for conformer in molecule.GetConformers()]
    name = molecule.GetProp("_Name") if molecule.HasProp("_Name") and molecule.GetProp("_Name") else "rdkit"
    places = lambda number: molecule.GetConformer(conformers[number]).GetPositions()  # noqa: E731
    atoms = list(molecule.GetAtoms())
    if not all(atom.GetPDBResidueInfo() for atom in atoms) and len(conformers) == 1:
        return f"{name}.mol", Chem.MolToMolBlock(molecule, confId=conformers[0], forceV3000=len(atoms) > 999).encode()
    orders = {Chem.BondType.DOUBLE: 2, Chem.BondType.TRIPLE: 3, Chem.BondType.AROMATIC: 4}
    arguments = {"positions": places(0), "elements": [atom.GetAtomicNum() or "X" for atom in atoms],
                 "bonds": numpy.array([(bond.GetBeginAtomIdx(), bond.GetEndAtomIdx(), orders.get(bond.GetBondType(), 1))
                                       for bond in molecule.GetBonds()], dtype=int).reshape(-1, 3)}
    if all(atom.GetPDBResidueInfo() for atom in atoms):
        about = [atom.GetPDBResidueInfo() for atom in atoms]
        arguments |= {"names": [one.GetName().strip() for one in about], "residue_names": [one.GetResidueName().strip() for one in about],
                      "residue_numbers": [one.GetResidueNumber() for one in about], "chains": [one.GetChainId() for one in about],
                      "b_factors": [one.GetTempFactor() for one in about], "occupancies": [one.GetOccupancy() for one in about]}
    return Columns(name, arguments, len(conformers), places)


def from_gemmi(structure):
    """(name, mmCIF) of a gemmi Structure, Model or Chain."""
    import gemmi  # type: ignore

    whole = structure
    if isinstance(whole, gemmi.Chain):
        chain, whole = whole, gemmi.Model("1")
        whole.add_chain(chain)
    if isinstance(whole, gemmi.Model):
        model, whole = whole, gemmi.Structure()
        whole.add_model(model)
    if not isinstance(whole, gemmi.Structure):
        raise UsageError(f"from_gemmi() takes a Structure, a Model or a Chain of gemmi, not {kind(structure)}")
    return f"{whole.name or 'gemmi'}.cif", whole.make_mmcif_document().as_string().encode()


def from_biopython(entity):
    """(name, mmCIF) of a Bio.PDB Structure, Model or Chain."""
    from Bio.PDB.Entity import Entity  # type: ignore
    from Bio.PDB.mmcifio import MMCIFIO  # type: ignore

    if not isinstance(entity, Entity):
        raise UsageError(f"from_biopython() takes a Structure, a Model or a Chain of Bio.PDB, not {kind(entity)}")
    if entity.get_level() == "S":
        # Biopython writes models 0 and 1 as one, with duplicate atoms.
        models, entity = entity.get_list(), copy.copy(entity)
        entity.child_list = [copy.copy(model) for model in models]
        for number, model in enumerate(entity.child_list, 1):
            model.serial_num = number
    writer, text = MMCIFIO(), io.StringIO()
    writer.set_structure(entity)
    writer.save(text)
    return "biopython.cif", text.getvalue().encode()


def converter(source):
    """The function that reads another package's object, or None."""
    of_package = {"MDAnalysis": from_mdanalysis, "mdtraj": from_mdtraj, "rdkit": from_rdkit, "gemmi": from_gemmi, "Bio": from_biopython}
    for base in type(source).__mro__:
        if found := of_package.get(base.__module__.partition(".")[0]):
            return found
    return None
