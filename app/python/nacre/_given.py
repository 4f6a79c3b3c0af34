"""What is given to the module, checked and as it takes it; errors and warnings from it."""

from __future__ import annotations

import errno
import json
import os
import warnings

import numpy

from . import _nacre
from ._nacre import Error, UsageError  # type: ignore

_TOGETHER = 8  # pictures that pictures() holds


class FileMissing(Error, FileNotFoundError):
    """The file, or the folder to write to, does not exist."""

    __module__ = "nacre"

    def __init__(self, message, path=None):
        super().__init__(message)
        self.errno, self.strerror, self.filename = errno.ENOENT, os.strerror(errno.ENOENT), path

    def __str__(self):
        return self.args[0]

    def __reduce__(self):
        return FileMissing, (self.args[0], self.filename)


def writable(path):
    path = os.fspath(path)
    folder = os.path.dirname(path)
    if folder and not os.path.isdir(folder):
        raise FileMissing(f"cannot write file: {path}: No such file or directory", path)
    return path


def plain(value):
    """The value in types that JSON has."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, numpy.ndarray):
        return value.tolist()
    if isinstance(value, numpy.generic):
        return value.item()
    if isinstance(value, dict):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    return value


def kind(value):
    """A value's type, for messages."""
    kind = type(value)
    return kind.__name__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__name__}"


def shown(value):
    """A value for messages: of a long one its type."""
    try:
        if len(value) > 8 and not isinstance(value, str):
            return f"{kind(value)} of {len(value)} entries"
    except TypeError:
        pass
    words = repr(value)
    return words if len(words) <= 60 else words[:60] + "..."


def ids(mask, count, name):
    """The selection of a mask's atoms: "id 1-20+35"."""
    if mask.shape != (count,):
        raise UsageError(f'"{name}": a mask has one value for each of the {count} atoms, not the shape {mask.shape}')
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([False], mask, [False])).astype(numpy.int8)))
    runs = (f"{a + 1}" if a + 1 == b else f"{a + 1}-{b}" for a, b in edges.reshape(-1, 2).tolist())
    return "id " + "+".join(runs) if len(edges) else "not all"


def as_mask(value):
    """A numpy array of booleans; None if it is something else. Lists are no masks."""
    if isinstance(value, (str, bytes, list, tuple, dict)) or not hasattr(value, "__array__"):
        return None
    array = numpy.asarray(value)
    return array if array.dtype == bool and array.ndim else None


_JOINED_BY_COMMA = {"measure", "interactions", "interface", "map_around"}
_ONE_TEXT = _JOINED_BY_COMMA - {"measure"}  # there, a tuple of texts is one value; elsewhere a list of values


def selections(value, count, name):
    """The value with masks as the selections of their atoms, and tuples as one text: (mask, "licorice")."""
    mask = as_mask(value)
    if mask is not None:
        return ids(mask, count, name)
    if isinstance(value, list):
        return [joined(one, count, name) if isinstance(one, tuple) and any(isinstance(part, str) for part in one)
                else selections(one, count, name) for one in value]
    if isinstance(value, tuple) and (name in _ONE_TEXT or any(as_mask(one) is not None for one in value)
                                     or (name == "measure" and any(isinstance(one, int) for one in value))):
        return joined(value, count, name)
    return value


def joined(parts, count, name):
    joint = "," if name in _JOINED_BY_COMMA else "="
    return joint.join(str(selections(part, count, name)) for part in parts)


def tables(value):
    """The value with tables as JSON: a DataFrame, a dict of columns, a list of rows; or a list of sources."""
    def table(one):
        if hasattr(one, "to_dict") and hasattr(one, "columns"):
            one = one.to_dict("list")
        return json.dumps(plain(one), default=str).replace("NaN", "null") if isinstance(one, (dict, list)) else one

    if isinstance(value, list) and not (value and all(isinstance(row, dict) for row in value)):
        return [table(one) for one in value]
    return table(value)


def text(options, count=None):
    """The options as JSON. @param count  atoms of masks; None: there are no masks"""
    texts = []
    for name, value in options.items():
        try:
            if name == "color_from":
                value = tables(value)
            elif count is not None:
                value = selections(value, count, name)
            texts.append(f"{json.dumps(name)}: {json.dumps(plain(value), allow_nan=False)}")
        except TypeError as error:
            raise UsageError(f'"{name}": {error}') from None
        except ValueError as error:
            if isinstance(error, UsageError):
                raise
            raise UsageError(f'"{name}": expected finite numbers, not {shown(value)}') from None
    return f"{{{', '.join(texts)}}}"


def tell(texts, level=3):
    for text in texts:
        warnings.warn(text, stacklevel=level)


def of_atoms(color):
    """Whether a color is one for each atom."""
    return color is not None and not isinstance(color, str)


def groups(views, options):
    """Options of pictures that are drawn together. What is wrong with one is told after those before it."""
    own, group = of_atoms(options.get("color")), []
    try:
        for view in views:
            if of_atoms(view.get("color")):
                raise UsageError('"color" of a view: a scheme or a colour; arrays go with all views')
            if own and "color" in view:
                raise UsageError('"color" of a view: the colours of all views are given')
            if own and ("palette" in view or "color_limits" in view):  # other colours than those of earlier views
                yield group
                group = []
                yield [options | dict(view)]
                continue
            group.append(options | dict(view))
            if len(group) == _TOGETHER:
                yield group
                group = []
    except Exception:
        yield group
        raise
    yield group


def colored(count, options):
    """Takes colours or values per atom out of the options."""
    options = dict(options)
    color, limits = options.get("color"), options.pop("color_limits", None)
    if not of_atoms(color):
        if limits is not None:
            raise UsageError('"color_limits" goes with values in "color", one for each atom')
        return _nacre.Colors(), text(options, count)
    del options["color"]
    array = numpy.asarray(color)
    if array.dtype.kind not in "biuf":
        raise UsageError(f'"color": expected a scheme, a colour, values or colours of the atoms, not {kind(color)}')
    if array.ndim == 1 and len(array) == count:
        if limits is not None:
            limits = tuple(float(limit) for limit in limits)
            if len(limits) != 2 or not numpy.all(numpy.isfinite(limits)) or limits[0] == limits[1]:
                raise UsageError('"color_limits": expected two finite numbers that differ')
        palette = options.pop("palette", "viridis")
        return _nacre.Colors.of_values(array.astype(float).tolist(), palette, limits), text(options, count)
    if array.shape != (count, 3):
        raise UsageError(f'"color": expected {count} values or ({count}, 3) colours, one for each atom, not an array of shape '
                         f"{array.shape}")
    if limits is not None:
        raise UsageError('"color_limits" goes with values, not colours')
    whole = array.dtype.kind in "iu"
    if not numpy.all(numpy.isfinite(array)) or array.min() < 0 or array.max() > (255 if whole else 1):
        raise UsageError('"color": expected whole numbers from 0 to 255, or others from 0 to 1')
    return _nacre.Colors(numpy.round(array * (1 if whole else 255)).astype(numpy.uint8)), text(options, count)
