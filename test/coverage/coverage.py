# SPDX-License-Identifier: MIT
"""Usage: coverage.py ROOT EXPORT [--json] [--figures FILE] [--command WORDS] [--seconds N]

Judges what the tests have reached of the code that moves canards (SCOPE, below ROOT). EXPORT is the output of `llvm-cov
export` of programs built with -fcoverage-mcdc. Every line must have run, every branch must have gone both ways, and every
condition of a decision must have been shown to change it alone (MC/DC), or a reason stands beside it:

    default:  // uncovered: every Phase has a case above

on the line itself or on the line above; for lines that did not run, at the first of them. A reason beside what was
reached is stale, which is a failure too. A decision that Clang cannot measure (it refuses some nested ones) is a failure: a
reason or a plainer expression mends it. Left out by rule: what runs in the compiler only (COMPILED_AWAY, functions declared
`consteval`, static_assert, `if constexpr`, conditions that the compiler has decided), and what has no text of its own (the
default of a switch that has none, `= default`, a `using` within a switch).

Exit code: 0 all reached or reasoned, 1 not, 65 EXPORT is no such export or has nothing of a file, 66 it cannot be read.
"""

import argparse
import dataclasses
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # not between the sources
import measured

SCOPE = ("firmware/core", "firmware/protocol", "firmware/avionics/arming", "firmware/avionics/bench_mode",
         "firmware/avionics/self_test", "firmware/avionics/flight_memory")
# Tables from which the compiler makes other tables: none of their functions is in a program.
COMPILED_AWAY = ("firmware/core/flight_plan_table.hpp",)
# A PC takes crc32c_sse42.cpp; the same tests run on the emulated processor with this one.
NOT_ON_A_PC = ("firmware/protocol/crc32c_tables.cpp",)
# The link between an emulated processor and its world: in no rocket, and tested where there are both (test/emulator).
IN_NO_ROCKET = ("firmware/protocol/hil_frame.cpp", "firmware/protocol/hil_frame.hpp", "firmware/protocol/hil_codec.hpp")
REASON = re.compile(r"//\s*uncovered:\s*(\S.*)")
OPERATOR = re.compile(r" (?:&&|\|\|) | (?:&&|\|\|)$")  # as clang-format writes them; `auto&& x` is no operator
LITERALS = re.compile(r'"(?:\\.|[^"\\])*"|//.*')
IN_THE_COMPILER = re.compile(r"\b(?:static_assert|if constexpr) ?\(.*?(?:;|\{)\s*$", re.DOTALL | re.MULTILINE)


@dataclasses.dataclass
class Judgement:
    """Of one file. A count is (reached, of how many); what has a reason is not counted."""

    lines: tuple = (0, 0)
    branches: tuple = (0, 0)
    conditions: tuple = (0, 0)
    reasons: int = 0
    wrong: list = dataclasses.field(default_factory=list)  # (line, what is wrong)


def judge(text, source):
    """`source`: the measured.Source of the file with this text."""
    rows = text.splitlines()
    reasons = {number: match[1] for number, row in enumerate(rows, 1) if (match := REASON.search(row))}
    left_out = measured.compile_time_lines(text)
    used = set()

    def excused(line):
        """The reason at this line, or alone on the line above."""
        for place in (line, line - 1):
            if place in reasons and (place == line or rows[place - 1].lstrip().startswith("//")):
                used.add(place)
                return True
        return False

    result = Judgement(reasons=len(reasons))
    missed, judged = [], 0
    before = excused_before = None
    declared = {line for line in source.lines if rows[line - 1].lstrip().startswith("using ")}
    for line in sorted(set(source.lines) - left_out - declared):
        reached = source.lines[line] > 0
        if not reached:
            # The reason at the first line, or at the branch that leads to it, stands for all that follow.
            follows = before == line - 1 and excused_before
            excused_before = follows or excused(line) or excused(line - 1)
            before = line
            if excused_before:
                continue
            missed.append((line, "the line did not run"))
        judged += 1
    result.lines = (judged - len(missed), judged)
    unrun = {line for line in source.lines if source.lines[line] == 0}

    def sides(places, kind, say):
        """Counts the parts of each place that are true, and says which are not."""
        reached = total = 0
        for place, parts in sorted(places.items()):
            if place[0] in left_out or (not all(parts) and excused(place[0])):
                continue
            reached += sum(map(bool, parts))
            total += len(parts)
            # A line that did not run says so once.
            if not all(parts) and place[0] not in unrun:
                missed.append((place[0], f"{kind} in column {place[1]}: {say(parts)}"))
        return reached, total

    branches = {place: counts for place, counts in source.branches.items()
                if not rows[place[0] - 1][: place[1] - 1].endswith("switch (") and "= default" not in rows[place[0] - 1]}
    decisions = {place: without_decided(place, parts, source.branches) for place, parts in source.decisions.items()}
    result.branches = sides(branches, "branch", lambda parts: f"never {'true' if not parts[0] else 'false'}"
                            if any(parts) else "neither true nor false")
    result.conditions = sides(decisions, "decision", lambda parts: "not shown to matter: condition "
                              + ", ".join(str(i) for i, part in enumerate(parts, 1) if not part) + f" of {len(parts)}")
    for line, column in unmeasured(text, source, left_out):
        if not excused(line):
            missed.append((line, f"decision in column {column}: Clang cannot measure it; nest less"))
    stale = [(line, f'stale reason: what stands here was reached ("{reasons[line]}")') for line in set(reasons) - used]
    result.wrong = sorted(missed + stale)
    return result


