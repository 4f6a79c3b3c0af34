"""Pictures of molecules, as arrays and in notebooks.

>>> import nacre
>>> dna = nacre.open("sample:dna")
>>> picture = dna.render(size=(640, 480), color="chain")   # (480, 640, 4) uint8
>>> layers = dna.layers(size=(640, 480))                   # depth, normals, atoms, occlusion
>>> dna.save("dna.png", background="transparent")
>>> dna.movie(spin="y")                                    # in a notebook: it moves
>>> dna.view()                                             # in a notebook: you turn it
>>> dna.select("chain A")                                  # a mask of the atoms
>>> dna.render(color=values, palette="viridis")            # your own values or colours, one per atom

The options are those of ``nacre render``, with ``_`` for ``-`` (``nacre render --help``, docs/reference.md).
``nacre.options()`` lists them. Text is as on the command line; sizes and rotations may be sequences of numbers, flags and
switches booleans, repeatable options lists.

Threads may share structures and call everything here at the same time. There is one renderer, at which pictures take
turns. It keeps the occlusion of a structure while only the view changes.
"""

from __future__ import annotations

import base64 as _base64
import json as _json
import os as _os
import tempfile as _tempfile

import numpy as _numpy

from . import _nacre, _others
from ._given import FileMissing
from ._given import colored as _colored, groups as _groups, kind as _kind, tell as _tell, text as _text
from ._given import writable as _writable
from ._nacre import Error, UsageError
from ._view import View, encoded as _encoded

__version__ = _nacre.__version__
__all__ = ["Atoms", "Error", "FileMissing", "Movie", "Structure", "UsageError", "View", "__version__", "density_map", "from_arrays",
           "from_biopython", "from_gemmi", "open", "options"]

_NOTEBOOK = {"size": (512, 512), "supersample": 2}
_NOTEBOOK_MOVIE = {"size": (384, 384)}, {"seconds": 4, "fps": 15}
_MOVIE_TYPES = {".png": "image/png", ".gif": "image/gif", ".mp4": "video/mp4", ".webm": "video/webm"}


class Movie:
    """The file of a movie, shown by notebooks."""

    def __init__(self, data, type, frames):
        self.data, self.type, self.frames = data, type, frames

    def __repr__(self):
        return f"<nacre.Movie: {self.frames} frames, {self.type}, {len(self.data)} bytes>"

    def _repr_mimebundle_(self, include=None, exclude=None):
        data = _base64.b64encode(self.data).decode()
        if self.type == "image/png":
            return {self.type: data}
        source = f"data:{self.type};base64,{data}"
        if self.type.startswith("image/"):  # notebooks do not support image/gif
            return {"text/html": f'<img alt="movie" src="{source}">'}
        return {"text/html": f'<video autoplay loop muted controls src="{source}"></video>'}


class Atoms(dict):
    """Arrays with one entry per atom, by name."""

    def to_frame(self):
        """The same as a pandas DataFrame: a row per atom, the position as x, y and z in Å."""
        import pandas

        columns = {axis: self["position"][:, i] for i, axis in enumerate("xyz")}
        return pandas.DataFrame(columns | {key: values for key, values in self.items() if key != "position"})


