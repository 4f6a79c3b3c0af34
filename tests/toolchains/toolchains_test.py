"""Configures the apps of phones by their toolchains, with stand-ins for the NDK and vcpkg and no compiler of shaders in PATH:
programs that run while the app is built come from vcpkg's tree of the building machine. Libraries are Debian's; nothing is compiled.

toolchains_test.py SOURCE: the source folder."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1])
ANDROID = SOURCE / "app/android"
CLANG = "/usr/bin/clang++-14"

# What vcpkg's own script does with these names; a stand-in for the rest, which downloads and builds.
VCPKG = """
foreach(name VCPKG_HOST_TRIPLET VCPKG_TARGET_TRIPLET VCPKG_MANIFEST_DIR)
    if(NOT DEFINED ${name} AND NOT DEFINED CACHE{${name}} AND NOT CMAKE_PROJECT_NAME STREQUAL "CMAKE_TRY_COMPILE")
        message(FATAL_ERROR "${name} is not set")
    endif()
endforeach()
if(NOT DEFINED VCPKG_INSTALLED_DIR)
    set(VCPKG_INSTALLED_DIR ${CMAKE_BINARY_DIR}/vcpkg_installed)
endif()
file(APPEND ${CMAKE_CURRENT_LIST_DIR}/installed.txt "${VCPKG_INSTALLED_DIR} ${VCPKG_HOST_TRIPLET}\n")
file(GLOB tools LIST_DIRECTORIES true ${CMAKE_CURRENT_LIST_DIR}/host/${VCPKG_HOST_TRIPLET}/tools/*)
list(APPEND CMAKE_PROGRAM_PATH ${tools})
if(VCPKG_CHAINLOAD_TOOLCHAIN_FILE)
    include(${VCPKG_CHAINLOAD_TOOLCHAIN_FILE})
endif()
"""
NDK = f"""
set(ANDROID TRUE)
set(CMAKE_C_COMPILER /usr/bin/clang-14)
set(CMAKE_CXX_COMPILER {CLANG})
"""
HOST_TRIPLET = {"x86_64": "x64-linux", "aarch64": "arm64-linux"}


class Toolchains(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.vcpkg = self.root / "vcpkg"
        self.scripts = self.vcpkg / "scripts/buildsystems"
        self.scripts.mkdir(parents=True)
        (self.scripts / "vcpkg.cmake").write_text(VCPKG)
        machine = subprocess.run(["uname", "-m"], capture_output=True, text=True).stdout.strip()
        self.tools = self.scripts / "host" / HOST_TRIPLET[machine] / "tools"
        for folder, name in (("glslang", "glslang"), ("spirv-tools", "spirv-opt"), ("spirv-tools", "spirv-val")):
            (self.tools / folder).mkdir(parents=True, exist_ok=True)
            program = self.tools / folder / name
            program.write_text("#!/bin/sh\n")
            program.chmod(0o755)
        # Not what the build needs, but what a ninja that is a script may.
        self.path = self.root / "path"
        self.path.mkdir()
        for name in filter(shutil.which, ("flock", "sleep")):
            (self.path / name).symlink_to(shutil.which(name))
        self.ndk = self.root / "ndk"
        (self.ndk / "build/cmake").mkdir(parents=True)
        (self.ndk / "build/cmake/android.toolchain.cmake").write_text(NDK)

    def tearDown(self):
        self.folder.cleanup()

    def configure(self, *options):
        build = self.root / "build"
        shutil.rmtree(build, ignore_errors=True)
        command = [shutil.which("cmake"), "-S", str(SOURCE), "-B", str(build), "-G", "Ninja",
                   "-D", f"CMAKE_MAKE_PROGRAM={shutil.which('ninja')}", "-D", "NACRE_TESTS=OFF",
                   "-D", f"VCPKG_MANIFEST_DIR={SOURCE / 'third_party'}", *options]
        run = subprocess.run(command, capture_output=True, text=True, env={"PATH": str(self.path), "HOME": str(self.root)})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE))

    def expect_tools_of_vcpkg(self, cache):
        # glslang 14 and newer has no other name there.
        for variable, program in (("GLSLANG_VALIDATOR", "glslang/glslang"), ("SPIRV_OPT", "spirv-tools/spirv-opt"),
                                  ("SPIRV_VAL", "spirv-tools/spirv-val")):
            self.assertEqual(cache[variable], str(self.tools / program))

    def installed(self):
        return {line.split()[0] for line in (self.scripts / "installed.txt").read_text().splitlines()}

    def test_android_takes_vcpkgs_tools_and_one_tree(self):
        abis = {"arm64-v8a": "arm64-android", "x86_64": "x64-android"}
        for abi, triplet in abis.items():
            for kind in ("Debug", "Release"):
                (self.scripts / "installed.txt").unlink(missing_ok=True)
                cache = self.configure("-D", f"CMAKE_TOOLCHAIN_FILE={ANDROID / 'toolchain.cmake'}", "-D",
                                       f"ANDROID_NDK={self.ndk}", "-D", f"ANDROID_ABI={abi}", "-D",
                                       f"NACRE_VCPKG_ROOT={self.vcpkg}", "-D", f"CMAKE_BUILD_TYPE={kind}")
                self.expect_tools_of_vcpkg(cache)
                self.assertEqual(self.installed(), {str(ANDROID / ".vcpkg" / triplet)}, "of both build types")

    def test_ios_takes_vcpkgs_tools(self):
        cache = self.configure("-D", f"CMAKE_TOOLCHAIN_FILE={self.scripts / 'vcpkg.cmake'}", "-D", "APPLE=ON", "-D",
                               "IOS=ON", "-D", "VCPKG_TARGET_TRIPLET=arm64-ios", "-D", f"CMAKE_CXX_COMPILER={CLANG}",
                               "-D", f"CMAKE_OBJCXX_COMPILER={CLANG}")
        self.expect_tools_of_vcpkg(cache)

    def test_the_wrapper_has_the_gradle_that_the_plugin_needs(self):
        plugin = re.search(r'id\("com.android.application"\) version "([\d.]+)"', (ANDROID / "build.gradle.kts").read_text())
        properties = (ANDROID / "gradle/wrapper/gradle-wrapper.properties").read_text()
        gradle = re.search(r"gradle-([\d.]+)-bin\.zip", properties)
        needed = {"8.10.1": (8, 11, 1)}  # developer.android.com/build/releases/gradle-plugin
        self.assertGreaterEqual(tuple(map(int, gradle.group(1).split("."))), needed[plugin.group(1)])
        self.assertRegex(properties, r"(?m)^distributionSha256Sum=[0-9a-f]{64}$")

    def test_the_wrappers_tool_refuses_another_zip(self):
        other = self.root / "other.zip"
        other.write_bytes(b"PK")
        run = subprocess.run([SOURCE / "tools/gradle_wrapper", other], capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("has another checksum than f397b287", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
