"""Structures of the Python module: where they come from, what they hold and where they go; and their density maps."""
import json
import os
import pathlib
import pickle
import resource
import signal
import subprocess
import sys

import numpy as np
import pytest

import nacre

PROGRAM = os.environ["NACRE_PROGRAM"]
STRUCTURES = pathlib.Path(os.environ["NACRE_WRITTEN_FILES"])
SMALL = {"size": (48, 32), "occlusion": 4, "occlusion_detail": 8, "cache": "off"}
PDB = b"ATOM      1  CA  GLY A   7       1.000   2.000   3.000  0.50 12.00           C\nEND\n"


@pytest.fixture(scope="module")
def dna():
    return nacre.open("sample:dna")


def test_atoms_are_gemmis():
    gemmi = pytest.importorskip("gemmi")
    path = STRUCTURES / "gemmi/dna.pdb"
    ours, theirs = nacre.open(path), gemmi.read_structure(str(path))
    atoms = [(a, r, c) for c in theirs[0] for r in c for a in r]
    assert len(ours) == len(atoms)
    table = ours.atoms
    np.testing.assert_allclose(table["position"], [a.pos.tolist() for a, _, _ in atoms], atol=1e-3)
    assert table["element"].tolist() == [a.element.name for a, _, _ in atoms]
    assert table["name"].tolist() == [a.name for a, _, _ in atoms]
    assert table["residue_name"].tolist() == [r.name for _, r, _ in atoms]
    assert table["residue_number"].tolist() == [r.seqid.num for _, r, _ in atoms]
    assert table["chain"].tolist() == [c.name for _, _, c in atoms]
    np.testing.assert_allclose(table["b_factor"], [a.b_iso for a, _, _ in atoms], atol=1e-2)
    np.testing.assert_array_equal(nacre.from_gemmi(theirs).render(**SMALL), ours.render(**SMALL))


def test_from_biopython():
    PDB = pytest.importorskip("Bio.PDB")
    path = STRUCTURES / "gemmi/dna.pdb"
    entity = PDB.PDBParser(QUIET=True).get_structure("dna", str(path))
    np.testing.assert_array_equal(nacre.from_biopython(entity).render(**SMALL), nacre.open(path).render(**SMALL))


MODELS = b"".join(b"MODEL     %4d\n" % i + PDB[:30] + b"%8.3f" % (5.0 * i) + PDB[38:-4] + b"ENDMDL\n" for i in (0, 1, 2)) + b"END\n"


def test_from_parts_of_gemmis(tmp_path):
    gemmi = pytest.importorskip("gemmi")
    path = STRUCTURES / "gemmi/dna.pdb"
    theirs, ours = gemmi.read_structure(str(path)), nacre.open(path)
    assert len(nacre.from_gemmi(theirs[0])) == len(ours)
    first = theirs[0][0]
    chain = nacre.from_gemmi(first)
    of_chain = ours.atoms["chain"] == first.name
    np.testing.assert_allclose(chain.atoms["position"], ours.atoms["position"][of_chain], atol=1e-3)
    assert 0 < len(chain) < len(ours) and set(chain.atoms["chain"]) == {first.name}


def test_from_biopython_of_any_models(tmp_path):
    PDB = pytest.importorskip("Bio.PDB")
    (tmp_path / "m.pdb").write_bytes(MODELS)
    entity = PDB.PDBParser(QUIET=True).get_structure("m", str(tmp_path / "m.pdb"))
    serials = [model.serial_num for model in entity]
    assert [nacre.from_biopython(entity, model=m).atoms["position"][:, 0].tolist() for m in (1, 2, 3)] == [[0], [5], [10]]
    assert [model.serial_num for model in entity] == serials
    assert nacre.from_biopython(entity[1]).atoms["position"][:, 0].tolist() == [5]
    assert len(nacre.from_biopython(entity[0]["A"])) == 1


