# SPDX-License-Identifier: MIT
# trace.py against small trees with one fault each. Usage: trace_test.py TRACE_PY
import pathlib
import subprocess
import sys
import tempfile

SAFETY = """# Safety case
## Hazards
| | hazard | does |
|---|---|---|
| H1 | a canard moves | [LIM-1](#lim-1), [PHS-1](#phs-1) |
## Requirements
| number | requirement | made in | shown by |
|---|---|---|---|
| <a id="lim-1"></a>LIM-1 | stays within | `core/mixer` | `Mixer.StaysWithin`, `proof mixer` |
| <a id="phs-1"></a>PHS-1 | begins late | `core/phase` | `Phase.*`, `figures detection` |
"""
TREE = {
    "docs/safety.md": SAFETY,
    "docs/figures/soak.md": "# Soak\n\n## False launches <a id=\"detection\"></a>\n",
    "docs/evidence.md": "## What is proved\n\n| `mixer` | `core/mixer` | each command stays within its limits |\n\n## What it takes\n",
    "firmware/core/mixer.cpp": "// Meets LIM-1.\nint a;\n",
    "firmware/core/phase.hpp": "int b;\n  // Meets PHS-1.\n",
    "hal/x.cpp": "int c;\n",
    "tools/link/x.cpp": "int d;\n",
    "test/core/mixer_test.cpp": "int e;\nTEST(Mixer, StaysWithin) {}\nTEST_F(Phase, BeginsLate) {}\nTEST_F(Phase, AndStops) {}\n",
    "test/proof/proofs.py": 'PROOFS = [\n    Proof("mixer", "stays within its limits")]\n',
}


def run(tree, *options):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in tree.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        said = subprocess.run([sys.executable, sys.argv[1], root, *options], capture_output=True, text=True, check=False)
        page = root / "docs/trace.md"
        return said.returncode, said.stderr, page.read_text() if page.exists() else ""


def changed(**replaced):
    tree = dict(TREE)
    for name, (before, after) in replaced.items():
        path = next(path for path in tree if path.replace("/", "_").replace(".", "_") == name)
        assert before in tree[path], (path, before)
        tree[path] = tree[path].replace(before, after)
    return tree


def expect_fault(sentence, tree, *options):
    code, said, page = run(tree, *options)
    assert code == 1 and sentence in said, f"wanted \"{sentence}\" and exit code 1, not {code}: {said}"
    assert not page, "a page was written in spite of a fault"


