# SPDX-License-Identifier: MIT
"""prove.py --resume: what is taken from an earlier call, and what is not."""

import json
import unittest

from misbehaving_prover import PROVER, Called


class Resume(Called):
    def test_a_run_is_not_repeated_while_everything_that_it_read_is_the_same(self):
        beside = self.work / "beside.hpp"
        beside.write_text("// as it was\n")
        first = self.prove(["good"])
        self.assertEqual(first.returncode, 0, first.stdout + first.stderr)
        log = self.work / "build/prove/good/claims.log"
        log.unlink()
        again = self.prove(["good"], "--resume")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.assertFalse(log.exists())
        self.assertIn("taken from earlier calls: 3 of 3 runs", again.stdout)
        notes = json.loads((self.work / "build/figures/proofs.json").read_text())["notes"]
        self.assertEqual(notes[-1], "3 of 3 runs are of earlier calls, in which the prover read the same.")
        for change in (
            lambda: beside.write_text("// another text\n"),
            lambda: beside.unlink(),
            lambda: (self.work / "good.cpp").write_text("#include <cmath>\nCLAIM(x == y);\n"),
            lambda: self.prover.write_text(PROVER + "# another prover\n"),
        ):
            change()
            done = self.prove(["good"], "--resume")
            self.assertIn("taken from earlier calls: 0 of 3 runs", done.stdout)
            self.assertTrue(log.exists())
            log.unlink()

    def test_without_resume_everything_is_run_again(self):
        self.prove(["good"])
        log = self.work / "build/prove/good/claims.log"
        log.unlink()
        self.assertEqual(self.prove(["good"]).returncode, 0)
        self.assertTrue(log.exists())

    def test_what_was_red_or_is_damaged_is_run_again(self):
        self.assertEqual(self.prove(["missed"]).returncode, 1)
        done = self.prove(["missed"], "--resume")
        self.assertEqual(done.returncode, 1)
        self.assertIn("taken from earlier calls: 2 of 3 runs", done.stdout)
        for name, text in (("claims", ""), ("place_1", '{"digest": 1}'), ("claims", '["verdict"]')):
            (self.work / f"build/prove/missed/{name}.json").write_text(text)
            self.assertIn("taken from earlier calls: 1 of 3 runs", self.prove(["missed"], "--resume").stdout)

    def test_a_kept_verdict_that_is_not_the_wanted_one_counts_for_nothing(self):
        self.prove(["good"])
        file = self.work / "build/prove/good/bug_1.json"
        file.write_text(file.read_text().replace('"refuted"', '"holds"'))
        done = self.prove(["good"], "--resume")
        self.assertEqual(done.returncode, 0)
        self.assertIn("taken from earlier calls: 2 of 3 runs", done.stdout)


if __name__ == "__main__":
    unittest.main()