def test_from_arrays(dna):
    a = dna.atoms
    columns = dict(names=a["name"], residue_names=a["residue_name"], residue_numbers=a["residue_number"],
                   chains=a["chain"], b_factors=a["b_factor"], occupancies=a["occupancy"])
    copy = nacre.from_arrays(a["position"], a["element"], **columns)
    np.testing.assert_array_equal(copy.bonds, dna.bonds)
    for key in ("name", "residue_name", "residue_number", "chain"):
        np.testing.assert_array_equal(copy.atoms[key], a[key])
    np.testing.assert_array_equal(copy.render(color="chain", **SMALL), dna.render(color="chain", **SMALL))
    water = nacre.from_arrays([[0, 0, 0], [0.96, 0, 0], [-0.24, 0.93, 0]], [8, 1, 1])
    assert water.bonds[:, :2].tolist() == [[0, 1], [0, 2]]
    assert nacre.from_arrays([[0, 0, 0], [1.2, 0, 0]], ["C", "O"], [[1, 0, 2]]).bonds.tolist() == [[0, 1, 2]]
    assert len(nacre.from_arrays([[0, 0, 0], [1.2, 0, 0]], ["C", "O"], []).bonds) == 0


def test_bonds_have_the_orders_that_pictures_draw():
    angles = np.arange(6) * np.pi / 3
    ring = 1.39 * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    benzene = nacre.from_arrays(ring, ["C"] * 6)
    assert benzene.bonds[:, 2].tolist() == [4] * 6
    bonds = benzene.info()["bonds_known"]
    assert (bonds["aromatic"], bonds["single"]) == (6, 0)


def test_open_takes_bytes_in_any_format():
    import gzip
    for source, more in ((PDB, {}), (gzip.compress(PDB), {"name": "a.pdb.gz"}), (bytearray(PDB), {"format": "pdb"})):
        atom = nacre.open(source, **more).atoms
        assert atom["position"].tolist() == [[1, 2, 3]]
        assert (atom["name"][0], atom["residue_number"][0], atom["b_factor"][0], atom["occupancy"][0]) == ("CA", 7, 12, 0.5)


def test_arrays_cannot_be_written_to(dna):
    with pytest.raises(ValueError):
        dna.atoms["position"][0] = 0


def test_a_file_that_is_missing_is_pythons_own_exception(dna, tmp_path):
    for call, path in ((lambda: nacre.open("nosuch.pdb"), "nosuch.pdb"),
                       (lambda: dna.save("/nowhere/a.png", **SMALL), "/nowhere/a.png"),
                       (lambda: dna.export("/nowhere/a.glb"), "/nowhere/a.glb"),
                       (lambda: dna.movie("/nowhere/a.gif"), "/nowhere/a.gif")):
        with pytest.raises(FileNotFoundError) as failure:
            call()
        assert isinstance(failure.value, nacre.Error)
        assert (failure.value.filename, failure.value.errno) == (path, 2) and path in str(failure.value)
        again = pickle.loads(pickle.dumps(failure.value))
        assert (str(again), again.filename) == (str(failure.value), path)


def test_selections_are_masks(dna):
    mask = dna.select("chain A and name P")
    np.testing.assert_array_equal(mask, (dna.atoms["chain"] == "A") & (dna.atoms["name"] == "P"))
    assert mask.dtype == bool and 0 < mask.sum() < len(dna)
    pair = nacre.open(["duplex=sample:dna", "sugar=sample:glucose"])
    assert pair.select("/sugar").tolist() == [False] * 486 + [True] * 24


def test_info_is_the_command_lines(dna):
    text = subprocess.run([PROGRAM, "info", "sample:dna", "--json"], capture_output=True, text=True, check=True).stdout
    entry = json.loads(text)[0]
    of_file = {key: entry.pop(key) for key in ("file", "bytes", "map")}
    assert of_file == {"file": "sample:dna", "bytes": None, "map": None} and dna.info() == entry


