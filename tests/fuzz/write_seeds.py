"""Seeds of binary formats that nobody else here writes: write_seeds.py FOLDER"""
import pathlib
import struct
import sys


def ccp4(group, intervals):
    """A box of 6 nodes along each edge, in a cell of so many intervals."""
    head = struct.pack("<10i", 6, 6, 6, 2, 0, 0, 0, intervals, intervals, intervals) + struct.pack("<6f", 9, 9, 9, 90, 90, 90)
    head += struct.pack("<3i3f2i", 1, 2, 3, 0, 1, 0.5, group, 0)
    head = (head.ljust(208, b"\0") + b"MAP \x44\x44\0\0").ljust(1024, b"\0")
    return head + struct.pack("<216f", *(i % 7 / 7 for i in range(216)))


def gsd(packed, bonds=(0, 1, 1, 2)):
    """Two frames of three beads. Version 1 has names of 64 bytes each, version 2 one after the other."""
    chunks = ((0, "particles/position", 3, 9, "<9f", (0, 0, 0, 1, 0, 0, 2, 0, 0)), (0, "particles/types", 2, 5, "<4s", (b"B\0C\0",)),
              (0, "particles/typeid", 1, 3, "<3I", (0, 1, 0)), (0, "particles/diameter", 1, 9, "<3f", (1, 2, 1)),
              (0, "bonds/group", 2, 3, f"<{len(bonds)}I", bonds), (0, "configuration/box", 1, 9, "<6f", (10, 10, 10, 0.1, 0, 0)),
              (1, "particles/position", 3, 9, "<9f", (0, 0, 1, 1, 0, 1, 2, 0, 1)))
    names, index, body = [], b"", b""
    for frame, name, columns, type, form, values in chunks:
        if name not in names:
            names.append(name)
        data = struct.pack(form, *values)
        width = {3: 4, 5: 1, 9: 4}[type]
        index += struct.pack("<QQqIHBB", frame, len(data) // (width * columns), 256 + len(body), columns, names.index(name), type, 0)
        body += data
    listed = b"".join(name.encode() + (b"\0" if packed else bytes(64 - len(name))) for name in names)
    listed += bytes(-len(listed) % 64)
    head = struct.pack("<QQQQQII", 0x65DF65DF65DF65DF, 256 + len(body), len(index) // 32, 256 + len(body) + len(index), len(listed) // 64,
                       0x10004, 0x20000 if packed else 0x10000)
    return head.ljust(256, b"\0") + body + index + listed


folder = pathlib.Path(sys.argv[1])
for name, data in (("box.ccp4", ccp4(0, 6)), ("cell.ccp4", ccp4(19, 12)), ("beads.gsd", gsd(False)), ("packed.gsd", gsd(True)),
                   ("unbonded.gsd", gsd(False, ()))):
    (folder / name).write_bytes(data)
