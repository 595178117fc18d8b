# SPDX-License-Identifier: MIT
"""The runs of the prover that a proof takes, and what must come of each."""

import pathlib

import prover

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent.parent


class Stop(Exception):
    def __init__(self, code, why):
        super().__init__(why)
        self.code = code


class Job:
    """One run of the prover and what must come of it."""

    def __init__(self, proof, kind, label, includes, options):
        self.proof, self.kind, self.label = proof, kind, label
        self.includes, self.options = includes, options
        self.verdict = None
        self.digest = ""
        self.kept = False

    @property
    def name(self):
        return f"{self.proof.name}, {self.label}"

    @property
    def place(self):
        """Where it writes, in the build folder, without the ending."""
        return f"{self.proof.name}/{self.label.split(':')[0].replace(' ', '_')}"

    def folders(self):
        return [
            *self.includes,
            *(HERE / f for f in self.proof.stubs),
            HERE / "stubs",
            HERE,
            SOURCES / "firmware",
            SOURCES / "hal" / "include",
        ]

    def command(self, esbmc):
        checks = () if self.proof.checks else prover.WITHOUT_CHECKS
        language = "c11" if self.proof.harness.endswith(".c") else "c++20"
        return [
            esbmc,
            HERE / self.proof.harness,
            *(w for f in self.folders() for w in ("-I", f)),
            "--std",
            language,
            *prover.OPTIONS,
            *checks,
            *self.proof.options,
            *self.options,
        ]

    def fault(self):
        """Why this did not end as it must; empty if it did."""
        v = self.verdict
        if v.kind == prover.NONE:
            return v.why
        if self.kind == "claims" and v.kind == prover.HOLDS:
            wanted = self.proof.claims(HERE)
            return "" if v.claims == wanted else f"{v.claims} claims were looked at, and the harness has {wanted}"
        if self.kind == "claims":
            return f"refuted: {v.why}"
        if v.kind == prover.HOLDS:
            return "this place is never reached" if self.kind == "place" else "the seeded bug was not refuted"
        wanted = ("reached",) if self.kind == "place" else self.proof.refuted_by
        return "" if v.why.startswith(wanted) else f"refuted by something else: {v.why}"

    def line(self):
        fault = self.fault()
        if self.kept:
            return f"{'as before':24}  {self.name}"
        word = "FAILED" if fault else {"claims": "proved", "place": "reached", "bug": "refuted"}[self.kind]
        claims = f" ({self.verdict.claims} claims)" if self.verdict.claims else ""
        cost = f"{self.verdict.seconds:6.1f} s {self.verdict.megabytes:5.0f} MB"
        return f"{word:8}{cost}  {self.name}{claims}{': ' + fault if fault else ''}"


def with_bug(bug, folder):
    """The folder of a copy of the bug's source file with the bug in it, to be searched before the sources."""
    source = SOURCES / "firmware" / bug.file
    text = source.read_text()
    if text.count(bug.text) != 1:
        raise Stop(
            1,
            f'{bug.file} has {text.count(bug.text)} times, instead of once, what the seeded bug "{bug.says}" replaces: {bug.text}',
        )
    copy = folder / bug.file
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text(text.replace(bug.text, bug.replacement))
    return folder


def jobs_of(proof, build, quick):
    """Its runs; of a quick look only the first place and the first bug."""
    places, bugs = proof.places, proof.bugs
    if quick:
        places, bugs = min(places, 1), bugs[:1]
    folder = build / proof.name
    folder.mkdir(parents=True, exist_ok=True)
    jobs = [Job(proof, "claims", "claims", [], [])]
    for place in range(1, places + 1):
        jobs.append(Job(proof, "place", f"place {place}", [], ["-D", f"PROOF_REACHABLE={place}"]))
    for number, bug in enumerate(bugs, 1):
        jobs.append(Job(proof, "bug", f"bug {number}: {bug.says}", [with_bug(bug, folder / f"bug{number}")], []))
    return jobs
