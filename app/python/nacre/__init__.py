"""Pictures of molecules, as arrays and in notebooks.

>>> import nacre
>>> dna = nacre.open("sample:dna")
>>> picture = dna.render(size=(640, 480), color="chain")   # (480, 640, 4) uint8
>>> layers = dna.layers(size=(640, 480))                   # depth, normals, atoms, occlusion
>>> dna.save("dna.png", background="transparent")

The options are those of ``nacre render``, with ``_`` for ``-``: what ``nacre render --help`` and docs/reference.md say of
them holds here. Texts are as on the command line; sizes, rotations and their like may be sequences of numbers, flags and
what is on or off may be booleans, and what may be repeated may be a list. ``nacre.options()`` lists them.

Threads may share structures and call everything here at once: reading runs beside whatever else, and there is one
renderer, at which pictures take turns. It keeps what it baked of a structure as long as only the view changes.
"""

from __future__ import annotations

import json as _json
import os as _os
import tempfile as _tempfile
import warnings as _warnings

import numpy as _numpy

from . import _nacre
from ._nacre import Error, UsageError

__all__ = ["Error", "Structure", "UsageError", "from_arrays", "from_biopython", "from_gemmi", "open", "options"]

_NOTEBOOK = {"size": (512, 512), "supersample": 2}


def _plain(value):
    """What JSON knows of a value."""
    if isinstance(value, _os.PathLike):
        return _os.fspath(value)
    if isinstance(value, _numpy.ndarray):
        return value.tolist()
    if isinstance(value, _numpy.generic):
        return value.item()
    if isinstance(value, dict):
        return {str(key): _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    return value


def _kind(value):
    """A value's type, for messages."""
    kind = type(value)
    return kind.__name__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__name__}"


def _text(options):
    texts = []
    for name, value in options.items():
        try:
            texts.append(f"{_json.dumps(name)}: {_json.dumps(_plain(value), allow_nan=False)}")
        except TypeError as error:
            raise UsageError(f'"{name}": {error}') from None
        except ValueError:
            raise UsageError(f'"{name}": expected finite numbers, not {value!r}') from None
    return f"{{{', '.join(texts)}}}"


def _tell(warnings):
    for warning in warnings:
        _warnings.warn(warning, stacklevel=3)


class Structure:
    """A molecule: atoms and bonds, one model of a file. Nothing changes it.

    Made by open(), from_arrays(), from_gemmi() or from_biopython().
    """

    def __init__(self, core):
        if not isinstance(core, _nacre.Structure):
            raise TypeError("a Structure is made by nacre.open() or nacre.from_arrays()")
        self._core = core
        self._atoms = self._bonds = None

    def __len__(self):
        """Atoms, those included that are not drawn."""
        return len(self._core)

    def __repr__(self):
        return f"<nacre.Structure {self.name!r}: {len(self)} atoms, {len(self.bonds)} bonds>"

    @property
    def name(self):
        """What it was opened as."""
        return self._core.name

    @property
    def title(self):
        """As the file states it."""
        return self._core.title.decode("utf-8", "replace")

    @property
    def warnings(self):
        """What was read leniently, a sentence each."""
        return list(self._core.warnings)

    @property
    def notes(self):
        """What there is to know of how it was opened, a sentence each: the RMSD of fit."""
        return list(self._core.said[1])

    @property
    def atoms(self):
        """Arrays of one entry an atom, in the file's order: position (n, 3) in Å, element, name, residue_name,
        residue_number, chain, model, b_factor in Å², occupancy, charge, hetero. Not to be written to.
        """
        if self._atoms is None:
            atoms = self._core.atoms()
            for key, values in atoms.items():
                if values.dtype.kind == "S":
                    atoms[key] = _numpy.char.decode(values, "utf-8", "replace") if len(values) else values.astype("U8")
                atoms[key].flags.writeable = False
            self._atoms = atoms
        return dict(self._atoms)

    @property
    def bonds(self):
        """(n, 3): indices of two atoms, the smaller first, and the order: 1, 2, 3 or 4, aromatic."""
        if self._bonds is None:
            self._bonds = self._core.bonds()
            self._bonds.flags.writeable = False
        return self._bonds

    def render(self, **options):
        """Draws a picture: (height, width, 4) uint8, sRGB with straight alpha, as a PNG has it.

        Raises UsageError for options that are wrong, Error for what cannot be done; both say it in the words of the
        command line.
        """
        picture, warnings = _nacre.render(self._core, _text(options))
        _tell(warnings)
        return picture

    def layers(self, **options):
        """Draws what compositing needs, one sample a pixel, float32 but for id, which is uint32:
        rgba (h, w, 4), linear light, premultiplied; z (h, w) in Å from the plane in front of the molecule (from the eye
        in perspective), infinite on the background; normal (h, w, 3), view space; id (h, w), 1-based atom, 0 on the
        background; occlusion (h, w), 0 closed to 1 open.
        """
        layers, warnings = _nacre.layers(self._core, _text(options))
        _tell(warnings)
        return layers

    def save(self, path, **options):
        """Draws a picture into a .png, .tif, .jpg, .webp or .exr file, which appears whole or not at all."""
        _tell(_nacre.save(self._core, _os.fspath(path), _text(options)))

    def _repr_png_(self):
        """What a notebook shows of it."""
        with _tempfile.TemporaryDirectory(prefix="nacre-") as folder:
            path = _os.path.join(folder, "picture.png")
            _nacre.save(self._core, path, _text(_NOTEBOOK))
            with _open(path, "rb") as file:
                return file.read()


