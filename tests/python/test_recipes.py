"""Every recipe of docs/recipes.md runs, in a folder of its own, and writes the files that it names."""
import os
import pathlib
import re
import subprocess
import sys

import pytest

PAGE = (pathlib.Path(os.environ["NACRE_SOURCE"]) / "docs/recipes.md").read_text()
RECIPES = [(title, code) for title, code in re.findall(r"^## (.+?)\n.*?```python\n(.*?)```", PAGE, re.M | re.S)]
MODULES = {"rdkit": "python3-rdkit", "MDAnalysis": "python3-mdanalysis", "mdtraj": "python3-mdtraj"}


def test_none_is_missed():
    assert len(RECIPES) == PAGE.count("\n## ") == PAGE.count("```python\n") >= 10


@pytest.mark.parametrize("code", [code for _, code in RECIPES], ids=[title for title, _ in RECIPES])
def test_recipe(code, tmp_path):
    for module in MODULES:
        if re.search(rf"^(import|from) {module}\b", code, re.M):
            pytest.importorskip(module)
    if ".to_frame()" in code:
        pytest.importorskip("pandas")
    run = subprocess.run([sys.executable, "-B", "-W", "ignore", "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    for name in re.findall(r'(?:save|movie)\("([^"]+)"', code):
        assert (tmp_path / name).stat().st_size > 200, name
