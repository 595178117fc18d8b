# SPDX-License-Identifier: MIT
"""prove.py with a prover that misbehaves: whatever it does, nothing may count as proved that was not."""

import json
import os
import re
import signal
import subprocess
import time
import unittest

import proofs
from misbehaving_prover import HERE, Called


class Prove(Called):
    def is_red(self, name, sentence):
        done = self.prove(["good", name])
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(f"NOT PROVED: {name};", done.stdout)
        self.assertIn(sentence, done.stdout)
        self.assertFalse(json.loads((self.work / "build/figures/proofs.json").read_text())["passed"])

    def test_what_holds_and_whose_bugs_are_refuted_is_proved(self):
        done = self.prove(["good"])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("1 of 1 properties proved, 1 of 1 seeded bugs refuted", done.stdout)
        figures = json.loads((self.work / "build/figures/proofs.json").read_text())
        self.assertTrue(figures["passed"])
        self.assertEqual(figures["tables"][0]["rows"][0][:5], ["good", "proved", "1", "1 of 1", "1 of 1"])

    def test_every_harness_is_in_the_table_and_every_place_of_it_is_looked_at(self):
        harnesses = {}
        for path in (*HERE.glob("*.cpp"), *HERE.glob("*.c")):
            harnesses[path.name] = len(re.findall(r"^ +REACHABLE\(\d+, ", path.read_text(), re.MULTILINE))
        self.assertEqual(
            {proof.harness: proof.places for proof in sorted(proofs.PROOFS, key=lambda proof: proof.places)}, harnesses
        )

    def test_every_proof_has_a_seeded_bug_and_its_text_stands_once_in_its_file(self):
        for proof in proofs.PROOFS:
            self.assertTrue(proof.bugs, proof.name)
            for bug in proof.bugs:
                source = (HERE.parent.parent / "firmware" / bug.file).read_text()
                self.assertEqual(source.count(bug.text), 1, f"{proof.name}: {bug.says}")

    def test_a_function_without_a_body_is_red(self):
        self.is_red("no_body", "a function has no body: sin")

    def test_a_run_whose_time_is_over_is_red(self):
        self.is_red("time", "time, claims: it")  # of the processor; on a busy machine that of the clock may be over first

    def test_a_run_that_waits_is_red(self):
        os.environ["FAKE_PID"] = str(self.work / "pid")
        self.is_red("sleeps", "it was not done after 10 s")

    def test_a_run_that_is_killed_is_red(self):
        self.is_red("killed", "killed by SIGKILL")

    def test_a_run_that_crashes_is_red_whatever_it_said(self):
        self.is_red("crashed", "killed by SIGSEGV")

    def test_a_run_without_enough_memory_is_red(self):
        self.is_red("memory", "exit code 1")

    def test_silence_is_red(self):
        self.is_red("silent", "it did not say what it found")

    def test_success_without_a_claim_is_red(self):
        self.is_red("no_claim", "there was no claim in what it looked at")

    def test_fewer_claims_than_the_harness_has_are_red(self):
        (self.work / "few.cpp").write_text("CLAIM(x == y);\n  CLAIM(y == z);\n")
        self.is_red("few", "1 claims were looked at, and the harness has 2")

    def test_a_quick_look_does_not_say_that_all_was_looked_at(self):
        done = self.prove(["good"], "--quick", bugs="BUG, BUG")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("1 of 1 properties hold, each with its first place and bug alone, 1 of 2 seeded bugs refuted", done.stdout)
        self.assertFalse((self.work / "build/figures/proofs.json").exists())

    def test_two_verdicts_are_red(self):
        self.is_red("both", "it did not say what it found")

    def test_an_unknown_verdict_is_red(self):
        self.is_red("unknown", "it did not say what it found")

    def test_a_verdict_with_the_wrong_exit_code_is_red(self):
        self.is_red("wrong_code", "exit code 3")

    def test_a_refuted_claim_is_red(self):
        self.is_red("refuted", "refuted: claim: x == y")

    def test_a_harness_that_cannot_be_read_is_red(self):
        self.is_red("parse", "exit code 6: x.cpp:1:1: error: no such thing")

    def test_a_place_that_nothing_reaches_is_red(self):
        self.is_red("unreachable", "this place is never reached")

    def test_a_place_where_something_else_fails_is_red(self):
        self.is_red("elsewhere", "refuted by something else: claim: x == y")

    def test_a_seeded_bug_that_is_not_refuted_is_red(self):
        self.is_red("missed", "the seeded bug was not refuted")

    def test_a_seeded_bug_that_only_breaks_a_bound_of_the_prover_is_red(self):
        self.is_red("unwinding", "refuted by something else: unwinding assertion loop 3")

    def test_a_seeded_bug_whose_text_is_not_there_is_red(self):
        done = self.prove(["good"], text="no such text")
        self.assertEqual(done.returncode, 1)
        self.assertIn("has 0 times, instead of once", done.stderr)

    def test_a_seeded_bug_whose_text_is_there_twice_is_red(self):
        done = self.prove(["good"], text="canard.limit")
        self.assertEqual(done.returncode, 1)
        self.assertIn("times, instead of once", done.stderr)

    def test_an_unknown_name_is_wrong_usage(self):
        for name, named in (("bad", "bad"), ("", "''")):
            done = self.prove(["good"], name)
            self.assertEqual(done.returncode, 64)
            self.assertIn(f"there is no proof {named};", done.stderr)

    def test_a_quick_look_that_would_look_at_nothing_is_wrong_usage(self):
        self.assertEqual(self.prove(["good", "refuted"], "--quick", "refuted").returncode, 64)

    def test_another_version_of_the_prover_is_refused(self):
        self.prover.write_text("#!/bin/sh\necho ESBMC version 6.0\n")
        done = self.prove(["good"])
        self.assertEqual(done.returncode, 70)
        self.assertIn("is not ESBMC version 8.4.0; it said: ESBMC version 6.0", done.stderr)

    def test_a_prover_that_is_not_there_is_refused(self):
        self.prover.unlink()
        self.assertEqual(self.prove(["good"]).returncode, 70)

    def test_the_results_as_json_are_all_that_is_on_standard_output(self):
        done = self.prove(["good", "missed"], "--json")
        self.assertEqual(done.returncode, 1)
        said = json.loads(done.stdout)
        self.assertEqual([proof["proved"] for proof in said["proofs"]], [True, False])
        self.assertEqual(said["proofs"][1]["faults"], ["bug 1: clamp gone: the seeded bug was not refuted"])

    def test_two_at_once_in_a_folder_are_refused(self):
        pid_file = self.work / "pid"
        os.environ["FAKE_PID"] = str(pid_file)
        process = subprocess.Popen(self.command(["sleeps"]), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (pid_file.exists() and pid_file.read_text().strip()):
            time.sleep(0.02)
        second = self.prove(["good"])
        self.assertEqual(second.returncode, 75)
        self.assertIn("another one is running in", second.stderr)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)

    def test_an_interrupt_ends_it_and_every_run_of_the_prover(self):
        pid_file = self.work / "pid"
        os.environ["FAKE_PID"] = str(pid_file)
        process = subprocess.Popen(self.command(["sleeps"]), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while not (pid_file.exists() and pid_file.read_text().strip()):
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted; nothing was proved", said)
        with self.assertRaises(ProcessLookupError):
            os.kill(int(pid_file.read_text()), 0)


if __name__ == "__main__":
    unittest.main()