_open = __builtins__["open"] if isinstance(__builtins__, dict) else __builtins__.open


def open(source, *, name="", **options):  # noqa: A001: nacre.open, as PIL's Image.open
    """Reads a structure: a path, "sample:dna", "pdb:1BNA" or another INPUT of `nacre render`, or a file's bytes, in any
    format that is read, compressed or not. A list of those but bytes is drawn together, each with a name for
    selections: open(["receptor=a.pdb", "ligand=b.sdf"], fit=("/ligand", "/receptor")) lays one onto the other.

    name: of bytes, for messages and as a hint to their format ("1crn.pdb"). options: those of `nacre info`: format, model (a
    number from 1, or "all"), trajectory, frame, memory, offline, cache and more.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return Structure(_nacre.open_bytes(name, bytes(source), _text(options)))
    sources = [source] if isinstance(source, (str, _os.PathLike)) else source
    if not isinstance(sources, (list, tuple)):
        raise UsageError(f"open() takes a path, a list of paths or a file's bytes, not {_kind(source)}")
    for one in sources:
        if isinstance(one, (bytes, bytearray, memoryview)):
            raise UsageError("open() takes bytes alone, not in a list: write them to a file")
        if not isinstance(one, (str, _os.PathLike)):
            raise UsageError(f"open() takes a list of paths, not of {_kind(one)}")
    core = _nacre.open_inputs([_os.fspath(one) for one in sources], _text(options))
    _tell(core.said[0])
    return Structure(core)


def from_arrays(positions, elements, bonds=None, *, names=(), residue_names=(), residue_numbers=(), chains=(),
                b_factors=(), occupancies=(), name="arrays"):
    """A structure of one's own.

    positions: (n, 3) in Å. elements: n symbols or atomic numbers. bonds: rows of two indices from 0, or of those and an
    order; None: found by residue and distance; an empty list: none. The others: n entries each, or nothing.
    """
    elements = [_symbol(e) for e in _numpy.asarray(elements).ravel().tolist()]
    positions = _numpy.asarray(positions, dtype=_numpy.float32)
    if bonds is not None:
        bonds = _numpy.asarray(bonds)
        if bonds.size and bonds.dtype.kind not in "iu":
            raise UsageError("from_arrays(): bonds are whole numbers")
        bonds = bonds.astype(_numpy.int64)

    def texts(column):
        return [str(entry) for entry in _numpy.asarray(column).ravel().tolist()]

    def numbers(column, kind):
        return [kind(entry) for entry in _numpy.asarray(column).ravel().tolist()]

    return Structure(_nacre.from_arrays(positions, elements, bonds, texts(names), texts(residue_names),
                                        numbers(residue_numbers, int), texts(chains), numbers(b_factors, float),
                                        numbers(occupancies, float), name))


def _symbol(element):
    if isinstance(element, str):
        return element
    if not 1 <= int(element) <= len(_SYMBOLS):
        raise UsageError(f"from_arrays(): there is no element {element}")
    return _SYMBOLS[int(element) - 1]


_SYMBOLS = (
    "H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se Br Kr Rb Sr Y Zr Nb "
    "Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au "
    "Hg Tl Pb Bi Po At Rn Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts "
    "Og").split()


def from_gemmi(structure, **options):
    """A gemmi Structure, Model or Chain, by way of mmCIF. options: as those of open()."""
    import gemmi

    whole = structure
    if isinstance(whole, gemmi.Chain):
        chain, whole = whole, gemmi.Model("1")
        whole.add_chain(chain)
    if isinstance(whole, gemmi.Model):
        model, whole = whole, gemmi.Structure()
        whole.add_model(model)
    if not isinstance(whole, gemmi.Structure):
        raise UsageError(f"from_gemmi() takes a Structure, a Model or a Chain of gemmi, not {_kind(structure)}")
    text = whole.make_mmcif_document().as_string()
    return open(text.encode(), name=f"{whole.name or 'gemmi'}.cif", **{"format": "mmcif"} | options)


def from_biopython(entity, **options):
    """A Bio.PDB Structure, Model or Chain, by way of mmCIF. options: as those of open()."""
    import copy
    import io

    from Bio.PDB.Entity import Entity
    from Bio.PDB.mmcifio import MMCIFIO

    if not isinstance(entity, Entity):
        raise UsageError(f"from_biopython() takes a Structure, a Model or a Chain of Bio.PDB, not {_kind(entity)}")
    if entity.get_level() == "S":
        # Biopython writes models 0 and 1 as one, whose atoms would be there twice.
        models, entity = entity.get_list(), copy.copy(entity)
        entity.child_list = [copy.copy(model) for model in models]
        for number, model in enumerate(entity.child_list, 1):
            model.serial_num = number
    writer, text = MMCIFIO(), io.StringIO()
    writer.set_structure(entity)
    writer.save(text)
    return open(text.getvalue().encode(), name="biopython.cif", **{"format": "mmcif"} | options)


def options():
    """The options that render(), layers() and save() take, and what each does."""
    return dict(_nacre.option_names())
