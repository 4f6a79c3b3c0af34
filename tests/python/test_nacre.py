"""The Python module, as a user meets it; gemmi's, Biopython's and the command line's answers are what it is held to."""
import io
import os
import pathlib
import pickle
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import nacre

PROGRAM = os.environ["NACRE_PROGRAM"]
SMALL = {"size": (48, 32), "occlusion": 4, "occlusion_detail": 8, "cache": "off"}
PDB = b"ATOM      1  CA  GLY A   7       1.000   2.000   3.000  0.50 12.00           C\nEND\n"
MODELS = b"".join(b"MODEL     %4d\n" % i + PDB[:30] + b"%8.3f" % (5.0 * i) + PDB[38:-4] + b"ENDMDL\n" for i in (0, 1, 2)) + b"END\n"


@pytest.fixture(scope="module")
def dna():
    return nacre.open("sample:dna")


def png(path):
    Image = pytest.importorskip("PIL.Image")
    return np.asarray(Image.open(path).convert("RGBA"))


def command_line(*arguments):
    subprocess.run([PROGRAM, "render", *map(str, arguments)], check=True, capture_output=True)


def test_renders_what_the_command_line_renders(dna, tmp_path):
    options = {**SMALL, "color": "chain", "rotate": (0, 90, 0), "show": ["chain A=licorice"], "background": "transparent"}
    command_line("sample:dna", "-o", tmp_path / "a.png", "--size", "48x32", "--occlusion", 4, "--occlusion-detail", 8,
                 "--color", "chain", "--rotate", "0,90,0", "--show", "chain A=licorice", "--background", "transparent")
    picture = dna.render(**options)
    assert picture.shape == (32, 48, 4) and picture.dtype == np.uint8
    np.testing.assert_array_equal(picture, png(tmp_path / "a.png"))
    dna.save(tmp_path / "b.png", **options)
    assert (tmp_path / "b.png").read_bytes() == (tmp_path / "a.png").read_bytes()


def test_pictures_are_the_callers_own(dna):
    first = dna.render(**SMALL)
    assert first.flags.writeable and first.flags.c_contiguous
    kept = first.copy()
    dna.render(**SMALL, color="chain")
    np.testing.assert_array_equal(first, kept)
    first[:] = 0
    np.testing.assert_array_equal(dna.render(**SMALL), kept)


def test_pictures_are_those_of_render(dna):
    views = [{"rotate": (0, 30 * turn, 0)} for turn in range(11)]  # more than are drawn together
    views[3] |= {"color": "chain", "title": "Chains"}
    views[5] |= {"depth": 16}
    views[7] |= {"halos": 3}
    views[8] |= {"size": (20, 30), "style": "licorice"}
    drawn = list(dna.pictures(views, **SMALL))
    assert len(drawn) == len(views)
    for view, picture in zip(views, drawn):
        np.testing.assert_array_equal(picture, dna.render(**SMALL | view))
    colours = np.arange(3 * len(dna), dtype=np.uint8).reshape(-1, 3)
    for view, picture in zip(views[:2], dna.pictures(views[:2], color=colours, **SMALL)):
        np.testing.assert_array_equal(picture, dna.render(color=colours, **SMALL | view))


def test_pictures_have_palettes_of_their_own(dna):
    values = np.arange(len(dna))
    views = [{}, {"palette": "plasma"}, {"color_limits": (0, 9)}, {"rotate": (0, 90, 0)}]
    for view, picture in zip(views, dna.pictures(views, color=values, **SMALL), strict=True):
        np.testing.assert_array_equal(picture, dna.render(color=values, **SMALL | view))


def test_large_pictures_are_not_all_held(dna):
    large = {"size": (1500, 1450), "depth": 16, "occlusion": "off", "supersample": 1}
    _, text = dna._given(large)
    assert len(nacre._nacre.render_all(dna._core, [text] * 3, nacre._nacre.Colors())) == 1
    assert len(list(dna.pictures([{}, {}], **large))) == 2


def test_warnings_of_pictures_name_the_caller(dna):
    with pytest.warns(UserWarning) as told:
        dna.render(**SMALL, hide=["chain Z"])
        list(dna.pictures([{"hide": ["chain Z"]}], **SMALL))
    assert [warning.filename for warning in told] == [__file__] * 2


