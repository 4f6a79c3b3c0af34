"""A structure that turns in the cell of a notebook: the page of `nacre serve`, answered over the kernel's channel."""

from __future__ import annotations

import base64
import html
import json
import os
import secrets
import tempfile
import threading
import urllib.parse
import warnings

from ._channel import channel as _channel, kernel as _kernel

_FOLDER = os.path.dirname(__file__)
_FIELDS = ("style", "color", "look", "show", "label")
_CAMERA = ("orientation", "zoom", "pan", "clip")
_KINDS = {"jpg": (".jpg", "image/jpeg"), "webp": (".webp", "image/webp"), "png": (".png", "image/png")}
_MOST_FRAMES = 64  # kept by a view, with their scenes
_turn = threading.Lock()  # guards the frames of all views


class View:
    """A view that Structure.view() returns. In a notebook it is a picture that turns; elsewhere a picture.

    description: the options of render() that draw what is seen now; render(**view.description) draws it.
    picked: index of the atom that was clicked last, or None. frame: number of the model or of the trajectory's frame.
    """

    def __init__(self, structure, size, options):
        self.structure, self.size = structure, (int(size[0]), int(size[1]))
        self.picked, self.frame = None, 1
        self._options, self._seen, self._token, self._loopback = dict(options), None, None, None
        self._frames = {}

    def _with(self, seen):
        """The cell's options, but the camera is the page's."""
        return {key: value for key, value in self._options.items() if key not in _CAMERA} | seen

    @property
    def description(self):
        return dict(self._options) if self._seen is None else self._with(self._seen)

    def picture(self, **options):
        """The picture as seen now, (height, width, 4) uint8. options: those of render(), instead of what is seen."""
        return self._shown().render(**({"size": self.size} | self.description | options))

    def save(self, path, **options):
        """Saves the picture as seen now."""
        self._shown().save(path, **({"size": self.size} | self.description | options))

    def _shown(self):
        """The structure at the frame that is seen."""
        number = self.frame  # a page may choose another one meanwhile
        if number == 1:
            return self.structure
        with _turn:
            if number not in self._frames:
                self._frames[number] = self.structure.frame(number)
                for old in list(self._frames)[:-_MOST_FRAMES]:
                    del self._frames[old]
            return self._frames[number]

    @property
    def _query(self):
        """The page's query for the view as seen now."""
        shown = [(key, _text(value)) for key, value in self.description.items()
                 if key in _CAMERA or key in _FIELDS and isinstance(value, str)]
        frame = [("frame", self.frame)] if self.frame > 1 else []
        return urllib.parse.urlencode([("input", self.structure.name), *shown, *frame])

    @property
    def url(self):
        """The address of the view as a page of its own. It answers on this machine alone, to whoever knows the token in it."""
        from ._page import server

        if self._loopback is None:
            self._loopback = server().add(self)
        return f"http://127.0.0.1:{server().server_port}/{self._loopback}/?{self._query}"

    def __repr__(self):
        return f"<nacre.View of {self.structure.name!r}>"

    def _repr_mimebundle_(self, include=None, exclude=None):
        picture = base64.b64encode(encoded(self._shown(), ".png", {"size": self.size} | self.description)).decode()
        bundle = {"text/plain": repr(self), "image/png": picture}
        kernel = _kernel()
        if self._token is None:
            self._token = secrets.token_urlsafe(24)
            _channel.add(self._token, self)
        if os.environ.get("VSCODE_PID") and (widget := _widget(self, picture)):
            return bundle | widget
        if kernel:
            bundle["text/html"] = _cell(self, picture, kernel)
        return bundle

    def _answer(self, path):
        """Answers a page: "", "options", "info", "picture?QUERY" or "pick?QUERY". @returns status, type, bytes"""
        from . import Error, UsageError, _nacre

        place = urllib.parse.urlsplit(path)
        query = urllib.parse.parse_qs(place.query)
        try:
            if place.path == "":
                # If a notebook reloads the page, as JupyterLab does with cells that scroll back into sight, it shows
                # the last state, whatever its cell contains.
                body = f'<body class="cell" data-query="{html.escape(self._query, quote=True)}">'
                return 200, "text/html; charset=utf-8", _read("page.html").replace("<body>", body, 1).encode()
            if place.path == "options":
                return 200, "application/schema+json", _nacre.option_schema().encode()
            if place.path == "info":
                info = self.structure.info() | {"frames": self.structure.frames}
                return 200, "application/json", json.dumps([info]).encode()
            if place.path == "picture":
                return self._draw(query)
            if place.path == "pick":
                return 200, "application/json", json.dumps(self._pick(query)).encode()
        except (UsageError, ValueError) as error:
            return _problem(400, error)
        except Error as error:
            return _problem(422, error)
        return _problem(404, f"there is no {place.path}")

    def _see(self, query):
        """Reads a page's query and takes its frame. @returns the options that the page sets, and those that draw it"""
        seen = {key: query[key][-1] for key in (*_FIELDS, *_CAMERA) if key in query}
        for key in ("orientation", "pan"):
            if key in seen:
                seen[key] = [float(number) for number in seen[key].split(",")]
        if "zoom" in seen:
            seen["zoom"] = float(seen["zoom"])
        self.frame = min(max(int(query.get("frame", ["1"])[-1]), 1), self.structure.frames)
        size = {key: query[key][-1] for key in ("size", "supersample") if key in query}
        return seen, {"size": self.size} | self._with(seen) | size

    def _draw(self, query):
        seen, options = self._see(query)
        ending, kind = _KINDS.get(query.get("format", [""])[-1], _KINDS["png"])
        data = encoded(self._shown(), ending, options)
        self._seen = seen
        return 200, kind, data

    def _pick(self, query):
        _, options = self._see(query)
        options.pop("supersample", None)
        x, y = (int(number) for number in query["at"][-1].split(","))
        number = int(self._shown().layers(**options)["id"][y, x])
        self.picked = number - 1 if number else None
        if not number:
            return {"atom": None, "text": ""}
        atoms = self.structure.atoms
        words = [atoms[key][self.picked] for key in ("residue_name", "residue_number", "name")]
        chain = atoms["chain"][self.picked]
        return {"atom": self.picked, "text": " ".join(map(str, words)) + (f", chain {chain}" if chain else "")}


