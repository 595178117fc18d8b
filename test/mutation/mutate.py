# SPDX-License-Identifier: MIT
"""Usage: mutate.py [--sample N] [--seed S] [--all] [--file F]... [--resume] [--json] [--check-options]

Changes the code that moves canards in one place at a time and asks whether a test notices (docs/evidence.md). It needs
build/host with test_core, test_protocol and test_avionics; build/mutation takes objects, programs and results_*.jsonl, one line
a trial. --check-options: no more than that.

Exit code: 0 noticed, or the survivor has its reason in survivors.txt; 1 not; 64 usage; 65 survivors.txt is wrong, or
results of other sources were to be resumed; 66 there is nothing to resume; 70 compiler, linker, tests or libclang failed;
73 build/mutation cannot be written; 130 interrupted.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import random
import signal
import sys
import threading
import time

sys.dont_write_bytecode = True  # not between the sources
import catalogue
import judge
import stored
import trial
import workshop

SCOPE = ("firmware/core", "firmware/protocol", "firmware/avionics/arming", "firmware/avionics/bench_mode",
         "firmware/avionics/self_test", "firmware/avionics/self_test_verdicts", "firmware/avionics/flight_memory")
# As in test/coverage: for the compiler, for a board, and for the link of an emulated processor.
LEFT_OUT = ("firmware/core/flight_plan_table.hpp", "firmware/protocol/crc32c_tables.cpp", "firmware/protocol/hil_frame.cpp",
            "firmware/protocol/hil_frame.hpp", "firmware/protocol/hil_codec.hpp")


def sources(root):
    """The files in scope, below the root."""
    found = []
    for part in SCOPE:
        path = pathlib.Path(root, part)
        found += path.glob("*.[ch]pp") if path.is_dir() else path.parent.glob(path.name + ".[ch]pp")
    return sorted(str(p.relative_to(root)) for p in found if str(p.relative_to(root)) not in LEFT_OUT)


def fingerprint(root):
    """Of everything that decides a trial: other sources or tests, other results."""
    digest = hashlib.sha256()
    for folder in ("firmware", "hal", "test/core", "test/protocol", "test/avionics", "test/mutation"):
        for path in sorted(pathlib.Path(root, folder).rglob("*.[chp][ppy]*")):
            digest.update(f"{path.relative_to(root)}\n".encode() + path.read_bytes())
    return digest.hexdigest()


class Progress:
    """A line that is kept up to date on a terminal, and a line every ten seconds in a pipe."""

    def __init__(self, total):
        self.total, self.done, self.alive = total, 0, 0
        self.begun = self.said = time.monotonic()

    def say(self, text, always=False):
        now = time.monotonic()
        if sys.stderr.isatty():
            print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)
        elif always or now - self.said >= 10:
            self.said = now
            print(text, file=sys.stderr, flush=True)

    def count(self, outcome):
        self.done += 1
        self.alive += outcome == "survived"
        rate = self.done / max(time.monotonic() - self.begun, 1e-3)
        left = (self.total - self.done) / rate
        self.say(f"mutants: {self.done} of {self.total}, {self.alive} alive, {rate * 60:.1f} a minute, about "
                 f"{left:.0f} s to go")

    def end(self):
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def select(mutants, options):
    if options.all or options.file:
        return mutants
    return sorted(random.Random(options.seed).sample(mutants, min(options.sample, len(mutants))),
                  key=lambda m: (m.file, m.begin, m.end))


def run_all(court, chosen, results_file, results, progress):
    """Tries them, as many at a time as there are processors, and writes each result as it comes."""
    places, lock, stop = threading.local(), threading.Lock(), threading.Event()
    numbers = iter(range(10**9))

    def one(mutant):
        if stop.is_set():
            return
        if not hasattr(places, "path"):
            with lock:
                places.path = court.shop.folder / f"place{next(numbers)}"
            places.path.mkdir(exist_ok=True)
        begun = time.monotonic()
        outcome, by = court.try_mutant(mutant, places.path)
        row = {"id": mutant.id, "file": mutant.file, "was": mutant.was, "now": mutant.now, "outcome": outcome, "by": by,
               "seconds": round(time.monotonic() - begun, 2), "begin": mutant.begin}
        with lock:
            results_file.write(json.dumps(row) + "\n")
            results_file.flush()
            results.append(row)
            progress.count(outcome)

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        futures = [pool.submit(one, mutant) for mutant in chosen]
        try:
            for future in concurrent.futures.as_completed(futures):
                future.result()
        except BaseException:
            stop.set()
            trial.end_all()
            pool.shutdown(cancel_futures=True)
            raise


def parse(arguments, root):
    parser = argparse.ArgumentParser(prog="./dev mutate", usage=(
        "./dev mutate [--sample N] [--seed S] [--all] [--file F]... [--resume] [--json]"))
    parser.add_argument("--sample", type=int, help="so many mutants, drawn from all [300]")
    parser.add_argument("--seed", type=int, help="of the draw [a new one, which is printed]")
    parser.add_argument("--all", action="store_true", help="every mutant: hours")
    parser.add_argument("--file", action="append", default=[], help="every mutant of this file; may be given again")
    parser.add_argument("--resume", action="store_true", help="go on where an interrupted run has stopped: with the options given, or else the last one")
    parser.add_argument("--json", action="store_true", help="print the page of figures as JSON")
    parser.add_argument("--check-options", action="store_true", help=argparse.SUPPRESS)
    parser.error = lambda message: (print(f"mutate: {message}; ./dev mutate --help", file=sys.stderr), sys.exit(64))
    options = parser.parse_args(arguments)
    if options.sample is not None and options.sample < 1:
        parser.error(f"--sample {options.sample}: it must be at least 1")
    if sum((options.sample is not None, options.all, bool(options.file))) > 1:
        parser.error("--sample, --all and --file: one of them")
    files = sources(root)
    if unknown := [file for file in options.file if file not in files]:
        parser.error(f"--file {unknown[0]}: not one of the {len(files)} files that are mutated, for example {files[0]}")
    return options, files


def main(arguments, root):
    options, files = parse(arguments, root)
    if options.check_options:
        return 0
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    begun, build = time.monotonic(), pathlib.Path(root, "build")
    folder = build / "mutation"
    results_path = None
    progress = Progress(0)
    try:
        if options.resume and options.sample is None and not options.all and not options.file:
            last = stored.newest_selection(folder)
            if last is None:
                raise FileNotFoundError(2, "", str(folder / "results_*.jsonl"))
            vars(options).update(last)
        if options.sample is None:
            options.sample = 300
        if options.resume and options.seed is None and (last := stored.newest_selection(folder)):
            options.seed = last["seed"]
        if options.seed is None:
            options.seed = random.SystemRandom().randrange(2**31)
        known = judge.read_survivors(pathlib.Path(root, "test/mutation/survivors.txt"))
        header = {"sources": fingerprint(root), "seed": options.seed, "all": options.all, "file": options.file,
                  "sample": options.sample}
        folder.mkdir(parents=True, exist_ok=True)
        path = stored.path_of(folder, header)
        results = stored.read(path, header) if options.resume else []
        results_path = path if options.resume else None
        shop = workshop.Workshop(root, build / "host", folder)
        everything = catalogue.all_mutants(shop, options.file or files, progress.say)
        chosen = select(everything, options)
        tried = {(r["file"], r["begin"], r["now"]) for r in results}
        left = [m for m in chosen if (m.file, m.begin, m.now) not in tried]
        print(f"seed {options.seed}; the same again with --seed {options.seed}", file=sys.stderr)
        court = trial.Court(shop, progress.say)
        court.prepare()
        progress = Progress(len(left))
        results_path = path
        with path.open("a" if options.resume else "w") as stream:
            if not options.resume:
                stream.write(json.dumps(header) + "\n")
                stream.flush()
            run_all(court, left, stream, results, progress)
        progress.end()
    except KeyboardInterrupt:
        progress.end()
        print("mutate: interrupted" + (f"; what was tried is in {results_path}: go on with --resume" if results_path else
                                       " before anything was tried"), file=sys.stderr)
        return 130
    except workshop.ToolFailure as error:
        progress.end()
        print(f"mutate: {error}", file=sys.stderr)
        return 70
    except FileNotFoundError as error:
        print(f"mutate: {error.filename}: there is no such file", file=sys.stderr)
        return 66
    except OSError as error:
        print(f"mutate: {error.filename}: {error.strerror}", file=sys.stderr)
        return 73
    except ValueError as error:
        print(f"mutate: {error}", file=sys.stderr)
        return 65
    in_scope = {entry for entry in known.values() if not options.file or entry.file in options.file}
    verdict = judge.judge(results, {e.key: e for e in in_scope}, collections.Counter((m.file, m.was, m.now) for m in everything))
    what = f"{len(results)} of {len(everything)} mutants" + ("" if options.all or options.file else f", seed {options.seed}")
    command = " ".join(["./dev mutate", *arguments])
    page = judge.page(verdict, command, time.monotonic() - begun, what)
    figures = build / "figures"
    figures.mkdir(exist_ok=True)
    if not options.file:  # a part must not stand for the whole
        (figures / "mutation.json").write_text(json.dumps(page, indent=1) + "\n")
    print(json.dumps(page) if options.json else "\n".join(
        [what, *("  ".join(f"{cell:>9}" if i else f"{cell:<44}" for i, cell in enumerate(row))
                 for row in [page["tables"][0]["columns"], *page["tables"][0]["rows"]]), *page["notes"]]))
    return 0 if verdict.passed else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], pathlib.Path(__file__).resolve().parents[2]))
