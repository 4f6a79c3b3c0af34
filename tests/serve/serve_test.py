"""`nacre serve`: its answers and its bounds. serve_test.py PROGRAM NO_MEMORY"""
import concurrent.futures
import io
import json
import os
import re
import socket
import subprocess
import sys
import unittest
import urllib.parse
import zipfile

from served import PDB, ROOM, SANITIZED, Client, ServedTest, Server

PROGRAM, NO_MEMORY = sys.argv.pop(1), sys.argv.pop(1)

class ServeTest(ServedTest):
    program = PROGRAM

    @classmethod
    def fill(cls):
        (cls.root / "gly.pdb").write_text(PDB)
        (cls.folder / "secret.pdb").write_text(PDB)
        (cls.root / "link.pdb").symlink_to(cls.folder / "secret.pdb")
        (cls.root / "bad.pdb").write_text("no atoms\n")

    def refused(self, path, status, words, data=None):
        got, headers, body = self.server.ask(path, data)
        self.assertEqual(got, status, body)
        self.assertEqual(headers["Content-Type"], "application/problem+json")
        self.assertIsNone(headers["ETag"], "a failure that caches would keep")
        self.assertNotIn("public", headers["Cache-Control"] or "")
        problem = json.loads(body)
        self.assertEqual(problem["status"], status)
        self.assertIn(words, problem["detail"])
        if str(self.folder) not in urllib.parse.unquote(path):
            self.assertNotIn(str(self.folder), problem["detail"])

    def test_a_picture_has_the_bytes_of_render(self):
        status, headers, body = self.server.ask("picture?input=sample:dna&style=licorice&size=96x64")
        self.assertEqual((status, headers["Content-Type"]), (200, "image/png"))
        path = self.folder / "render.png"
        subprocess.run([PROGRAM, "render", "sample:dna", "--style", "licorice", "--size", "96x64", "-o", path, "-q"],
                       check=True)
        self.assertEqual(body, path.read_bytes())
        plain = body
        status, _, body = self.server.ask("picture?input=sample:dna&style=licorice&size=96x64&"
                                          "interactions=chain%20A&interaction-labels=distance")
        self.assertEqual(status, 200)
        self.assertNotEqual(body, plain)
        subprocess.run([PROGRAM, "render", "sample:dna", "--style", "licorice", "--size", "96x64", "--interactions", "chain A",
                        "--interaction-labels", "distance", "-o", path, "-q"], check=True)
        self.assertEqual(body, path.read_bytes(), "with interactions")

    def test_the_same_picture_is_not_sent_twice(self):
        path = "picture?input=gly.pdb&size=64x64"
        _, headers, first = self.server.ask(path)
        tag = headers["ETag"]
        self.assertEqual(self.server.ask(path, None, **{"If-None-Match": tag})[0], 304)
        hits = self.server.metric("nacre_cache_hits_total")
        self.assertEqual(self.server.ask(path)[2], first)
        self.assertEqual(self.server.metric("nacre_cache_hits_total"), hits + 1)
        # Another order of the same options is the same picture, another option another.
        self.assertEqual(self.server.ask("picture?size=64x64&input=gly.pdb")[1]["ETag"], tag)
        self.assertNotEqual(self.server.ask(path + "&zoom=2")[1]["ETag"], tag)
        changed = PDB.replace("2.390", "4.390")
        (self.root / "gly.pdb").write_text(changed)
        try:
            _, headers, body = self.server.ask(path)
            self.assertNotEqual(headers["ETag"], tag)
            self.assertNotEqual(body, first, "drawn from the file as it was")
        finally:
            (self.root / "gly.pdb").write_text(PDB)

    def test_kept_pictures_make_room(self):
        """In a folder of the cache's own, whatever else there is."""
        cache = self.folder / "small"
        server = Server(PROGRAM, self.folder, "--cache", str(cache), "--pictures", "1")
        self.addCleanup(server.process.kill)
        sizes = []
        for number in range(60):
            path = f"picture?input=sample:glucose&size=300x300&occlusion=off&format=tif&rotate=0,{number},0"
            sizes.append(len(server.ask(path)[2]))
            kept = [file.stat().st_size for file in (cache / "pictures").glob("picture-*")]
            self.assertLessEqual(sum(kept), 1 << 20)
        self.assertGreater(sum(sizes), 1 << 20)
        self.assertGreater(sum(kept), (1 << 20) / 2)
        hits = server.metric("nacre_cache_hits_total")
        server.ask(path)
        self.assertEqual(server.metric("nacre_cache_hits_total"), hits + 1)
        self.assertEqual(server.stop(), 0)
        # Somebody's pictures are no cache.
        home = self.folder / "home"
        (home / "pictures").mkdir(parents=True)
        (home / "pictures/holiday.jpg").write_text("sun")
        server = Server(PROGRAM, self.folder, "--cache", str(home), "--pictures", "1")
        self.assertEqual(server.ask("picture?input=sample:glucose&size=32x32")[0], 200)
        self.assertEqual(server.stop(), 0)
        self.assertEqual([file.name for file in (home / "pictures").iterdir()], ["holiday.jpg"])

    def test_models(self):
        """Whoever drew the first model does not take it for the second."""
        atom = PDB.splitlines(True)[0]
        (self.root / "two.pdb").write_text("MODEL        1\n" + atom + "ENDMDL\nMODEL        2\n" + PDB[:-4] + "ENDMDL\nEND\n")
        server = Server(PROGRAM, self.folder, "--root", str(self.root), "--jobs", "1")
        answers = [server.ask(f"picture?input=two.pdb&size=64x64&camera=model&model={model}") for model in (1, 2, 1)]
        self.assertEqual(server.stop(), 0)
        self.assertEqual([status for status, _, _ in answers], [200] * 3)
        bodies = [body for _, _, body in answers]
        self.assertNotEqual(bodies[0], bodies[1])
        self.assertEqual(bodies[0], bodies[2])

    def test_bodies(self):
        status, headers, body = self.server.ask("picture?size=64x64&format=webp", PDB.encode())
        self.assertEqual((status, headers["Content-Type"], body[:4]), (200, "image/webp", b"RIFF"))
        view = json.dumps({"input": "gly.pdb", "style": "licorice"}).encode()
        status, _, body = self.server.ask("picture?size=64x64", view)
        self.assertEqual(status, 200, body)
        self.assertEqual(body, self.server.ask("picture?input=gly.pdb&style=licorice&zoom=1&size=64x64")[2])
        ball = urllib.parse.quote('{"kind": "sphere", "center": "all", "radius": 9}')
        self.assertNotEqual(body, self.server.ask("picture?input=gly.pdb&style=licorice&zoom=1&size=64x64&primitives=" + ball)[2])
        table = urllib.parse.quote("csv:element,color;C,red;N,red;O,red")
        self.assertNotEqual(body, self.server.ask("picture?input=gly.pdb&style=licorice&zoom=1&size=64x64&color-from=" + table)[2])
        told = json.loads(self.server.ask("structures", PDB.encode())[2])
        self.assertEqual(self.server.ask("picture?size=64x64&input=" + told["input"])[0], 200)
        remarks = ("REMARK 999 " + "x" * 69 + "\n") * 30000  # more than a view may have
        status, _, large = self.server.ask("picture?size=64x64", (remarks + PDB).encode())
        self.assertEqual((status, large), (200, self.server.ask("picture?size=64x64", PDB.encode())[2]))
        self.refused("picture", 400, "empty", b"")
        endless = Client(self.server.port).send("POST /picture " + ROOM + "Connection: close\r\n\r\n").rest()
        self.assertIn(b" 400 ", endless.partition(b"\r\n")[0])
        self.assertIn(b"whose length Content-Length says", endless)
        self.refused("picture?input=gly.pdb&format=bmp", 400, "format: expected one of png, ")
        self.refused("picture", 413, "64 MiB", bytes((64 << 20) + 1))
        self.refused("picture", 422, "maps", json.dumps({"input": "gly.pdb", "map": ["/etc/passwd"]}).encode())
        for key, text in (("surface-color-from", "/etc/passwd"), ("electrostatics", "on")):
            self.refused("picture", 422, "maps", json.dumps({"input": "gly.pdb", "style": "surface", key: text}).encode())
        for key in ("primitives", "color-from"):
            self.refused("picture", 422, "not drawn here", json.dumps({"input": "gly.pdb", key: ["/etc/passwd"]}).encode())
        outside = json.dumps({"input": "../secret.pdb", "style": "licorice"}).encode()
        self.refused("picture", 404, "there is no input", outside)

    def test_scenes_of_molviewspec(self):
        """As a body: an archive has its files with it, and nothing of this machine."""
        def scene(url):
            node = {"kind": "representation", "params": {"type": "ball_and_stick"}}
            for kind, params in (("component", {"selector": "all"}), ("structure", {"type": "model"}), ("parse", {"format": "pdb"}),
                                 ("download", {"url": url}), ("root", {})):
                node = {"kind": kind, "params": params, "children": [node]}
            return json.dumps({"root": node, "metadata": {"version": "1", "timestamp": "2026-01-01T00:00:00Z"}})

        def archive(*files):
            packed = io.BytesIO()
            with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as out:
                for name, text in files:
                    out.writestr(name, text)
            return packed.getvalue()

        path = self.folder / "scene.mvsx"
        path.write_bytes(archive(("index.mvsj", scene("gly.pdb")), ("gly.pdb", PDB)))
        status, headers, body = self.server.ask("picture?size=64x64", path.read_bytes())
        self.assertEqual((status, headers["Content-Type"]), (200, "image/png"), body)
        subprocess.run([PROGRAM, "render", path, "--size", "64x64", "-o", self.folder / "scene.png", "-q"], check=True)
        self.assertEqual(body, (self.folder / "scene.png").read_bytes())
        self.assertNotEqual(self.server.ask("picture?size=64x64&zoom=2", path.read_bytes())[2], body)
        told = json.loads(self.server.ask("structures", path.read_bytes())[2])
        self.assertEqual(self.server.ask("picture?size=64x64&input=" + told["input"])[2], body)
        for url in ("gly.pdb", "../secret.pdb", str(self.folder / "secret.pdb"), "file:///etc/passwd", "http://127.0.0.1:9/x.pdb"):
            got, _, answer = self.server.ask("picture?size=64x64", scene(url).encode())
            self.assertIn(got, (404, 422), (url, answer[:200]))
            self.assertNotIn(b"root:", answer)
        self.assertEqual(self.server.ask("picture", archive(("x", "y")))[0], 422)
        self.assertEqual(self.server.ask("picture", archive(("index.mvsj", scene("../gly.pdb")), ("../gly.pdb", PDB)))[0], 422)
        # Below the root a scene has the files beside it.
        (self.root / "scene.mvsj").write_text(scene("gly.pdb"))
        self.assertEqual(self.server.ask("picture?size=64x64&input=scene.mvsj")[2], body)
        (self.root / "out.mvsj").write_text(scene("../secret.pdb"))
        self.assertIn(self.server.ask("picture?size=64x64&input=out.mvsj")[0], (404, 422))

    def test_nothing_outside_the_root_is_read(self):
        for name in ("../secret.pdb", "link.pdb", str(self.folder / "secret.pdb"), "none.pdb", "."):
            self.refused("picture?input=" + urllib.parse.quote(name), 404, "there is no input")
        self.refused("picture?input=upload:../../x", 404, "no longer stored")

    def test_what_is_wrong(self):
        self.refused("picture", 400, "INPUT is required")
        self.refused("picture?input=gly.pdb&stile=cartoon", 400, "stile")
        self.refused("picture?input=gly.pdb&style=blob", 400, "spacefill")
        self.refused("picture?input=gly.pdb&size=9000x9000", 400, "samples")
        self.refused("picture?input=bad.pdb", 422, "the input")
        self.refused("picture?input=pdb:9xyz", 404, "cache")
        self.refused("x.png", 404, "no picture has this name")
        self.refused("nowhere", 404, "/nowhere")
        for key in ("output", "layers", "stats", "capture", "view", "trajectory", "device", "cache", "memory", "map"):
            self.refused(f"picture?input=gly.pdb&{key}=/etc/passwd", 400, "set by the server")
        self.refused("picture?input=gly.pdb&electrostatics=on", 400, "set by the server")
        for key in ("primitives", "color-from"):
            self.refused(f"picture?input=gly.pdb&{key}=/etc/passwd", 400, "takes text here")
        self.refused("picture?input=gly.pdb&look=/etc/passwd", 400, "look")

    def test_options_are_the_tables(self):
        schema = json.loads(self.server.ask("options")[2])
        for key in ("input", "style", "color", "zoom", "label", "size"):
            self.assertIn(key, schema["properties"])
        for key, row in schema["properties"].items():
            if key != "look":  # a name, here; of others the text
                self.assertNotRegex(row.get("x-syntax", ""), r"FILE(?!\|)|DIR", key)

    def test_stable_names(self):
        status, headers, body = self.server.ask("dna_licorice_front-80x60.webp")
        self.assertEqual((status, headers["Content-Type"]), (200, "image/webp"))
        path = "picture?input=sample:dna&style=licorice&orient=principal&size=80x60&format=webp"
        self.assertEqual(body, self.server.ask(path)[2])

    def test_info_health_metrics(self):
        info, = json.loads(self.server.ask("info?input=gly.pdb")[2])
        self.assertEqual((info["file"], info["atoms"]), ("the input", 4))
        self.assertNotIn(str(self.folder), json.dumps(info))
        self.assertEqual(self.server.ask("health")[2], b"ok\n")
        before = int(re.search(r'status="404"} (\d+)', self.server.ask("metrics")[2].decode() + 'status="404"} 0').group(1))
        self.server.ask("nowhere")
        after = int(re.search(r'status="404"} (\d+)', self.server.ask("metrics")[2].decode()).group(1))
        self.assertEqual(after, before + 1)

    def test_a_full_queue_asks_to_come_again(self):
        server = Server(PROGRAM, self.folder, "--jobs", "1", "--queue", "1", "--pictures", "off")
        with concurrent.futures.ThreadPoolExecutor(12) as pool:
            paths = [f"picture?input=sample:dna&size=400x400&zoom={1 + i / 10}" for i in range(12)]
            answers = list(pool.map(server.ask, paths))
        self.assertEqual(server.stop(), 0)
        codes = [status for status, _, _ in answers]
        self.assertEqual(set(codes), {200, 429})
        for status, headers, _ in answers:
            self.assertEqual(headers["Retry-After"], "1" if status == 429 else None)

    @unittest.skipIf(SANITIZED, "no library can be preloaded")
    def test_a_picture_without_memory_is_one_answer(self):
        server = Server(PROGRAM, self.folder, "--jobs", "1", LD_PRELOAD=NO_MEMORY, NACRE_TEST_MOST_BYTES=str(16 << 20))
        self.addCleanup(server.process.kill)
        for size, expected in (("64x64", 200), ("4000x4000", 503), ("64x32", 200)):
            status, headers, body = server.ask(f"picture?input=sample:glucose&occlusion=off&size={size}")
            self.assertEqual(status, expected, body[:200])
            if status == 503:
                self.assertEqual((json.loads(body)["detail"], headers["Retry-After"]), ("out of memory", "1"))
        self.assertEqual(server.stop(), 0)

    @unittest.skipUnless(socket.has_ipv6 and os.path.exists("/proc/net/if_inet6"), "no IPv6")
    def test_its_address_of_ipv6_is_one_that_browsers_take(self):
        server = Server(PROGRAM, self.folder, listen="[::1]:0")
        self.assertTrue(server.url.startswith("http://[::1]:"), server.url)
        self.assertEqual(server.ask("health")[0], 200)
        self.assertEqual(server.stop(), 0)

    def test_addresses_where_it_cannot_listen(self):
        taken = self.server.url.rstrip("/").rsplit(":", 1)[1]
        for listen, where, why in ((taken, "127.0.0.1:" + taken, "another program listens there; stop it, or name another port: "
                                                                 "--listen 127.0.0.1:0 takes a free port"),
                                   ("192.0.2.1:8080", "192.0.2.1:8080", "not an address of this machine; --listen 127.0.0.1:8080"),
                                   ("nowhere.invalid:8080", "nowhere.invalid:8080", "not an address of this machine")):
            run = subprocess.run([PROGRAM, "serve", "--listen", listen], capture_output=True, text=True, timeout=60)
            self.assertEqual(run.returncode, 1)
            self.assertIn(f"cannot listen: {where}: {why}", run.stderr)
            self.assertEqual(run.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
