"""`nacre serve` and files: what its caches go by, what it leaves or follows on disk, and where it downloads from.
files_test.py PROGRAM RESOLVE_HERE"""
import concurrent.futures
import contextlib
import ctypes
import io
import json
import os
import pathlib
import resource
import shutil
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import unittest
import zipfile

from served import PDB, ROOM, SANITIZED, SLOWER, Client, ServedTest, Server, scene

PROGRAM, RESOLVE_HERE = sys.argv.pop(1), sys.argv.pop(1)
MOVED = PDB.replace("2.390", "4.390")


@contextlib.contextmanager
def listening():
    """A web server that answers everything with a structure. -> its port, and the first lines of the requests so far"""
    heard = []

    def answer(door):
        while True:
            try:
                client, _ = door.accept()
            except OSError:
                return
            heard.append(client.recv(4096).decode("latin-1").partition("\r\n")[0])
            client.sendall(f"HTTP/1.1 200 OK\r\nContent-Length: {len(PDB)}\r\nConnection: close\r\n\r\n{PDB}".encode())
            client.close()

    with socket.create_server(("127.0.0.1", 0)) as door:
        thread = threading.Thread(target=answer, args=(door,), daemon=True)
        thread.start()
        yield door.getsockname()[1], heard
        door.shutdown(socket.SHUT_RDWR)
        thread.join()


class NewNames:
    """Names that appear in a folder, by inotify."""

    def __init__(self, folder):
        libc = ctypes.CDLL(None, use_errno=True)
        self.file = libc.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        in_create, in_moved_to = 0x100, 0x80
        assert libc.inotify_add_watch(self.file, os.fsencode(folder), in_create | in_moved_to) >= 0, os.strerror(ctypes.get_errno())

    def since(self):
        """Those since the last call."""
        names, head = [], struct.Struct("iIII")
        with contextlib.suppress(BlockingIOError):
            while data := os.read(self.file, 65536):
                at = 0
                while at < len(data):
                    length = head.unpack_from(data, at)[3]
                    names.append(os.fsdecode(data[at + head.size:at + head.size + length].rstrip(b"\0")))
                    at += head.size + length
        return [name for name in names if not name.startswith("tsan.")]  # ThreadSanitizer's own


SIDE = 8  # nodes of a map per axis


def values(center):
    """A blob, the first axis fastest."""
    return [max(0.0, 9.0 - (x - center) ** 2 - (y - 3) ** 2 - (z - 3) ** 2) for z in range(SIDE) for y in range(SIDE) for x in range(SIDE)]


def ccp4(center=3, magic=b"MAP "):
    data = values(center)
    header = bytearray(1024)
    struct.pack_into("<10i6f3i3f2i", header, 0, SIDE, SIDE, SIDE, 2, 0, 0, 0, SIDE, SIDE, SIDE, 8, 8, 8, 90, 90, 90, 1, 2, 3,
                     min(data), max(data), sum(data) / len(data), 1, 0)
    header[208:216] = magic + b"\x44\x44\0\0"
    return bytes(header) + struct.pack(f"<{len(data)}f", *data)


def dx(center=3):
    data = values(center)  # the last axis is the fastest in DX
    ordered = [data[x + SIDE * (y + SIDE * z)] for x in range(SIDE) for y in range(SIDE) for z in range(SIDE)]
    return (f"object 1 class gridpositions counts {SIDE} {SIDE} {SIDE}\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\ndelta 0 0 1\n"
            f"object 2 class gridconnections counts {SIDE} {SIDE} {SIDE}\n"
            f"object 3 class array type double rank 0 items {len(data)} data follows\n" + "\n".join(map(str, ordered)) + "\n").encode()


