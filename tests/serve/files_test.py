"""`nacre serve` and files: what its caches go by, and what it leaves or follows on disk. files_test.py PROGRAM"""
import concurrent.futures
import io
import json
import os
import pathlib
import resource
import socket
import sys
import threading
import time
import unittest
import zipfile

from served import PDB, ServedTest, Server, scene

PROGRAM = sys.argv.pop(1)
MOVED = PDB.replace("2.390", "4.390")


class FilesTest(ServedTest):
    program = PROGRAM

    @classmethod
    def fill(cls):
        for name, text in (("one", PDB), ("two", MOVED), ("inside", PDB)):
            (cls.root / name).mkdir()
            (cls.root / name / "gly.pdb").write_text(text)
            (cls.root / name / "scene.mvsj").write_text(scene("gly.pdb"))
        (cls.folder / "outside").mkdir()
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
        inside = server.ask("picture?size=64x64&input=inside/gly.pdb")[2]
        server.ask("picture?size=64x64&input=sample:dna")  # so that the molecule is read again
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            busy = pool.submit(server.ask, "picture?input=sample:dna&size=1500x1500&occlusion=4000")
            time.sleep(0.5)
            late = pool.submit(server.ask, "picture?size=64x64&input=inside/gly.pdb")
            time.sleep(0.3)
            (self.root / "inside").rename(self.root / "was")
            (self.root / "inside").symlink_to(self.folder / "outside")
            try:
                status, _, body = late.result()
                busy.result()
            finally:
                (self.root / "inside").unlink()
                (self.root / "was").rename(self.root / "inside")
        self.assertEqual((status, body), (200, inside))
        self.assertEqual(server.stop(), 0)

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
        self.assertLess(server.cpu_seconds() - before, 30)
        self.assertEqual(server.ask("picture?input=sample:glucose&size=32x32")[0], 200)
        self.assertEqual(server.stop(), 0)

    def test_a_worker_gives_up_a_scene_in_time(self):
        """Between two nodes; a server that is asked to end does not wait for it either."""
        (self.root / "many").mkdir()
        (self.root / "many/helix.pdb").write_text("".join(
            f"ATOM  {n % 100000:5}  CA  ALA A{n % 10000:4}    {n % 50 * 4:8.3f}{n // 50 % 50 * 4:8.3f}{n // 2500 * 4:8.3f}  1.00  0.00           C\n"
            for n in range(60000)))
        component = {"kind": "component", "params": {"selector": "all"}, "children": [
            {"kind": "representation", "params": {"type": "ball_and_stick"}, "children": [
                {"kind": "color", "params": {"color": "red", "selector": [{"label_seq_id": k} for k in range(2000)]}}]}]}
        node = {"kind": "structure", "params": {"type": "model"}, "children": [component] * 300}
        for kind, params in (("parse", {"format": "pdb"}), ("download", {"url": "helix.pdb"}), ("root", {})):
            node = {"kind": kind, "params": params, "children": [node]}
        (self.root / "many/slow.mvsj").write_text(json.dumps({"root": node, "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}}))
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1", "--timeout", "3")
        self.addCleanup(server.process.kill)
        self.assertEqual(server.ask("picture?size=32x32&input=many/slow.mvsj")[0], 503)
        for _ in range(20):  # the worker is between two nodes
            status = server.ask("picture?input=sample:glucose&size=32x32")[0]
            if status == 200:
                break
        self.assertEqual(status, 200)
        self.assertEqual(server.stop(), 0)

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

    def test_no_planted_link_is_followed(self):
        place = self.folder / "shared"
        place.mkdir()
        server = Server(PROGRAM, self.folder, TMPDIR=str(place))
        self.addCleanup(server.process.kill)
        victim = self.folder / "victim"
        victim.write_text("mine")
        for number in range(1, 9):
            (place / f"nacre-serve-{server.process.pid}-{number}.png").symlink_to(victim)
        for zoom in (1, 2):
            self.assertEqual(server.ask(f"picture?input=sample:glucose&size=32x32&zoom={zoom}")[0], 200)
        self.assertEqual(victim.read_text(), "mine")
        self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
