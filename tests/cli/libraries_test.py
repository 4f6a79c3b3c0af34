#!/usr/bin/python3
"""What nacre loads at its start: libraries that few commands need are loaded by those. libraries_test.py PROGRAM"""

import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop()
LATE = ("libcurl", "libOpenImageIO", "libwebp", "librenderdoc", "libdbus-1", "libLLVM")


def loaded(*words):
    """Names of the libraries that a command has the dynamic linker load."""
    env = {name: value for name, value in os.environ.items() if not name.startswith("VK_")} | {"LD_DEBUG": "files"}
    said = subprocess.run([PROGRAM, *words], env=env, capture_output=True, text=True, timeout=60).stderr
    return {os.path.basename(line.split("calling init: ")[1].strip()) for line in said.splitlines() if "calling init: " in line}


class Libraries(unittest.TestCase):
    def test_help_loads_what_all_commands_need(self):
        names = loaded("--help")
        self.assertIn("libvulkan.so.1", names)
        for late in LATE:
            self.assertFalse([name for name in names if name.startswith(late)], late)
        self.assertLess(len(names), 45)

    def test_a_picture_loads_no_driver_for_gpus_that_are_not_there(self):
        if any(os.path.exists(f"/dev/{node}") for node in ("dri", "kgsl-3d0", "dxg")):
            self.skipTest("the kernel has a GPU")
        with tempfile.TemporaryDirectory() as folder:
            names = loaded("render", "sample:glucose", "-o", folder + "/a.png", "--size", "16x16", "--occlusion", "off")
        self.assertTrue([name for name in names if name.startswith("libvulkan_")])
        for driver in ("libvulkan_intel", "libvulkan_radeon", "libvulkan_nouveau"):
            self.assertFalse([name for name in names if name.startswith(driver)], driver)


if __name__ == "__main__":
    unittest.main()