def volume_scene(url, format):
    node = {"kind": "volume_representation", "params": {"type": "isosurface", "absolute_isovalue": 4}}
    for kind, params in (("volume", {}), ("parse", {"format": format}), ("download", {"url": url}), ("root", {})):
        node = {"kind": kind, "params": params, "children": [node]}
    return json.dumps({"root": node, "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}})


class FilesTest(ServedTest):
    program = PROGRAM

    @classmethod
    def fill(cls):
        for name, text in (("one", PDB), ("two", MOVED), ("inside", PDB)):
            (cls.root / name).mkdir()
            (cls.root / name / "gly.pdb").write_text(text)
            (cls.root / name / "scene.mvsj").write_text(scene("gly.pdb"))
        (cls.root / "maps").mkdir()
        for name, data in (("a.ccp4", ccp4()), ("a.dx", dx()), ("old.map", ccp4(magic=b"    ")), ("b.ccp4", ccp4(5))):
            (cls.root / "maps" / name).write_bytes(data)
        for format, name in (("map", "a.ccp4"), ("dx", "a.dx")):
            (cls.root / "maps" / f"{format}.mvsj").write_text(volume_scene(name, format))
        (cls.folder / "outside").mkdir()
        (cls.folder / "outside" / "a.ccp4").write_bytes(ccp4(5))
        (cls.folder / "outside" / "gly.pdb").write_text(MOVED)

    def picture(self, name, **headers):
        return self.server.ask(f"picture?size=64x64&input={name}", None, **headers)

    def test_scenes_go_by_what_they_name(self):
        """Scenes of the same text in two folders are two pictures."""
        one, two = self.picture("one/scene.mvsj"), self.picture("two/scene.mvsj")
        self.assertEqual((one[0], two[0]), (200, 200))
        self.assertNotEqual(one[2], two[2])
        self.assertNotEqual(one[1]["ETag"], two[1]["ETag"])
        tag = one[1]["ETag"]
        self.assertEqual(self.picture("one/scene.mvsj", **{"If-None-Match": tag})[0], 304)
        (self.root / "one/gly.pdb").write_text(MOVED)
        try:
            status, headers, body = self.picture("one/scene.mvsj", **{"If-None-Match": tag})
            self.assertEqual((status, body), (200, two[2]))
            self.assertNotEqual(headers["ETag"], tag)
        finally:
            (self.root / "one/gly.pdb").write_text(PDB)

    def test_a_body_shows_no_file_below_the_root(self):
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1")
        self.addCleanup(server.process.kill)
        self.assertEqual(server.ask("picture?size=64x64&input=one/scene.mvsj")[0], 200)
        status, _, body = server.ask("picture?size=64x64", scene("gly.pdb").encode())
        self.assertIn(status, (404, 422), body[:200])
        self.assertEqual(server.stop(), 0)

    def test_errors_name_no_folder_of_the_server(self):
        (self.root / "lost.mvsj").write_text(scene("lost.pdb"))
        status, _, body = self.picture("lost.mvsj")
        self.assertEqual(status, 422, body)
        self.assertNotIn(str(self.folder).encode(), body)
        self.assertNotIn(b"/proc", body)

    def opened(self):
        """Files below the root that the server holds open."""
        names = []
        for descriptor in pathlib.Path(f"/proc/{self.server.process.pid}/fd").iterdir():
            try:
                names.append(os.readlink(descriptor))
            except FileNotFoundError:  # closed meanwhile
                pass
        return [name for name in names if name.startswith(os.path.realpath(self.root))]

    def test_inputs_are_closed_once_they_are_read(self):
        self.assertEqual(self.picture("one/gly.pdb")[0], 200)
        for _ in range(50):  # the worker ends its task after the answer
            if not self.opened():
                break
            time.sleep(0.1)
        self.assertEqual(self.opened(), [])

    def test_a_folder_that_is_exchanged_leads_nowhere(self):
        """Checked, then a link when its turn comes: a queue makes that moment long."""
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1", "--pictures", "off")
        self.addCleanup(server.process.kill)
        for directions, folder, name in ((4000, "inside", "gly.pdb"), (4001, "maps", "a.ccp4")):
            path = f"picture?size=64x64&input={folder}/{name}"
            inside = server.ask(path)[2]
            server.ask("picture?size=64x64&input=sample:dna")  # so that the file is read again
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                busy = pool.submit(server.ask, f"picture?input=sample:dna&size=1500x1500&occlusion={directions}")
                time.sleep(0.5)
                late = pool.submit(server.ask, path)
                while server.metric("nacre_waiting_requests") < 1 and not late.done():
                    time.sleep(0.01)
                self.assertFalse(late.done(), "it did not wait")
                (self.root / folder).rename(self.root / "was")
                (self.root / folder).symlink_to(self.folder / "outside")
                try:
                    status, _, body = late.result()
                    busy.result()
                finally:
                    (self.root / folder).unlink()
                    (self.root / "was").rename(self.root / folder)
            self.assertEqual((status, body), (200, inside), folder)
        self.assertEqual(server.stop(), 0)

    def test_maps_are_drawn(self):
        """Uploaded, as a body and below the root: the picture that `nacre render` draws of the same file."""
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1")
        self.addCleanup(server.process.kill)
        pictures = set()
        for name in ("a.ccp4", "b.ccp4", "a.dx"):
            data = (self.root / "maps" / name).read_bytes()
            path = self.folder / "map.png"
            subprocess.run([PROGRAM, "render", self.root / "maps" / name, "--size", "64x64", "-o", path, "-q"], check=True)
            expected = path.read_bytes()
            pictures.add(expected)
            uploaded = json.loads(server.ask("structures", data)[2])["input"]
            for query, body in ((f"&input={uploaded}", None), ("", data), (f"&input=maps/{name}", None)):
                status, _, picture = server.ask("picture?size=64x64" + query, body)
                self.assertEqual(status, 200, picture)
                self.assertEqual(picture, expected, (name, query))
            # The map that is held is drawn at another level.
            status, _, other = server.ask(f"picture?size=64x64&map-level=5&input={uploaded}")
            self.assertEqual(status, 200, other)
            self.assertNotEqual(other, expected)
            status, _, told = server.ask(f"info?input={uploaded}")
            self.assertEqual(status, 200, told)
            self.assertNotIn(b"upload:", told)
            self.assertNotIn(b"/proc", told)
        self.assertEqual(len(pictures), 2)  # both formats hold the same map
        # A name tells the format of files without a magic number.
        status, _, old = server.ask("picture?size=64x64&input=maps/old.map")
        self.assertEqual(status, 200, old)
        self.assertEqual(old, server.ask("picture?size=64x64&input=maps/a.ccp4")[2])
        self.assertEqual(server.stop(), 0)

    def test_maps_are_bounded_by_memory(self):
        """By their headers, before memory is taken, whoever reads them: the worker of pictures, or that of /info."""
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1")
        self.addCleanup(server.process.kill)
        cell, nodes = bytearray(ccp4()), bytearray(ccp4())
        struct.pack_into("<3i", cell, 28, 900, 900, 900)
        struct.pack_into("<i", cell, 88, 19)  # by whose symmetry the cell is filled
        struct.pack_into("<3i", nodes, 0, 600, 600, 600)
        for name, data in (("cell.ccp4", cell), ("nodes.ccp4", nodes), ("empty.dx", dx().replace(b"8 8 8", b"600 600 600").replace(b"items 512", b"items 216000000"))):
            (self.root / "maps" / name).write_bytes(data)
            (self.root / "maps" / "vast.mvsj").write_text(volume_scene(name, "dx" if name.endswith("dx") else "map"))
            before = server.most_address_space()
            for query, body in ((f"&input=maps/{name}", None), ("&input=maps/vast.mvsj", None), ("", bytes(data))):
                status, _, told = server.ask("picture?size=64x64" + query, body)
                self.assertEqual(status, 422, (name, query, told[:200]))
            self.assertEqual(server.ask(f"info?input=maps/{name}")[0], 422)
            if not SANITIZED:
                self.assertLess(server.most_address_space() - before, 512 << 20, name)
        self.assertEqual(server.stop(), 0)

    def test_scenes_show_maps(self):
        for format, name in (("map", "a.ccp4"), ("dx", "a.dx")):
            status, _, below = self.picture(f"maps/{format}.mvsj")
            self.assertEqual(status, 200, below)
            packed = io.BytesIO()
            with zipfile.ZipFile(packed, "w") as out:
                out.writestr("index.mvsj", volume_scene("volume", format))
                out.writestr("volume", (self.root / "maps" / name).read_bytes())
            status, _, sent = self.server.ask("picture?size=64x64", packed.getvalue())
            self.assertEqual((status, sent), (200, below))
            uploaded = json.loads(self.server.ask("structures", packed.getvalue())[2])["input"]
            self.assertEqual(self.picture(uploaded)[::2], (200, below))

    def test_kept_pictures_are_checked(self):
        """Flipped, cut, empty or longer: drawn again."""
        cache = self.folder / "checked"
        server = Server(PROGRAM, self.folder, "--cache", str(cache))
        self.addCleanup(server.process.kill)
        path = "picture?input=sample:glucose&size=64x64"
        first = server.ask(path)
        for damage in (lambda b: b[:-9] + bytes([b[-9] ^ 1]) + b[-8:], lambda b: b[:len(b) // 2], lambda b: b"", lambda b: b + b"x",
                       lambda b: first[2], lambda b: bytes(len(b))):
            kept, = (cache / "pictures").glob("picture-*")
            kept.write_bytes(damage(kept.read_bytes()))
            again = server.ask(path)
            self.assertEqual((again[0], again[2], again[1]["ETag"]), (200, first[2], first[1]["ETag"]))
        self.assertEqual(server.metric("nacre_cache_hits_total"), 0)
        server.ask(path)
        self.assertEqual(server.metric("nacre_cache_hits_total"), 1)
        self.assertEqual(server.stop(), 0)

    def test_scenes_download_from_databases_alone(self):
        """One text, whatever is there; and nobody of this network hears of it."""
        with socket.create_server(("127.0.0.1", 0)) as listening, socket.create_server(("127.0.0.1", 0)) as other:
            closed = socket.create_server(("127.0.0.1", 0))
            ports = [listening.getsockname()[1], closed.getsockname()[1]]
            closed.close()
            listening.settimeout(0.2)
            server = Server(PROGRAM, self.folder, "--allow-download", "--allow-host", f"localhost:{other.getsockname()[1]}")
            self.addCleanup(server.process.kill)
            texts = set()
            for url in (f"http://127.0.0.1:{ports[0]}/a.pdb", f"http://127.0.0.1:{ports[1]}/a.pdb", f"http://localhost:{ports[0]}/a.pdb",
                        f"http://[::1]:{ports[0]}/a.pdb", "http://10.0.0.1/a.pdb", "http://169.254.169.254/latest", "http://2130706433/a.pdb",
                        f"http://files.rcsb.org@127.0.0.1:{ports[0]}/a.pdb", f"http://files.rcsb.org:{ports[0]}/a.pdb"):
                status, _, body = server.ask("picture?size=32x32", scene(url).encode())
                self.assertEqual(status, 422, body)
                texts.add(json.loads(body)["detail"].replace(url, "URL"))
            self.assertEqual(len(texts), 1, texts)
            with self.assertRaises(TimeoutError):
                listening.accept()

            def answer():
                client, _ = other.accept()
                client.recv(4096)
                client.sendall(f"HTTP/1.1 200 OK\r\nContent-Length: {len(PDB)}\r\nConnection: close\r\n\r\n{PDB}".encode())
                client.close()
            threading.Thread(target=answer, daemon=True).start()
            status, _, body = server.ask("picture?size=32x32", scene(f"http://localhost:{other.getsockname()[1]}/a.pdb").encode())
            self.assertEqual(status, 200, body)
            self.assertEqual(server.stop(), 0)

    def test_a_file_that_is_named_often_is_read_once(self):
        """3,000 times, from an archive that inflates it: 61 MB each."""
        grid = b"#" * 79 + b"\n" + b"# \n" * 15_000_000 + b"object 1 class gridpositions counts 2 2 2\norigin 0 0 0\n"
        leaf = {"kind": "parse", "params": {"format": "dx"}, "children": [{"kind": "volume", "params": {}, "children": [
            {"kind": "volume_representation", "params": {"type": "isosurface", "relative_isovalue": 1}}]}]}
        root = {"kind": "root", "children": [{"kind": "download", "params": {"url": "a.dx"}, "children": [leaf]}] * 3000}
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as out:
            out.writestr("index.mvsj", json.dumps({"root": root, "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}}))
            out.writestr("a.dx", grid)
        server = Server(PROGRAM, self.folder, "--jobs", "1")
        self.addCleanup(server.process.kill)
        before = server.cpu_seconds()
        status, _, body = server.ask("picture?size=32x32", packed.getvalue())
        self.assertEqual(status, 422, body)
        self.assertLess(server.cpu_seconds() - before, 30 * SLOWER)
        self.assertEqual(server.ask("picture?input=sample:glucose&size=32x32")[0], 200)
        self.assertEqual(server.stop(), 0)

    def slow_scene(self, structures, components, selectors):
        """One of many steps: each component looks for so many residues among 60,000. -> its name below the root"""
        folder = self.root / "many"
        folder.mkdir(exist_ok=True)
        (folder / "helix.pdb").write_text("".join(
            f"ATOM  {n % 100000:5}  CA  ALA A{n % 10000:4}    {n % 50 * 4:8.3f}{n // 50 % 50 * 4:8.3f}{n // 2500 * 4:8.3f}  1.00  0.00           C\n"
            for n in range(60000)))
        component = {"kind": "component", "params": {"selector": "all"}, "children": [
            {"kind": "representation", "params": {"type": "ball_and_stick"}, "children": [
                {"kind": "color", "params": {"color": "red", "selector": [{"label_seq_id": k} for k in range(selectors)]}}]}]}
        nodes = [{"kind": "structure", "params": {"type": "model"}, "children": [component] * components}] * structures
        for kind, params in (("parse", {"format": "pdb"}), ("download", {"url": "helix.pdb"}), ("root", {})):
            nodes = [{"kind": kind, "params": params, "children": nodes}]
        name = f"many/{structures}-{components}.mvsj"
        (self.root / name).write_text(json.dumps({"root": nodes[0], "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}}))
        return name

    def test_a_worker_gives_up_a_scene_in_time(self):
        """Between two nodes; a server that is asked to end does not wait for it either."""
        name = self.slow_scene(1, 300, 2000)
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1", "--timeout", "3")
        self.addCleanup(server.process.kill)
        for number, path in enumerate((f"picture?size=32x32&input={name}", f"info?input={name}")):
            self.assertEqual(server.ask(path)[0], 503)
            before = server.cpu_seconds()
            while (status := server.ask(f"picture?input=sample:glucose&size=32x{32 + number}")[0]) != 200:
                self.assertEqual(status, 503)
                self.assertLess(server.cpu_seconds() - before, 5 * SLOWER, path)  # the worker is between two nodes
        self.assertEqual(server.stop(), 0)

    def test_stopping_gives_up_what_does_not_end(self):
        """Two pictures of minutes, in steps of many seconds; one waits for the other."""
        name = self.slow_scene(12, 1, 30000)
        place = self.folder / "stopped"
        place.mkdir()
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1", "--timeout", "600", TMPDIR=str(place))
        self.addCleanup(server.process.kill)
        clients = [Client(server.port, 600).send(f"GET /picture?size=32x32&zoom={zoom}&input={name} {ROOM}\r\n") for zoom in (1, 2)]
        deadline = time.monotonic() + 60 * SLOWER
        while server.metric("nacre_waiting_requests") < 1:  # whichever of them it is
            self.assertLess(time.monotonic(), deadline, "no request waits for the slow one")
            time.sleep(0.1)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        server.process.send_signal(signal.SIGTERM)
        said = server.process.stderr.read()
        self.assertEqual(server.process.wait(60), 0)
        server.process.stderr.close()
        self.assertIn("stopped while pictures were still drawn", said)
        for client in clients:
            self.assertNotIn(b"200 OK", client.rest())
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime, 60 * SLOWER)  # all of its run
        self.assertEqual(self.left(place), [])

    def left(self, place):
        """Files of a folder for temporary ones."""
        return sorted(str(file.relative_to(place)) for file in place.rglob("*") if file.is_file())

    def test_bodies_need_no_room_on_disk(self):
        server = Server(PROGRAM, self.folder, TMPDIR=str(self.folder / "none"))
        self.addCleanup(server.process.kill)
        for format in ("png", "jpg", "webp", "tif", "exr"):
            status, _, body = server.ask(f"picture?input=sample:glucose&size=64x64&format={format}")
            self.assertEqual(status, 200, body)
        self.assertEqual(server.ask("picture?size=64x64", PDB.encode())[0], 200)
        self.assertEqual(server.ask("structures", PDB.encode())[0], 503)
        self.assertEqual(server.stop(), 0)

    def test_a_picture_that_cannot_be_encoded_is_the_servers_error(self):
        """Without its module for images there is room enough."""
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy2(PROGRAM, alone)
        server = Server(str(alone / pathlib.Path(PROGRAM).name), self.folder)
        self.addCleanup(server.process.kill)
        status, _, body = server.ask("picture?input=sample:glucose&size=64x64&format=jpg")
        self.assertEqual((status, json.loads(body)["detail"]), (500, "the picture cannot be encoded"))
        self.assertEqual(server.stop(), 0)

    def test_a_body_that_does_not_fit_leaves_nothing(self):
        place = self.folder / "temporary"
        place.mkdir()
        limit = 1 << 20
        server = Server(PROGRAM, self.folder, TMPDIR=str(place), prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.addCleanup(server.process.kill)
        large = (PDB + "REMARK\n" * (limit // 3)).encode()
        for path in ("picture?size=64x64", "structures"):
            self.assertEqual(server.ask(path, large)[0], 503, path)
            self.assertEqual(self.left(place), [])
        for _ in range(2):
            self.assertEqual(server.ask("picture?size=64x64", PDB.encode())[0], 200)
            self.assertEqual(server.ask("picture?input=sample:glucose&size=64x64")[0], 200)
        stored = server.ask("structures", PDB.encode())
        self.assertEqual(stored[0], 200)
        self.assertEqual(self.left(place), [])
        server.process.kill()
        server.process.wait()
        self.assertEqual(self.left(place), [])

    def test_no_name_can_be_planted(self):
        """The server makes no name in a folder that others may write to, where a link could wait for it."""
        place = self.folder / "shared"
        place.mkdir()
        watch = NewNames(place)
        subprocess.run([PROGRAM, "render", "sample:glucose", "--size", "16x16", "-o", "-"], stdout=subprocess.DEVNULL, check=True,
                       env=os.environ | {"TMPDIR": str(place)})
        self.assertNotEqual(watch.since(), [])  # of the command line; it is a random one
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as out:
            out.writestr("index.mvsj", scene("gly.pdb"))
            out.writestr("gly.pdb", PDB)
        models = "".join(f"MODEL {n + 1}\n{PDB.replace('END', 'ENDMDL')}" for n in range(3))
        server = Server(PROGRAM, self.folder, "--root", str(self.root), TMPDIR=str(place))
        self.addCleanup(server.process.kill)
        for format in ("png", "jpg", "webp", "tif", "exr"):
            for data in (None, PDB.encode(), packed.getvalue(), models.encode()):
                given = "" if data else "&input=one/gly.pdb"
                self.assertEqual(server.ask(f"picture?size=32x32&format={format}{given}", data)[0], 200)
        stored = json.loads(server.ask("structures", PDB.encode())[2])["input"]
        self.assertEqual(server.ask(f"picture?size=32x32&input={stored}")[0], 200)
        self.assertEqual(server.ask(f"info?input={stored}")[0], 200)
        self.assertEqual(server.stop(), 0)
        self.assertEqual(watch.since(), [])

    def test_no_picture_is_a_file(self):
        """Nor is it compared with files of its name, where the server was started."""
        (self.root / "picture.jpg").write_text(PDB)
        server = Server(PROGRAM, self.folder, "--root", str(self.root), prepare=lambda: os.chdir(self.root))
        self.addCleanup(server.process.kill)
        status, _, body = server.ask("picture?size=32x32&input=picture.jpg&format=jpg")
        self.assertEqual(status, 200, body)
        self.assertEqual((self.root / "picture.jpg").read_text(), PDB)
        self.assertEqual(server.stop(), 0)

    @unittest.skipIf(SANITIZED, "it keeps what was freed")
    def test_an_upload_takes_no_memory_twice(self):
        server = Server(PROGRAM, self.folder)
        self.addCleanup(server.process.kill)

        def peak():
            return int(pathlib.Path(f"/proc/{server.process.pid}/status").read_text().split("VmHWM:")[1].split()[0]) << 10
        server.ask("structures", PDB.encode())
        before = peak()
        self.assertEqual(server.ask("structures", PDB.encode() + bytes(60 << 20))[0], 200)
        self.assertLess(peak() - before, 30 << 20)
        self.assertEqual(server.stop(), 0)

    @unittest.skipIf(SANITIZED, "no library can be preloaded")
    def test_a_database_name_leads_to_no_private_address(self):
        """files.rcsb.org is 127.0.0.1 here. Whatever proxies there are, only one that is asked for it is connected to."""
        body = scene("http://files.rcsb.org/a.pdb").encode()
        with listening() as (port, heard), listening() as (proxy_port, asked):
            proxy = f"http://127.0.0.1:{proxy_port}"

            def status(*options, **environment):
                server = Server(PROGRAM, self.folder, "--allow-download", "--cache", "off", *options, LD_PRELOAD=RESOLVE_HERE,
                                NACRE_TEST_PORT=str(port), **environment)
                self.addCleanup(server.process.kill)
                answer = server.ask("picture?size=32x32", body)[0]
                self.assertEqual(server.stop(), 0)
                return answer

            for environment in ({}, {"https_proxy": proxy}, {"HTTP_PROXY": proxy}, {"http_proxy": proxy, "no_proxy": "rcsb.org"},
                                {"http_proxy": proxy, "NO_PROXY": "*"}, {"all_proxy": proxy, "no_proxy": "localhost,.rcsb.org"},
                                {"ALL_PROXY": proxy, "no_proxy": "files.rcsb.org"}):
                self.assertEqual(status(**environment), 422, environment)
                self.assertEqual((heard, asked), ([], []), environment)
            for environment in ({"http_proxy": proxy}, {"all_proxy": proxy, "no_proxy": "csb.org"}, {"ALL_PROXY": proxy}):
                self.assertEqual(status(**environment), 200, environment)
                self.assertEqual((heard, asked), ([], ["GET http://files.rcsb.org/a.pdb HTTP/1.1"]), environment)
                asked.clear()
            self.assertEqual(status("--allow-host", "files.rcsb.org"), 200)
            self.assertEqual(heard, ["GET /a.pdb HTTP/1.1"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
