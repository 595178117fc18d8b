# SPDX-License-Identifier: MIT
import base64
import contextlib
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import types
import unittest.mock

import kept_notebook
import pytest

PROJECT = pathlib.Path(__file__).parents[2]
EXAMPLES = re.findall(r"^## (.*?)$.*?^```python\n(.*?)^```", (PROJECT / "docs/python.md").read_text(encoding="utf-8"),
                      re.M | re.S)


@pytest.mark.parametrize("code", [code for _, code in EXAMPLES], ids=[title for title, _ in EXAMPLES])
def test_the_example_of_the_manual_runs(code, tmp_path):
    subprocess.run([sys.executable, "-W", "error", "-c", code], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)


def test_every_section_of_the_manual_has_an_example():
    assert len(EXAMPLES) == 7


def undrawn():
    """matplotlib, which these tests do not have, drawing nothing."""
    pyplot = unittest.mock.MagicMock()
    pyplot.subplots = lambda rows=1, columns=1, **_: (pyplot, pyplot if rows * columns == 1 else [pyplot] * (rows * columns))
    return {"matplotlib": types.SimpleNamespace(pyplot=pyplot), "matplotlib.pyplot": pyplot}


# ./dev examples runs them in Jupyter, with their pictures.
@pytest.mark.parametrize("path", kept_notebook.ALL, ids=lambda path: path.stem)
def test_a_notebook_prints_what_is_kept_in_it(path, monkeypatch):
    for name, module in undrawn().items():
        monkeypatch.setitem(sys.modules, name, module)
    names = {}
    for cell in kept_notebook.code_cells(path):
        with contextlib.redirect_stdout(io.StringIO()) as made:
            exec("".join(cell["source"]), names)
        assert kept_notebook.differences(kept_notebook.printed(cell), made.getvalue()) == [], \
            "FANTAIL_WRITE_MANUAL=1 ./dev examples keeps what is printed now"


@pytest.mark.parametrize("path", kept_notebook.ALL, ids=lambda path: path.stem)
def test_a_kept_picture_is_there_for_each_figure_and_small(path):
    for cell in kept_notebook.code_cells(path):
        pictures = [base64.b64decode(picture) for picture in kept_notebook.pictures(cell)]
        assert len(pictures) == "".join(cell["source"]).count("plt.subplots(")
        assert all(picture.startswith(b"\x89PNG") and len(picture) < 60_000 for picture in pictures)


def test_kept_texts_may_differ_by_rounding_and_by_nothing_else():
    assert kept_notebook.differences("rests at -29.7 degrees", "rests at  -29.8 degrees") == []
    assert kept_notebook.differences("rests at -29.7 degrees", "rests at -29.9 degrees") == ["-29.7 is kept, -29.9 is printed"]
    assert kept_notebook.differences("rests at -29.7 degrees", "rests at 29.7 degrees") == ["-29.7 is kept, 29.7 is printed"]
    assert len(kept_notebook.differences("tasha3_launch2 held", "tasha3_launch1 held")) == 1
    assert len(kept_notebook.differences("held", "not held")) == 1
    assert len(kept_notebook.differences("90 of 128 runs", "91 of 128 runs")) == 1


@pytest.mark.parametrize("path", kept_notebook.ALL, ids=lambda path: path.stem)
def test_a_notebook_has_no_path_of_a_machine_and_its_links_lead_somewhere(path):
    printed = "".join(map(kept_notebook.printed, kept_notebook.code_cells(path)))
    assert printed and not re.search(r"/\w+/|0x[0-9a-f]{6}| object at ", printed)
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    links = re.findall(r"\]\(([^)#]+)", "".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"))
    assert links and all((path.parent / link).is_file() for link in links)


def test_the_stubs_are_what_nanobind_makes_of_the_module(tmp_path):
    made = tmp_path / "_core.pyi"
    subprocess.run([sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "fantail._core", "-o", made], check=True)
    kept = (PROJECT / "python/fantail/_core.pyi").read_text(encoding="utf-8")
    assert made.read_text(encoding="utf-8") == kept.partition("\n")[2]  # the first line is the licence


def test_the_versions_that_pip_builds_with_are_those_of_the_tests():
    pinned = (PROJECT / "test/python/requirements.txt").read_text(encoding="utf-8").splitlines()
    project = (PROJECT / "pyproject.toml").read_text(encoding="utf-8")
    assert next(line for line in pinned if line.startswith("nanobind==")) in project


# Read as text: Python 3.10 cannot read TOML.
def test_the_package_has_the_version_of_the_programs():
    project = (PROJECT / "pyproject.toml").read_text(encoding="utf-8")
    assert 'dynamic = ["version"]' in project and '\ninput = "CMakeLists.txt"\n' in project
    rule = re.search(r"^regex = '(.*)'$", project, re.MULTILINE)[1]
    version = re.search(rule, (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)["value"]
    said = subprocess.run([os.environ["FANTAIL_PROGRAM"], "--version"], capture_output=True, text=True, check=True).stdout
    assert said.split()[1] == version
