# SPDX-License-Identifier: MIT
"""Usage: judge_test.py

What is said of results and of the list of survivors.
"""

import collections
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # not between the sources
import judge


def result(outcome, line="a", file="firmware/core/trig.cpp"):
    return {"id": f"{file}:1:1:slip", "file": file, "was": line, "now": "b", "outcome": outcome, "by": "a test"}


KNOWN = {("firmware/core/trig.cpp", "a", "b"): judge.Known("firmware/core/trig.cpp", "a", "b", "it is the same")}


class Judgement(unittest.TestCase):
    def verdict(self, results, known=None, keys=None):
        known = known or {}
        return judge.judge(results, known, collections.Counter(list(known if keys is None else keys)))

    def test_the_score_is_of_what_could_be_noticed(self):
        verdict = self.verdict([result("killed")] * 18 + [result("timeout"), result("survived"), result("same"),
                                                          result("invalid")])
        self.assertEqual((verdict.score, verdict.passed), (0.95, True))
        self.assertFalse(self.verdict([result("killed")] * 18 + [result("survived")]).passed)

    def test_nothing_judged_is_no_success(self):
        for results in ([], [result("same"), result("invalid")]):
            self.assertFalse(self.verdict(results).passed)

    def test_a_survivor_with_its_reason_is_none(self):
        verdict = self.verdict([result("killed", "x"), result("survived")], KNOWN)
        self.assertEqual((verdict.score, verdict.unlisted, verdict.passed), (1.0, [], True))

    def test_one_that_is_noticed_must_leave_the_list(self):
        self.assertFalse(self.verdict([result("killed")], KNOWN).passed)

    def test_but_not_while_another_that_reads_the_same_was_left_out_of_the_sample(self):
        twice = 2 * list(KNOWN)
        self.assertTrue(self.verdict([result("killed")], KNOWN, twice).passed)
        self.assertTrue(self.verdict([result("killed"), result("survived")], KNOWN, twice).passed)
        self.assertFalse(self.verdict([result("killed")] * 2, KNOWN, twice).passed)

    def test_so_must_one_that_is_no_mutant_any_more(self):
        self.assertFalse(self.verdict([result("killed", "x")], KNOWN, set()).passed)

    def test_where_limits_and_arming_are_no_survivor_is_allowed(self):
        verdict = self.verdict([result("killed")] * 1000 + [result("survived", "c", "firmware/avionics/arming.cpp")])
        self.assertEqual((verdict.passed, len(verdict.strict)), (False, 1))
        self.assertIn("allows none", judge.sentences(verdict)[0])

    def test_the_list_is_read_and_its_mistakes_are_named(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name, "survivors.txt")
        entry = "file: firmware/core/trig.cpp\nwas: a\nnow: b\nwhy: it is the same\n"
        path.write_text("# a comment\n" + entry)
        self.assertEqual(judge.read_survivors(path), KNOWN)
        for text, line in ((entry.replace("why:", "because:"), 4), (entry.replace("was: a\n", ""), 4),
                           (entry.replace("it is the same", ""), 5), (entry + "why: twice\n", 5)):
            path.write_text(text)
            with self.assertRaisesRegex(ValueError, f":{line}:"):
                judge.read_survivors(path)


if __name__ == "__main__":
    unittest.main()
