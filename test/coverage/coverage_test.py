# SPDX-License-Identifier: MIT
"""Usage: coverage_test.py

coverage.py on small exports that are written by hand: what is reached, what is not, reasons that hold and reasons that
do not, and exports that are none.
"""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True  # not between the sources
import coverage
import measured


def source(**parts):
    return measured.Source(functions={(1, 1, 99, 1)}, **parts)


def wrong(text, **parts):
    return coverage.judge(text, source(**parts)).wrong


class Lines(unittest.TestCase):
    TEXT = "int f() {\n  g();\n  h();\n}\n"

    def test_every_line_that_did_not_run_is_named(self):
        found = coverage.judge(self.TEXT, source(lines={1: 1, 2: 0, 3: 0, 4: 1}))
        self.assertEqual([line for line, _ in found.wrong], [2, 3])
        self.assertEqual(found.lines, (2, 4))

    def test_a_reason_at_the_first_stands_for_the_lines_that_follow_it(self):
        text = self.TEXT.replace("  g();", "  g();  // uncovered: no test can get here")
        found = coverage.judge(text, source(lines={1: 1, 2: 0, 3: 0, 4: 1}))
        self.assertEqual((found.wrong, found.lines, found.reasons), ([], (2, 2), 1))

    def test_and_not_for_lines_elsewhere(self):
        text = self.TEXT.replace("  g();", "  g();  // uncovered: no test can get here")
        self.assertEqual([line for line, _ in wrong(text, lines={1: 1, 2: 0, 3: 1, 4: 0})], [4])

    def test_a_reason_stands_on_the_line_above_only_if_nothing_else_does(self):
        self.assertEqual(wrong("// uncovered: why\ng();\n", lines={2: 0}), [])
        self.assertEqual(len(wrong("f();  // uncovered: why\n\ng();\n", lines={1: 1, 3: 0})), 2)

    def test_a_reason_beside_what_was_reached_is_stale(self):
        (line, text), = wrong("g();  // uncovered: no test can get here\n", lines={1: 7})
        self.assertEqual(line, 1)
        self.assertIn("stale", text)

    def test_an_empty_reason_is_none(self):
        self.assertEqual(len(wrong("g();  // uncovered:\n", lines={1: 0})), 1)

    def test_what_only_the_compiler_runs_is_left_out(self):
        text = "consteval int f() {\n  return 1;\n}\nint g() {\n}\n"
        self.assertEqual([line for line, _ in wrong(text, lines={1: 0, 2: 0, 3: 0, 4: 0, 5: 1})], [4])

    def test_segments_are_counted_as_llvm_cov_does(self):
        # A function from line 1 to 5 that ran 3 times, with a block in lines 2 and 3 that never did.
        segments = [[1, 1, 3, True, True, False], [2, 10, 0, True, True, False], [3, 4, 3, True, False, False],
                    [5, 2, 0, False, False, False]]
        self.assertEqual(measured.line_counts(segments), {1: 3, 2: 3, 3: 0, 4: 3, 5: 3})


class BranchesAndDecisions(unittest.TestCase):
    TEXT = "bool f(bool a, bool b) {\n  return a && b;\n}\n"
    BRANCHES = {(2, 10, 2, 11): [5, 5], (2, 15, 2, 16): [3, 2]}
    DECISION = (2, 10, 2, 16)

    def found(self, text=TEXT, branches=None, conditions=(True, True)):
        return coverage.judge(text, source(lines={1: 1, 2: 1, 3: 1}, branches=branches or self.BRANCHES,
                                           decisions={self.DECISION: list(conditions)}))

    def test_all_reached_is_right(self):
        found = self.found()
        self.assertEqual((found.wrong, found.branches, found.conditions), ([], (4, 4), (2, 2)))

    def test_a_branch_that_went_one_way_only_is_named_with_the_way_it_did_not_go(self):
        (line, text), = self.found(branches=self.BRANCHES | {(2, 15, 2, 16): [3, 0]}).wrong
        self.assertEqual((line, "never false" in text, "column 15" in text), (2, True, True))

    def test_a_condition_that_was_not_shown_to_matter_is_named(self):
        found = self.found(conditions=(True, False))
        self.assertEqual(found.conditions, (1, 2))
        self.assertIn("condition 2 of 2", found.wrong[0][1])

    def test_a_reason_excuses_branch_and_condition(self):
        text = self.TEXT.replace("b;", "b;  // uncovered: b is a")
        found = self.found(text, self.BRANCHES | {(2, 15, 2, 16): [3, 0]}, (True, False))
        self.assertEqual((found.wrong, found.branches, found.conditions), ([], (2, 2), (0, 0)))

    def test_a_condition_that_the_compiler_has_decided_is_not_asked_for(self):
        found = self.found(branches={(2, 15, 2, 16): [3, 2], self.DECISION: [1, 1]}, conditions=(False, True))
        self.assertEqual((found.wrong, found.conditions), ([], (1, 1)))

    def test_a_decision_that_clang_has_not_measured_is_wrong(self):
        (line, text), = wrong(self.TEXT, lines={1: 1, 2: 1, 3: 1}, branches=self.BRANCHES)
        self.assertEqual((line, "cannot measure" in text), (2, True))

    def test_operators_in_comments_texts_and_assertions_are_none(self):
        text = 'f();  // a && b\ng(" || ");\nstatic_assert(a &&\n              b);\nvoid h(auto&& x);\n'
        self.assertEqual(wrong(text, lines=dict.fromkeys(range(1, 6), 1)), [])

    def test_the_default_that_a_switch_does_not_have_is_not_asked_for(self):
        self.assertEqual(wrong("  switch (x) {\n", lines={1: 1}, branches={(1, 11, 1, 12): [0, 4]}), [])


class Export(unittest.TestCase):
    def run_main(self, export, text="int f() {\n}\n"):
        with tempfile.TemporaryDirectory() as root:
            file = pathlib.Path(root, "firmware/core/f.cpp")
            file.parent.mkdir(parents=True)
            file.write_text(text)
            path = pathlib.Path(root, "export.json")
            path.write_text(export if isinstance(export, str) else json.dumps(export(str(file))))
            out, err = io.StringIO(), io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), \
                 mock.patch.object(sys, "argv", ["coverage.py", root, str(path), "--figures", f"{root}/figures.json"]):
                code = coverage.main()
            figures = pathlib.Path(root, "figures.json")
            return code, out.getvalue() + err.getvalue(), json.loads(figures.read_text()) if figures.exists() else None

    @staticmethod
    def export(count):
        return lambda file: {"data": [{
            "files": [{"filename": file, "segments": [[1, 9, count, True, True, False], [2, 2, 0, False, False, False]]}],
            "functions": [{"filenames": [file], "regions": [[1, 9, 2, 2, count, 0, 0, 0]], "branches": [],
                           "mcdc_records": []}]}]}

    def test_the_verdict_is_the_exit_code_and_stands_in_the_figures(self):
        for count, code in ((3, 0), (0, 1)):
            got, said, figures = self.run_main(self.export(count))
            self.assertEqual((got, figures["passed"]), (code, code == 0), said)

    def test_a_source_that_was_not_measured_is_no_success(self):
        code, said, figures = self.run_main(lambda file: {"data": []})
        self.assertEqual((code, figures), (65, None))
        self.assertIn("firmware/core/f.cpp", said)

    def test_what_is_no_export_is_refused(self):
        for text in ("", "[]", '{"data": [{"files": [{}]}]}'):
            self.assertEqual(self.run_main(text)[0], 65, text)


if __name__ == "__main__":
    unittest.main()