def test_structures_are_pickled(tmp_path):
    (tmp_path / "m.pdb").write_bytes(MODELS)
    for structure in (nacre.open("sample:dna"), nacre.open(STRUCTURES / "gemmi/dna.cif"), nacre.open(tmp_path / "m.pdb"),
                      nacre.open(["duplex=sample:dna", "sugar=sample:glucose"])):
        again = pickle.loads(pickle.dumps(structure))
        assert (again.name, again.title, again.warnings, len(again)) == (structure.name, structure.title, structure.warnings,
                                                                         len(structure))
        assert again.info() == structure.info()
        for key, column in structure.atoms.items():
            np.testing.assert_array_equal(again.atoms[key], column)
        np.testing.assert_array_equal(again.bonds, structure.bonds)
        np.testing.assert_array_equal(again.render(color="chain", **SMALL), structure.render(color="chain", **SMALL))
        assert pickle.dumps(again) == pickle.dumps(structure)
    state = nacre.open("sample:glucose")._core.__reduce_ex__(2)[2]
    flipped = [state[0][:at] + bytes([state[0][at] ^ bit]) + state[0][at + 1:]
               for at in range(60, len(state[0]), 97) for bit in (1, 128)]
    for damaged in (state[0][:-9], b"x" + state[0][1:], b"", *flipped):
        with pytest.raises(nacre.Error, match="cannot unpickle"):
            nacre._nacre.Structure.__new__(nacre._nacre.Structure).__setstate__((damaged, *state[1:]))


BALLS = ("''.join('ATOM  %5d  CA  ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\\n' % "
         "(n % 99999, n % 9999, n % 30 * 4, n // 30 % 30 * 4, n // 900 * 4) for n in range(27000))")


@pytest.mark.parametrize("work", [
    "structure.render(size=(64, 64), occlusion=4096, occlusion_detail=32, occlusion_memory=4096, cache='off')",  # many steps
    "nacre.open('fifo.pdb')",  # one step, which waits for a writer for ever
])
def test_an_interrupt_ends_a_call(tmp_path, work):
    """Within moments, as CPU time tells; the work itself would take a minute of it."""
    code = ("import nacre, os, signal, threading, time\n"
            f"structure = nacre.open({BALLS}.encode(), format='pdb')\n"
            "small = dict(size=(32, 32), occlusion='off')\n"
            "before = structure.render(**small)\n"
            "asked = []\n"
            "def interrupt():\n"
            "    asked.append(time.process_time())\n"
            "    os.kill(os.getpid(), signal.SIGINT)\n"
            "threading.Timer(1, interrupt).start()\n"
            "try:\n"
            f"    {work}\n"
            "    print('done')\n"
            "except KeyboardInterrupt:\n"
            "    print('ended', time.process_time() - asked[0], flush=True)\n")
    os.mkfifo(tmp_path / "fifo.pdb")

    def run(more):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([sys.executable, "-c", code + more], capture_output=True, text=True, cwd=tmp_path)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        words = done.stdout.split()
        assert words[0] == "ended", done.stderr
        assert float(words[1]) < 2
        assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < 20
        return done

    assert run("").returncode == 0
    assert run("os.kill(os.getpid(), signal.SIGINT)\n").returncode == -signal.SIGINT  # nobody catches it
    if "occlusion=" in work:  # what it locked is free again
        assert "same" in run("print('same' if (structure.render(**small) == before).all() else 'another')\n").stdout


def test_after_a_fork_it_says_what_to_do(dna):
    dna.render(**SMALL)
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            dna.render(**SMALL)
            said = "drawn"
        except nacre.Error as error:
            said = str(error)
        os.write(write, said.encode())
        os._exit(0)
    os.close(write)
    assert "start processes by spawn" in os.read(read, 1000).decode()
    os.close(read)
    os.waitpid(child, 0)


def test_it_has_a_version():
    said = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
    assert said.startswith(f"nacre {nacre.__version__} ")


