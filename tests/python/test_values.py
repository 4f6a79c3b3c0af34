"""What options of pictures take in Python: masks, tables, booleans, frames; interactions; and arrays of atoms."""
import json
import os
import pathlib
import re
import subprocess
import warnings

import numpy as np
import pytest

import nacre

PROGRAM = os.environ["NACRE_PROGRAM"]
SMALL = {"size": (48, 32), "occlusion": 4, "occlusion_detail": 8, "cache": "off"}
ATOM = b"ATOM  %5d  %-3s%sALA A%4d%s   %8.3f%8.3f%8.3f  1.00  0.00           %s\n"


@pytest.fixture(scope="module")
def dna():
    return nacre.open("sample:dna")


def test_masks_are_selections(dna):
    mask = dna.select("chain A")
    drawn = dna.render(show=[(mask, "licorice")], hide=~mask, zoom_to=mask, **SMALL)
    np.testing.assert_array_equal(drawn, dna.render(show="chain A=licorice", hide="not chain A", zoom_to="chain A", **SMALL))
    for pairs in ([("chain A", "licorice")], (mask, "licorice")):
        np.testing.assert_array_equal(dna.render(show=pairs, **SMALL), dna.render(show="chain A=licorice", **SMALL))
    np.testing.assert_array_equal(dna.render(color_by=[(mask, "red"), (~mask, "blue")], **SMALL),
                                  dna.render(color_by=["chain A=red", "chain B=blue"], **SMALL))
    other, atoms = dna.select("chain B"), (dna.select("/A:1@C1'"), dna.select("/B:24@C1'"))
    for name, masks, text in (("interface", (mask, other), "chain A,chain B"), ("interface", ("chain A", "chain B"), "chain A,chain B"),
                              ("interactions", (mask, other), "chain A,chain B"), ("measure", atoms, "/A:1@C1',/B:24@C1'"),
                              ("measure", [("/A:1@C1'", atoms[1])], "/A:1@C1',/B:24@C1'")):
        np.testing.assert_array_equal(dna.render(**{name: masks}, **SMALL), dna.render(**{name: text}, **SMALL), name)
    assert dna.info(interactions=(mask, other)) == dna.info(interactions="chain A,chain B")
    with pytest.raises(nacre.UsageError, match=r'"hide": a mask has one value for each of the 486 atoms, not the shape \(3,\)'):
        dna.render(hide=np.array([True, False, True]), **SMALL)


def test_tables_are_frames_dicts_and_rows(dna):
    columns = {"chain": ["A", "B"], "value": [1.0, 2.0]}
    rows = [{"chain": "A", "value": 1.0}, {"chain": "B", "value": 2.0}]
    wanted = dna.render(color_from=json.dumps(rows), **SMALL)
    tables = [columns, rows, {"chain": np.array(["A", "B"]), "value": np.array([1.0, 2.0])}]
    pandas = pytest.importorskip("pandas")
    for table in [*tables, pandas.DataFrame(columns)]:
        np.testing.assert_array_equal(dna.render(color_from=table, **SMALL), wanted)
    gap = pandas.DataFrame({"chain": ["A", "B"], "value": [1.0, float("nan")]})
    np.testing.assert_array_equal(dna.render(color_from=gap, **SMALL), dna.render(color_from=rows[:1], **SMALL))


def test_booleans_switch_on_and_off(dna):
    for key, value, text in (("fog", True, "auto"), ("fog", False, "off"), ("occlusion", False, "off"), ("halos", False, "off"),
                             ("gaps", True, "dashed"), ("bond_orders", False, "off"), ("carbohydrates", True, "on"),
                             ("water", True, "show"), ("hydrogens", False, "hide"), ("scale_bar", True, "angstrom")):
        options = SMALL | {"style": "licorice"}
        np.testing.assert_array_equal(dna.render(**options | {key: value}), dna.render(**options | {key: text}), key)
    with pytest.raises(nacre.UsageError, match='"halos": expected a text or a number, not true'):
        dna.render(halos=True, **SMALL)


def test_long_values_do_not_fill_errors(dna):
    for options in ({"zoom": np.arange(5000.0)}, {"title": list(range(5000))}, {"show": [[1] * 5000]},
                    {"clip": np.full(5000, np.nan)}, {"zoom": {str(i): i for i in range(5000)}}):
        with pytest.raises(nacre.UsageError) as failure:
            dna.render(**options, **SMALL)
        assert len(str(failure.value)) < 200, failure.value


