# SPDX-License-Identifier: MIT
"""prove.py with a prover that misbehaves: whatever it does, nothing may count as proved that was not.

The prover is a shell script that is told by the name of the harness what to do. What it is asked can be seen in its words:
PROOF_REACHABLE for a place, a folder bug1 for a seeded bug.
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import proofs

HERE = pathlib.Path(__file__).resolve().parent

PROVER = r"""#!/bin/sh
[ "$1" = --version ] && echo "ESBMC version 8.4.0 64-bit x86_64 linux" && exit 0
holds() { echo "  PASSED  [main.assertion.1]  line 1  claim: x == y"; echo "VERIFICATION SUCCESSFUL"; exit 0; }
fails() { printf 'Violated property:\n  file x line 1 column 1\n  %s\n\nVERIFICATION FAILED\n' "$1"; exit 1; }
kind=claims
case "$*" in *PROOF_REACHABLE=*) kind=place ;; */bug1*) kind=bug ;; esac
case "$(basename "$1" .cpp),$kind" in
  good,claims) holds ;;
  good,place) fails reached ;;
  good,bug) fails "claim: x == y" ;;
  no_body,claims) echo "WARNING: no body for function sin"; holds ;;
  time,claims) while :; do :; done ;;
  sleeps,claims) echo $$ >"$FAKE_PID"; exec sleep 600 ;;
  killed,claims) kill -9 $$ ;;
  crashed,claims) echo "VERIFICATION SUCCESSFUL"; kill -11 $$ ;;
  memory,claims) exec python3 -c 'b = bytearray(1 << 32); print("VERIFICATION SUCCESSFUL")' ;;
  silent,claims) exit 0 ;;
  no_claim,claims) echo "VERIFICATION SUCCESSFUL"; exit 0 ;;
  both,claims) echo "VERIFICATION FAILED"; holds ;;
  unknown,claims) echo "VERIFICATION UNKNOWN"; exit 0 ;;
  wrong_code,claims) echo "  PASSED  [x]  line 1  claim: x"; echo "VERIFICATION SUCCESSFUL"; exit 3 ;;
  refuted,claims) fails "claim: x == y" ;;
  parse,claims) echo "x.cpp:1:1: error: no such thing"; echo "ERROR: PARSING ERROR"; exit 6 ;;
  unreachable,place) holds ;;
  missed,bug) holds ;;
  unwinding,bug) fails "unwinding assertion loop 3" ;;
  elsewhere,place) fails "claim: x == y" ;;
  *,claims) holds ;;
  *,place) fails reached ;;
  *,bug) fails "claim: x == y" ;;
esac
"""

TABLE = """
import sys
sys.path.insert(0, {here!r})
from proof import Bug, Proof
BUG = Bug("clamp gone", "core/canard_mixer.cpp", {text!r}, "")
PROOFS = [Proof(name, name, {work!r} + name + ".cpp", 1, (BUG,), quick=name == "good", seconds=1, megabytes=1000) for name in {names!r}]
"""

ONCE = "angle = clamp(wanted, canard.limit);"


class Prove(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.work = pathlib.Path(self.folder.name)
        self.prover = self.work / "esbmc"
        self.prover.write_text(PROVER)
        self.prover.chmod(0o755)

    def command(self, names, *words, text=ONCE):
        table = self.work / "table.py"
        table.write_text(TABLE.format(here=str(HERE), work=f"{self.work}/", names=names, text=text))
        for name in names:
            harness = self.work / f"{name}.cpp"
            if not harness.exists():
                harness.write_text('#include "core/canard_mixer.cpp"\n#include "beside.hpp"\n#include <cmath>\n')
        return [
            sys.executable,
            "-B",
            str(HERE / "prove.py"),
            str(self.prover),
            str(self.work / "build"),
            "--table",
            str(table),
            *words,
        ]

    def prove(self, names, *words, **options):
        return subprocess.run(self.command(names, *words, **options), capture_output=True, text=True, timeout=120)

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
        done = self.prove(["good"], "bad")
        self.assertEqual(done.returncode, 64)
        self.assertIn("there is no proof bad", done.stderr)

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
            lambda: (self.work / "good.cpp").write_text("#include <cmath>\n"),
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
