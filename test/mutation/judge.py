# SPDX-License-Identifier: MIT
"""What the trials of mutants say together: the score, the list of survivors, the verdict and the page of figures."""

import collections
import dataclasses
import pathlib
import re

SCORE = 0.95  # of those that a test could have noticed
# No survivor without a reason: limits, arming, and the gates to motion.
STRICT = ("canard_mixer", "pd_controller", "canard_sharing", "flight_phase", "launch_detector", "arming", "bench_mode",
          "self_test")
NOTICED = ("killed", "timeout")


@dataclasses.dataclass(frozen=True)
class Known:
    """An entry of survivors.txt: a mutant by the text of its line before and after, which outlives a change above it."""

    file: str
    was: str
    now: str
    why: str

    @property
    def key(self):
        return self.file, self.was, self.now


def read_survivors(path):
    """Entries of four lines, `file:`, `was:`, `now:`, `why:`, apart by empty lines. ValueError says which is wrong."""
    known, fields = {}, {}
    lines = pathlib.Path(path).read_text().splitlines()
    for number, line in enumerate([*lines, ""], 1):
        if line.startswith("#"):
            continue
        if not line.strip():
            if fields:
                if list(fields) != ["file", "was", "now", "why"] or not all(fields.values()):
                    raise ValueError(f"{path}:{number}: an entry is file, was, now and why, each with a text; this has "
                                     f"{', '.join(fields)}")
                entry = Known(**fields)
                known[entry.key] = entry
                fields = {}
            continue
        match = re.fullmatch(r"(file|was|now|why): (.*)", line)
        if not match or match[1] in fields:
            raise ValueError(f"{path}:{number}: not one of file, was, now, why, each once: {line}")
        fields[match[1]] = " ".join(match[2].split())
    return known


def key_of(result):
    return result["file"], result["was"], result["now"]


@dataclasses.dataclass
class Verdict:
    counts: dict  # file -> Counter of outcomes
    score: float | None  # None: nothing could be judged
    unlisted: list  # survivors without a reason
    strict: list  # of these, those in STRICT
    stale: list  # listed ones that were noticed
    gone: list  # listed ones that are no mutant of the sources any more

    @property
    def passed(self):
        return self.score is not None and self.score >= SCORE and not self.strict and not self.stale and not self.gone


def judge(results, known, all_keys):
    """`results`: one dict a trial. `all_keys`: how often each key is that of a mutant of the sources, tried or not."""
    counts = collections.defaultdict(collections.Counter)
    for result in results:
        counts[result["file"]][result["outcome"]] += 1
    unlisted = [r for r in results if r["outcome"] == "survived" and key_of(r) not in known]
    noticed = sum(r["outcome"] in NOTICED for r in results)
    judged = noticed + len(unlisted)
    # Two mutants may read the same (the same slip twice in a line, the same line twice in a file): one that lives is enough, and
    # one that a sample has left out may.
    alive = {key_of(r) for r in results if r["outcome"] in ("survived", "same")}
    tried = collections.Counter(key_of(r) for r in results)
    stale = [r for r in results if r["outcome"] in NOTICED and key_of(r) in known and key_of(r) not in alive
             and tried[key_of(r)] >= all_keys[key_of(r)]]
    return Verdict(dict(counts), noticed / judged if judged else None, unlisted,
                   [r for r in unlisted if pathlib.Path(r["file"]).stem in STRICT], stale,
                   [entry for key, entry in known.items() if key not in all_keys])


def sentences(verdict):
    """What is wrong, one sentence each."""
    wrong = []
    if verdict.score is None:
        wrong.append("no mutant could be judged")
    elif verdict.score < SCORE:
        wrong.append(f"{verdict.score:.1%} of the mutants were noticed, which is less than {SCORE:.0%}")
    for r in verdict.unlisted:
        what = "no test notices, in a file that allows none" if r in verdict.strict else "no test notices"
        wrong.append(f"{r['id']}: {what} ({r['by']}): \"{r['now']}\" instead of \"{r['was']}\"")
    wrong += [f"{r['id']}: stands in survivors.txt and is noticed by {r['by']}" for r in verdict.stale]
    wrong += [f"survivors.txt: no mutant of {entry.file} makes \"{entry.now}\" of \"{entry.was}\"" for entry in verdict.gone]
    return wrong


def page(verdict, command, seconds, what):
    kinds = ("killed", "timeout", "survived", "same", "invalid")
    rows = [[file, *(str(count[kind]) for kind in kinds)] for file, count in sorted(verdict.counts.items())]
    total = sum(verdict.counts.values(), collections.Counter())
    rows.append(["all", *(str(total[kind]) for kind in kinds)])
    score = "nothing was judged" if verdict.score is None else (
        f"{verdict.score:.1%} noticed of those that could be, without the survivors that have their reason in "
        "test/mutation/survivors.txt")
    return {"title": "Mutation of flight law, protocol and four files of the avionics", "command": command, "seconds": round(seconds, 1),
            "passed": verdict.passed,
            "tables": [{"caption": what, "columns": ["file", "killed", "too slow", "survived", "same object", "not C++"],
                        "rows": rows}],
            "notes": [score, *sentences(verdict)]}
