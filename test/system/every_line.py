# SPDX-License-Identifier: MIT
"""Usage: every_line.py PROJECT FANTAIL [PAGE...]

Every command line in a block of code of every page of the manual, or of those named: run as a reader copies it, in a folder a page, in
which the lines above it have left their results; or named in lines_elsewhere.toml, with the reason why it cannot be run so and where
it is run instead. A line that is neither is an error, and so is a name that matches no line, or a place that is not there.
"""

import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import tomllib

sys.dont_write_bytecode = True  # not between the sources
import page_lines

PROJECT, FANTAIL = (pathlib.Path(word).absolute() for word in sys.argv[1:3])
BY_HAND = "by hand"  # no machine runs it
ELSEWHERE = "test/system/lines_elsewhere.toml"


def is_there(where, begin):
    """Is there a verb, a test or a file of that name, which does more than to be there?"""
    if where == BY_HAND:
        return True
    if where.startswith("./dev "):
        verbs = subprocess.run([PROJECT / "dev", "help"], capture_output=True, text=True, check=True).stdout
        return re.search(rf"^{re.escape(where)} ", verbs, re.MULTILINE)
    if "/" in where:  # a file that holds the line
        return (PROJECT / where).is_file() and begin in (PROJECT / where).read_text(encoding="utf-8")
    made = "".join(file.read_text(encoding="utf-8") for file in PROJECT.glob("test/**/CMakeLists.txt"))
    names = (re.sub(r"\\\$\\\{\w+\\\}", r"\\w+", re.escape(name)) for name in re.findall(r"\bNAME (\S+)", made))
    if any(re.fullmatch(name, where) for name in names):
        return True
    suite, _, name = where.partition(".")
    words = re.compile(rf"\bTEST(_F|_P)?\({re.escape(suite)}, {re.escape(name)}\)")
    return any(words.search(file.read_text(encoding="utf-8")) for file in PROJECT.glob("test/**/*.cpp"))


class Elsewhere:
    def __init__(self):
        self.entries = tomllib.loads((PROJECT / ELSEWHERE).read_text(encoding="utf-8"))["lines"]
        self.used = set()

    def of(self, page, line):
        """Where a line is run, or nothing."""
        for number, entry in enumerate(self.entries):
            for begin in entry["begin"]:
                if entry.get("page", page) == page and line.startswith(begin):
                    self.used.add((number, begin))
                    return entry["where"]
        return None

    def wrong(self, pages):
        for number, entry in enumerate(self.entries):
            if not entry["why"]:
                yield f"{entry['begin']}: no reason"
            for begin in entry["begin"]:
                if entry.get("page", "") in pages and (number, begin) not in self.used:
                    yield f"{entry['page']} has no line that is not run and begins with {begin}"
                if not is_there(entry["where"], begin):
                    yield f"there is no {entry['where']} that runs {begin}"


def lines_of_page(page, elsewhere):
    """Runs a page in the folder at hand; how many lines were run, are run elsewhere and by hand, and what is wrong."""
    counts, wrong = collections.Counter(), []
    page_lines.make_folder(PROJECT, FANTAIL)
    for kind, what, content in page_lines.steps_of((PROJECT / page).read_text(encoding="utf-8")):
        if kind == "file":
            page_lines.save(what, content)
        elif kind == "unknown":
            wrong.append(f"{what}: is this a command? PROGRAMS in page_lines.py does not know it")
        elif where := elsewhere.of(page, what):
            counts["by hand" if where == BY_HAND else "elsewhere"] += 1
        else:
            begin = time.monotonic()
            failure = page_lines.run(FANTAIL, what, content)
            counts["run"] += 1
            print(f"docs: {page}: {time.monotonic() - begin:.1f} s: {what}", file=sys.stderr, flush=True)
            if failure:
                wrong.append(f"{what}: {failure}")
                print(f"FAILED: {failure}", file=sys.stderr, flush=True)
    return counts, wrong


def main():
    pages = sys.argv[3:] or [str(file.relative_to(PROJECT)) for file in sorted([*PROJECT.glob("*.md"), *PROJECT.glob("docs/**/*.md")])]
    elsewhere, total, failures = Elsewhere(), collections.Counter(), []
    begin = time.monotonic()
    kinds = ("run", "elsewhere", "by hand")
    rows = []
    for page in pages:
        with tempfile.TemporaryDirectory(prefix="every_line.") as folder:
            os.chdir(folder)
            counts, wrong = lines_of_page(page, elsewhere)
            os.chdir("/")
        failures += [f"{page}: {what}" for what in wrong]
        total += counts
        if counts:
            rows.append((page, *(counts[kind] for kind in kinds)))
    failures += [f"{ELSEWHERE}: {what}" for what in elsewhere.wrong(pages)]
    for row in (("lines of", *kinds), *rows, ("all pages", *(total[kind] for kind in kinds))):
        print("{:36}{:>6}{:>12}{:>10}".format(*row))
    for failure in failures:
        print(f"FAILED: {failure}")
    print(f"{total['run']} command lines of the manual run in {time.monotonic() - begin:.0f} s; errors: {len(failures)}")
    return len(failures) > 0


sys.exit(main())