def test_pictures_are_drawn_as_they_are_asked_for(dna):
    asked = []
    pictures = dna.pictures(({"rotate": (0, asked.append(turn) or turn, 0)} for turn in range(100)), **SMALL)
    assert next(pictures).shape == (32, 48, 4) and len(asked) < 20
    pictures.close()
    assert list(dna.pictures([], **SMALL)) == []
    with pytest.raises(nacre.UsageError, match="halo"):
        list(dna.pictures([{}, {"halo": 1}], **SMALL))
    with pytest.raises(nacre.UsageError, match="arrays go with all views"):
        list(dna.pictures([{"color": np.zeros((len(dna), 3))}], **SMALL))
    with pytest.raises(nacre.Error):  # in the midst of others
        list(dna.pictures([{}, {"hide": "all"}, {}], **SMALL))
    assert dna.render(**SMALL).shape == (32, 48, 4)


@pytest.mark.parametrize("wrong, words", [
    ({"halo": 1}, "halo"), ({"hide": "all"}, "."), ({"color_limits": (0, 1)}, "color_limits"),
    ({"color": [1, 2]}, "arrays go with all views"), (None, ".")])
def test_pictures_before_a_wrong_view_are_drawn(dna, wrong, words):
    views = [{"rotate": (0, 30 * turn, 0)} for turn in range(3)]
    drawn = []
    with pytest.raises(Exception, match=words):
        for picture in dna.pictures(views + [wrong, {}], **SMALL):
            drawn.append(picture)
    assert len(drawn) == len(views)
    for view, picture in zip(views, drawn):
        np.testing.assert_array_equal(picture, dna.render(**SMALL | view))


def test_no_color_is_the_usual_one(dna):
    for picture in dna.pictures([{}, {"color": None}], color=None, **SMALL):
        np.testing.assert_array_equal(picture, dna.render(**SMALL))
    chains, = dna.pictures([{"color": "chain"}], color=None, **SMALL)
    np.testing.assert_array_equal(chains, dna.render(color="chain", **SMALL))


def test_files_say_that_they_are_srgb(dna, tmp_path):
    ImageCms, Image = pytest.importorskip("PIL.ImageCms"), pytest.importorskip("PIL.Image")
    colours = Image.fromarray(np.random.default_rng(1).integers(0, 256, (64, 64, 3), dtype=np.uint8))
    for name in ("a.jpg", "a.tif", "a.webp"):
        dna.save(tmp_path / name, **SMALL)
        profile = ImageCms.ImageCmsProfile(io.BytesIO(Image.open(tmp_path / name).info["icc_profile"]))
        assert (ImageCms.getProfileDescription(profile).strip(), ImageCms.getDefaultIntent(profile)) == ("sRGB", 0)
        # LittleCMS takes its own sRGB for the same.
        changed = ImageCms.applyTransform(colours, ImageCms.buildTransform(profile, ImageCms.createProfile("sRGB"), "RGB", "RGB"))
        assert np.abs(np.asarray(changed).astype(int) - np.asarray(colours)).max() <= 1


def test_sixteen_bits_are_sixteen(dna):
    options = {**SMALL, "supersample": 1, "background": "#336699"}
    coarse, fine, light = dna.render(**options), dna.render(depth=16, **options), dna.layers(**options)["rgba"]
    assert fine.dtype == np.uint16 and fine.shape == coarse.shape
    light = np.clip(light, 0, 1)
    coded = np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
    coded[..., 3] = 1
    assert np.abs(fine.astype(int) - np.round(65535 * coded)).max() <= 1
    assert np.abs(fine / 257 - coarse).max() < 1 and len(np.unique(fine)) > 3 * len(np.unique(coarse))


def test_words_are_written(dna, tmp_path):
    command_line("sample:dna", "-o", tmp_path / "a.png", "--size", "96x64", "--occlusion", "off", "--title", "DNA")
    picture = dna.render(size=(96, 64), occlusion="off", title="DNA")
    np.testing.assert_array_equal(picture, png(tmp_path / "a.png"))
    assert not np.array_equal(picture, dna.render(size=(96, 64), occlusion="off"))


def test_several_inputs_are_drawn_together(dna, tmp_path):
    inputs = ["duplex=sample:dna", "sugar=sample:glucose"]
    rules = {"show": ["/sugar=licorice"], "rotate": (0, 90, 0)}
    command_line(*inputs, "-o", tmp_path / "a.png", "--size", "48x32", "--occlusion", 4, "--occlusion-detail", 8,
                 "--rotate", "0,90,0", "--show", "/sugar=licorice")
    pair = nacre.open(inputs)
    assert len(pair) == len(dna) + len(nacre.open("sample:glucose"))
    np.testing.assert_array_equal(pair.render(**SMALL, **rules), png(tmp_path / "a.png"))