class Structure:
    """A molecule: the atoms and bonds of one model of a file. Immutable.

    Made by open(), from_arrays(), from_gemmi() or from_biopython().
    """

    def __init__(self, core, maps=()):
        if not isinstance(core, _nacre.Structure):
            raise TypeError("a Structure is made by nacre.open() or nacre.from_arrays()")
        self._core = core
        self._maps = [_os.fspath(name) for name in maps]
        self._atoms = self._bonds = self._motion = None

    def __len__(self):
        """The number of atoms, drawn or not."""
        return len(self._core)

    def __repr__(self):
        return f"<nacre.Structure {self.name!r}: {len(self)} atoms, {len(self.bonds)} bonds>"

    @property
    def name(self):
        """The name that it was opened by."""
        return self._core.name

    @property
    def title(self):
        """The title in the file."""
        return self._core.title.decode("utf-8", "replace")

    @property
    def warnings(self):
        """One sentence per problem that the reader tolerated."""
        return list(self._core.warnings)

    @property
    def notes(self):
        """One sentence per note on opening it, such as the RMSD of fit."""
        return list(self._core.said[1])

    @property
    def atoms(self):
        """Arrays with one entry per atom, in the file's order: position (n, 3) in Å, element, name, residue_name,
        residue_number, insertion_code, altloc, chain, model, b_factor in Å², occupancy, charge, hetero,
        secondary_structure ("helix", "strand", "coil"; "" outside proteins). Read-only. With pandas installed,
        atoms.to_frame() is a DataFrame of them.
        """
        if self._atoms is None:
            atoms = self._core.atoms()
            for key, values in atoms.items():
                if values.dtype.kind == "S":
                    atoms[key] = _numpy.char.decode(values, "utf-8", "replace") if len(values) else values.astype("U8")
                atoms[key].flags.writeable = False
            self._atoms = atoms
        return Atoms(self._atoms)

    @property
    def bonds(self):
        """(n, 3): two atom indices, the smaller first, and the order: 1, 2, 3, or 4 in a ring drawn as aromatic. Orders that the
        file does not state are perceived, as in pictures. Read-only."""
        if self._bonds is None:
            self._bonds = self._core.bonds()
            self._bonds.flags.writeable = False
        return self._bonds

    @property
    def frames(self):
        """The number of its models, or of the frames of the trajectory that it was opened with."""
        return len(self._moving())

    def frame(self, number):
        """The structure at one of its frames, from 1: the same atoms at other places."""
        if not 1 <= int(number) <= self.frames:
            raise UsageError(f"frame(): there are frames 1 to {self.frames}")
        return Structure(self._moving().at(int(number) - 1), self._maps)

    def _moving(self):
        if self._motion is None:
            self._motion = _nacre.Frames(self._core)
        return self._motion

    def info(self, *, interactions=None, interaction_kinds=None, interaction_rules=None, assembly=None):
        """The summary of `nacre info --json` as a dict: counts, chains with sequences, ligands, assemblies, bonds.

        interactions: a selection or mask, or two of them as "SEL,SEL"; adds "interactions", a list of dicts. The others: as
        on the command line.
        """
        summary = _json.loads(self._core.info())
        given = {"interactions": interactions, "interaction_kinds": interaction_kinds, "interaction_rules": interaction_rules,
                 "assembly": assembly}
        if interactions is None:
            if any(value is not None for value in given.values()):
                raise UsageError("info(): give the interactions, a selection")
            return summary
        return summary | {"interactions": _json.loads(self._core.interactions(_text(given, len(self))))}

    def select(self, selection):
        """A boolean array, one value per atom, for a selection such as "chain A and not water"."""
        return self._core.select(selection)

    def _at(self, options):
        """The structure at the frame that the options name, and the other options."""
        options = dict(options)
        number = options.pop("frame", None)
        return (self if number is None else self.frame(number)), options

    def _given(self, options):
        return _colored(len(self), ({"map": self._maps} if self._maps else {}) | options)

    def render(self, **options):
        """Draws a picture: (height, width, 4) uint8 (depth=16: uint16), sRGB with straight alpha, as in PNG.

        color may also be an array with one entry per atom: colours (n, 3), integers from 0 to 255 or numbers from 0 to 1;
        or values (n,), shown along palette (a ramp, "viridis") from the smallest to the largest, or between color_limits.
        Values that are not finite are grey. frame is a number from 1, as for frame(). Where an option takes a selection, it
        takes a mask: show=[(mask, "licorice")]. The same holds for layers(), save(), movie() and export(); movie() has no frame.

        Raises UsageError for wrong options and Error for other failures, with the messages of the command line.
        """
        structure, options = self._at(options)
        colors, text = structure._given(options)
        picture, warnings = _nacre.render(structure._core, text, colors)
        _tell(warnings)
        return picture

    def pictures(self, views, **options):
        """Draws a picture for each view, in turn: a dict of options, which the others complete. As render(), in less time:
        the next picture is drawn while the last is copied.

        >>> for picture in dna.pictures(({"rotate": (0, y, 0)} for y in range(360)), size=(256, 256)): ...
        """
        for group in _groups(views, options):
            yield from self._drawn(group)

    def _drawn(self, group):
        texts, colors, failure = [], None, None
        for options in group:
            try:
                given, text = self._given(options)
            except Exception as error:  # after the pictures before it
                failure = error
                break
            colors = colors or given
            texts.append(text)
        done = 0
        while done < len(texts):
            for picture, warnings in _nacre.render_all(self._core, texts[done:], colors):  # large ones: only the first
                done += 1
                _tell(warnings, 4)
                yield picture
        if failure:
            raise failure

    def layers(self, **options):
        """Draws layers for compositing, one sample per pixel, as float32 (id: uint32):
        rgba (h, w, 4), linear light, premultiplied; z (h, w) in Å from the plane in front of the molecule (from the eye
        in perspective), infinite on the background; normal (h, w, 3), view space; id (h, w), 1-based atom, 0 on the
        background; occlusion (h, w), 0 closed to 1 open.
        """
        structure, options = self._at(options)
        colors, text = structure._given(options)
        layers, warnings = _nacre.layers(structure._core, text, colors)
        _tell(warnings)
        return layers

    def save(self, path, **options):
        """Draws a picture into a .png, .tif, .jpg, .webp or .exr file. The file appears whole or not at all."""
        structure, options = self._at(options)
        colors, text = structure._given(options)
        _tell(_nacre.save(structure._core, _writable(path), text, colors))

    def export(self, path, **options):
        """Exports the scene as triangles: a .glb, .usdz, .ply, .stl or .obj file. options: style, color, show and others about
        the scene.
        """
        structure, options = self._at(options)
        colors, text = structure._given(options)
        _tell(_nacre.export(structure._core, _writable(path), text, colors))

    def movie(self, path=None, *, spin=None, turns=None, rock=None, axis=None, easing=None, map_sweep=None, models=False,
              morph=False, loop=False, seconds=None, fps=None, **options):
        """Draws a movie and returns it; notebooks show it. A path writes it to a file as well: .mp4 or .webm (both need the
        program ffmpeg), .gif or .png (animated). Without a path it is an animated PNG.

        spin: axis to turn about, "x", "y", "z" or a vector; turns: their number (1). rock: degrees to either side, about
        axis. map_sweep: contour level of the first map from one to another, "1sigma,3sigma". models: one model after the
        other, or one frame of the trajectory that it was opened with. morph: from each model to the next by interpolated
        frames, and with loop back to the first; the models may be structures opened with conformations=True. Without any
        of these it turns about y. seconds, fps: how long and how fast. options: those of render().
        """
        motion = {"spin": spin, "turns": turns, "rock": rock, "axis": axis, "easing": easing, "map-sweep": map_sweep,
                  "seconds": seconds, "fps": fps}
        if path is None:
            usual, pace = _NOTEBOOK_MOVIE
            options = usual | options
            for key, value in pace.items():
                if motion[key] is None and not ((models or morph) and key == "seconds"):
                    motion[key] = value
        values = [(key, value if isinstance(value, str) else ",".join(map(str, _numpy.ravel(value).tolist())))
                  for key, value in motion.items() if value is not None]
        colors, text = self._given(options)
        with _tempfile.TemporaryDirectory(prefix="nacre-") as folder:
            target = _os.path.join(folder, "movie.png") if path is None else _writable(path)
            frames, warnings = _nacre.movie(self._core, target, values, bool(models), bool(morph), bool(loop), text, colors)
            with _open(target, "rb") as file:
                data = file.read()
        _tell(warnings)
        return Movie(data, _MOVIE_TYPES[_os.path.splitext(target)[1].lower()], frames)

    def view(self, *, size=(640, 480), **options):
        """A picture that is turned, moved and zoomed in the cell of a notebook, and whose style is chosen there. Where no
        browser shows it, it is a picture. options: those of render(). See View.
        """
        _colored(len(self), options)
        return View(self, size, options)

    def __reduce__(self):
        return Structure, (self._core, self._maps)

    def _repr_png_(self):
        """The picture in a notebook."""
        return _encoded(self, ".png", _NOTEBOOK)


