#!/usr/bin/env python3
"""vcpkg's manifest names ports and features that there are: those of third_party/vcpkg_ports.txt, or of our own."""
import json
import pathlib
import re
import sys
import unittest

THIRD_PARTY = pathlib.Path(sys.argv.pop()) / "third_party"


def known_ports():
    ports = {}
    for line in (THIRD_PARTY / "vcpkg_ports.txt").read_text().splitlines():
        words = [word for word in line.split() if word != "*"]
        if words and not line.startswith("#"):
            ports[words[0]] = set(words[1:])
    for port in (THIRD_PARTY / "vcpkg_ports").iterdir():
        ports[port.name] = set()
    return ports


def dependencies():
    manifest = json.loads((THIRD_PARTY / "vcpkg.json").read_text())
    for feature in [manifest, *manifest["features"].values()]:
        for dependency in feature["dependencies"]:
            yield {"name": dependency} if isinstance(dependency, str) else dependency


class Manifest(unittest.TestCase):
    def test_every_port_is_there_with_its_features(self):
        ports = known_ports()
        for dependency in dependencies():
            self.assertIn(dependency["name"], ports)
            self.assertLessEqual(set(dependency.get("features", [])), ports[dependency["name"]], dependency["name"])

    def test_no_library_under_the_lgpl_comes_along(self):
        """HarfBuzz's features glib and graphite2, and curl's other TLS libraries."""
        ports = {dependency["name"]: dependency for dependency in dependencies()}
        for name, features in (("harfbuzz", []), ("freetype", []), ("curl", ["ssl"])):
            self.assertIs(ports[name]["default-features"], False, name)
            self.assertEqual(ports[name].get("features", []), features, name)
        self.assertFalse(ports.keys() & {"fribidi", "glib", "graphite2", "gnutls", "ffmpeg"})

    def test_ports_of_our_own_are_found_and_whole(self):
        configuration = json.loads((THIRD_PARTY / "vcpkg-configuration.json").read_text())
        for overlay in configuration["overlay-ports"]:
            for port in (THIRD_PARTY / overlay).iterdir():
                self.assertEqual(json.loads((port / "vcpkg.json").read_text())["name"], port.name)
                recipe = (port / "portfile.cmake").read_text()
                self.assertTrue(re.search(r"REF [0-9a-f]{40}\n", recipe), "a commit, not a branch")
                self.assertTrue(re.search(r"SHA512 [0-9a-f]{128}\n", recipe))
                self.assertIn("vcpkg_install_copyright", recipe)

    def test_the_phone_exports_what_it_is_called_by(self):
        android = THIRD_PARTY.parent / "app/android"
        exports = (android / "exports.map").read_text()
        for name in re.findall(r"global: (.*);", exports)[0].split():
            self.assertIn(f" {name}(", (android / "activity.cpp").read_text())
        self.assertIn("local: *;", exports)


unittest.main()