def test_one_input_is_laid_onto_another(tmp_path):
    shifted = PDB[:30] + b"   5.000" + PDB[38:]
    atoms = [PDB[:6] + b"%5d" % (i + 1) + PDB[11:22] + b"%4d" % (i + 1) + PDB[26:38] + b"%8.3f" % (3.0 * i * i) + PDB[46:-4]
             for i in range(4)]
    (tmp_path / "a.pdb").write_bytes(b"".join(atoms))
    (tmp_path / "b.pdb").write_bytes(b"".join(a[:30] + shifted[30:38] + a[38:] for a in atoms))
    paths = [tmp_path / "a.pdb", tmp_path / "b.pdb"]
    apart, laid = nacre.open(paths), nacre.open(paths, fit=("/b", "/a"))
    np.testing.assert_allclose(apart.atoms["position"][4:, 0], 5)
    np.testing.assert_allclose(laid.atoms["position"][4:], laid.atoms["position"][:4], atol=1e-3)


def test_options_change_one_after_the_other(dna):
    """The renderer keeps its scene while the view alone changes, and no longer."""
    first = dna.render(**SMALL)
    turned = dna.render(rotate=(0, 90, 0), **SMALL)
    licorice = dna.render(style="licorice", **SMALL)
    assert not np.array_equal(first, turned) and not np.array_equal(first, licorice)
    np.testing.assert_array_equal(first, dna.render(**SMALL))
    np.testing.assert_array_equal(turned, dna.render(rotate="0,90,0", **SMALL))
    other = nacre.open("sample:glucose").render(**SMALL)
    assert not np.array_equal(first, other)
    np.testing.assert_array_equal(first, nacre.open("sample:dna").render(**SMALL))


def test_layers(dna):
    layers = dna.layers(style="spacefill", **SMALL)
    assert {name: (values.shape, values.dtype.name) for name, values in layers.items()} == {
        "rgba": ((32, 48, 4), "float32"), "z": ((32, 48), "float32"), "normal": ((32, 48, 3), "float32"),
        "id": ((32, 48), "uint32"), "occlusion": ((32, 48), "float32")}
    hit = layers["id"] > 0
    assert 50 < hit.sum() < hit.size and layers["id"].max() <= len(dna)
    np.testing.assert_array_equal(np.isinf(layers["z"]), ~hit)
    np.testing.assert_allclose(np.linalg.norm(layers["normal"][hit], axis=1), 1, atol=1e-4)
    assert 0 <= layers["occlusion"].min() < layers["occlusion"].max() <= 1


def test_notebooks_see_a_picture(dna):
    assert nacre.open("sample:glucose")._repr_png_().startswith(b"\x89PNG")
    assert repr(dna).startswith("<nacre.Structure 'sample:dna': 486 atoms, ")