def test_the_stub_is_whole(tmp_path):
    """mypy's own comparison of a stub with the module."""
    pytest.importorskip("mypy.stubtest")
    (tmp_path / "allowed").write_text("nacre\\._nacre.*\nnacre\\.nacre_images\nnacre\\.(Options|OwnColors|Still|Layers|Mask|Table)\n")
    (tmp_path / "mypy.ini").write_text("[mypy]\nenable_incomplete_feature = Unpack\n")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "nacre", "--allowlist", str(tmp_path / "allowed"),
                           "--ignore-unused-allowlist", "--mypy-config-file", str(tmp_path / "mypy.ini")],
                          capture_output=True, text=True, cwd=tmp_path,
                          env={**os.environ, "MYPYPATH": str(pathlib.Path(nacre.__file__).parents[1])})
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_name_what_there_is(tmp_path):
    mypy = pytest.importorskip("mypy.api")
    program = tmp_path / "use.py"
    program.write_text("import nacre\ns = nacre.open('a.pdb', model=2)\np = s.render(size=(3, 4), color='chain')\n"
                       "reveal_type(p.shape)\nd = s.layers()['z']\nb: bytes = s._repr_png_()\nx: str = s.save('a.png')\ns.render(sise=3)\n")
    out, _, _ = mypy.run([str(program), "--no-incremental", "--cache-dir", str(tmp_path), "--ignore-missing-imports",
                         "--enable-incomplete-feature=Unpack"])
    errors = [line for line in out.splitlines() if "error" in line and "Found" not in line]
    assert len(errors) == 2 and "save" in errors[0] and "sise" in errors[1], out


def ball(name="ball"):
    nodes = np.indices((17, 17, 17)) - 8
    return nacre.density_map(name, 8 - np.sqrt((nodes ** 2).sum(axis=0)), (17, 17, 17), origin=(-8, -8, -8))


def test_maps_of_arrays_are_drawn_and_exported(tmp_path):
    glucose, name = nacre.open("sample:glucose"), ball()
    with_map = nacre.open("sample:glucose", maps=[name])
    picture = with_map.render(map_level="3", **SMALL)
    np.testing.assert_array_equal(picture, glucose.render(map=[name], map_level="3", **SMALL))
    assert not np.array_equal(picture, glucose.render(**SMALL))
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(with_map)).render(map_level="3", **SMALL), picture)
    with_map.export(tmp_path / "ball.obj", hide="all", map_level="3", map_style="mesh")
    lines = (tmp_path / "ball.obj").read_text().splitlines()
    corners = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)
    assert len(corners) > 100 and any(line.startswith("f ") for line in lines)
    assert np.abs(np.linalg.norm(corners, axis=1) - 5).max() < 0.1  # where 8 less the distance is 3


def test_a_surface_takes_the_colours_of_a_map(dna):
    nodes = np.indices((9, 9, 9))[0] * 10.0 - 40
    name = nacre.density_map("along x", nodes, (90, 90, 90), origin=(-40, -40, -40))
    plain = dna.render(style="surface", lighting="off", **SMALL)
    coloured = dna.render(style="surface", lighting="off", surface_color_from=f"{name}:-10..10:blue-white-red", **SMALL)
    assert not np.array_equal(plain, coloured)
    seen = coloured[..., :3].astype(int)
    blue, red = seen[..., 2] - seen[..., 0] > 60, seen[..., 0] - seen[..., 2] > 60
    assert blue.any() and red.any() and np.nonzero(blue)[1].max() <= np.nonzero(red)[1].min() + 8


def test_a_movie_sweeps_the_level(tmp_path):
    glucose = nacre.open("sample:glucose", maps=[ball()])
    options = {"map_style": "mesh", **SMALL, "size": (64, 48)}
    movie = glucose.movie(tmp_path / "a.png", map_sweep="2,6", fps=2, seconds=1.5, **options)
    assert movie.frames == 3
    Image = pytest.importorskip("PIL.Image")
    with Image.open(tmp_path / "a.png") as animation:
        for i, level in enumerate(("2", "4", "6")):
            animation.seek(i)
            still = glucose.render(map_level=level, zoom=1, **options)
            assert np.abs(np.asarray(animation.convert("RGBA")).astype(int) - still).max() <= 1
    with pytest.raises(nacre.UsageError, match="map_sweep"):
        nacre.open("sample:glucose").movie(tmp_path / "b.png", map_sweep="2,6")
