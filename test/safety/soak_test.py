# SPDX-License-Identifier: MIT
# soak.py with steps that pass, fail, die and say nothing, and the page that figures.py makes of them. Usage: soak_test.py TOOLS_DEV
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

TOOLS = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(TOOLS))  # soak.py imports from there
ENDED = """
import sys
sys.path.insert(0, sys.argv[1])
import soak
root = sys.argv[2]
open(root + "/sleeps.sh", "w").write("#!/bin/sh\\necho $$ >" + root + "/pid\\nexec sleep 600\\n")
soak.STEPS = [("sleeps", "It sleeps", "nights", 1, "/bin/sh " + root + "/sleeps.sh", {}, [])]
sys.argv = ["soak.py", root]
sys.exit(soak.main())
"""


def load(name):
    spec = importlib.util.spec_from_file_location(name, TOOLS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def soak(root, steps, *options):
    module = load("soak")
    module.STEPS = steps
    sys.argv = ["soak.py", str(root), *options]
    with contextlib.redirect_stdout(io.StringIO()) as said:
        code = module.main()
    return code, said.getvalue(), json.loads((root / "build/figures/soak.json").read_text())


def step(name, command, reads=()):
    return (name, f"About {name}", "runs", 5000, command, {"FANTAIL_N": "{n}"}, list(reads))


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        count = step("count", "printenv FANTAIL_N", [("runs", r"^(\d+)")])
        code, said, result = soak(root, [count])
        assert code == 0 and result["passed"], said
        assert result["tables"][0]["rows"][0][:3] == ['<a id="count"></a>About count', "5,000 runs", "none"], result
        assert "5000 runs" in result["tables"][0]["rows"][0][3], result

        code, said, _ = soak(root, [count], "--short")
        assert "5 runs" in json.loads((root / "build/figures/soak.json").read_text())["tables"][0]["rows"][0][1]

        code, said, _ = soak(root, [count, step("no", "false")])
        assert code == 1 and "no: FAILED" in said, said
        dies = root / "dies.sh"
        dies.write_text("#!/bin/sh\nkill -9 $$\n")
        dies.chmod(0o755)
        for name, command, reads in [("dies", str(dies), ()), ("silent", "true", [("edges", r"cov: (\d+)")])]:
            code, said, result = soak(root, [step(name, command, reads)])
            assert code == 1 and not result["passed"], (name, said)

        # A program that was not built is known before the first step, not after an hour.
        module = load("soak")
        module.STEPS = [step("touches", "touch touched"), step("none", "build/fuzz/none_fuzz -runs=1")]
        sys.argv = ["soak.py", str(root)]
        with contextlib.redirect_stderr(io.StringIO()) as said:
            assert module.main() == 66 and "none cannot run: there is no build/fuzz/none_fuzz" in said.getvalue(), said.getvalue()
        assert not (root / "touched").exists()

        # A program that says it passed and has run no test.
        empty = root / "empty.sh"
        empty.write_text("#!/bin/sh\necho '[  PASSED  ] 0 tests.'\n")
        one = root / "one.sh"
        one.write_text("#!/bin/sh\necho '[  PASSED  ] 1 test.'\n")
        for program in (empty, one):
            program.chmod(0o755)
        assert soak(root, [step("empty", f"{empty} --gtest_filter=No.Test")])[0] == 1
        code, said, result = soak(root, [step("one", f"{one} --gtest_filter=A.Test")])
        assert code == 0 and "1 tests passed" in result["tables"][0]["rows"][0][3], result

        # What these sources have passed is not run again, what it has not is.
        code, said, result = soak(root, [count, step("no", "true")], "--resume")
        assert code == 0 and "1 of 2 steps" in said and "count: passed" not in said, said
        assert result["command"] == "./dev soak --resume" and "1 of 2 are of an earlier call" in result["notes"][1], result
        (root / "firmware").mkdir()
        (root / "firmware/new.cpp").write_text("")
        code, said, _ = soak(root, [count, step("no", "true")], "--resume")
        assert code == 0 and "2 of 2 steps" in said, said
        # A program of a build hangs on what it is compiled from, and not on another tool.
        build = root / "build/host"
        build.mkdir()
        (build / "build.ninja").write_text("rule copy\n  command = cp $in $out\nbuild one: copy ../../firmware/one.cpp\n")
        one = root / "firmware/one.cpp"
        for new, text, to_run in [(one, "true", 1), (root / "tools/new.cpp", "", 0), (one, "exit 0", 1), (root / "cmake/x", "", 1)]:
            new.parent.mkdir(exist_ok=True)
            new.write_text(f"#!/bin/sh\n{text}\n")
            one.chmod(0o755)
            subprocess.run(["ninja", "-C", build], check=True, stdout=subprocess.DEVNULL)
            code, said, _ = soak(root, [step("one", "build/host/one")], "--resume")
            assert code == 0 and f"{to_run} of 1 steps" in said, (new, said)
        # What has failed is run again, what has passed is not, whatever has changed; the page says of which commit that is.
        assert soak(root, [count, step("no", "false")])[0] == 1
        (root / "firmware/new.cpp").write_text("int a;\n")
        subprocess.run("git init -q && git add firmware && git -c user.name=a -c user.email=a@b commit -qm a", shell=True, cwd=root, check=True)
        code, said, result = soak(root, [count, step("no", "true")], "--failed")
        assert code == 0 and "1 of 2 steps" in said and "count: passed" not in said, said
        assert result["tables"][0]["rows"][0][3].endswith("at a tree without git"), result
        assert "at " not in result["tables"][0]["rows"][1][3] and "1 of 2 passed in an earlier call" in result["notes"][1], result
        code, said, result = soak(root, [count, step("new", "true")], "--only", "count")
        assert code == 0 and len(result["tables"][0]["rows"]) == 1

        # An end from outside ends the steps.
        module = subprocess.Popen([sys.executable, "-B", "-c", ENDED, str(TOOLS), str(root)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while not (root / "pid").exists() or not (root / "pid").read_text().strip():
            time.sleep(0.02)
        module.terminate()
        assert b"--resume runs the unfinished steps" in module.communicate(timeout=60)[1] and module.returncode == 130
        pid = int((root / "pid").read_text())
        assert not pathlib.Path(f"/proc/{pid}").exists() or "State:\tZ" in pathlib.Path(f"/proc/{pid}/status").read_text()

        # A step that is in the table and was not run is no success.
        module = load("soak")
        sys.argv = ["soak.py", str(root), "--only", "nothing"]
        with contextlib.redirect_stderr(io.StringIO()) as said:
            assert module.main() == 64 and "nothing" in said.getvalue()

        figures = load("figures")
        os.chdir(root)
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
            assert figures.main(["docs/figures/x.md", "Soak", "./dev soak", "build/figures/soak.json"]) == 0
            page = pathlib.Path("docs/figures/x.md").read_text()
            assert '## The long tests <a id="soak"></a>' in page and '| <a id="count"></a>About count | 5,000 runs | none |' in page, page
            assert figures.main(["docs/figures/y.md", "Soak", "./dev soak", "build/figures/none.json"]) == 66
            assert "none.json" in said.getvalue() and not pathlib.Path("docs/figures/y.md").exists()
            pathlib.Path("bad.json").write_text(json.dumps({**json.loads(pathlib.Path("build/figures/soak.json").read_text()), "passed": False}))
            assert figures.main(["docs/figures/y.md", "Soak", "./dev soak", "bad.json"]) == 1
            assert "**not passed**" in pathlib.Path("docs/figures/y.md").read_text()
            for verdict, passed in (("passed", 0), ("NOT PASSED", 1)):  # what ./dev repository writes
                pathlib.Path("checked.txt").write_text(f"licences\tpassed\nforms\t{verdict}\n")
                subprocess.run([sys.executable, TOOLS / "checked.py", "The repository", "./dev repository", "checked.txt", "12", "checked.json"], check=True)
                assert figures.main(["docs/figures/z.md", "Gates", "./dev gates", "checked.json"]) == passed
                page = pathlib.Path("docs/figures/z.md").read_text()
                assert "`./dev repository`, 12 s: " in page and f"({2 - passed} of 2 checks)" in page, page
                assert ("| forms | NOT PASSED |" in page) == bool(passed) and "licences" not in page, page
            # Of a table with a sum the sum alone.
            pathlib.Path("summed.json").write_text(json.dumps({"title": "Coverage", "command": "./dev coverage", "seconds": 3, "passed": True, "tables": [
                {"columns": ["file", "lines"], "rows": [["a.cpp", "1 of 1"], ["b.cpp", "2 of 2"], ["all", "3 of 3"]]}]}))
            assert figures.main(["docs/figures/z.md", "Gates", "./dev gates", "summed.json"]) == 0
            page = pathlib.Path("docs/figures/z.md").read_text()
            assert "| all 2 | 3 of 3 |" in page and "a.cpp" not in page, page


main()