def main():
    code, said, page = run(TREE)
    assert (code, said) == (0, ""), said
    assert "[mixer.cpp:1](../firmware/core/mixer.cpp#L1)" in page, page
    assert "[Mixer.StaysWithin](../test/core/mixer_test.cpp#L2)" in page, page
    assert "[proof mixer](../test/proof/proofs.py#L2)" in page, page
    assert "[figures detection](figures/soak.md#detection)" in page, page
    assert run({**TREE, "docs/trace.md": page}, "--check")[0] == 0

    # The number of a requirement leads to its row, in the safety case and from the page; its text is not repeated.
    assert '| <a id="lim-1"></a>[LIM-1](safety.md#lim-1) | [mixer.cpp:1]' in page and "stays within" not in page, page
    assert "a canard moves" not in page, page
    expect_fault("names PHS-9, which is no requirement", changed(docs_safety_md=("| stays within |", "| as [PHS-9](#phs-9) |")))
    expect_fault("[PHS-1](#lim-1) leads elsewhere", changed(docs_safety_md=("| stays within |", "| as [PHS-1](#lim-1) |")))
    expect_fault("[PHS-1] leads elsewhere", changed(docs_safety_md=("| stays within |", "| as [PHS-1] |")))
    expect_fault("PHS-1 has no anchor", changed(docs_safety_md=('<a id="phs-1"></a>', "")))

    # A test that is not compiled, or that does nothing, is none.
    test = TREE["test/core/mixer_test.cpp"]
    whole = "TEST(Mixer, StaysWithin) {}\n"
    for unseen in ("#if 0\n" + whole + "#endif\n", "/*\n" + whole + "*/\n", "// " + whole,
                   "TEST(Mixer, StaysWithin) {\n  GTEST_SKIP();\n}\n"):
        expect_fault("LIM-1 names Mixer.StaysWithin, which does not exist", {**TREE, "test/core/mixer_test.cpp": test.replace(whole, unseen)})
    assert run({**TREE, "test/core/mixer_test.cpp": test.replace(whole, "#if LINUX\n" + whole + "#endif\n")})[0] == 0
    expect_fault("PHS-1 is not read there", changed(firmware_core_mixer_cpp=("Meets LIM-1.", "Meets LIM-1 and PHS-1.")))
    below = TREE["docs/safety.md"] + "\n## Rules\n\n| g | met | outputs by [LIM-9] |\n"
    expect_fault("docs/safety.md: names LIM-9, which is no requirement", {**TREE, "docs/safety.md": below})
    # A page of figures is no statement.
    expect_fault("does not state the proof mixer", changed(docs_evidence_md=("| `core/mixer` | each command stays within its limits |", "| 3 | 2 of 2 | 89 | 341 |")))
    expect_fault("LIM-1 names Mixer.StaysWithin, which does not exist", changed(test_core_mixer_test_cpp=("StaysWithin", "StaysInside")))
    expect_fault("nothing in the code says that it meets LIM-1", changed(firmware_core_mixer_cpp=("Meets LIM-1.", "")))
    expect_fault("LIM-1 is made in core/mixer, but no comment there", changed(firmware_core_mixer_cpp=("Meets LIM-1.", "")))
    expect_fault("mixer.cpp:1: meets LIM-9, which", changed(firmware_core_mixer_cpp=("Meets LIM-1", "Meets LIM-9")))
    expect_fault("x.cpp:1: meets LIM-1, but docs/safety.md does not name this file", changed(hal_x_cpp=("int c;", "int c;  // Meets LIM-1.")))
    expect_fault("PHS-1 has no evidence", changed(docs_safety_md=("`Phase.*`, `figures detection`", "none")))
    expect_fault("nothing in docs/safety.md or docs/evidence.md names the figures detection", changed(docs_safety_md=(", `figures detection`", "")))
    linked = changed(docs_safety_md=(", `figures detection`", ""))
    for page_of_it in ("docs/safety.md", "docs/evidence.md"):
        more = {**linked, page_of_it: linked[page_of_it] + "\nHow [often](figures/soak.md#detection) it is wrong.\n"}
        assert run(more)[:2] == (0, ""), run(more)
    expect_fault("there are no figures misses in docs/figures", changed(docs_safety_md=("## Requirements", "[x](figures/soak.md#misses)\n## Requirements")))
    expect_fault("no requirement in docs/safety.md names the proof mixer", changed(docs_safety_md=(", `proof mixer`", "")))
    expect_fault("names proof mixture, which does not exist", changed(docs_safety_md=("`proof mixer`", "`proof mixture`")))
    expect_fault("no hazard names PHS-1", changed(docs_safety_md=(", [PHS-1](#phs-1)", "")))
    expect_fault("hazard H1 names ARM-1, which is no requirement", changed(docs_safety_md=("[LIM-1](#lim-1),", "[LIM-1](#lim-1), ARM-1,")))
    expect_fault("LIM-1 is there twice", changed(docs_safety_md=("PHS-1 | begins", "LIM-1 | begins")))
    expect_fault("has four cells", changed(docs_safety_md=("PHS-1 | begins late |", "PHS-1 |")))
    expect_fault("no table below the heading Requirements", changed(docs_safety_md=("## Requirements", "## Wishes")))

    code, said, _ = run({**TREE, "docs/trace.md": page + "\n"}, "--check")
    assert code == 1 and "docs/trace.md is not what the code says" in said, said
    code, said, _ = run(TREE, "--check")
    assert code == 1 and "docs/trace.md is not what the code says" in said, said
    assert run(TREE, "--czech")[0] == 64


main()
