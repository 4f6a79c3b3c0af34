"""Shaders on Apple's GPUs, as far as it shows without one: MoltenVK translates SPIR-V to Metal's language by the library
SPIRV-Cross, and so does this, for all that the build makes. And what the renderer hands over when a device says that it
is MoltenVK, by a layer that listens, reads no input attachment.

shaders_test.py SHADERS NACRE LAYERS DRIVER: the folder of the built shaders, the program, the folder of the phone
layer's manifest, the manifest of lavapipe."""

import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

SHADERS, NACRE, LAYERS, DRIVER = (pathlib.Path(a) for a in sys.argv[1:5])

# MoltenVK asks for the newest version that the system has: 2.1 came with iOS 12 and macOS 10.14, 2.4 with iOS 15.
PLATFORMS = {
    "iOS 12": ["--msl-ios", "--msl-version", "20100"],
    "iOS 15": ["--msl-ios", "--msl-version", "20400"],
    "macOS 10.14": ["--msl-version", "20100"],
}
ENTRY = re.compile(r"^(?:\[\[ early_fragment_tests \]\] )?(?:vertex|fragment|kernel) \w+ main0\(.*\)$", re.MULTILINE)


def listed():
    """The names that shaders/shaders.cmake embeds."""
    return re.findall(r"^extern const (?!std::span<const ForEyes>).* (\w+);$", (SHADERS / "shaders.h").read_text(), re.MULTILINE)


def reads_input_attachment(words_of):
    """Whether a module has an image type of dimension SubpassData (SPIR-V specification: OpTypeImage is 25, Dim 6)."""
    data = words_of.read_bytes()
    words = struct.unpack(f"<{len(data) // 4}I", data)
    if words[0] != 0x07230203:
        raise ValueError(f"{words_of} is no SPIR-V")
    at = 5
    while at < len(words):
        length, opcode = words[at] >> 16, words[at] & 0xFFFF
        if opcode == 25 and words[at + 3] == 6:
            return True
        at += length
    return False


def to_metal(binary, options):
    run = subprocess.run(["spirv-cross", "--msl", *options, str(binary)], capture_output=True, text=True)
    return run.returncode, run.stdout, run.stderr


def handed_over(folder, phone, *arguments):
    """The modules that `nacre` gives a driver that says it is `phone`."""
    folder.mkdir()
    environment = dict(os.environ, VK_DRIVER_FILES=str(DRIVER), VK_ICD_FILENAMES=str(DRIVER), NACRE_PHONE=phone,
                       VK_ADD_LAYER_PATH=str(LAYERS), VK_INSTANCE_LAYERS="VK_LAYER_NACRE_phone",
                       NACRE_PHONE_SHADERS=str(folder), NACRE_CACHE="off")
    subprocess.run([str(NACRE), *arguments], check=True, env=environment, capture_output=True)
    return sorted(folder.glob("*.spv"))


class Metal(unittest.TestCase):
    def test_every_shader_translates(self):
        names = listed()
        self.assertGreater(len(names), 100)
        for name in names:
            for platform, options in PLATFORMS.items():
                # Subgroups hand values round from Metal 2.2 on, or iOS 13; before, MoltenVK does not say that they do.
                handing = ("tileNearest", "tileShaded", "tileRimmed", "tileEdge", "tileDepth", "tileLayers")
                if name.startswith(handing) and platform == "iOS 12":
                    continue
                status, text, complaint = to_metal(SHADERS / f"{name}.spv", options)
                with self.subTest(shader=name, platform=platform):
                    self.assertEqual((status, complaint), (0, ""))
                    entries = ENTRY.findall(text)
                    self.assertEqual(len(entries), 1)
                    # A pixel that is read from the tile would come as an argument: framebuffer fetch, which MoltenVK
                    # does not use.
                    self.assertNotIn("[[color(", entries[0])

    def test_a_shader_that_does_not_translate_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            broken = pathlib.Path(folder) / "broken.spv"
            broken.write_bytes((SHADERS / "tileMean.spv").read_bytes()[:-40])
            self.assertNotEqual(to_metal(broken, PLATFORMS["iOS 15"])[0], 0)


class InputAttachments(unittest.TestCase):
    def test_are_told_by_the_shaders(self):
        """What the next test looks for is there to be found."""
        for name in listed():
            expected = "Input" in name or "Ordered" in name
            self.assertEqual(reads_input_attachment(SHADERS / f"{name}.spv"), expected, name)

    def test_no_plan_of_apple_has_one(self):
        def inputs(*arguments):
            run = subprocess.run([str(NACRE), "plan", "--json", *arguments], check=True, capture_output=True)
            passes = json.loads(run.stdout)["render_passes"]
            self.assertTrue(passes)
            return [image for p in passes for s in p["subpasses"] for image in s["input_attachments"]]

        for size in ("640x960", "2048x2732"):
            self.assertEqual(inputs("--caps", "apple-moltenvk", "--size", size), [])
        for visibility in ("encoded", "deferred"):
            self.assertEqual(inputs("--caps", "apple-moltenvk", "--visibility", visibility), [])
        self.assertEqual(set(inputs("--caps", "mali", "--visibility", "encoded")), {"encoded depth"})

    def test_none_is_handed_to_moltenvk(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            picture = ["-o", str(root / "picture.png"), "--size", "64x64"]
            used = set()
            for number, arguments in enumerate([
                ["render", "sample:glucose", "--style", "ball-and-stick", "--layers", str(root / "layers.exr"),
                 "--stats", str(root / "stats.json"), *picture],
                ["render", "sample:buckyball", "--style", "spacefill", "--projection", "perspective", "--occlusion",
                 "off", "--supersample", "2", *picture],
                ["render", "sample:dna", "--style", "ball-and-stick", "--atom-opacity", "0.5", *picture],
            ]):
                for module in handed_over(root / str(number), "moltenvk", *arguments):
                    if module.read_bytes() in used:
                        continue
                    used.add(module.read_bytes())
                    self.assertFalse(reads_input_attachment(module), module.name)
                    # Without what constants never reach, it still translates.
                    status, _, complaint = to_metal(module, PLATFORMS["iOS 15"])
                    self.assertEqual((status, complaint), (0, ""), module.name)
            # As much as drawing takes: plates, impostors of both kinds, layers, occlusion, counting, translucency (whose
            # scene casts no occlusion: a bake in parts without one to draw).
            self.assertGreater(len(used), 30)
            # The same listening hears them on a phone that is given some.
            heard = handed_over(root / "android", "android", "render", "sample:glucose", *picture)
            self.assertTrue(any(reads_input_attachment(module) for module in heard))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
