# SPDX-License-Identifier: MIT
"""The trials that were made, one line each after a line that says of what, so that an interrupted run can go on.

A whole run, one of some files and a sample have a file each: hours of one are not written over by a minute of another.
"""

import json
import os
import pathlib

SELECTION = ("all", "file", "sample", "seed")


def path_of(folder, header):
    kind = "all" if header["all"] else "files" if header["file"] else "sample"
    return pathlib.Path(folder) / f"results_{kind}.jsonl"


def newest_selection(folder):
    """What the run asked for whose file was written last; None: there is none."""
    files = sorted(pathlib.Path(folder).glob("results_*.jsonl"), key=lambda path: path.stat().st_mtime)
    for path in reversed(files):
        with path.open() as stream:
            try:
                header = json.loads(stream.readline())
                return {name: header[name] for name in SELECTION}
            except (ValueError, KeyError, TypeError):
                continue
    return None


def read(path, header):
    """The trials that an earlier run has left, of the same sources and selection. What was cut off while it was being written is
    taken off the file, so that the next line begins anew. ValueError: it is of other sources or another selection."""
    rows, end = [], 0
    for line in path.read_bytes().splitlines(keepends=True):
        try:
            if not line.endswith(b"\n"):
                break
            rows.append(json.loads(line))
        except ValueError:
            break
        end += len(line)
    if not rows or rows[0] != header:
        raise ValueError(f"{path}: results of other sources, tests or options; begin anew without --resume")
    os.truncate(path, end)
    return rows[1:]
