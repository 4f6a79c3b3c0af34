"""docs/serve/nginx.conf and the unit: TLS, two servers, a machine that goes. nginx_test.py PROGRAM SOURCE_FOLDER"""
import concurrent.futures
import json
import pathlib
import re
import shutil
import socket
import ssl
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

from served import PDB, Server

PROGRAM, SOURCE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@unittest.skipUnless(shutil.which("nginx") and shutil.which("openssl"), "nginx or openssl is not installed")
class NginxTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-nginx-"))
        for name in ("a", "b"):
            (cls.folder / name).mkdir()
        cls.servers = [Server(PROGRAM, cls.folder / name) for name in ("a", "b")]
        cls.port = free_port()
        key, certificate = cls.folder / "key.pem", cls.folder / "certificate.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key, "-out", certificate, "-days", "1",
                        "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost"], check=True, capture_output=True)
        conf = (SOURCE / "docs/serve/nginx.conf").read_text()
        for old, new in (("127.0.0.1:8080", f"127.0.0.1:{cls.servers[0].port}"), ("127.0.0.1:8081", f"127.0.0.1:{cls.servers[1].port}"),
                         ("listen 443 ssl", f"listen 127.0.0.1:{cls.port} ssl"), ("/etc/ssl/certs/nacre.pem", str(certificate)),
                         ("/etc/ssl/private/nacre.key", str(key))):
            assert conf.count(old) == 1, old
            conf = conf.replace(old, new)
        (cls.folder / "nacre.conf").write_text(conf)
        temporary = "".join(f"{kind}_temp_path {cls.folder}/{kind};" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
        (cls.folder / "nginx.conf").write_text(
            f"daemon off; pid {cls.folder}/pid; error_log {cls.folder}/error.log; user {pathlib.Path(cls.folder).owner()};"
            f"events {{ worker_connections 512; }} http {{ access_log off; {temporary} include {cls.folder}/nacre.conf; }}\n")
        cls.nginx = subprocess.Popen(["nginx", "-p", cls.folder, "-c", cls.folder / "nginx.conf"])
        cls.context = ssl.create_default_context(cafile=certificate)
        for _ in range(100):
            try:
                cls.ask("health")
                break
            except (OSError, urllib.error.URLError):
                time.sleep(0.1)

    @classmethod
    def tearDownClass(cls):
        cls.nginx.terminate()
        cls.nginx.wait(30)
        for server in cls.servers:
            if server.process.poll() is None:
                server.stop()
        shutil.rmtree(cls.folder)

    @classmethod
    def ask(cls, path, data=None):
        try:
            with urllib.request.urlopen(urllib.request.Request(f"https://localhost:{cls.port}/{path}", data=data), context=cls.context,
                                        timeout=120) as answer:
                return answer.status, answer.headers, answer.read()
        except urllib.error.HTTPError as error:
            return error.code, error.headers, error.read()

    def requests(self, server):
        return sum(int(number) for number in re.findall(r'nacre_requests_total\{status="200"\} (\d+)', server.ask("metrics")[2].decode()))

    def test_1_pictures_come_from_both(self):
        path = "picture?input=sample:dna&size=64x64"
        status, headers, body = self.ask(path)
        self.assertEqual((status, headers["Content-Type"]), (200, "image/png"))
        for server in self.servers:  # alike, to the tag
            _, own, picture = server.ask(path)
            self.assertEqual((picture, own["ETag"]), (body, headers["ETag"]))
        before = [self.requests(server) for server in self.servers]
        samples = [f"picture?input=sample:{name}&size=32x32" for name in ("dna", "glucose", "buckyball")]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            answers = list(pool.map(self.ask, samples * 4 + [f"health?input=pdb:{n}abc" for n in range(1, 10)]))
        self.assertEqual({status for status, _, _ in answers}, {200})
        after = [self.requests(server) for server in self.servers]
        self.assertTrue(all(now > then + 1 for now, then in zip(after, before)), (before, after))  # one is the count itself

    def test_2_uploads_are_found_again(self):
        for number in range(6):
            told = json.loads(self.ask("structures", PDB.replace("1.450", f"1.4{number}0").encode())[2])
            self.assertEqual(self.ask(f"picture?size=32x32&input={told['input']}")[0], 200)
            self.assertEqual(self.ask(f"picture?size=32x32&input={told['input'].replace(':', '%3A')}")[0], 200)

    def test_3_large_bodies_and_counts_stay_outside(self):
        self.assertEqual(self.ask("picture", bytes((64 << 20) + 1))[0], 413)
        self.assertEqual(self.ask("metrics")[0], 403)
        self.assertIn(b"<html", self.ask("")[2])

    def test_4_a_machine_that_goes_is_left_out(self):
        self.assertEqual(self.servers[0].stop(), 0)
        answers = [self.ask(f"health?input=pdb:{number}xyz")[0] for number in range(1, 10)]
        self.assertEqual(answers, [200] * 9)


@unittest.skipUnless(shutil.which("systemd-analyze"), "systemd is not installed")
class UnitTest(unittest.TestCase):
    def test_the_unit_is_locked_up(self):
        run = subprocess.run(["systemd-analyze", "security", "--offline=true", "--threshold=25", "--no-pager",
                              SOURCE / "docs/serve/nacre-serve.service"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertRegex(run.stdout, r"Overall exposure level for nacre-serve.service: [012]\.\d")


if __name__ == "__main__":
    unittest.main(verbosity=2)
