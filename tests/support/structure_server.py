"""An HTTP server that serves a folder well or badly: structure_server.py FOLDER [CERTIFICATE KEY].

The first part of a path says how (the methods of Handler), the rest names the file: "/ok/a/b?c" is FOLDER/a_b_c, where
'?' too becomes '_'. Prints its port as its first line, and then each request as a line: METHOD PATH RANGE IF-RANGE.
"""
import http.server
import os
import socket
import ssl
import sys
import threading
import time

folder = sys.argv[1]
seen = {}  # requests so far, by path
lock = threading.Lock()


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self):
        way, _, rest = self.path[1:].partition("/")
        with lock:
            self.turn = seen[self.path] = seen.get(self.path, 0) + 1
            print("GET", self.path, self.headers.get("Range", "-"), self.headers.get("If-Range", "-"), flush=True)
        self.file = os.path.join(folder, rest.replace("/", "_").replace("?", "_"))
        try:
            getattr(self, way.replace("-", "_"))(rest)
        except (BrokenPipeError, ConnectionResetError):
            pass

    def log_message(self, *arguments):
        pass

    def content(self):
        with open(self.file, "rb") as file:
            return file.read()

    def head(self, status, length=None, **headers):
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name.replace("_", "-"), value)
        if length is not None:
            self.send_header("Content-Length", str(length))
        self.end_headers()

    def part(self, tag='"v1"'):
        """Sends the headers of what was asked for, and returns the bytes that belong to them."""
        if not os.path.exists(self.file):
            self.error(404)
            return b""
        whole = self.content()
        start = self.headers.get("Range", "")
        if start and self.headers.get("If-Range") == tag:
            first = int(start[len("bytes="):-1])
            if first >= len(whole):
                self.error(416)
                return b""
            self.head(206, len(whole) - first, ETag=tag,
                      Content_Range=f"bytes {first}-{len(whole) - 1}/{len(whole)}")
            return whole[first:]
        self.head(200, len(whole), ETag=tag)
        return whole

    def lose(self):
        self.wfile.flush()
        self.connection.shutdown(socket.SHUT_RDWR)
        self.close_connection = True

    def error(self, status):
        text = b"<html><body>no</body></html>"
        self.head(status, len(text), Content_Type="text/html")
        self.wfile.write(text)

    def ok(self, rest):
        self.wfile.write(self.part())

    def slow(self, rest):
        body = self.part()
        step = len(body) // 30 + 1
        for at in range(0, len(body), step):
            self.wfile.write(body[at:at + step])
            time.sleep(0.1)

    def stall(self, rest):
        body = self.part()
        self.wfile.write(body[:len(body) // 2])
        self.wfile.flush()
        time.sleep(20)

    def trickle(self, rest):
        for byte in self.part():
            self.wfile.write(bytes([byte]))
            time.sleep(0.2)

    def silent(self, rest):
        time.sleep(20)

    def drop(self, rest):
        body = self.part()
        self.wfile.write(body[:len(body) // 2])
        self.lose()

    def drop_once(self, rest):
        self.drop(rest) if self.turn == 1 else self.ok(rest)

    def drop_changed(self, rest):
        """Half of one version, then another."""
        if self.turn == 1:
            self.head(200, 1000, ETag='"old"')
            self.wfile.write(b"x" * 500)
            self.lose()
        else:
            self.ok(rest)

    def drop_untagged(self, rest):
        """Half of a file of which nothing says the version."""
        body = self.content()
        self.head(200, len(body))
        self.wfile.write(body if self.turn > 1 else body[:len(body) // 2])
        if self.turn == 1:
            self.lose()

    def wrong_range(self, rest):
        if self.turn == 1:
            self.drop(rest)
        else:
            self.head(206, 5, ETag='"v1"', Content_Range="bytes 0-4/5")
            self.wfile.write(b"wrong")

    def chunked(self, rest):
        body = self.content()
        self.head(200, Transfer_Encoding="chunked")
        for at in range(0, len(body), 1000):
            piece = body[at:at + 1000]
            self.wfile.write(b"%x\r\n%s\r\n" % (len(piece), piece))
        self.wfile.write(b"0\r\n\r\n")

    def chunked_cut(self, rest):
        self.head(200, Transfer_Encoding="chunked")
        self.wfile.write(b"%x\r\n%s\r\n" % (100, self.content()[:100]))
        self.lose()

    def endless(self, rest):
        self.head(200, Transfer_Encoding="chunked")
        while True:
            self.wfile.write(b"10000\r\n" + b"x" * 65536 + b"\r\n")

    def huge(self, rest):
        self.head(200, 10 ** 13)
        time.sleep(20)

    def untrue(self, rest):
        """All that HTTP can check is right, but the file is cut."""
        body = self.content()
        self.head(200, len(body) * 2 // 3)
        self.wfile.write(body[:len(body) * 2 // 3])

    def html(self, rest):
        self.error(200)

    def empty(self, rest):
        self.head(200, 0)

    def busy(self, rest):
        self.error(503)

    def redirect(self, rest):
        self.head(302, 0, Location=self.turned("ok", rest))

    def circle(self, rest):
        self.head(302, 0, Location="/circle/" + rest)

    def no_http(self, rest):
        self.wfile.write(b"This is the text, without a status or a header.\n")
        self.close_connection = True

    def to_file(self, rest):
        self.head(302, 0, Location="file:///etc/hostname")

    def to_ftp(self, rest):
        self.head(302, 0, Location="ftp://localhost/" + rest)

    def to_http(self, rest):
        self.head(302, 0, Location="http://localhost:1/" + rest)

    def to_https(self, rest):
        self.head(302, 0, Location="https://localhost:1/" + rest)

    def turned(self, way, rest):
        return f"http://localhost:{self.server.server_address[1]}/{way}/{rest}"

    def predictions(self, rest):
        """A list in which the protein's own entry is the second."""
        name = rest.rpartition("/")[2]
        other, own = self.turned("ok", "other"), self.turned("ok", name)
        self.json(f'[{{"uniprotAccession": "Q00000", "bcifUrl": "{other}.bcif", "cifUrl": "{other}.cif"}},'
                  f' {{"uniprotAccession": "{name}", "bcifUrl": "{own}.bcif", "cifUrl": "{own}.cif"}}]')

    def no_predictions(self, rest):
        self.json("[]")

    def bad_predictions(self, rest):
        self.json('[{"bcifUrl": "file:///etc/hostname", "cifUrl": 7}]')

    def json(self, text):
        self.head(200, len(text), Content_Type="application/json")
        self.wfile.write(text.encode())


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, request, client_address):
        """A client that hangs up, or a file that is not there: the test sees what comes of it."""


server = Server(("127.0.0.1", 0), Handler)
if len(sys.argv) > 2:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(sys.argv[2], sys.argv[3])
    server.socket = context.wrap_socket(server.socket, server_side=True, do_handshake_on_connect=False)
print(server.server_address[1], flush=True)
server.serve_forever()
