# SPDX-License-Identifier: MIT
"""A prover that misbehaves, and how prove.py is called with it.

The prover is a shell script that is told by the name of the harness what to do. What it is asked can be seen in its words:
PROOF_REACHABLE for a place, a folder bug1 for a seeded bug.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

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
PROOFS = [Proof(name, name, {work!r} + name + ".cpp", 1, ({bugs},), quick=name == "good", seconds=1, megabytes=1000) for name in {names!r}]
"""

ONCE = "angle = clamp(wanted, canard.limit);"


class Called(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.work = pathlib.Path(self.folder.name)
        self.prover = self.work / "esbmc"
        self.prover.write_text(PROVER)
        self.prover.chmod(0o755)

    def command(self, names, *words, text=ONCE, bugs="BUG"):
        table = self.work / "table.py"
        table.write_text(TABLE.format(here=str(HERE), work=f"{self.work}/", names=names, text=text, bugs=bugs))
        for name in names:
            harness = self.work / f"{name}.cpp"
            if not harness.exists():
                harness.write_text('#include "core/canard_mixer.cpp"\n#include "beside.hpp"\n#include <cmath>\n  CLAIM(x == y);\n')
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
