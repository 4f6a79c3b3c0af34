"""Maps as `nacre info --json` reads them, beside gemmi, mrcfile and numpy; and damaged ones, one line each.
beside_gemmi.py NACRE"""
import gzip
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

try:
    import gemmi
    import mrcfile
    import numpy as np
except ImportError:
    test_data.cannot_judge("python3-gemmi, python3-mrcfile or python3-numpy is not installed")

NACRE = sys.argv[1]
faults = []
FOLDER = tempfile.TemporaryDirectory()


def path(name):
    return os.path.join(FOLDER.name, name)


def write(name, data):
    with open(path(name), "wb") as file:
        file.write(data)
    return path(name)


def info(name):
    done = subprocess.run([NACRE, "info", name, "--json"], capture_output=True, text=True)
    if done.returncode:
        faults.append(f"{name}: {done.stderr.strip()}")
        return None
    return json.loads(done.stdout)[0]


def expect(name, got, wanted, within=1e-5):
    if got is None:
        return
    if not np.allclose(np.array(got, float), np.array(wanted, float), rtol=within, atol=within * 1e-2):
        faults.append(f"{name}: {got} instead of {wanted}")


def expect_values(name, values, within=1e-5, **more):
    read = info(name)
    if read is None:
        return None
    values = np.asarray(values, "f8")
    wanted = {"min": np.nanmin(values), "max": np.nanmax(values), "mean": np.nanmean(values), "rms": np.nanstd(values)}
    for key, value in {**wanted, **more}.items():
        expect(f"{os.path.basename(name)}: {key}", read["map"][key], value, within)
    return read


# Files of archives: crystals, whose cell is made by symmetry.
data = test_data.needed_folder() / "maps"
for name in ("3nzd.ccp4.gz", "3nzd_diff.ccp4.gz", "3pqr.ccp4.gz", "5i55_tiny.ccp4", "emd_3001.map.gz"):
    file = str(data / name)
    judge = gemmi.read_ccp4_map(file)
    axes = [judge.header_i32(i) for i in (17, 18, 19)]
    sampling = [judge.header_i32(i) for i in (8, 9, 10)]  # MX, MY, MZ: of the cell, beside the box NX, NY, NZ
    judge.setup(float("nan"))
    grid = judge.grid
    expect_values(file, np.array(grid, copy=False), grid=[grid.nu, grid.nv, grid.nw], sampling=sampling, axes=axes,
                  cell=grid.unit_cell.parameters, space_group=grid.spacegroup.number)

# A box of another program's, in every mode and both byte orders.
random = np.random.default_rng(1)
shape = (5, 6, 7)  # sections, rows, columns
for mode, kind in ((0, "i1"), (1, "i2"), (2, "f4"), (6, "u2"), (12, "f2")):
    values = (random.normal(size=shape) * 40).astype(kind) if kind != "u2" else random.integers(0, 60000, shape).astype("u2")
    if kind == "i1":
        values[0, 0, 0] = -100
    for order in "<>":
        file = path(f"mode{mode}{'big' if order == '>' else 'little'}.mrc")
        with mrcfile.new(file) as mrc:
            mrc.set_data(values.astype(order + kind))
            mrc.voxel_size = (1.5, 2.0, 2.5)
            mrc.header.origin = (10, -20, 30)
            mrc.update_header_from_data()
        with mrcfile.open(file) as mrc:
            judged = mrc.data
            cell = [float(mrc.header.cella[i]) for i in "xyz"]
        expect_values(file, judged, grid=[7, 6, 5], cell=cell + [90, 90, 90], origin=[10, -20, 30], axes=[1, 2, 3])
        for packer, ending in ((gzip.compress, "gz"), (__import__("bz2").compress, "bz2"), (__import__("lzma").compress, "xz")):
            packed = write(f"mode{mode}.mrc.{ending}", packer(open(file, "rb").read()))
            expect_values(packed, judged)


def header(size=(4, 5, 6), mode=2, start=(0, 0, 0), intervals=None, cell=(10, 11, 12, 90, 90, 90), axes=(1, 2, 3), group=0,
           extended=0, origin=(0, 0, 0), stamp=b"\x44\x44\0\0", word=b"MAP ", order="<", most=0.0):
    intervals = intervals or size
    words = struct.pack(order + "10i6f3i3f2i", *size, mode, *start, *intervals, *cell, *axes, 0.0, most, 0.0, group, extended)
    words += b"\0" * (4 * 25)
    words += struct.pack(order + "3f", *origin) + word + stamp + b"\0" * (1024 - 216)
    return words[:1024]


def volume(count, order="<"):
    return random.normal(size=count).astype(order + "f4")


