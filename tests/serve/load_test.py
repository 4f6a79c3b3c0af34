"""`nacre serve` under load, and against clients and devices that fail: load_test.py PROGRAM FAULT_LAYER_FOLDER

NACRE_LOAD=1 prints rates and times by wrk, which nothing here judges.
"""
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from served import PDB, ROOM, SANITIZED, Client, Server

PROGRAM, FAULTS = sys.argv.pop(1), sys.argv.pop(1)


def needs(*programs):
    missing = [program for program in programs if not shutil.which(program)]
    return unittest.skipIf(missing, f"{', '.join(missing)} not installed")


class LoadTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-load-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.root = self.folder / "root"
        self.root.mkdir()
        (self.root / "gly.pdb").write_text(PDB)
        (self.root / "bad.pdb").write_text("no atoms\n")

    def serve(self, *options, **environment):
        server = Server(PROGRAM, self.folder, "--root", str(self.root), *options, **environment)
        self.addCleanup(lambda: server.process.poll() is None and server.process.kill())
        return server

    # Clients of every kind, each one request. -> whether the answer was the right one

    def status(self, server, request, *expected):
        answer = Client(server.port).send(request).rest()
        status = answer[9:12].decode("latin-1")
        return status in expected or f"{request[:60]!r}: {answer[:200]!r}"

    def bad_request(self, server, number):
        """Bad, slow or cut."""
        kind, port = number % 10, server.port
        close = ROOM + "Connection: close\r\n\r\n"
        if kind == 0:
            return self.status(server, "GET /picture?input=gly.pdb&stile=x " + close, "400")
        if kind == 1:
            return self.status(server, "GET /picture?input=none.pdb " + close, "404")
        if kind == 2:
            return self.status(server, "GET /picture?input=bad.pdb " + close, "422", "429")
        if kind == 3:
            return self.status(server, "\x00\x01 garbage\r\n\r\n", "400", "")
        if kind == 4:  # cut within the head
            Client(port).send("GET /picture?inp").cut()
        elif kind == 5:  # cut within the body
            Client(port).send("POST /picture " + ROOM + "Content-Length: 100000\r\n\r\nATOM").cut()
        elif kind == 6:  # gone before the answer
            Client(port).send(f"GET /picture?input=gly.pdb&size=64x64&zoom={1 + number % 50 / 100} " + ROOM + "\r\n").cut()
        elif kind == 7:  # slow, but in time
            client = Client(port).send("GET /hea")
            time.sleep(0.05)
            answer = client.send("lth " + close).rest()
            return answer.endswith(b"ok\n") or f"slow: {answer!r}"
        elif kind == 8:
            return self.status(server, "GET /" + "a" * 9000 + " " + close, "414", "400")
        else:  # a body, and a head without end
            client = Client(port)
            try:
                client.send("GET / " + ROOM + "X: " + "a" * 80000).cut()
            except (BrokenPipeError, ConnectionResetError):
                pass
        return True

    def good_request(self, server, number):
        zoom = 1 + number % 20 / 20
        return self.status(server, f"GET /picture?input=gly.pdb&size=64x64&zoom={zoom} {ROOM}Connection: close\r\n\r\n", "200", "429")

    def storm(self, server, count, connections):
        """Half of the requests by ab, which goes through the cached ones; half bad ones. -> wrong answers"""
        ab = subprocess.Popen(["ab", "-q", "-l", "-k", "-n", str(count // 2), "-c", str(connections // 2),
                               server.url + "picture?input=gly.pdb&size=64x64"], stdout=subprocess.PIPE, text=True)
        with concurrent.futures.ThreadPoolExecutor(connections // 2) as pool:
            def one(number):
                return (self.bad_request if number % 20 else self.good_request)(server, number)
            wrong = [answer for answer in pool.map(one, range(count // 2)) if answer is not True]
        report = ab.communicate()[0]
        self.assertRegex(report, rf"Complete requests: +{count // 2}\n")
        self.assertRegex(report, r"Failed requests: +0\n")
        self.assertNotIn("Non-2xx", report, server.ask("metrics")[2])
        return wrong

    @needs("ab")
    def test_ten_thousand_requests_half_of_them_bad(self):
        server = self.serve()
        self.assertEqual(server.ask("picture?input=gly.pdb&size=64x64")[0], 200)
        self.assertEqual(self.storm(server, 200, 200), [])  # what is made once: caches, threads
        files = pathlib.Path(f"/proc/{server.process.pid}/fd")
        before, resident = len(list(files.iterdir())), []
        for _ in range(8):  # 20,000
            self.assertEqual(self.storm(server, 2500, 200), [])
            resident.append(server.metric("process_resident_memory_bytes"))
        self.assertEqual(server.ask("health")[2], b"ok\n")
        self.assertEqual(server.ask("metrics")[2].count(b'status="500"'), 0)
        if not SANITIZED:  # which keeps what was freed
            self.assertLess(max(resident[4:]), 1.05 * min(resident[4:]), resident)  # after 10,000
        for _ in range(100):  # connections that were cut linger for a moment
            if len(list(files.iterdir())) <= before:
                break
            time.sleep(0.1)
        self.assertLessEqual(len(list(files.iterdir())), before)
        self.assertEqual(server.stop(), 0)

    def test_variety_does_not_fill_the_memory(self):
        """Each new combination of effects has pipelines of its own, which a device keeps."""
        server = self.serve("--jobs", "1", "--pictures", "off")
        effects = ("contours=1", "halos=2", "shadow=0.5", "clip=0", "transparent=on", "lighting=off", "fog=auto", "occlusion=off",
                   "projection=perspective", "contours=1&contour-weights=3", "clip=0&cap=hatched")
        styles = ("ball-and-stick", "surface", "spacefill", "line", "licorice")
        pictures = [f"picture?input=sample:glucose&size=32x32&occlusion-detail=4&style={style}&{effect}"
                    for style in styles for effect in effects]
        left = 3  # pictures of the second device
        while left and pictures:
            answer = server.ask(pictures.pop(0))
            self.assertEqual(answer[0], 200, answer[2])
            if server.metric("nacre_devices_total") > 1:
                left -= 1
        self.assertEqual(left, 0)
        self.assertEqual(server.stop(), 0)

    def test_what_is_sent_slowly_is_dropped(self):
        """A byte now and then keeps no connection."""
        server = self.serve()
        head = Client(server.port).send("GET /health HTTP/1.1\r\nX: ")
        body = Client(server.port).send("POST /picture " + ROOM + "Content-Length: 1000\r\n\r\n")
        dropped = {}
        deadline = time.monotonic() + 60
        while len(dropped) < 2 and time.monotonic() < deadline:
            time.sleep(0.5)
            for name, client in (("head", head), ("body", body)):
                try:
                    if name not in dropped:
                        client.send("a")
                        client.socket.setblocking(False)
                        if client.socket.recv(1000)[:1] in (b"", b"H"):  # closed, or told why
                            dropped[name] = True
                except BlockingIOError:
                    client.socket.setblocking(True)
                except (BrokenPipeError, ConnectionResetError):
                    dropped[name] = True
        self.assertEqual(set(dropped), {"head", "body"})
        self.assertEqual(server.stop(), 0)

    def test_silent_connections_make_room(self):
        """More of them than are served at the same time do not keep others from their answer."""
        server = self.serve()
        silent = [Client(server.port) for _ in range(300)]
        self.assertEqual(server.ask("health")[2], b"ok\n")
        for client in silent:
            client.cut()
        self.assertEqual(server.stop(), 0)

    def test_stopping_finishes_requests(self):
        server = self.serve("--jobs", "1")
        path = "/picture?input=sample:dna&size=500x500&supersample=3"
        clients = [Client(server.port).send(f"GET {path}&zoom={zoom} {ROOM}\r\n") for zoom in (1, 1.5)]
        while server.metric("nacre_waiting_requests") < 1:  # one is drawn, one waits
            time.sleep(0.01)
        server.process.send_signal(signal.SIGTERM)
        for client in clients:
            answer = client.rest()
            self.assertTrue(answer.startswith(b"HTTP/1.1 200"), answer[:200])
            length = int(re.search(rb"Content-Length: (\d+)", answer).group(1))
            self.assertEqual(len(answer.partition(b"\r\n\r\n")[2]), length)
        self.assertEqual(server.process.wait(60), 0)
        server.process.stderr.close()
        self.assertEqual(list(self.folder.glob("nacre-*")), [], "files are left")

    def test_a_lost_device_costs_no_request(self):
        environment = {"VK_ADD_LAYER_PATH": FAULTS, "VK_INSTANCE_LAYERS": "VK_LAYER_NACRE_faults"}
        paths = [f"picture?input=gly.pdb&size=64x64&style=licorice&zoom={zoom}" for zoom in (1, 1.5, 2)]
        server = self.serve("--pictures", "off", "--jobs", "1")
        expected = [server.ask(path)[2] for path in paths]
        self.assertEqual(server.stop(), 0)
        for call in (2, 4, 6):
            server = self.serve("--pictures", "off", "--jobs", "1", NACRE_FAULT=f"vkQueueSubmit:{call}:DEVICE_LOST", **environment)
            answers = [server.ask(path) for path in paths]
            self.assertEqual([status for status, _, _ in answers], [200] * 3, answers[0][2])
            self.assertEqual([body for _, _, body in answers], expected)
            self.assertEqual(server.stop(), 0)
        # One that stays lost is told of, and the server lives.
        server = self.serve("--pictures", "off", "--jobs", "1", NACRE_FAULT="vkQueueSubmit:2+:DEVICE_LOST", **environment)
        self.assertEqual(server.ask(paths[0])[0], 503)
        self.assertEqual(server.ask(paths[1])[0], 503)
        self.assertEqual(server.ask("health")[0], 200)
        self.assertEqual(server.stop(), 0)

    def test_a_request_asks_the_device_for_what_a_job_of_batch_does(self):
        """Counts of Vulkan calls per picture: what 12 views need beyond one, so that starts count on neither side."""
        environment = {"VK_ADD_LAYER_PATH": FAULTS, "VK_INSTANCE_LAYERS": "VK_LAYER_NACRE_faults", "NACRE_FAULT_COUNTS": "1"}
        samples, options = ("dna", "glucose"), {"style": "ball-and-stick", "size": "256x256", "occlusion-detail": "12"}

        def counts(text):
            return collections.Counter({name: int(count) for name, count in
                                        re.findall(r"^fault layer: called (\w+) (\d+)$", text, re.MULTILINE)})

        def by_server(views):
            server = self.serve("--jobs", "1", "--pictures", "off", "--cache", "off", **environment)
            query = "&".join(f"{name}={value}" for name, value in options.items())
            for view in range(views):
                for sample in samples:
                    self.assertEqual(server.ask(f"picture?input=sample:{sample}&zoom={1 + view / 100}&{query}")[0], 200)
            server.process.send_signal(signal.SIGTERM)
            said = server.process.communicate(timeout=60)[1]
            self.assertEqual(server.process.returncode, 0)
            return counts(said)

        def by_batch(views):
            jobs = "".join(f'{{"input": "sample:{sample}", "output": "{self.folder}/{view}-{sample}.png", "zoom": {1 + view / 100}}}\n'
                           for view in range(views) for sample in samples)
            given = [part for name, value in options.items() for part in ("--" + name, value)]
            return counts(subprocess.run([PROGRAM, "batch", "-", "--jobs", "1", "--quiet", "--cache", "off", *given], input=jobs, text=True,
                                         check=True, capture_output=True, env=os.environ | environment).stderr)

        served, drawn = by_server(12) - by_server(1), by_batch(12) - by_batch(1)
        self.assertGreaterEqual(drawn["vkQueueSubmit"], 22)
        self.assertLessEqual(served, drawn, f"served: {served}, by batch: {drawn}")

    @unittest.skipUnless(os.environ.get("NACRE_LOAD"), "NACRE_LOAD is not set: rates are for a quiet machine")
    @needs("wrk")
    def test_rates(self):
        server = self.serve("--pictures", "off")
        script = self.folder / "views.lua"
        script.write_text('local n = 0\nrequest = function()\n  n = n + 1\n  return wrk.format("GET", string.format('
                          '"/picture?input=sample:%s&size=256x256&occlusion-detail=12&rotate=0,%d,0", '
                          '({"dna", "glucose", "buckyball"})[n % 3 + 1], n % 360))\nend\n')
        print(subprocess.run(["wrk", "--latency", "-t1", "-c4", "-d10s", "-s", script, server.url], capture_output=True,
                             text=True).stdout)
        times = []
        def timed(number):
            start = time.monotonic()
            status = server.ask(f"picture?input=sample:dna&size=256x256&occlusion-detail=12&rotate=0,{number},0")[0]
            times.append(time.monotonic() - start)
            return status
        with concurrent.futures.ThreadPoolExecutor(40) as pool:
            answers = []
            for number in range(300):
                answers.append(pool.submit(timed, number))
                time.sleep(1 / 20)
        self.assertEqual({answer.result() for answer in answers}, {200})
        times.sort()
        print(f"20 requests per second: median {times[150] * 1e3:.0f} ms, p99 {times[297] * 1e3:.0f} ms")
        self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
