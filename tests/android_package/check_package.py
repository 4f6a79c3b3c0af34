#!/usr/bin/env python3
"""Packs an APK by tools/package_android and reads it again, by aapt, by apksigner, and byte by byte."""

import re
import struct
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = 16384
LIBRARIES = {"lib/arm64-v8a/libnacre.so": 183, "lib/x86_64/libnacre.so": 62}  # ELF's numbers of the machines


def run(*command, code=0):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != code and not (code == "not 0" and done.returncode != 0):
        sys.exit(f"{' '.join(command)}: exit status {done.returncode}, not {code}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def expect(condition, what):
    if not condition:
        sys.exit(f"not so: {what}")


def check_badging(apk):
    badging = run("aapt", "dump", "badging", apk).splitlines()
    for line in ("sdkVersion:'26'", "targetSdkVersion:'36'", "application-label:'Nacre'",
                 "native-code: 'arm64-v8a' 'x86_64'",
                 "  uses-feature: name='android.hardware.vulkan.version' version='4198400'",
                 "  uses-feature-not-required: name='android.hardware.touchscreen'"):
        expect(line in badging, f"badging says {line}")
    expect(badging[0].startswith("package: name='org.nacre.viewer' versionCode='1' versionName='0.1.0-stand-in'"),
           "the package says what it is: " + badging[0])
    expect(any(line.startswith("launchable-activity: name='org.nacre.viewer.NacreActivity'") for line in badging),
           "NacreActivity is launched")
    # The network is given without a question; whatever a user would be asked for is not wanted.
    wanted = ["package:", "org.nacre.viewer", "uses-permission:", "name='android.permission.INTERNET'"]
    expect(run("aapt", "dump", "permissions", apk).split() == wanted, "the network alone")


def check_manifest(apk):
    tree = run("aapt", "dump", "xmltree", apk, "AndroidManifest.xml")
    # aapt prints booleans as 0x0 or 0xffffffff.
    for attribute in ("extractNativeLibs", "allowBackup"):
        line = next((l for l in tree.splitlines() if f"android:{attribute}(" in l), "")
        expect(line.endswith("0x0"), f"{attribute} is false")
    for text in ("android.intent.action.VIEW", "android.intent.action.SEND", "chemical/*", "chemical/x-pdb", "chemical/x-mmcif", "chemical/x-mdl-sdfile",
                 "application/octet-stream", r".*\\.pdb", r".*\\.cif", r".*\\.sdf", "content"):
        expect(f'"{text}"' in tree, f"the manifest names {text}")
    filters = [f for f in tree.split("E: intent-filter")[1:] if "action.VIEW" in f and "application/octet-stream" in f]
    expect(any("pathPattern" not in f for f in filters), "a document without a name in its address is offered")
    profileable = tree.partition("E: profileable")[2].partition("E: ")[0]
    expect(re.search(r"android:shell\(.*0xffffffff", profileable), "profilers attach to released builds")
    # A path of the file system needs a permission that is not asked for.
    expect('"file"' not in tree, "no file: address is offered to be opened")
    activity = [l.strip() for l in tree.splitlines()]
    expect(any(l.startswith("A: android:launchMode(") and l.endswith("0x2") for l in activity), "the activity is the only one")
    changes = next(l for l in tree.splitlines() if "android:configChanges(" in l)
    kept = int(changes.rsplit("0x", 1)[1], 16)
    # orientation, screen layout, smallest size, screen size, density: none of them makes the activity anew.
    expect(kept & 0x1D80 == 0x1D80, f"turning keeps the activity: {kept:#x}")


def check_icon(apk):
    tree = run("aapt", "dump", "xmltree", apk, "res/mipmap-anydpi-v26/icon.xml")
    for layer in ("background", "foreground", "monochrome"):
        expect(f"E: {layer} " in tree, f"the icon has a layer {layer}")


def check_libraries(apk):
    data = Path(apk).read_bytes()
    with zipfile.ZipFile(apk) as package:
        expect("classes.dex" not in package.namelist(), "no Java code but what --dex gives")
        for name, machine in LIBRARIES.items():
            info = package.getinfo(name)
            expect(info.compress_type == zipfile.ZIP_STORED, f"{name} is stored")
            header = data[info.header_offset:info.header_offset + 30]
            start = info.header_offset + 30 + sum(struct.unpack("<HH", header[26:30]))
            expect(start % PAGE == 0, f"{name} starts on a page of 16 KB: {start}")
            check_elf(name, data[start:start + info.file_size], machine)


def check_elf(name, elf, machine):
    expect(elf[:6] == b"\x7fELF\x02\x01", f"{name} is a 64-bit ELF file")
    expect(struct.unpack_from("<H", elf, 18)[0] == machine, f"{name} is for machine {machine}")
    table, = struct.unpack_from("<Q", elf, 32)
    size, count = struct.unpack_from("<HH", elf, 54)
    loads = 0
    for i in range(count):
        kind, _, offset, address, _, _, _, align = struct.unpack_from("<IIQQQQQQ", elf, table + i * size)
        if kind != 1:
            continue
        loads += 1
        expect(align >= PAGE and (offset - address) % PAGE == 0, f"{name}: segments stand on pages of 16 KB")
    expect(loads > 0, f"{name} has segments")
    expect(b"\0ANativeActivity_onCreate\0" in elf, f"{name} has the entry point")


def check_signature(apk, folder):
    said = run("apksigner", "verify", "--verbose", "--min-sdk-version", "26", apk)
    expect("Verified using v2 scheme (APK Signature Scheme v2): true" in said, said)
    data = bytearray(Path(apk).read_bytes())
    with zipfile.ZipFile(apk) as package:
        at = package.getinfo("lib/x86_64/libnacre.so").header_offset + 5000
    data[at] ^= 1
    tampered = str(folder / "tampered.apk")
    Path(tampered).write_bytes(data)
    run("apksigner", "verify", "--min-sdk-version", "26", tampered, code="not 0")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        apk = str(folder / "nacre.apk")
        said = run(str(ROOT / "tools" / "package_android"), apk)
        expect("stand-ins, which do not run" in said, "the tool says what it packs")
        check_badging(apk)
        check_manifest(apk)
        check_icon(apk)
        check_libraries(apk)
        check_signature(apk, folder)


main()
