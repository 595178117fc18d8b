# SPDX-License-Identifier: MIT
"""Notebooks as they are kept: their code, what it printed, and how that is compared with what it prints now."""
import json
import pathlib
import re

FOLDER = pathlib.Path(__file__).parents[1] / "docs/notebooks"
ALL = sorted(FOLDER.glob("*.ipynb"))
# With decimals: others are counts, and 2.0.1 is a version.
NUMBER = re.compile(r"(?<![\w.])-?\d+\.\d+(?![\w.]*\w)")


def code_cells(path):
    return [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]


def printed(cell):
    return "".join("".join(output["text"]) for output in cell["outputs"] if output["output_type"] == "stream")


def pictures(cell):
    """As they lie in the file: base64, perhaps in lines."""
    return ["".join(output["data"]["image/png"]) for output in cell["outputs"] if "image/png" in output.get("data", {})]


def differences(kept, made):
    """Of two texts. A number may differ by one in its last digit: another processor or library rounds otherwise."""
    if NUMBER.sub("#", " ".join(kept.split())) != NUMBER.sub("#", " ".join(made.split())):
        return [f"{kept!r} is kept, {made!r} is printed"]
    pairs = zip(NUMBER.findall(kept), NUMBER.findall(made))
    return [f"{a} is kept, {b} is printed" for a, b in pairs if abs(float(a) - float(b)) > 1.01 * 10.0 ** -len(a.partition(".")[2])]
