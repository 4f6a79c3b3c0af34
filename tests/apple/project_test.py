"""The Apple projects as CMake makes them when it is told that the system is iOS or macOS, and the property lists of the
apps. Nothing is compiled here: there is no Apple toolchain.

project_test.py SOURCE: the source folder."""

import json
import pathlib
import plistlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

SOURCE = pathlib.Path(sys.argv[1])
APPLE = SOURCE / "app/apple"
CLANG = "/usr/bin/clang++-14"


def configure(folder, *options):
    command = ["cmake", "-S", str(SOURCE), "-B", str(folder), "-G", "Ninja", "-D", "APPLE=ON",
               "-D", "NACRE_TESTS=OFF", "-D", f"CMAKE_CXX_COMPILER={CLANG}",
               "-D", f"CMAKE_OBJCXX_COMPILER={CLANG}", "-D", "CMAKE_EXPORT_COMPILE_COMMANDS=ON", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        raise RuntimeError(run.stderr)
    return Project(folder)


class Project:
    def __init__(self, folder):
        self.ninja = (folder / "build.ninja").read_text()
        self.compiled = {c["file"]: c["command"] for c in json.loads((folder / "compile_commands.json").read_text())}
        lists = list(folder.rglob("Nacre.app/**/Info.plist"))
        if len(lists) != 1:
            raise RuntimeError(f"{len(lists)} property lists")
        self.plist = plistlib.loads(lists[0].read_bytes())
        link = re.search(r"^build \S*Nacre\.app/Contents/MacOS/Nacre:.*?\n\n", self.ninja, re.MULTILINE | re.DOTALL)
        self.frameworks = set(re.findall(r"-framework (\w+)", link.group()))


def imported(folder):
    """The frameworks that the sources of a folder import."""
    text = "".join(f.read_text() for f in (APPLE / folder).iterdir() if f.suffix in (".h", ".mm"))
    return set(re.findall(r"#import <(\w+)/", text))


MAPS = {"ccp4", "map", "mrc", "dx", "cube", "dsn6", "brix"}  # of density maps, which engine/volume reads by content


def endings_read():
    """The endings that the reader knows."""
    text = (SOURCE / "engine/molecule/formats/format_table.cpp").read_text()
    rows = re.findall(r'\{Format::\w+, "\w+", "[^"]+", "([^"]+)"', text)
    return {ending for row in rows for ending in row.split()}


class Projects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(cls.folder.name)
        cls.ios = configure(root / "ios", "-D", "IOS=ON")
        cls.debug = configure(root / "ios_debug", "-D", "IOS=ON", "-D", "CMAKE_BUILD_TYPE=Debug")
        molten = root / "MoltenVK"
        molten.mkdir()
        (molten / "libMoltenVK.dylib").write_text("")
        (molten / "MoltenVK_icd.json").write_text(
            '{"file_format_version": "1.0.0", "ICD": {"library_path": "./libMoltenVK.dylib", "api_version": "1.2.0"}}')
        cls.mac = configure(root / "mac", "-D", f"NACRE_MOLTENVK={molten}")
        cls.manifest = json.loads(next((root / "mac").rglob("MoltenVK_icd.json")).read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_source_is_built_with_reference_counting(self):
        for project, folder in ((self.ios, "ios"), (self.mac, "mac")):
            sources = {str(f) for f in (APPLE / folder).glob("*.mm")}
            built = {f: c for f, c in project.compiled.items() if f.endswith(".mm")}
            self.assertEqual(set(built), sources)
            for source, command in built.items():
                self.assertIn("-fobjc-arc", command, source)
            self.assertIn("DYNAMIC_LOADER_TOOL=0", project.compiled[str(SOURCE / "engine/gpu/device.cpp")])

    def test_what_is_imported_is_linked(self):
        self.assertLessEqual(imported("ios"), self.ios.frameworks)
        self.assertLessEqual(imported("mac") - {"Foundation"}, self.mac.frameworks)  # AppKit brings it
        self.assertIn("Metal", self.ios.frameworks)

    def test_the_phone_gets_no_desktop_part(self):
        for part in ("cli/main.cpp", "download/http.cpp", "desktop/", "image_file.cpp"):
            self.assertFalse([f for f in self.ios.compiled if part in f], part)
            self.assertTrue([f for f in self.mac.compiled if part in f], part)
        self.assertTrue([f for f in self.ios.compiled if "download/http_host.cpp" in f], "its HTTP is the system's")

    def test_both_open_what_the_engine_reads(self):
        for project in (self.ios, self.mac):
            types = {t["UTTypeIdentifier"]: t for t in project.plist["UTImportedTypeDeclarations"]}
            endings = [e for t in types.values() for e in t["UTTypeTagSpecification"]["public.filename-extension"]]
            self.assertEqual(len(endings), len(set(endings)))
            self.assertEqual(set(endings) | {"json"}, endings_read() | MAPS)
            opened = [t for d in project.plist["CFBundleDocumentTypes"] for t in d["LSItemContentTypes"]]
            self.assertEqual(set(opened), set(types) | {"public.json", "org.gnu.gnu-zip-archive"})
            for document in project.plist["CFBundleDocumentTypes"]:
                self.assertEqual(document["CFBundleTypeRole"], "Viewer")
                self.assertIn(document["LSHandlerRank"], ("Default", "Alternate"))
            for kind in types.values():
                self.assertTrue(kind["UTTypeConformsTo"][0].startswith("public."))

    def test_the_phones_list_names_what_the_sources_have(self):
        plist = self.ios.plist
        for key in ("UIFileSharingEnabled", "LSSupportsOpeningDocumentsInPlace",
                    "UIApplicationSupportsIndirectInputEvents", "CADisableMinimumFrameDurationOnPhone"):
            self.assertIs(plist[key], True, key)
        scenes = plist["UIApplicationSceneManifest"]["UISceneConfigurations"]["UIWindowSceneSessionRoleApplication"]
        delegate = scenes[0]["UISceneDelegateClassName"]
        text = (APPLE / "ios/scene_delegate.mm").read_text()
        self.assertIn(f"@implementation {delegate} ", text)
        self.assertEqual(plist["NSUserActivityTypes"], re.findall(r'kActivity = @"([^"]+)"', text))
        version = re.search(r"project\(nacre VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
        for project in (self.ios, self.mac):
            self.assertEqual(project.plist["CFBundleShortVersionString"], version)
            self.assertEqual(project.plist["CFBundleExecutable"], "Nacre")

    def test_the_phone_takes_its_privacy_manifest_along(self):
        self.assertIn("Nacre.app/Contents/Resources/PrivacyInfo.xcprivacy", self.ios.ninja)
        manifest = plistlib.loads((APPLE / "ios/PrivacyInfo.xcprivacy").read_bytes())
        self.assertIs(manifest["NSPrivacyTracking"], False)
        self.assertEqual(manifest["NSPrivacyCollectedDataTypes"], [])
        reasons = {a["NSPrivacyAccessedAPIType"]: a["NSPrivacyAccessedAPITypeReasons"]
                   for a in manifest["NSPrivacyAccessedAPITypes"]}
        self.assertEqual(reasons, {"NSPrivacyAccessedAPICategoryFileTimestamp": ["C617.1"],
                                   "NSPrivacyAccessedAPICategorySystemBootTime": ["35F9.1"]})

    def test_the_phone_has_an_icon(self):
        self.assertIn("Nacre.app/Contents/Resources/Assets.xcassets", self.ios.ninja)
        catalog = next(pathlib.Path(self.folder.name).glob("ios/**/Assets.xcassets/AppIcon.appiconset"))
        image = json.loads((catalog / "Contents.json").read_text())["images"][0]
        data = (catalog / image["filename"]).read_bytes()
        width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
        self.assertEqual((width, height, depth, kind), (1024, 1024, 8, 2), "opaque, and of the size that is named")
        rows = zlib.decompress(data[data.index(b"IDAT") + 4:-16])
        pixel = lambda x, y: tuple(rows[y * (3 * width + 1) + 1 + 3 * x:][:3])
        self.assertEqual(pixel(0, 0), (0x17, 0x19, 0x1f), "the background")
        self.assertEqual(pixel(512, 427), (0xe0, 0x40, 0x30), "the oxygen in the middle")
        self.assertEqual(pixel(299, 640), (0xe8, 0xe8, 0xe8), "a hydrogen")

    def test_debug_builds_can_be_captured(self):
        self.assertIs(self.debug.plist["MetalCaptureEnabled"], True)
        self.assertNotIn("MetalCaptureEnabled", self.ios.plist)

    def test_the_mac_takes_moltenvk_along(self):
        self.assertEqual(self.manifest["ICD"],
                         {"library_path": "../../../Frameworks/libMoltenVK.dylib", "api_version": "1.2.0"})
        for place in ("Resources/vulkan/icd.d/MoltenVK_icd.json", "Frameworks/libMoltenVK.dylib"):
            self.assertIn(f"Nacre.app/Contents/{place}", self.mac.ninja)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