_open = __builtins__["open"] if isinstance(__builtins__, dict) else __builtins__.open


def open(source, *, name="", maps=(), **options):  # noqa: A001: nacre.open, as PIL's Image.open
    """Reads a structure:

    - a path, "sample:dna", "pdb:1BNA" or another INPUT of `nacre render`, or a list of them, which are drawn together, each
      with a name for selections: open(["receptor=a.pdb", "ligand=b.sdf"], fit=("/ligand", "/receptor")) superposes the
      first on the second; open(["open.pdb", "closed.pdb"], conformations=True) takes them for models of one
    - a file's bytes or an open file, in any supported format, compressed or not; an address (https://...)
    - a Universe or AtomGroup of MDAnalysis, a Trajectory of MDTraj, a Mol of RDKit with conformers, a Structure, Model or
      Chain of gemmi or Biopython

    name: of bytes, for messages and as a hint to the format ("1crn.pdb"). maps: density maps that its pictures show: files,
    downloads or names of density_map(). options: those of `nacre info`: format, model (a
    number from 1, or "all"), trajectory, frame, memory, offline, cache and more.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _of_file(name, bytes(source), options, maps)
    if _others.is_address(source):
        found, data = _others.address_bytes(source)
        return _of_file(name or found, data, options, maps)
    if convert := _others.converter(source):
        return _of_other(convert(source), options, maps)
    if hasattr(source, "read") and not isinstance(source, _os.PathLike):
        found, data = _others.file_bytes(source)
        return _of_file(name or found, data, options, maps)
    sources = [source] if isinstance(source, (str, _os.PathLike)) else source
    if not isinstance(sources, (list, tuple)):
        raise UsageError(f"open() takes a path, a list of paths, a file, its bytes or another package's structure, not {_kind(source)}")
    for one in sources:
        if isinstance(one, (bytes, bytearray, memoryview)):
            raise UsageError("open() takes bytes alone, not in a list: write them to a file")
        if not isinstance(one, (str, _os.PathLike)):
            raise UsageError(f"open() takes a list of paths, not of {_kind(one)}")
    try:
        core = _nacre.open_inputs([_os.fspath(one) for one in sources], _text(options))
    except _nacre.Missing as missing:
        raise FileMissing(*missing.args) from None
    _tell(core.said[0])
    return Structure(core, maps)


def from_arrays(positions, elements, bonds=None, *, names=(), residue_names=(), residue_numbers=(), chains=(),
                b_factors=(), occupancies=(), name="arrays"):
    """A structure from your own arrays.

    positions: (n, 3) in Å. elements: n symbols or atomic numbers. bonds: rows of two indices from 0, or of two indices
    and an order; None: found by residue and distance; an empty list: none. The others: n entries each, or empty.
    """
    return Structure(_core_of(positions, elements, bonds, names, residue_names, residue_numbers, chains, b_factors,
                              occupancies, name))


def _core_of(positions, elements, bonds=None, names=(), residue_names=(), residue_numbers=(), chains=(), b_factors=(),
             occupancies=(), name="arrays"):
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

    return _nacre.from_arrays(positions, elements, bonds, texts(names), texts(residue_names),
                              numbers(residue_numbers, int), texts(chains), numbers(b_factors, float),
                              numbers(occupancies, float), name)


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


def density_map(name, values, cell, *, origin=(0, 0, 0), crystal=False):
    """A density map of an array, under a name that pictures take: render(map=[name]).

    values: (a, b, c) nodes. cell: the edges in Å, and the angles in degrees if they are not 90; a numpy array's box, or
    the unit cell if the map is a crystal's. origin: place of the first node in Å.
    """
    cell = [float(value) for value in cell]
    _nacre.density_map(str(name), _numpy.asarray(values, dtype=_numpy.float32),
                       cell + [90.0] * (6 - len(cell)) if len(cell) == 3 else cell, [float(v) for v in origin],
                       bool(crystal))
    return str(name)


def from_gemmi(structure, **options):
    """A gemmi Structure, Model or Chain, by way of mmCIF. options: as for open()."""
    return _of_file(*_others.from_gemmi(structure), {"format": "mmcif"} | options)


def from_biopython(entity, **options):
    """A Bio.PDB Structure, Model or Chain, by way of mmCIF. options: as for open()."""
    return _of_file(*_others.from_biopython(entity), {"format": "mmcif"} | options)


def _of_file(name, data, options, maps=()):
    return Structure(_nacre.open_bytes(name, data, _text(options)), maps)


class _Places:
    """Frames of a structure that another package holds."""

    def __init__(self, columns):
        self._columns = columns

    def __len__(self):
        return self._columns.frames

    def at(self, number):
        return _core_of(**self._columns.arguments | {"positions": self._columns.positions(number), "name": self._columns.name})


def _of_other(made, options, maps):
    """A structure of what _others made: a file's name and bytes, or columns."""
    if not isinstance(made, _others.Columns):
        return _of_file(*made, options, maps)
    if options:
        raise UsageError(f'open() takes no "{next(iter(options))}" with this object')
    structure = Structure(_core_of(**made.arguments, name=made.name), maps)
    structure._motion = _Places(made) if made.frames > 1 else None
    return structure


def options():
    """The options of render(), layers() and save(), with their help."""
    return dict(_nacre.option_names())
