# SPDX-License-Identifier: MIT
"""Every mutant of the files in scope. Reading a file with libclang takes longer than a trial, so what was found is kept in
build/mutation/mutants, by the content of all that decides it."""

import concurrent.futures
import dataclasses
import hashlib
import itertools
import json
import os
import pathlib
import threading

from mutant import Mutant

LOADING = threading.Lock()
HERE = pathlib.Path(__file__).resolve().parent


def all_mutants(shop, files, say):
    """`files` below the root, each with its mutants, in the order of the files."""
    folder = shop.folder / "mutants"
    folder.mkdir(parents=True, exist_ok=True)
    common = hashlib.sha256()
    headers = [path for part in ("firmware", "hal") for path in pathlib.Path(shop.root, part).rglob("*.h*")]
    for path in sorted(headers) + [HERE / "mutants.py", HERE / "mutant.py"]:
        common.update(path.read_bytes())
    numbers = itertools.count(1)

    def of(file):
        key = common.copy()
        key.update((shop.root / file).read_bytes() + json.dumps(shop.parse_arguments(file)).encode())
        kept = folder / (file.replace("/", "_") + ".json")
        data = json.loads(kept.read_text()) if kept.exists() else {}
        number = next(numbers)
        if data.get("key") != key.hexdigest():
            say(f"reading {number} of {len(files)}: {file}")
            data = {"key": key.hexdigest(), "mutants": [dataclasses.astuple(mutant) for mutant in read(shop, file)]}
            kept.write_text(json.dumps(data))
        return [Mutant(*fields) for fields in data["mutants"]]

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return list(itertools.chain.from_iterable(pool.map(of, files)))


def read(shop, file):
    import clang.cindex  # not before it is needed: --help works without libclang

    import mutants
    with LOADING:
        if not clang.cindex.Config.loaded:
            for library in ("/usr/lib/x86_64-linux-gnu/libclang-19.so.1", "libclang-19.so.1"):
                if os.path.exists(library) or not library.startswith("/"):
                    clang.cindex.Config.set_library_file(library)
                    break
            clang.cindex.Index.create()
    return mutants.mutants(file, str(shop.root / file), shop.parse_arguments(file))