# Axes in every order: gemmi reads the same nodes, and the first one's place is the same.
for axes in ((1, 2, 3), (1, 3, 2), (2, 1, 3), (2, 3, 1), (3, 1, 2), (3, 2, 1)):
    values = volume(4 * 5 * 6)
    intervals = (20, 24, 28)
    start = (1, -2, 3)  # of columns, rows, sections
    file = write(f"axes{''.join(map(str, axes))}.ccp4",
                 header(start=start, intervals=intervals, cell=(30, 35, 40, 80, 95, 105), axes=axes, group=1) + values.tobytes())
    judge = gemmi.read_ccp4_map(file)
    judge.setup(float("nan"))
    node = [start[axes.index(i + 1)] for i in range(3)]
    first = judge.grid.unit_cell.orthogonalize(gemmi.Fractional(*[n / i for n, i in zip(node, intervals)]))
    expect_values(file, np.array(judge.grid, copy=False), origin=first.tolist(), grid=intervals)

values = volume(120)
# ORIGIN prevails over NSTART in a box; in a crystal NSTART alone counts.
expect_values(write("both.mrc", header(start=(2, 2, 2), origin=(7, 8, 9)) + values.tobytes()), values, origin=[7, 8, 9])
expect_values(write("start.mrc", header(start=(2, 2, 2)) + values.tobytes()), values, origin=[5, 4.4, 4])
expect_values(write("crystal.ccp4", header(start=(2, 2, 2), origin=(7, 8, 9), cell=(10, 11, 12, 90, 91, 90), group=1) + values.tobytes()),
              values)
# A cell of zeros, a wrong stamp, an old file without one or its word: read, and said.
for name, raw, words in (("zero.mrc", header(cell=(0,) * 6), "no cell"), ("stamp.mrc", header(stamp=b"\x11\x11\0\0"), "stamp")):
    read = expect_values(write(name, raw + values.tobytes()), values)
    if read and not any(words in warning for warning in read["warnings"]):
        faults.append(f"{name}: no warning about {words}: {read['warnings']}")
expect_values(write("old.map", header(stamp=b"\0" * 4, word=b"\0" * 4) + values.tobytes()), values)
# Bytes of a header that has more than 127 of them are unsigned.
bytes_ = random.integers(0, 255, 120).astype("u1")
expect_values(write("bytes.mrc", header(mode=0, most=255.0) + bytes_.tobytes()), bytes_)
holes = values.copy()
holes[3:7] = np.nan
holes[8] = np.inf
read = expect_values(write("holes.mrc", header() + holes.tobytes()), np.where(np.isfinite(holes), holes, np.nan))
if read and not any("5 of the 120" in warning for warning in read["warnings"]):
    faults.append(f"holes.mrc: {read['warnings']}")

# Other formats: the last axis is the fastest.
nodes = (3, 4, 5)
values = random.normal(size=nodes)
numbers = "\n".join(" ".join(f"{v:.7e}" for v in values.ravel()[i:i + 3]) for i in range(0, 60, 3))
dx = (f"# a comment\nobject 1 class gridpositions counts 3 4 5\norigin -1 -2 -3\ndelta 0.5 0 0\ndelta 0 0.6 0\ndelta 0 0 0.7\n"
      f"object 2 class gridconnections counts 3 4 5\nobject 3 class array type double rank 0 items 60 data follows\n{numbers}\n"
      'attribute "dep" string "positions"\nobject "regular positions regular connections" class field\n')
expect_values(write("potential.dx", dx.encode()), values, grid=nodes, origin=[-1, -2, -3], cell=[1.5, 2.4, 3.5, 90, 90, 90])
bohr = 0.529177210903
cube = f"a\nb\n 1 -1.0 -2.0 -3.0\n 3 0.5 0 0\n 4 0 0.6 0\n 5 0 0 0.7\n 6 6.0 0 0 0\n{numbers}\n"
expect_values(write("density.cube", cube.encode()), values, grid=nodes, origin=[-bohr, -2 * bohr, -3 * bohr],
              cell=[1.5 * bohr, 2.4 * bohr, 3.5 * bohr, 90, 90, 90])
