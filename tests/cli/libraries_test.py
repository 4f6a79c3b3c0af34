#!/usr/bin/python3
"""What nacre loads at its start: libraries that few commands need are loaded by those. libraries_test.py PROGRAM"""

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop()
COPYLEFT = ("libfribidi", "libglib", "libgobject", "libgraphite2", "libgnutls", "libnettle", "libgmp", "libidn2", "libunistring",
            "librtmp", "libjbig", "libavcodec", "libgtk", "libopenbabel", "libreadline")
LATE = ("libcurl", "libOpenEXR", "libjpeg", "libwebp", "librenderdoc", "libdbus-1", "libLLVM")


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

    def test_no_library_under_the_lgpl_is_linked(self):
        """Debian's HarfBuzz loads two."""
        said = subprocess.run(["readelf", "-d", PROGRAM], capture_output=True, text=True, check=True).stdout
        linked = {line.split("[")[1].rstrip("]") for line in said.splitlines() if "(NEEDED)" in line}
        self.assertIn("libharfbuzz.so.0", linked)
        for names, allowed in ((linked, set()), (loaded("--help"), {"libglib-2.0.so.0", "libgraphite2.so.3"})):
            self.assertLessEqual({name for name in names if name.startswith(COPYLEFT)}, allowed)

    def test_a_picture_loads_no_driver_for_gpus_that_are_not_there(self):
        if any(os.path.exists(f"/dev/{node}") for node in ("dri", "kgsl-3d0", "dxg")):
            self.skipTest("the kernel has a GPU")
        with tempfile.TemporaryDirectory() as folder:
            names = loaded("render", "sample:glucose", "-o", folder + "/a.png", "--size", "16x16", "--occlusion", "off")
        self.assertTrue([name for name in names if name.startswith("libvulkan_")])
        for driver in ("libvulkan_intel", "libvulkan_radeon", "libvulkan_nouveau"):
            self.assertFalse([name for name in names if name.startswith(driver)], driver)

    def test_a_package_s_driver_is_taken_where_there_is_no_other(self):
        driver = "/usr/lib/chromium/libvk_swiftshader.so"
        with tempfile.TemporaryDirectory() as folder:
            program = shutil.copy(PROGRAM, folder)
            os.symlink(driver, folder + "/libvk_swiftshader.so")
            shutil.copy(os.path.dirname(driver) + "/vk_swiftshader_icd.json", folder)
            none = {name: value for name, value in os.environ.items() if not name.startswith("VK_")} | {"VK_DRIVER_FILES": "/nonexistent"}
            said = subprocess.run([program, "devices"], env=none, capture_output=True, text=True, timeout=60).stdout
            self.assertIn("SwiftShader", said)
            self.assertIn("driver of nacre's package", said)
            if "VK_DRIVER_FILES" in os.environ:  # the system's driver goes first
                said = subprocess.run([program, "devices"], capture_output=True, text=True, timeout=60).stdout
                self.assertNotIn("nacre's package", said)

    def test_a_program_that_is_gone_from_disk_still_writes_all_formats(self):
        with tempfile.TemporaryDirectory() as folder:
            program, picture = folder + "/nacre", folder + "/a.tif"
            shutil.copy(PROGRAM, program)
            for module in glob.glob(os.path.dirname(PROGRAM) + "/*.so"):
                os.symlink(os.path.abspath(module), folder + "/" + os.path.basename(module))
            words = [program, "render", "-", "--format", "xyz", "-o", picture, "--size", "16x16", "--occlusion", "off"]
            with subprocess.Popen(words, stdin=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
                os.remove(program)
                errors = running.communicate("1\n\nC 0 0 0\n", timeout=60)[1]
            self.assertEqual((running.returncode, errors), (0, ""))
            self.assertTrue(os.path.exists(picture))


if __name__ == "__main__":
    unittest.main()
