"""The notebook of the docs runs from its beginning to its end."""
import os
import pathlib

import pytest


def test_notebook_runs():
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    notebook = nbformat.read(pathlib.Path(os.environ["NACRE_SOURCE"]) / "docs/python/nacre.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=120).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    assert any("image/png" in output.get("data", {}) for output in outputs)
    assert any("<nacre.Movie: 20 frames" in output.get("data", {}).get("text/plain", "") for output in outputs)
    assert any("did you mean 'navy'" in output.get("text", "") for output in outputs)
