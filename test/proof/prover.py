# SPDX-License-Identifier: MIT
"""One run of the model checker ESBMC: what it is given, how it is watched, and what its answer is worth.

An answer counts only if nothing speaks against it: a function without a body, a run that was killed, that ran out of time or
memory, or that said nothing, has no verdict, whatever else it printed.
"""

import dataclasses
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

HOLDS, REFUTED, NONE = "holds", "refuted", "no verdict"

# Boolector, because the default solver wanted 17 GB for the mixer. The standard checks (arithmetic, pointers) are added by
# the proofs that need them.
OPTIONS = ("--boolector", "--quiet", "--color", "never")
WITHOUT_CHECKS = ("--no-standard-checks",)

# A run has so many seconds of the processor; of the clock it has more, because the machine may be busy.
PATIENCE = 10


@dataclasses.dataclass
class Verdict:
    kind: str  # HOLDS, REFUTED or NONE
    why: str  # REFUTED: the property that was violated; NONE: what is wrong with the run
    claims: int = 0  # HOLDS: how many claims were looked at
    seconds: float = 0.0  # of the processor
    megabytes: float = 0.0  # the most that it had in memory


def judged(text, code):
    """What the prover's output and exit code are worth."""
    if "no body for function" in text:
        return Verdict(
            NONE, "a function has no body: " + ", ".join(sorted(set(re.findall(r"no body for function (\S+)", text))))
        )
    if code == -signal.SIGXCPU:
        return Verdict(NONE, "its processor time was over")
    if code < 0:
        return Verdict(NONE, f"it was killed by {signal.Signals(-code).name}")
    said = set(re.findall(r"^VERIFICATION (\w+)$", text, re.MULTILINE))
    if said == {"SUCCESSFUL"} and code == 0:
        claims = len(re.findall(r"^\s*PASSED\s.*\bclaim: ", text, re.MULTILINE))
        if not claims:
            return Verdict(NONE, "it said SUCCESSFUL, but there was no claim in what it looked at")
        return Verdict(HOLDS, "", claims)
    if said == {"FAILED"} and code == 1:
        violated = re.search(r"^Violated property:\n[^\n]*\n\s*([^\n]*)", text, re.MULTILINE)
        if violated:
            return Verdict(REFUTED, violated[1].strip())
        return Verdict(NONE, "it said FAILED, but not what failed")
    errors = re.findall(r"^.*(?:error|ERROR|terminate called|bad_alloc|[Oo]ut of memory).*$", text, re.MULTILINE)
    return Verdict(NONE, f"exit code {code}: " + (errors[0].strip() if errors else "it did not say what it found"))


class Run:
    """A process of the prover. Its output goes into a file, which stays for whoever wants to read it."""

    def __init__(self, command, log, seconds, megabytes):
        self.patience = PATIENCE * seconds
        self.log = pathlib.Path(log)
        self.begun = time.monotonic()
        self.late = False

        def limit():
            memory = megabytes * 1_000_000
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        with open(self.log, "wb") as out:
            out.write((" ".join(map(str, command)) + "\n").encode())
            out.flush()
            # A group of its own, so that Ctrl-C reaches this program first, and whatever it starts ends with it.
            self.process = subprocess.Popen(
                list(map(str, command)),
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=out,
                preexec_fn=limit,
                start_new_session=True,
            )

    def kill(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    def stop(self):
        """Ends it and waits for its end."""
        self.kill()
        self.process.wait()

    def verdict(self):
        """Its verdict when it has ended, else None. Ends it when its time is over."""
        if not self.late and time.monotonic() - self.begun > self.patience:
            self.late = True
            self.kill()
        pid, status, usage = os.wait4(self.process.pid, os.WNOHANG)
        if not pid:
            return None
        code = os.waitstatus_to_exitcode(status)
        self.process.returncode = code
        self.kill()  # what it may have started
        text = self.log.read_text(errors="replace")
        verdict = Verdict(NONE, f"it was not done after {self.patience} s") if self.late else judged(text, code)
        verdict.seconds = usage.ru_utime + usage.ru_stime
        verdict.megabytes = usage.ru_maxrss * 1024 / 1e6
        return verdict
