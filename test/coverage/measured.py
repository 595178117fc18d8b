# SPDX-License-Identifier: MIT
"""What `llvm-cov export` (LLVM 19) says of a program's sources: per file the lines, the branches and the conditions.

Instantiations of one template, and the copies of an inline function in several programs, are one piece of source: what
one of them has reached is reached.
"""

import collections
import dataclasses
import os
import pathlib
import re

CODE, GAP = 0, 3  # kinds of a region


@dataclasses.dataclass
class Source:
    """One file. Places are (line, column, end line, end column), counted from 1."""

    lines: dict = dataclasses.field(default_factory=dict)  # line -> how often it ran
    branches: dict = dataclasses.field(default_factory=dict)  # place of the condition -> [times true, times false]
    decisions: dict = dataclasses.field(default_factory=dict)  # place -> [a bool for each condition: shown to matter]
    functions: set = dataclasses.field(default_factory=set)  # places of the bodies that the compiler has counted


def read(export, root):
    """Path below `root` -> Source. `export`: the parsed JSON. Files outside of `root` are left out."""
    sources = collections.defaultdict(Source)
    root = os.path.realpath(root) + "/"

    def source(name):
        # Headers are found through links in the build folder.
        path = os.path.realpath(name)
        return sources[path.removeprefix(root)] if path.startswith(root) else None

    for data in export["data"]:
        for file in data["files"]:
            if (found := source(file["filename"])) is not None:
                for line, count in line_counts(file["segments"]).items():
                    found.lines[line] = max(count, found.lines.get(line, 0))
        for function in data["functions"]:
            add_function(function, source)
    return dict(sources)


def add_function(function, source):
    names = function["filenames"]
    for *place, _, file, _, kind in function["regions"][:1]:
        if kind == CODE and (found := source(names[file])) is not None:
            found.functions.add(tuple(place))
    for *place, true, false, file, _, _ in function["branches"]:
        if (found := source(names[file])) is not None:
            counts = found.branches.setdefault(tuple(place), [0, 0])
            counts[0] += true
            counts[1] += false
    for *place, file, _, conditions in function["mcdc_records"]:
        if (found := source(names[file])) is not None:
            known = found.decisions.setdefault(tuple(place), [False] * len(conditions))
            found.decisions[tuple(place)] = [a or b for a, b in zip(known, conditions, strict=True)]


def line_counts(segments):
    """As llvm-cov counts: the largest count of a region that begins in the line, or of the one that goes on into it."""
    by_line = collections.defaultdict(list)
    for segment in segments:
        by_line[segment[0]].append(segment)
    counts, around = {}, None
    for line in range(segments[0][0], segments[-1][0] + 1) if segments else ():
        here = by_line.get(line, [])
        begun = [s for s in here if s[3] and s[4] and not s[5]]
        skipped = here and here[0][4] and not here[0][3]
        if not skipped and ((around and around[3]) or begun):
            own = [s[2] for s in begun]
            goes_on = [around[2]] if around and around[3] else []
            counts[line] = max(own + goes_on)
        if here:
            around = here[-1]
    return counts


def compile_time_lines(text):
    """The lines of functions declared `consteval`: they run in the compiler only, and nothing can count them."""
    lines = set()
    for match in re.finditer(r"\bconsteval\b[^;{}]*(\{)", text):
        depth, end = 0, match.start(1)
        for end in range(match.start(1), len(text)):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            if depth == 0:
                break
        lines.update(range(text.count("\n", 0, match.start()) + 1, text.count("\n", 0, end) + 2))
    return lines


def sources_below(root, folders):
    """Path below `root` -> text, of every C++ file in the folders or of these stems (firmware/avionics/arming)."""
    found = {}
    for folder in folders:
        path = pathlib.Path(root, folder)
        files = path.glob("*.[ch]pp") if path.is_dir() else path.parent.glob(path.name + ".[ch]pp")
        for file in sorted(files):
            found[str(file.relative_to(root))] = file.read_text()
    return found
