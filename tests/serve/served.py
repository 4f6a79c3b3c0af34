"""A `nacre serve` of its own for a test."""
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest
import urllib.error
import urllib.request

PDB = ("ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N\n"
       "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00  0.00           C\n"
       "ATOM      3  C   GLY A   1       2.000   1.420   0.000  1.00  0.00           C\n"
       "ATOM      4  O   GLY A   1       1.250   2.390   0.000  1.00  0.00           O\nEND\n")

SANITIZED = "NACRE_SANITIZED" in os.environ
SLOWER = 6 if SANITIZED else 1  # a program, at most

ROOM = "HTTP/1.1\r\nHost: localhost\r\n"


def scene(url, format="pdb", kind="structure", **params):
    """A MolViewSpec scene of one file."""
    node = {"kind": "representation", "params": {"type": "ball_and_stick"}}
    for kind, params in (("component", {"selector": "all"}), (kind, {"type": "model"} | params), ("parse", {"format": format}),
                         ("download", {"url": url}), ("root", {})):
        node = {"kind": kind, "params": params, "children": [node]}
    return json.dumps({"root": node, "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}})


class Client:
    """A socket, and what comes of it."""

    def __init__(self, port, timeout=60 * SLOWER):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout)

    def send(self, text):
        self.socket.sendall(text if isinstance(text, bytes) else text.encode())
        return self

    def rest(self):
        """What is sent until the other end closes."""
        data = b""
        try:
            while piece := self.socket.recv(65536):
                data += piece
        except ConnectionResetError:
            pass
        self.socket.close()
        return data

    def cut(self):
        self.socket.close()


class ServedTest(unittest.TestCase):
    """A server for all tests of a class. `program` is nacre; fill() puts files into cls.folder and cls.root."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-serve-"))
        cls.root = cls.folder / "root"
        cls.root.mkdir()
        cls.fill()
        cls.server = Server(cls.program, cls.folder, "--root", str(cls.root))

    @classmethod
    def tearDownClass(cls):
        code = cls.server.stop()
        shutil.rmtree(cls.folder)
        assert code == 0, f"SIGTERM: exit status {code}"


class Server:
    def __init__(self, program, folder, *options, listen="0", prepare=None, **environment):
        """@param prepare  called in the new process, before it is nacre"""
        environment = os.environ | {"NACRE_CACHE": str(folder / "cache"), "TMPDIR": str(folder)} | environment
        self.process = subprocess.Popen([program, "serve", "--listen", listen, *options], stderr=subprocess.PIPE, text=True,
                                        env=environment, preexec_fn=prepare)
        line = self.process.stderr.readline()
        self.url = re.search(r"http://[^/ ]+/", line).group(0)
        self.port = int(self.url.rstrip("/").rsplit(":", 1)[1])

    def ask(self, path, data=None, **headers):
        """-> status, headers, body"""
        request = urllib.request.Request(self.url + path, data=data, headers=headers)
        try:
            with urllib.request.urlopen(request, timeout=120 * SLOWER) as answer:
                return answer.status, answer.headers, answer.read()
        except urllib.error.HTTPError as error:
            return error.code, error.headers, error.read()

    def metric(self, name):
        return float(re.search(rf"^{re.escape(name)} (\S+)$", self.ask("metrics")[2].decode(), re.MULTILINE).group(1))

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def most_address_space(self):
        """Bytes that it had at most."""
        return 1024 * int(re.search(r"VmPeak:\s+(\d+) kB", pathlib.Path(f"/proc/{self.process.pid}/status").read_text()).group(1))

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        code = self.process.wait(120 * SLOWER)
        self.process.stderr.close()
        return code
