"""`nacre serve` against requests that are malformed, hostile or unusual. attack_test.py PROGRAM"""
import concurrent.futures
import gzip
import json
import os
import pathlib
import re
import sys
import threading
import unittest

from served import PDB, ROOM, Client, ServedTest, Server

PROGRAM = sys.argv.pop(1)
CLOSE = "Connection: close\r\n\r\n"
PICTURE = "/picture?input=gly.pdb&size=32x32"


class Answer:
    """The first answer in some bytes, and the bytes that follow it."""

    def __init__(self, data, head_only=False):
        head, _, rest = data.partition(b"\r\n\r\n")
        lines = head.decode("latin-1").split("\r\n")
        self.status = int(lines[0].split()[1]) if lines[0] else None
        self.headers = {}
        for line in lines[1:]:
            key, _, value = line.partition(":")
            self.headers.setdefault(key.lower(), []).append(value.strip())
        length = 0 if head_only or self.status == 100 else int(self.headers.get("content-length", ["0"])[0])
        self.body, self.rest = rest[:length], rest[length:]


class AttackTest(ServedTest):
    program = PROGRAM

    @classmethod
    def fill(cls):
        (cls.root / "below").mkdir()
        (cls.folder / "root2").mkdir()
        for place in ("root/gly.pdb", "root/below/gly.pdb", "secret.pdb", "root2/secret.pdb"):
            (cls.folder / place).write_text(PDB)
        (cls.root / "outside").symlink_to(cls.folder / "root2")
        (cls.root / "link.pdb").symlink_to(cls.folder / "secret.pdb")
        (cls.root / "inside.pdb").symlink_to(cls.root / "gly.pdb")
        os.mkfifo(cls.root / "fifo.pdb")

    def tearDown(self):
        self.assertEqual(self.server.ask("health")[2], b"ok\n")

    def raw(self, text, head_only=False):
        return Answer(Client(self.server.port).send(text).rest(), head_only)

    def get(self, target, headers="", method="GET"):
        return self.raw(f"{method} {target} {ROOM}{headers}{CLOSE}", method == "HEAD")

    def refused(self, answer, status, words=""):
        self.assertEqual(answer.status, status, answer.body)
        self.assertEqual(answer.headers["content-type"], ["application/problem+json"])
        problem = json.loads(answer.body)
        self.assertEqual(problem["status"], status)
        self.assertIn(words, problem["detail"])
        self.assertNotIn(str(self.folder), problem["detail"])
        self.assertNotIn("etag", answer.headers)

    def test_nothing_outside_the_root_is_read(self):
        for name in ("below/gly.pdb", "below/../gly.pdb", "inside.pdb", "%67ly.pdb", "./gly.pdb"):
            self.assertEqual(self.get(f"/picture?input={name}&size=32x32").status, 200, name)
        for name in ("../secret.pdb", "%2e%2e/secret.pdb", "..%2fsecret.pdb", "%2e%2e%2fsecret.pdb", "%252e%252e/secret.pdb",
                     "..%5csecret.pdb", "below/../../secret.pdb", "../root2/secret.pdb", "outside/secret.pdb", "link.pdb", "fifo.pdb",
                     "below", ".", "/", "//etc/passwd", "/etc/passwd", "file:///etc/passwd", "/proc/self/environ", "/dev/stdin", "-",
                     "%c0%ae%c0%ae/secret.pdb", "upload:../secret.pdb"):
            answer = self.get(f"/picture?input={name}")
            self.refused(answer, 404)
            self.refused(self.get(f"/info?input={name}"), 404)
        for target in ("/../secret.pdb", "/..%2fsecret.pdb", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/..png"):
            self.refused(self.get(target), 404)

    def test_what_is_no_encoding(self):
        for text in ("%", "%4", "gly%zz", "%-1", "%+1", "% 1".replace(" ", "%20x%"), "%0x"):
            self.refused(self.get(f"/picture?input={text}"), 400, "percent")
        for text in ("gly.pdb%00", "gly.pdb%00.png", "%00", "%1b[31m", "gly%7f.pdb"):
            self.refused(self.get(f"/picture?input={text}"), 400, "control character")
        self.refused(self.get("/picture?input=%ff%fe"), 404)
        self.refused(self.get("/picture?%ff=1"), 400)
        self.refused(self.get("/picture?in%0d%0aX-Evil:%201=1"), 400)

    def test_no_query_writes_headers(self):
        evil = "%0d%0aX-Evil:%201%0d%0a%0d%0a<script>"
        for target in (f"/picture?input={evil}", f"/picture?input=gly.pdb&size=32x32&title={evil}", f"/{evil}",
                       f"/picture?input=gly.pdb&size=32x32&label=resi%201={evil}"):
            answer = self.get(target)
            self.assertNotIn("x-evil", answer.headers)
            self.assertEqual(answer.headers["x-content-type-options"], ["nosniff"])
            self.assertNotIn("access-control-allow-origin", answer.headers)

    def test_methods(self):
        for method, path, allowed in (("PUT", "/picture", "GET, HEAD, POST"), ("DELETE", "/4hhb.png", "GET, HEAD"), ("TRACE", "/", "GET, HEAD"),
                                      ("OPTIONS", "/info", "GET, HEAD"), ("PATCH", "/structures", "POST"), ("GET", "/structures", "POST"),
                                      ("POST", "/info", "GET, HEAD"), ("POST", "/", "GET, HEAD")):
            answer = self.get(path, method=method)
            self.refused(answer, 405, path)
            self.assertEqual(answer.headers["allow"], [allowed])
        self.assertEqual(self.raw(f"BREW / {ROOM}{CLOSE}").status, 400)

    def test_head(self):
        whole, head = self.get(PICTURE), self.get(PICTURE, method="HEAD")
        for key in ("content-length", "content-type", "etag", "cache-control"):
            self.assertEqual(head.headers[key], whole.headers[key])
        self.assertEqual((head.status, head.rest), (200, b""))

    def test_ranges_are_not_taken(self):
        """Twenty thousand ranges of a picture would be its size twenty thousand times."""
        whole = self.get(PICTURE)
        self.assertNotIn("accept-ranges", whole.headers)
        for ranges in ("0-9", "0-9,20-29", ",".join(["0-"] * 1500), "9999999-", "junk", "-" * 4000):
            for header in ("Range: bytes=", "range:", "RANGE: bytes="):
                answer = self.get(PICTURE, f"{header}{ranges}\r\n")
                self.assertEqual((answer.status, answer.body), (200, whole.body), ranges[:20])

    def test_more_requests_than_a_connection_has_are_told(self):
        """The answers before come whole, and the last says that it is the last."""
        client = Client(self.server.port)
        threading.Thread(target=lambda: client.send(f"GET /health {ROOM}\r\n" * 1500)).start()
        data = client.rest()
        self.assertEqual(data.count(b"HTTP/1.1 200 OK"), 1000)
        self.assertEqual(data.count(b"ok\n"), 1000)
        self.assertIn(b"connection: close", data[data.rindex(b"HTTP/1.1 200 OK"):].lower())

    def test_who_drips_keeps_nobody_waiting(self):
        """500 heads that never end: others are answered while all of these are open."""
        slow = [Client(self.server.port) for _ in range(500)]
        for part in (b"GET /health HTTP/1.1\r\n", b"Host: local"):
            for client in slow:
                client.send(part)
        self.assertEqual(self.get("/health").body, b"ok\n")
        self.assertEqual(self.get(PICTURE).status, 200)
        dropped = 0
        for client in slow:
            client.socket.setblocking(False)
            try:
                dropped += client.socket.recv(1) == b""
            except BlockingIOError:
                pass
            client.cut()
        self.assertEqual(dropped, 0)

    def test_old_and_chained_requests(self):
        answer = self.raw(f"GET {PICTURE} HTTP/1.0\r\n\r\n")
        self.assertEqual((answer.status, answer.body[1:4]), (200, b"PNG"))
        self.assertEqual(self.raw("GET / HTTP/2.0\r\nHost: localhost\r\n\r\n").status, 400)
        self.assertEqual(self.raw("GET /health\r\n\r\n").status, 400)
        three = self.raw(f"GET {PICTURE} {ROOM}\r\nPOST /picture?size=16x16 {ROOM}Content-Length: {len(PDB)}\r\n\r\n{PDB}"
                         f"GET /health {ROOM}{CLOSE}")
        second = Answer(three.rest)
        third = Answer(second.rest)
        self.assertEqual([three.status, second.status, third.status], [200, 200, 200])
        self.assertEqual((three.body[1:4], second.body[1:4], third.body, third.rest), (b"PNG", b"PNG", b"ok\n", b""))

    def test_bodies_of_every_kind(self):
        target = "/picture?size=32x32"

        def post(headers, body, where=target):
            body = body if isinstance(body, bytes) else body.encode()
            return self.raw(f"POST {where} {ROOM}{headers}Connection: close\r\n\r\n".encode() + body)

        plain = post(f"Content-Length: {len(PDB)}\r\n", PDB)
        self.assertEqual((plain.status, plain.body[1:4]), (200, b"PNG"))
        half = len(PDB) // 2
        chunks = f"{half:x}\r\n{PDB[:half]}\r\n{len(PDB) - half:X};x=y\r\n{PDB[half:]}\r\n0\r\n\r\n"
        self.assertEqual(post("Transfer-Encoding: chunked\r\n", chunks).body, plain.body)
        for kind in ("text/plain", "application/x-www-form-urlencoded", "chemical/x-pdb"):
            self.assertEqual(post(f"Content-Length: {len(PDB)}\r\nContent-Type: {kind}\r\n", PDB).body, plain.body, kind)
        packed = gzip.compress(PDB.encode())
        self.assertEqual(post(f"Content-Length: {len(packed)}\r\nContent-Encoding: gzip\r\n", packed).body, plain.body)
        self.assertEqual(post(f"Content-Length: {len(packed)}\r\n", packed).body, plain.body)
        waits = Client(self.server.port).send(f"POST {target} {ROOM}Expect: 100-continue\r\nContent-Length: {len(PDB)}\r\n{CLOSE}")
        first = waits.socket.recv(1000)
        self.assertTrue(first.startswith(b"HTTP/1.1 100"), first)
        self.assertEqual(Answer(waits.send(PDB).rest()).body, plain.body)
        bomb = gzip.compress(bytes(200 << 20), 9)
        self.refused(post(f"Content-Length: {len(bomb)}\r\nContent-Encoding: gzip\r\n", bomb), 413, "64 MiB")
        self.refused(post(f"Content-Length: {len(packed)}\r\nContent-Encoding: br\r\n", packed), 400)
        for headers, body in (("Content-Length: -1\r\n", "x"), ("Content-Length: 99999999999999999999\r\n", "x"),
                              ("Transfer-Encoding: chunked\r\n", "zz\r\nx\r\n0\r\n\r\n"), ("Transfer-Encoding: chunked\r\n", "-5\r\nx"),
                              ("Transfer-Encoding: chunked\r\n", "f" * 70000), ("Content-Type: multipart/form-data\r\nContent-Length: 3\r\n", "abc"),
                              ("Transfer-Encoding: chunked\r\nContent-Length: 3\r\n", "abc")):
            client = Client(self.server.port)
            try:
                answer = Answer(client.send(f"POST {target} {ROOM}{headers}{CLOSE}{body}").rest())
                self.assertIn(answer.status, (None, 400, 411, 413, 415, 422), (headers, answer.body))
            except (BrokenPipeError, ConnectionResetError):
                pass

    def test_floods(self):
        self.assertEqual(self.get("/health", "".join(f"X-{n}: y\r\n" for n in range(1000))).status, 200)
        for flood in (f"GET /health {ROOM}" + "".join(f"X-{n}: {'y' * 50}\r\n" for n in range(4000)) + CLOSE, "\r\n" * 70000,
                      f"GET /health {ROOM}" + "X" * 200000, "G" * 200000, f"GET /picture?{'a=1&' * 50000} {ROOM}{CLOSE}"):
            client = Client(self.server.port)
            try:
                client.send(flood)
                self.assertIn(Answer(client.rest()).status, (None, 400, 413, 414, 431), flood[:20])
            except (BrokenPipeError, ConnectionResetError):
                pass
        # As long as a target may be: the names of pictures are matched by a regular expression.
        for target in ("/" + "a" * 8100, "/" + "a" * 8100 + ".png", "/" + ".png" * 2000, "/picture?input=" + "a/" * 4000,
                       "/picture?input=gly.pdb&" + "a=1&" * 2000, "/picture?" + "&" * 8000):
            self.assertIn(self.get(target).status, (400, 404), target[:20])

    def test_one_drawing_for_all_who_ask(self):
        server = Server(PROGRAM, self.folder, "--pictures", "off", "--jobs", "2")
        path = "picture?input=sample:dna&size=300x300"
        with concurrent.futures.ThreadPoolExecutor(24) as pool:
            answers = list(pool.map(server.ask, [path] * 24))
        drawn = server.metric("nacre_pictures_drawn_total")
        self.assertEqual(server.stop(), 0)
        self.assertEqual({(status, body) for status, _, body in answers}, {(200, answers[0][2])})
        self.assertLess(drawn, 6)  # one, and one more for those that came when it was done

    def test_tags_are_the_servers(self):
        first = self.get(PICTURE)
        tag = first.headers["etag"][0]
        self.assertRegex(tag, r'^"[0-9a-f]{32}"$')
        for sent in (tag, f'"x", {tag}', f"W/{tag}"):
            self.assertEqual(self.get(PICTURE, f"If-None-Match: {sent}\r\n").status, 304, sent)
        for sent in ('"x"', tag[1:-1], tag[:-2] + '"', "junk" * 1000):
            self.assertEqual(self.get(PICTURE, f"If-None-Match: {sent}\r\n").status, 200, sent[:40])
        # Another's tag gets no picture, and bodies get into no cache.
        other = self.get(PICTURE + "&zoom=2", f"If-None-Match: {tag}\r\n")
        self.assertEqual(other.status, 200)
        self.assertNotEqual(other.body, first.body)
        moved = PDB.replace("2.390", "9.390")
        posted = self.raw(f"POST {PICTURE} {ROOM}Content-Length: {len(moved)}\r\n{CLOSE}{moved}")
        self.assertNotIn("etag", posted.headers)
        self.assertEqual(posted.headers["cache-control"], ["no-store"])
        self.assertEqual(self.get(PICTURE).body, first.body)
        for header in ("X-Forwarded-Host: evil", "X-Original-URL: /metrics", "X-HTTP-Method-Override: DELETE", "Origin: http://evil"):
            self.assertEqual(self.get(PICTURE, header + "\r\n").body, first.body)

    def test_hosts_and_sites(self):
        port = self.server.port
        for host in ("localhost", f"localhost:{port}", "LOCALHOST", f"127.0.0.1:{port}", "[::1]", f"[::1]:{port}"):
            self.assertEqual(self.raw(f"GET /health HTTP/1.1\r\nHost: {host}\r\n{CLOSE}").status, 200, host)
        for host in ("evil.example", f"evil.example:{port}", "127.0.0.1.evil.example", "localhost.evil.example", "evil@localhost.x",
                     "10.0.0.1", "0.0.0.0", "[::2]"):
            self.refused(self.raw(f"GET /picture?input=gly.pdb HTTP/1.1\r\nHost: {host}\r\n{CLOSE}"), 421, "this machine")
        for none in ("", "Host:\r\n"):
            self.refused(self.raw(f"GET /health HTTP/1.1\r\n{none}{CLOSE}"), 400, "Host")
        self.refused(self.raw(f"GET /health HTTP/1.1\r\nHost: localhost\r\nHost: evil\r\n{CLOSE}"), 400, "Host")
        body = f"Content-Length: {len(PDB)}\r\n{CLOSE}{PDB}"
        for site, status in (("cross-site", 403), ("same-origin", 200), ("none", 200)):
            self.assertEqual(self.raw(f"POST /structures {ROOM}Sec-Fetch-Site: {site}\r\n{body}").status, status)
        for origin, status in (("http://evil.example", 403), ("null", 403), (f"http://localhost:{port + 1}", 403), ("http://localhost.evil", 403),
                               (f"http://localhost:{port}", 200), (f"HTTP://LOCALHOST:{port}", 200)):
            head = f"POST /structures HTTP/1.1\r\nHost: localhost:{port}\r\nOrigin: {origin}\r\n"
            self.assertEqual(self.raw(head + body).status, status, origin)
        for kind in ("multipart/form-data; boundary=x", "Multipart/Mixed"):
            answer = self.raw(f"POST /structures {ROOM}Content-Type: {kind}\r\n{body}")
            self.refused(answer, 415, "not a form")
            self.assertNotIn("exception_what", answer.headers)
        # On every address, names are the matter of the proxy in front.
        public = Server(PROGRAM, self.folder, listen="0.0.0.0:0")
        answer = Answer(Client(public.port).send(f"GET /health HTTP/1.1\r\nHost: pictures.example\r\n{CLOSE}").rest())
        self.assertEqual(public.stop(), 0)
        self.assertEqual(answer.status, 200)

    def test_uploads_make_room(self):
        """At most 32 of them, and 512 MiB."""
        small = [json.loads(self.server.ask("structures", PDB.replace("0.000", f"0.0{n:02}").encode())[2])["input"] for n in range(40)]
        stored = [self.server.ask(f"picture?size=16x16&input={name}")[0] for name in (small[0], small[7], small[8], small[39])]
        self.assertEqual(stored, [404, 404, 200, 200])
        for n in range(9):
            self.assertEqual(self.server.ask("structures", (PDB + str(n)).encode() + bytes(60 << 20))[0], 200)
        opened = [pathlib.Path(f"/proc/{self.server.process.pid}/fd/{number}") for number in os.listdir(f"/proc/{self.server.process.pid}/fd")]
        kept = {(file.stat().st_ino, file.stat().st_size) for file in opened if file.stat().st_size >= 60 << 20}
        self.assertEqual(len(kept), 8)


if __name__ == "__main__":
    unittest.main(verbosity=2)
