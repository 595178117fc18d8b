# SPDX-License-Identifier: MIT
import json
import os
import pathlib
import re
import subprocess
import sys

import pytest

PROJECT = pathlib.Path(__file__).parents[2]
EXAMPLES = re.findall(r"^## (.*?)$.*?^```python\n(.*?)^```", (PROJECT / "docs/python.md").read_text(encoding="utf-8"),
                      re.M | re.S)


@pytest.mark.parametrize("code", [code for _, code in EXAMPLES], ids=[title for title, _ in EXAMPLES])
def test_the_example_of_the_manual_runs(code, tmp_path):
    subprocess.run([sys.executable, "-W", "error", "-c", code], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)


def test_every_section_of_the_manual_has_an_example():
    assert len(EXAMPLES) == 7


@pytest.mark.parametrize("path", sorted((PROJECT / "docs/notebooks").glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_notebook_is_kept_without_outputs_and_its_links_lead_somewhere(path):
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in cells if cell["cell_type"] == "code")
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
