# SPDX-License-Identifier: MIT
"""The notebooks in Jupyter. With FANTAIL_WRITE_MANUAL=1 what they print and draw is kept in them."""
import base64
import io
import json
import os
import pathlib
import sys

import nbclient
import nbformat
import PIL.Image
import pytest

sys.path.append(str(pathlib.Path(__file__).parents[1]))
import kept_notebook


def small(picture):
    """A drawing has few colours."""
    file = io.BytesIO()
    with PIL.Image.open(io.BytesIO(base64.b64decode(picture))) as image:
        image.convert("RGB").quantize(64).save(file, "png", optimize=True)
    return base64.b64encode(file.getvalue()).decode()


def keep(path, cells):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    of_code = (cell for cell in notebook["cells"] if cell["cell_type"] == "code")
    for number, (kept, made) in enumerate(zip(of_code, cells, strict=True), 1):
        kept["execution_count"] = number
        text, kept["outputs"] = kept_notebook.printed(made), []
        if text:
            kept["outputs"].append({"name": "stdout", "output_type": "stream", "text": text.splitlines(keepends=True)})
        for picture in kept_notebook.pictures(made):
            kept["outputs"].append({"data": {"image/png": small(picture)}, "metadata": {}, "output_type": "display_data"})
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


@pytest.mark.parametrize("path", kept_notebook.ALL, ids=lambda path: path.stem)
def test_a_notebook_runs_and_its_outputs_are_those_that_are_kept(path):
    run = nbclient.NotebookClient(nbformat.read(path, as_version=4), timeout=120, kernel_name="python3", record_timing=False,
                                  resources={"metadata": {"path": str(path.parent)}}).execute()
    cells = [cell for cell in run.cells if cell.cell_type == "code"]
    assert not [output for cell in cells for output in cell.outputs if output.get("name") == "stderr"]
    if os.environ.get("FANTAIL_WRITE_MANUAL"):
        keep(path, cells)
    for kept, made in zip(kept_notebook.code_cells(path), cells, strict=True):
        assert kept_notebook.differences(kept_notebook.printed(kept), kept_notebook.printed(made)) == []
        assert len(kept_notebook.pictures(kept)) == len(kept_notebook.pictures(made))