@pytest.mark.parametrize("call, kind, words", [
    (lambda s: nacre.open("nosuch.pdb"), nacre.Error, "cannot read molecule: nosuch.pdb: No such file or directory"),
    (lambda s: nacre.open("4HHB"), nacre.Error, "(did you mean 'pdb:4hhb'?)"),
    (lambda s: s.select("chian A"), nacre.UsageError, "(did you mean 'chain'?)"),
    (lambda s: s.render(color=np.zeros(3)), nacre.UsageError, "expected 486 values or (486, 3) colours"),
    (lambda s: s.render(color=np.full((486, 3), 2.0)), nacre.UsageError, "from 0 to 1"),
    (lambda s: s.render(color=["red"] * 486), nacre.UsageError, '"color": expected a scheme'),
    (lambda s: s.render(color="chain", color_limits=(0, 1)), nacre.UsageError, "goes with values"),
    (lambda s: s.render(color=np.zeros(486), color_limits=(1, 1)), nacre.UsageError, "two finite numbers that differ"),
    (lambda s: s.render(color=np.zeros(486), palette="muted"), nacre.UsageError, "'muted' is for categories"),
    (lambda s: s.export("a.xyz"), nacre.UsageError, "export() takes a name that ends in .glb, .usdz, .ply, .stl or .obj"),
    (lambda s: s.movie("a.avi"), nacre.UsageError, "movie() takes a name that ends in .mp4"),
    (lambda s: s.movie(spin="w"), nacre.UsageError, "spin: expected x, y, z"),
    (lambda s: s.movie(spin="x", rock=5), nacre.UsageError, "exclude each other"),
    (lambda s: s.movie(models=True), nacre.Error, "it has only one"),
    (lambda s: nacre.open(b"ATOM  no\n", name="bad.pdb"), nacre.Error, "bad.pdb (line 1)"),
    (lambda s: nacre.open("-"), nacre.UsageError, "does not read standard input"),
    (lambda s: nacre.open(["sample:dna", "-"]), nacre.UsageError, "does not read standard input"),
    (lambda s: nacre.open([]), nacre.UsageError, "needs an input"),
    (lambda s: nacre.open(5), nacre.UsageError, "another package's structure, not int"),
    (lambda s: nacre.open(None), nacre.UsageError, "not NoneType"),
    (lambda s: nacre.open(["sample:dna", 5]), nacre.UsageError, "a list of paths, not of int"),
    (lambda s: nacre.from_gemmi("a.pdb"), nacre.UsageError, "a Structure, a Model or a Chain of gemmi, not str"),
    (lambda s: nacre.from_biopython(s), nacre.UsageError, "of Bio.PDB, not nacre.Structure"),
    (lambda s: nacre.open([PDB, "sample:dna"]), nacre.UsageError, "takes bytes alone"),
    (lambda s: nacre.open("sample:dna", fit=("/a", "/b")), nacre.UsageError, "name two"),
    (lambda s: s.render(fit=("/a", "/b")), nacre.UsageError, "is for open()"),
    (lambda s: nacre.open("sample:dna", size="3x3"), nacre.UsageError, 'open() takes no "size"'),
    (lambda s: s.render(siez=(3, 3)), nacre.UsageError, "(did you mean 'size'?)"),
    (lambda s: s.render(size="3by3"), nacre.UsageError, "size: expected"),
    (lambda s: s.render(size=(100000, 1)), nacre.UsageError, "size: "),
    (lambda s: s.render(background="navi"), nacre.UsageError, "navy"),
    (lambda s: s.render(hide="chian A"), nacre.UsageError, "chain"),
    (lambda s: s.render(style=object()), nacre.UsageError, "not JSON serializable"),
    (lambda s: s.render(zoom=float("nan")), nacre.UsageError, '"zoom": expected finite numbers, not nan'),
    (lambda s: s.render(size=(float("inf"), 3)), nacre.UsageError, '"size": expected finite numbers'),
    (lambda s: nacre.open("a\0b"), nacre.UsageError, "it contains a NUL character"),
    (lambda s: s.render(output="a.png"), nacre.UsageError, 'takes no "output"'),
    (lambda s: s.render(model=2), nacre.UsageError, "is for open()"),
    (lambda s: s.render(trajectory="a.dcd"), nacre.UsageError, "is for open()"),
    (lambda s: nacre.open(PDB, trajectory="a.dcd"), nacre.UsageError, "not its bytes"),
    (lambda s: s.render(device="no such device"), nacre.Error, "no such device"),
    (lambda s: s.save("a.gif"), nacre.UsageError, "save() takes a name"),
    (lambda s: s.save("/nowhere/a.png", **SMALL), nacre.Error, "/nowhere/a.png"),
    (lambda s: nacre.from_arrays([], []), nacre.UsageError, "positions"),
    (lambda s: nacre.from_arrays([[0, 0, 0]], ["Qq"]), nacre.UsageError, "no element 'Qq'"),
    (lambda s: nacre.from_arrays([[0, 0, float("nan")]], ["C"]), nacre.UsageError, "row 0"),
    (lambda s: nacre.from_arrays([[0, 0, 0]], ["C", "C"]), nacre.UsageError, "2 entries for 1 atoms"),
    (lambda s: nacre.from_arrays([[0, 0, 0]], ["C"], [[0, 1]]), nacre.UsageError, "atoms 0 to 0"),
    (lambda s: nacre.from_arrays([[0, 0, 0]], ["C"], [[0.5, 1]]), nacre.UsageError, "whole numbers"),
    (lambda s: nacre.from_arrays([[0, 0, 0]], ["C"], names=["a", "b"]), nacre.UsageError, "names has 2 entries"),
])
def test_errors_have_the_same_words(dna, call, kind, words):
    with pytest.raises(kind) as failure:
        call(dna)
    assert words in str(failure.value)


def test_after_an_error_it_draws_on(dna):
    before = dna.render(**SMALL)
    with pytest.raises(nacre.Error):
        dna.render(device="no such device", **SMALL)
    np.testing.assert_array_equal(dna.render(**SMALL), before)


