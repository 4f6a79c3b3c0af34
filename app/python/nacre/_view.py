"""A structure that turns in the cell of a notebook: the page of `nacre serve`, answered by this process on loopback."""

from __future__ import annotations

import base64
import hmac
import html
import http.server
import json
import os
import secrets
import tempfile
import threading
import urllib.parse
import warnings

_SCRIPT = """(function () {
  const cell = document.getElementById("ID"), page = cell.querySelector("iframe");
  addEventListener("message", function (event) {
    if (event.source === page.contentWindow && event.data === "nacre") page.style.visibility = "visible";
  });
  page.src = "URL";
})();"""
_FIELDS = ("style", "color", "look", "show", "label")
_CAMERA = ("orientation", "zoom", "pan", "clip")
_MOST_VIEWS = 64  # that answer; older ones are pictures from then on


class View:
    """What Structure.view() returns. In a notebook it is a picture that turns; elsewhere a picture.

    description: the options of render() that draw what is seen now; render(**view.description) draws it.
    """

    def __init__(self, structure, size, options):
        self.structure, self.size = structure, (int(size[0]), int(size[1]))
        self._options, self._seen, self._token = dict(options), None, None

    def _with(self, seen):
        """The cell's options, but the camera is the page's."""
        return {key: value for key, value in self._options.items() if key not in _CAMERA} | seen

    @property
    def description(self):
        return dict(self._options) if self._seen is None else self._with(self._seen)

    def picture(self, **options):
        """The picture as seen now, (height, width, 4) uint8. options: those of render(), instead of what is seen."""
        return self.structure.render(**({"size": self.size} | self.description | options))

    def save(self, path, **options):
        """The same into a file."""
        self.structure.save(path, **({"size": self.size} | self.description | options))

    @property
    def _query(self):
        """The page's query: what is seen now."""
        shown = [(key, _text(value)) for key, value in self.description.items()
                 if key in _CAMERA or key in _FIELDS and isinstance(value, str)]
        return urllib.parse.urlencode([("input", self.structure.name), *shown])

    @property
    def url(self):
        """The page's address. It answers on this machine alone, to whoever knows the token in it."""
        if self._token is None:
            self._token = _server().add(self)
        return f"http://127.0.0.1:{_server().server_port}/{self._token}/?{self._query}"

    def __repr__(self):
        return f"<nacre.View of {self.structure.name!r}>"

    def _repr_mimebundle_(self, include=None, exclude=None):
        width, height = self.size
        picture = base64.b64encode(_file(self.structure, ".png", {"size": self.size} | self.description)).decode()
        bundle = {"text/plain": repr(self), "image/png": picture}
        try:
            url = self.url
        except OSError:  # no loopback
            return bundle
        # The page covers the picture once it has drawn: a notebook without its kernel, or on paper, shows the picture.
        name = f"nacre-{secrets.token_hex(8)}"
        script = _SCRIPT.replace("ID", name).replace("URL", url.replace("\\", "%5C").replace('"', "%22").replace("<", "%3C"))
        title = html.escape(self.structure.name, quote=True)
        bundle["text/html"] = (
            f'<div id="{name}" style="position:relative;width:100%;max-width:{width}px;height:{height}px">'
            f'<img alt="{title}" src="data:image/png;base64,{picture}" style="width:100%;height:100%;object-fit:contain;margin:0">'
            f'<iframe title="{title}" style="position:absolute;top:0;left:0;width:100%;height:100%;border:0;visibility:hidden">'
            f"</iframe><script>{script}</script></div>")
        return bundle

    def _answer(self, query):
        """The picture of a request. @returns type, bytes"""
        seen = {key: query[key][-1] for key in (*_FIELDS, *_CAMERA) if key in query}
        for key in ("orientation", "pan"):
            if key in seen:
                seen[key] = [float(number) for number in seen[key].split(",")]
        if "zoom" in seen:
            seen["zoom"] = float(seen["zoom"])
        kind = {"jpg": ".jpg", "webp": ".webp"}.get(query.get("format", [""])[-1], ".png")
        moving = {key: query[key][-1] for key in ("size", "supersample") if key in query}
        data = _file(self.structure, kind, {"size": self.size} | self._with(seen) | moving)
        self._seen = seen
        return {".png": "image/png", ".jpg": "image/jpeg", ".webp": "image/webp"}[kind], data


def _text(value):
    return value if isinstance(value, str) else ",".join(map(str, value)) if hasattr(value, "__iter__") else str(value)


def _file(structure, ending, options):
    with tempfile.TemporaryDirectory(prefix="nacre-") as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = os.path.join(folder, "picture" + ending)
        structure.save(path, **options)
        with open(path, "rb") as file:
            return file.read()


class _Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    timeout = 30

    def log_message(self, *_):
        pass

    def _send(self, status, kind, data):
        self.send_response(status)
        for key, value in (("Content-Type", kind), ("Content-Length", str(len(data))), ("Cache-Control", "no-store"),
                           ("Referrer-Policy", "no-referrer"), ("X-Content-Type-Options", "nosniff")):
            self.send_header(key, value)
        self.end_headers()
        self.wfile.write(data)

    def _problem(self, status, detail):
        self._send(status, "application/problem+json", json.dumps({"status": status, "detail": str(detail)}).encode())

    def do_GET(self):
        from . import Error, UsageError, _nacre

        place = urllib.parse.urlsplit(self.path)
        _, token, *rest = place.path.split("/")
        # A page elsewhere that calls a name of its own 127.0.0.1 sends that name.
        host = self.headers.get("Host", "").rsplit(":", 1)[0]
        view = self.server.view(token) if host in ("127.0.0.1", "localhost") else None
        if view is None or len(rest) != 1:
            return self._problem(404, "no such view: run its cell again")
        try:
            if rest[0] == "":
                # A notebook that loads the page anew, as JupyterLab does with cells that come back into sight, shows
                # what was seen last, whatever its cell says.
                body = f'<body class="cell" data-query="{html.escape(view._query, quote=True)}">'
                return self._send(200, "text/html; charset=utf-8", self.server.page.replace(b"<body>", body.encode(), 1))
            if rest[0] == "options":
                return self._send(200, "application/schema+json", _nacre.option_schema().encode())
            if rest[0] == "info":
                return self._send(200, "application/json", json.dumps(view.structure.info()).encode())
            if rest[0] == "picture":
                return self._send(200, *view._answer(urllib.parse.parse_qs(place.query)))
        except (UsageError, ValueError) as error:
            return self._problem(400, error)
        except Error as error:
            return self._problem(422, error)
        self._problem(404, f"there is no {rest[0]}")


class _Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self):
        super().__init__(("127.0.0.1", 0), _Handler)
        self.process, self.views = os.getpid(), {}
        with open(os.path.join(os.path.dirname(__file__), "page.html"), "rb") as file:
            self.page = file.read()

    def view(self, token):
        """The view with a token, or None; it takes the same time for every wrong token."""
        found = None
        for known, view in list(self.views.items()):
            if hmac.compare_digest(known.encode(), token.encode("utf-8", "replace")):
                found = view
        return found

    def add(self, view):
        token = secrets.token_urlsafe(24)
        self.views[token] = view
        for old in list(self.views)[:-_MOST_VIEWS]:
            del self.views[old]
        return token

    def handle_error(self, request, client_address):
        pass  # a browser that went away


_lock, _running = threading.Lock(), None


def _server():
    global _running
    with _lock:
        if _running is None or _running.process != os.getpid():
            _running = _Server()
            threading.Thread(target=_running.serve_forever, name="nacre-view", daemon=True).start()
        return _running