def test_pictures_are_of_a_frame(tmp_path):
    models = b"".join(b"MODEL     %4d\n" % i + ATOM % (1, b"CA", b" ", 1, b" ", 5.0 * i, 0, 0, b"C") + b"ENDMDL\n" for i in (0, 1, 2))
    moving = nacre.open(models, name="m.pdb")
    np.testing.assert_array_equal(moving.layers(frame=3, **SMALL)["z"], moving.frame(3).layers(**SMALL)["z"])
    np.testing.assert_array_equal(moving.render(frame=2, **SMALL), moving.frame(2).render(**SMALL))
    moving.save(tmp_path / "a.png", frame=3, **SMALL)
    moving.frame(3).save(tmp_path / "b.png", **SMALL)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    with pytest.raises(nacre.UsageError, match="frames 1 to 3"):
        moving.render(frame=4, **SMALL)


def test_arrays_tell_conformers_and_folds():
    text = ATOM % (1, b"CA", b" ", 7, b"B", 0, 0, 0, b"C") + ATOM % (2, b"CB", b"A", 7, b"B", 1.5, 0, 0, b"C")
    atoms = nacre.open(text, name="a.pdb").atoms
    assert atoms["insertion_code"].tolist() == ["B", "B"] and atoms["altloc"].tolist() == ["", "A"]
    assert atoms["secondary_structure"].tolist() == ["coil", "coil"]
    assert set(nacre.open("sample:dna").atoms["secondary_structure"]) == {""}


def test_interactions_are_the_command_lines(dna):
    mask = dna.select("chain A")
    said = subprocess.run([PROGRAM, "info", "sample:dna", "--interactions", "chain A", "--interaction-kinds", "hydrogen-bond", "--json"],
                          capture_output=True, text=True, check=True).stdout
    wanted = json.loads(said)[0]["interactions"]
    for selection in ("chain A", mask):
        assert dna.info(interactions=selection, interaction_kinds="hydrogen-bond")["interactions"] == wanted
    assert len(wanted) >= 32 and "interactions" not in dna.info()
    with pytest.raises(nacre.UsageError, match="hydrogen-bond"):
        dna.info(interactions="all", interaction_kinds="hbond")


def test_examples_of_the_docs_have_the_stubs_types(tmp_path):
    """mypy over every program in the docs."""
    mypy = pytest.importorskip("mypy.api")
    docs = pathlib.Path(os.environ["NACRE_SOURCE"]) / "docs"
    programs = []
    for page in [*sorted(docs.glob("*.md")), docs.parent / "README.md"]:
        for i, code in enumerate(re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)):
            program = tmp_path / f"{page.stem.lower()}_{i}.py"
            program.write_text(code)
            programs.append(str(program))
    assert len(programs) >= 12
    out, _, code = mypy.run([*programs, "--no-incremental", "--cache-dir", str(tmp_path), "--ignore-missing-imports",
                             "--enable-incomplete-feature=Unpack", "--scripts-are-modules"])
    assert code == 0, out


# Values that work, and what a type checker must take, therefore.
WORKING = """
clip=0, clip=(-5, 5), fog=(0, 10), fog=True, center=(1, 2, 3), center=mask, pan=[1, 2], orientation=(1, 0, 0, 0)
rotate=np.array([0, 90, 0]).tolist(), water=True, hydrogens=False, scale_bar=True, cavities=False, disulfides=True, msaa=False
text_size=20, depth=16, occlusion_detail=8, thumbnail=32, map_level=0.5, map_level=[0.5, 0.7], map_opacity=0.5
look=pathlib.Path("look.json"), interface=(mask, ~mask), interface=("chain A", "chain B"), interactions=(mask, ~mask)
map_around=(mask, 2.5), measure=(1, 2), measure=[(1, 2), (1, 2, 3)], measure=["1,2"], show=(mask, "licorice")
show=[(mask, "licorice"), "chain B=cartoon"], hide=[mask, "chain A and name P"], label=[("chain A", "{chain}")], color=[[1, 0, 0]] * 486
""".replace("\n", ", ")


def test_stubs_take_what_works(dna, tmp_path, monkeypatch):
    (tmp_path / "look.json").write_text('{"halos": 3}')
    monkeypatch.chdir(tmp_path)
    calls = [f"dna.render({one})" for one in re.split(r", (?=\w+=)", WORKING.strip(", "))]
    assert len(calls) > 30
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for call in calls:
            eval(call.replace("dna.render(", "draw("), {"draw": lambda **given: dna.render(**{**SMALL, **given}), "np": np,
                                                        "pathlib": pathlib, "mask": dna.select("chain A")})
    mypy = pytest.importorskip("mypy.api")
    program = tmp_path / "use.py"
    program.write_text("import pathlib\nimport nacre\nimport numpy as np\ndna = nacre.open('sample:dna')\n"
                       "mask = dna.select('chain A')\n" + "\n".join(calls) + "\n")
    out, _, code = mypy.run([str(program), "--no-incremental", "--cache-dir", str(tmp_path), "--ignore-missing-imports",
                             "--enable-incomplete-feature=Unpack"])
    assert code == 0, out