def without_decided(place, parts, branches):
    """A condition that the compiler has decided has no branch, and cannot be shown to matter."""
    inside = sum(place[:2] <= branch[:2] and branch[2:] <= place[2:] and branch != place for branch in branches)
    decided = max(len(parts) - inside, 0)
    kept = []
    for part in parts:
        if not part and decided:
            decided -= 1
        else:
            kept.append(part)
    return kept


def unmeasured(text, source, left_out):
    """Where && and || stand in code that was counted, but in no decision that was."""
    plain = LITERALS.sub(lambda match: " " * len(match[0]), text)
    plain = IN_THE_COMPILER.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), plain)
    for number, row in enumerate(plain.splitlines(), 1):
        if number in left_out:
            continue
        for match in OPERATOR.finditer(row):
            at = (number, match.start() + 2)
            inside = [any(place[:2] <= at < place[2:] for place in places)
                      for places in (source.functions, source.decisions)]
            if inside == [True, False]:
                yield at


def judge_all(texts, sources):
    """Path -> Judgement. What the compiler made no code of (declarations, tables, consteval) is not in it."""
    return {path: judge(text, sources[path] if path in sources else measured.Source())
            for path, text in texts.items() if path not in COMPILED_AWAY and (path in sources or REASON.search(text))}


def cell(count):
    reached, total = count
    return f"{reached} of {total}" if total else "-"


def table(judgements):
    rows = [[path, cell(j.lines), cell(j.branches), cell(j.conditions), str(j.reasons)]
            for path, j in judgements.items()]
    sums = [tuple(map(sum, zip(*(getattr(j, what) for j in judgements.values()), strict=True)))
            for what in ("lines", "branches", "conditions")]
    rows.append(["all", *map(cell, sums), str(sum(j.reasons for j in judgements.values()))])
    return {"caption": "Reached by test_core, test_protocol and test_avionics",
            "columns": ["file", "lines", "branch sides", "MC/DC conditions", "reasons"], "rows": rows}


def printed(page):
    cells = [page["columns"], *page["rows"]]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]))]
    return "\n".join(f"{row[0]:<{widths[0]}}  " + "  ".join(f"{c:>{w}}" for c, w in zip(row[1:], widths[1:], strict=True))
                     for row in cells)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root")
    parser.add_argument("export")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--figures")
    parser.add_argument("--command", default="./dev coverage")
    parser.add_argument("--seconds", type=float, default=0.0)
    options = parser.parse_args()
    try:
        export = json.loads(pathlib.Path(options.export).read_text())
    except OSError as error:
        print(f"coverage: {options.export}: {error.strerror}", file=sys.stderr)
        return 66
    except ValueError as error:
        print(f"coverage: {options.export} is no JSON: {error}", file=sys.stderr)
        return 65
    try:
        sources = measured.read(export, options.root)
    except (KeyError, TypeError, ValueError, IndexError) as error:
        print(f"coverage: {options.export} is no export of llvm-cov 19: {error!r}", file=sys.stderr)
        return 65
    texts = {path: text for path, text in measured.sources_below(options.root, SCOPE).items()
             if path not in NOT_ON_A_PC + IN_NO_ROCKET}
    # A file that was not measured at all must not look like one that is covered.
    absent = [path for path in texts if path.endswith(".cpp") and path not in sources]
    if not texts or absent:
        print(f"coverage: {options.export} has nothing of {', '.join(absent) or 'any source'}", file=sys.stderr)
        return 65
    judgements = judge_all(texts, sources)
    wrong = [f"{path}:{line}: {what}" for path, j in judgements.items() for line, what in j.wrong]
    page = {"title": "Coverage of flight law, protocol and four files of the avionics", "command": options.command,
            "seconds": round(options.seconds, 1), "passed": not wrong, "tables": [table(judgements)],
            "notes": [f"{len(wrong)} places are neither reached nor have a reason, or have a stale one", *wrong]
            if wrong else ["every line, branch and condition was reached or has its reason beside it",
                           "left out: functions declared consteval, which run in the compiler only"]}
    if options.figures:
        pathlib.Path(options.figures).write_text(json.dumps(page, indent=1) + "\n")
    if options.json:
        print(json.dumps(page))
    else:
        print(printed(page["tables"][0]))
        print("\n".join(wrong + page["notes"][:1]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