def test_warnings_are_pythons(dna):
    with pytest.warns(UserWarning, match="chain Z"):
        dna.render(show="chain Z=licorice", **SMALL)


def test_threads_draw_what_one_draws(dna):
    structures = [dna, nacre.open("sample:glucose"), nacre.open("sample:buckyball")]
    alone = [s.render(**SMALL) for s in structures]
    wrong = []

    def work(k):
        for i in range(6):
            n = (i + k) % 3
            if not np.array_equal(structures[n].render(**SMALL), alone[n]):
                wrong.append((k, n))
    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert wrong == []


def test_others_run_while_it_draws(dna):
    """A thread counts on while another draws: the GIL is free."""
    count, done = 0, threading.Event()

    def counting():
        nonlocal count
        while not done.is_set():
            count += 1
            time.sleep(0)
    thread = threading.Thread(target=counting)
    thread.start()
    before = count
    nacre.open("sample:buckyball").render(size=(256, 256), occlusion=256, cache="off", supersample=2)
    during = count - before
    done.set()
    thread.join()
    assert during > 100


def test_options_are_the_command_lines():
    text = subprocess.run([PROGRAM, "help", "keywords"], capture_output=True, text=True, check=True).stdout
    keywords = {line.split(":")[0].strip() for line in text.splitlines()}
    ours = set(nacre.options())
    assert ours == keywords | {"cache"}
    assert (pathlib.Path(nacre.__file__).parent / "__init__.pyi").read_text().endswith(text)
    assert {"size", "color", "show", "occlusion"} <= ours


def test_colours_of_ones_own(dna):
    flat = {**SMALL, "occlusion": "off", "lighting": "off", "supersample": 1}
    rng = np.random.default_rng(1)
    colours = rng.integers(0, 256, (len(dna), 3))
    for style in ("spacefill", "ball-and-stick"):
        options = {**flat, "style": style}
        ids, picture = dna.layers(**options)["id"], dna.render(color=colours, **options)
        hit = ids > 0
        np.testing.assert_array_equal(picture[..., :3][hit], colours[ids[hit] - 1])
        np.testing.assert_array_equal(picture, dna.render(color=colours / 255, **options))
    # What a scheme has drawn before and after stays what it was.
    chain = dna.render(color="chain", **flat)
    np.testing.assert_array_equal(dna.render(color=[[255, 0, 0]] * len(dna), **flat), dna.render(color="#ff0000", **flat))
    np.testing.assert_array_equal(dna.render(color="chain", **flat), chain)
    for style in ("cartoon", "surface"):
        np.testing.assert_array_equal(dna.render(color=[[0, 0, 255]] * len(dna), style=style, **SMALL),
                                      dna.render(color="#0000ff", style=style, **SMALL))


def test_values_along_a_ramp(dna):
    flat = {**SMALL, "occlusion": "off", "lighting": "off", "style": "spacefill", "supersample": 1}
    ids = dna.layers(**flat)["id"]
    hit = ids > 0
    values = np.arange(len(dna), dtype=float)
    # The command line's own ramp over the same numbers.
    atoms = dna.atoms
    same = nacre.from_arrays(atoms["position"], atoms["element"], dna.bonds, names=atoms["name"], b_factors=values)
    np.testing.assert_array_equal(dna.render(color=values, **flat)[hit],
                                  same.render(color=f"b-factor:0..{len(dna) - 1}:viridis", **flat)[hit])
    np.testing.assert_array_equal(dna.render(color=values, color_limits=(400, 50), palette="plasma", **flat)[hit],
                                  same.render(color="b-factor:400..50:plasma", **flat)[hit])
    values[ids[hit][0] - 1] = np.nan
    grey = dna.render(color=values, **flat)[hit][0]
    assert grey[:3].tolist() == [0xc4, 0xbe, 0xb4]
    assert not np.array_equal(dna.render(color=values, legend=True, **flat), dna.render(color=values, **flat))
    dna.render(color=np.zeros(len(dna)), **flat)


