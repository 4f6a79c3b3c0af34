"""nacre.open() of other packages' structures, of files and of addresses; atoms as a pandas frame."""
import gzip
import http.server
import io
import os
import pathlib
import threading

import nacre
import numpy as np
import pytest

WRITTEN = pathlib.Path(os.environ.get("NACRE_WRITTEN_FILES", "."))
PEPTIDE = """\
ATOM      1  N   ALA A   7       0.000   0.000   0.000  1.00 10.00           N  
ATOM      2  CA  ALA A   7       1.458   0.000   0.000  1.00 20.00           C  
ATOM      3  C   ALA A   7       2.009   1.420   0.000  0.50 30.00           C  
ATOM      4  O   ALA A   7       1.251   2.390   0.000  1.00 40.00           O  
ATOM      5  CB  ALA A   7       1.988  -0.773  -1.199  1.00 50.00           C  
HETATM    6 CA    CA B   9       6.000   0.000   0.000  1.00 60.00          CA  
END
"""


@pytest.fixture
def peptide(tmp_path):
    (tmp_path / "peptide.pdb").write_text(PEPTIDE)
    return tmp_path / "peptide.pdb"


def same_atoms(structure, other):
    for key in ("element", "name", "residue_name", "residue_number", "chain"):
        assert structure.atoms[key].tolist() == other.atoms[key].tolist(), key
    np.testing.assert_allclose(structure.atoms["position"], other.atoms["position"], atol=2e-3)


def test_files_and_addresses(peptide, tmp_path):
    of_path = nacre.open(peptide)
    with open(peptide) as text, open(peptide, "rb") as data:
        same_atoms(nacre.open(text), of_path)
        same_atoms(nacre.open(data), of_path)
    same_atoms(nacre.open(io.StringIO(PEPTIDE)), of_path)
    same_atoms(nacre.open(io.BytesIO(gzip.compress(PEPTIDE.encode())), name="a.pdb.gz"), of_path)

    class Handler(http.server.BaseHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def do_GET(self):
            self.send_response(200 if self.path == "/a/peptide.pdb?x=1" else 404)
            self.end_headers()
            self.wfile.write(PEPTIDE.encode())

    server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        base = f"http://127.0.0.1:{server.server_port}"
        fetched = nacre.open(base + "/a/peptide.pdb?x=1")
        assert fetched.name == "peptide.pdb"
        same_atoms(fetched, of_path)
        with pytest.raises(nacre.Error, match="cannot download: http.*Not Found"):
            nacre.open(base + "/none.pdb")
    finally:
        server.shutdown()
        server.server_close()


def test_mdanalysis(peptide, tmp_path):
    mda = pytest.importorskip("MDAnalysis")
    universe = mda.Universe(str(peptide))
    same_atoms(nacre.open(universe), nacre.open(peptide))
    assert nacre.open(universe).atoms["b_factor"].tolist() == [10, 20, 30, 40, 50, 60]
    some = nacre.open(universe.select_atoms("resname CA"))
    assert (some.atoms["element"].tolist(), some.atoms["residue_number"].tolist()) == (["Ca"], [9])
    # Without elements: CA of a residue is carbon, CA alone is calcium.
    bare = mda.Universe.empty(2, n_residues=2, atom_resindex=[0, 1], trajectory=True)
    bare.add_TopologyAttr("names", ["CA", "CA"])
    bare.add_TopologyAttr("resnames", ["ALA", "CA"])
    assert nacre.open(bare).atoms["element"].tolist() == ["C", "Ca"]
    # Frames of a trajectory.
    coordinates = np.stack([universe.atoms.positions + i for i in range(3)])
    moving = nacre.open(universe.load_new(coordinates))
    assert moving.frames == 3
    np.testing.assert_allclose(moving.frame(3).atoms["position"], coordinates[2])
    assert universe.trajectory.frame == 0  # as it was


def test_mdtraj(peptide):
    mdtraj = pytest.importorskip("mdtraj")
    trajectory = mdtraj.load(str(peptide))
    structure = nacre.open(trajectory)
    for key in ("element", "name", "residue_name", "residue_number"):
        assert structure.atoms[key].tolist() == nacre.open(peptide).atoms[key].tolist()
    np.testing.assert_allclose(structure.atoms["position"], nacre.open(peptide).atoms["position"], atol=2e-3)
    assert len(structure.bonds) == trajectory.topology.n_bonds
    two = mdtraj.join([trajectory, trajectory])
    two.xyz[1] += 0.1
    assert nacre.open(two).frames == 2
    np.testing.assert_allclose(nacre.open(two).frame(2).atoms["position"], two.xyz[1] * 10, atol=2e-3)


def test_rdkit():
    Chem = pytest.importorskip("rdkit.Chem")
    from rdkit.Chem import AllChem

    aspirin = Chem.AddHs(Chem.MolFromSmiles("CC(=O)Oc1ccccc1C(=O)O"))
    with pytest.raises(nacre.UsageError, match="no conformer"):
        nacre.open(aspirin)
    AllChem.EmbedMolecule(aspirin, randomSeed=1)
    structure = nacre.open(aspirin)
    assert structure.atoms["element"].tolist() == [atom.GetSymbol() for atom in aspirin.GetAtoms()]
    np.testing.assert_allclose(structure.atoms["position"], aspirin.GetConformer().GetPositions(), atol=1e-3)
    assert len(structure.bonds) == aspirin.GetNumBonds()
    # Charges come along.
    acid = Chem.MolFromSmiles("CC(=O)[O-]")
    AllChem.EmbedMolecule(acid, randomSeed=1)
    assert nacre.open(acid).atoms["charge"].sum() == -1
    # Conformers are frames; residues of a PDB file stay.
    AllChem.EmbedMultipleConfs(aspirin, 3, randomSeed=1)
    assert nacre.open(aspirin).frames == 3
    np.testing.assert_allclose(nacre.open(aspirin).frame(2).atoms["position"], aspirin.GetConformer(1).GetPositions(), atol=1e-3)
    glycine = Chem.MolFromSequence("GA")
    AllChem.EmbedMolecule(glycine, randomSeed=1)
    assert set(nacre.open(glycine).atoms["residue_name"]) == {"GLY", "ALA"}


def test_each_is_drawn(peptide):
    mdtraj = pytest.importorskip("mdtraj")
    picture = nacre.open(mdtraj.load(str(peptide))).render(size=(48, 48), style="ball-and-stick")
    assert (picture[..., :3] != 255).any()


def test_others_objects_are_refused():
    with pytest.raises(nacre.UsageError, match="not set"):
        nacre.open({1, 2})
    with pytest.raises(nacre.UsageError, match="from_gemmi|not gemmi"):
        import gemmi

        nacre.open(gemmi.UnitCell())


def test_atoms_as_a_frame(peptide):
    pytest.importorskip("pandas")
    frame = nacre.open(peptide).atoms.to_frame()
    assert list(frame.columns) == ["x", "y", "z", "element", "name", "residue_name", "residue_number", "insertion_code", "altloc",
                                   "chain", "model", "b_factor", "occupancy", "charge", "hetero", "secondary_structure"]
    assert frame.groupby("chain")["b_factor"].mean().to_dict() == {"A": 30, "B": 60}
    assert frame.query("element == 'C'")["name"].tolist() == ["CA", "C", "CB"]


def test_the_command_by_python():
    import subprocess
    import sys

    run = subprocess.run([sys.executable, "-m", "nacre", "--version"], capture_output=True, text=True)
    assert run.returncode == 0 and run.stdout.startswith(f"nacre {nacre.__version__} ")
