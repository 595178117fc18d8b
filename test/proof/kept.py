# SPDX-License-Identifier: MIT
"""Verdicts of earlier runs of the prover, for --resume: a run need not be repeated while everything that it read is the same."""

import dataclasses
import functools
import hashlib
import json
import os
import pathlib
import re

import prover

INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)


@functools.cache
def digest_of_file(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def files_read(source, folders):
    """`source` and all that it includes, by any of its branches. What is in none of the folders comes with the prover."""
    found, waiting = {}, [pathlib.Path(source)]
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found[path] = True
        for kind, name in INCLUDE.findall(path.read_bytes()):
            beside = [path.parent] if kind == b'"' else []
            for folder in [*beside, *folders]:
                if (candidate := pathlib.Path(folder) / name.decode()).is_file():
                    waiting.append(candidate)
                    break
    return found


def digest_of(command, folders):
    """Of the prover, of its words and of the files that it reads. command[0] is the prover, command[1] the harness."""
    digest = hashlib.sha256()
    for word in [digest_of_file(os.path.realpath(command[0])), *command[1:]]:
        digest.update(f"{word}\n".encode())
    for path in sorted(files_read(command[1], folders)):
        digest.update(f"{path} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return digest.hexdigest()


def read(path, digest):
    """The verdict in `path`, if it is of this digest; else None. Whoever reads it must hold it against what was wanted."""
    try:
        stored = json.loads(pathlib.Path(path).read_text())
        return prover.Verdict(**stored["verdict"]) if stored["digest"] == digest else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def write(path, digest, verdict):
    path = pathlib.Path(path)
    new = path.with_suffix(".new")
    new.write_text(json.dumps({"digest": digest, "verdict": dataclasses.asdict(verdict)}) + "\n")
    new.replace(path)