def test_movies_are_the_command_lines(dna, tmp_path):
    size = {"size": (48, 32), "occlusion": "off"}
    subprocess.run([PROGRAM, "movie", "sample:dna", "-o", tmp_path / "a.png", "--spin", "x", "--turns", "0.5", "--seconds", "1",
                    "--fps", "5", "--size", "48x32", "--occlusion", "off"], check=True, capture_output=True)
    movie = dna.movie(tmp_path / "b.png", spin="x", turns=0.5, seconds=1, fps=5, **size)
    assert movie.frames == 5 and movie.data == (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert list(movie._repr_mimebundle_()) == ["image/png"]
    inline = dna.movie(seconds=0.2, **size)
    assert inline.frames == 3 and b"acTL" in inline.data
    assert dna.movie(tmp_path / "c.gif", rock=20, seconds=0.5, fps=10, **size).type == "image/gif"
    before = dna.render(**SMALL)
    dna.movie(color=np.zeros((len(dna), 3)), seconds=0.2, **size)
    np.testing.assert_array_equal(dna.render(**SMALL), before)


def test_movies_through_models(tmp_path):
    (tmp_path / "m.pdb").write_bytes(MODELS)
    size = {"size": (48, 32), "occlusion": "off"}
    subprocess.run([PROGRAM, "movie", tmp_path / "m.pdb", "-o", tmp_path / "a.png", "--models", "--fps", "10", "--size",
                    "48x32", "--occlusion", "off"], check=True, capture_output=True)
    for structure in (nacre.open(tmp_path / "m.pdb"), nacre.open(MODELS, name="m.pdb"),
                      pickle.loads(pickle.dumps(nacre.open(tmp_path / "m.pdb")))):
        assert structure.movie(models=True, fps=10, **size).data == (tmp_path / "a.png").read_bytes()


def test_morphs_are_the_command_lines(tmp_path):
    (tmp_path / "m.pdb").write_bytes(MODELS)
    size = {"size": (48, 32), "occlusion": "off"}

    def drawn(*words):
        subprocess.run([PROGRAM, "movie", *words, "-o", tmp_path / "a.png", "--morph", "--fps", "5", "--size", "48x32",
                        "--occlusion", "off"], check=True, capture_output=True)
        return (tmp_path / "a.png").read_bytes()

    models = nacre.open(tmp_path / "m.pdb")
    assert models.movie(morph=True, fps=5, **size).data == drawn(tmp_path / "m.pdb")
    assert models.movie(morph=True, loop=True, easing="stops", fps=5, **size).data == \
        drawn(tmp_path / "m.pdb", "--loop", "--easing", "stops")
    both = ["sample:dna", "sample:dna"]
    two = nacre.open(both, conformations=True)
    assert len(two) == 486 and two.frames == 2
    again = pickle.loads(pickle.dumps(two))
    assert two.movie(morph=True, fps=5, **size).data == again.movie(morph=True, fps=5, **size).data == drawn(*both)
    with pytest.raises(nacre.Error, match="it has one model"):
        nacre.open(both).movie(morph=True)
    with pytest.raises(nacre.UsageError, match="exclude each other"):
        models.movie(morph=True, models=True)
    with pytest.raises(nacre.UsageError, match="loop: it is for morph"):
        models.movie(loop=True)


def test_export_is_the_command_lines(dna, tmp_path):
    subprocess.run([PROGRAM, "export", "sample:dna", "-o", tmp_path / "a.ply", "--style", "cartoon"], check=True)
    dna.export(tmp_path / "b.ply", style="cartoon")
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()
    dna.export(tmp_path / "c.ply", style="cartoon", color=np.zeros((len(dna), 3)))
    assert (tmp_path / "c.ply").read_bytes() != (tmp_path / "b.ply").read_bytes()


def test_the_command_of_the_package(tmp_path):
    """As a module, and as the script of a wheel, which starts without numpy."""
    version = subprocess.run([PROGRAM, "--version"], check=True, capture_output=True).stdout
    script = tmp_path / "bin/nacre"
    script.parent.mkdir()
    script.write_text(f"#!{sys.executable}\n" + (pathlib.Path(nacre.__file__).parent / "__main__.py").read_text())
    script.chmod(0o755)
    assert subprocess.run([sys.executable, "-m", "nacre", "--version"], check=True, capture_output=True).stdout == version
    (tmp_path / "numpy.py").write_text("raise SystemExit('numpy is imported')\n")
    found = [str(tmp_path), *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(found)}
    assert subprocess.run([script, "--version"], env=environment, check=True, capture_output=True).stdout == version
    # A package without a program does not start the script again.
    (tmp_path / "nacre").mkdir()
    (tmp_path / "nacre/__init__.py").touch()
    alone = subprocess.run([script], env=environment | {"PATH": str(script.parent)}, capture_output=True, text=True, timeout=60)
    assert (alone.returncode, alone.stderr) == (1, "nacre: error: no program: not in the package nacre, not along PATH\n")
