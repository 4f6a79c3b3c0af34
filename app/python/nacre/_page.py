"""The page of a view on loopback, for a browser on the kernel's machine: View.url."""

from __future__ import annotations

import hmac
import http.server
import os
import secrets
import threading
import urllib.parse

_MOST_VIEWS = 64  # that respond


class _Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    timeout = 30

    def log_message(self, *_):
        pass

    def do_GET(self):
        _, token, *rest = self.path.split("/", 2)
        # A foreign page whose name resolves to 127.0.0.1 sends that name.
        host = self.headers.get("Host", "").rsplit(":", 1)[0]
        view = self.server.view(token) if host in ("127.0.0.1", "localhost") else None
        if view is None or len(rest) != 1:
            return self._send(404, "application/problem+json", b'{"status": 404, "detail": "no such view: run its cell again"}')
        self._send(*view._answer(rest[0]))

    def _send(self, status, kind, data):
        self.send_response(status)
        for key, value in (("Content-Type", kind), ("Content-Length", str(len(data))), ("Cache-Control", "no-store"),
                           ("Referrer-Policy", "no-referrer"), ("X-Content-Type-Options", "nosniff")):
            self.send_header(key, value)
        self.end_headers()
        self.wfile.write(data)


class _Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self):
        super().__init__(("127.0.0.1", 0), _Handler)
        self.process, self.views = os.getpid(), {}

    def view(self, token):
        """The view with a token, or None; it takes the same time for every wrong token."""
        token, found = urllib.parse.unquote(token), None
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
        pass  # the browser disconnected


_lock, _running = threading.Lock(), None


def server():
    """The server of this process, started by the first call."""
    global _running
    with _lock:
        if _running is None or _running.process != os.getpid():
            _running = _Server()
            threading.Thread(target=_running.serve_forever, name="nacre-page", daemon=True).start()
        return _running