expect_values(write("angstrom.cube", cube.replace("\n 3 0.5", "\n -3 0.5").encode()), values, origin=[-1, -2, -3])
two = "\n".join(f"{v:.7e} 7" for v in values.ravel())
orbital = f"a\nb\n -1 -1.0 -2.0 -3.0\n 3 0.5 0 0\n 4 0 0.6 0\n 5 0 0 0.7\n 6 6.0 0 0 0\n 2 10 11\n{two}\n"
expect_values(write("orbital.cube", orbital.encode()), values)
brix_bytes = random.integers(0, 255, (16, 16, 16)).astype("u1")  # z, y, x
bricks = b"".join(brix_bytes[z:z + 8, y:y + 8, x:x + 8].tobytes() for z in (0, 8) for y in (0, 8) for x in (0, 8))
kept = brix_bytes[:13, :12, :11].astype(float)
brix = b":-) Origin 1 2 3 Extent 11 12 13 Grid 40 50 60 Cell 40.0 50.0 60.0 90.0 100.0 90.0 Prod 2.5 Plus 100 Sigma 1.0".ljust(512) + bricks
expect_values(write("map.brix", brix), (kept - 100) / 2.5, grid=[11, 12, 13])
dsn6 = struct.pack(">19h", 1, 2, 3, 11, 12, 13, 40, 50, 60, 400, 500, 600, 900, 1000, 900, 250, 100, 10, 100).ljust(512, b"\0")
pairs = np.frombuffer(bricks, "u1").reshape(-1, 2)[:, ::-1].tobytes()
expect_values(write("map.dsn6", dsn6 + pairs), (kept - 100) / 2.5, grid=[11, 12, 13], cell=[40, 50, 60, 90, 100, 90])

# Damaged: a line each, and an exit status of 1.
plain = header() + volume(120).tobytes()
bad = {
    "nothing.map": (b"", "map"),
    "short_header.mrc": (plain[:500], "cut short"),
    "short.mrc": (plain[:-10], "cut short"),
    "short.mrc.gz": (gzip.compress(plain[:-10]), "cut short"),
    "negative.mrc": (header(size=(-4, 5, 6)) + volume(120).tobytes(), "-4 x 5 x 6"),
    "huge.mrc": (header(size=(2000000000, 2000000000, 2000000000)), "limit"),
    "large.mrc": (header(size=(500, 500, 500)), "cut short"),
    "large.mrc.gz": (gzip.compress(header(size=(500, 500, 500))), "cut short"),
    "mode.mrc": (header(mode=4) + volume(240).tobytes(), "mode 4"),
    "axes.mrc": (header(axes=(1, 1, 3)) + volume(120).tobytes(), "axes"),
    "stamped.mrc": (header(mode=-7, stamp=b"\x11\x11\0\0") + volume(120).tobytes(), "byte order"),
    "flat.mrc": (header(cell=(10, 11, 12, 90, 180, 90)) + volume(120).tobytes(), "no volume"),
    "nan_cell.mrc": (header(cell=(float("nan"), 11, 12, 90, 90, 90)) + volume(120).tobytes(), "no volume"),
    "one_zero.mrc": (header(cell=(0, 11, 12, 90, 90, 90)) + volume(120).tobytes(), "no volume"),
    "nans.mrc": (header() + np.full(120, np.nan, "f4").tobytes(), "none of its values"),
    "extended.mrc": (header(extended=-80) + volume(120).tobytes(), "-80"),
    "extended_far.mrc": (header(extended=2000000000) + volume(120).tobytes(), "cut short"),
    "far.ccp4": (header(start=(2000000000, 0, 0), group=1) + volume(120).tobytes(), "16,777,216"),
    "short.dx": (dx[:dx.index("attribute") - 200].encode(), "cut short"),
    "words.dx": (dx.replace("delta 0 0.6 0", "delta 0 six 0").encode(), "six"),
    "huge.dx": (dx.replace("counts 3 4 5", "counts 9999999 9999999 9999999").encode(), "limit"),
    "flat.dx": (dx.replace("delta 0 0 0.7", "delta 0 0.6 0").encode(), "volume"),
    "short.cube": (cube[:cube.rindex("\n", 0, -60)].encode(), "cut short"),
    "words.cube": (cube.replace(f"{values.ravel()[7]:.7e}", "x").encode(), '"x"'),
    "zero.cube": (cube.replace("\n 3 0.5", "\n 0 0.5").encode(), "0 nodes"),
    "short.brix": (brix[:-600], "cut short"),
    "words.brix": (brix.replace(b"Prod 2.5", b"Prod two"), "prod"),
}
for name, (raw, words) in bad.items():
    done = subprocess.run([NACRE, "info", write(name, raw), "--json"], capture_output=True, text=True)
    lines = done.stderr.strip().splitlines()
    if done.returncode != 1 or len(lines) != 1 or words not in lines[0] or done.stdout:
        faults.append(f"{name}: exit {done.returncode}, {done.stderr.strip()!r}")

for fault in faults:
    print(fault)
sys.exit(bool(faults))