def _problem(status, detail):
    return status, "application/problem+json", json.dumps({"status": status, "detail": str(detail)}).encode()


def _text(value):
    return value if isinstance(value, str) else ",".join(map(str, value)) if hasattr(value, "__iter__") else str(value)


def _read(name):
    with open(os.path.join(_FOLDER, name), encoding="utf-8") as file:
        return file.read()


def encoded(structure, ending, options):
    """Bytes of a picture's file, without warnings. options: those of save()."""
    with tempfile.TemporaryDirectory(prefix="nacre-") as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = os.path.join(folder, "picture" + ending)
        structure.save(path, **options)
        with open(path, "rb") as file:
            return file.read()


def _frame(view, picture, name):
    """The element of a cell: its picture, which the page covers once it has drawn."""
    width, height = view.size
    title = html.escape(view.structure.name, quote=True)
    return (f'<div id="{name}" style="position:relative;width:100%;max-width:{width}px;height:{height}px">'
            f'<img alt="{title}" src="data:image/png;base64,{picture}" style="width:100%;height:100%;object-fit:contain;margin:0"></div>')


def _cell(view, picture, kernel):
    name = f"nacre-{secrets.token_hex(8)}"
    # One channel for all cells of a page.
    start = (f"globalThis.nacreAsker = globalThis.nacreAsker && !nacreAsker.closed ? nacreAsker\n"
             f"  : new Asker((receive, closed) => openChannel({json.dumps(kernel)}, receive, closed));\n"
             f"showView(document.getElementById({json.dumps(name)}), {json.dumps(view._token)}, nacreAsker);")
    return f"{_frame(view, picture, name)}<script>(function () {{\n{_read('cell.js')}\n{start}\n}})();</script>"


def _widget(view, picture):
    """By Jupyter's widget protocol, for VS Code, whose outputs have no other way to the kernel; None without anywidget."""
    try:
        import anywidget  # type: ignore
    except ImportError:
        return None

    script = _read("cell.js") + f"""
export default {{ render({{model, el}}) {{
  el.innerHTML = {json.dumps(_frame(view, picture, "nacre"))};
  const asker = new Asker(receive => {{
    model.on("msg:custom", (data, buffers) => receive(data, buffers));
    return {{send: data => model.send(data)}};
  }});
  showView(el.firstElementChild, {json.dumps(view._token)}, asker);
}} }};
"""

    widget = type("Cell", (anywidget.AnyWidget,), {"_esm": script})()
    widget.on_msg(lambda _, data, __: _channel.receive(data, widget.send))
    view._held = widget
    bundle = widget._repr_mimebundle_()
    return bundle[0] if isinstance(bundle, tuple) else bundle
