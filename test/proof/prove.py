# SPDX-License-Identifier: MIT
"""Usage: prove.py PROVER BUILD_FOLDER [--quick] [--resume] [--list] [--json] [--table FILE.py] [NAME...]

Proves with ESBMC what proofs.py lists, of the sources of the flight code themselves. For each proof there are three kinds of
runs, and it counts only if all of them end as they must:
  claims    the harness as it is: every claim in it holds
  places    each numbered place of the harness is reached, so that no claim is true because nothing gets there
  bugs      the same claims with a known error put into a copy of one source file: each must be refuted
With --resume a run that ended as it must is not repeated, if the prover, its words and all files that it read are the same.
Exit code: 0 all as they must be; 1 not so; 64 wrong usage; 66 a file is missing; 70 the prover cannot be run; 73 the folder
cannot be written; 75 another one is running in it; 130 interrupted.
"""

import argparse
import fcntl
import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import figures
import kept
import prover
from job import HERE, Stop, jobs_of

VERSION = "ESBMC version 8.4.0"
AT_ONCE = max(1, min(2, len(os.sched_getaffinity(0))))


class Asked:
    """To end. An exception in the middle of the start of a run would leave a process that nobody knows."""

    to_end = False

    def __call__(self, number, frame):
        self.to_end = True


def run(jobs, esbmc, build, say):
    """Every job, AT_ONCE at a time, the longest first."""
    asked = Asked()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, asked)
    waiting = sorted(jobs, key=lambda job: -job.proof.seconds)
    running, done, said_at, begun = {}, 0, time.monotonic(), time.monotonic()
    try:
        while waiting or running:
            if asked.to_end:
                raise KeyboardInterrupt
            while waiting and len(running) < AT_ONCE:
                job = waiting.pop(0)
                running[job] = prover.Run(job.command(esbmc), build / f"{job.place}.log", job.proof.seconds, job.proof.megabytes)
            for job in list(running):
                job.verdict = running[job].verdict()
                if job.verdict:
                    del running[job]
                    done += 1
                    say(job.line())
                    # What was changed meanwhile may have been read before or after.
                    if not job.fault() and job.digest == kept.digest_of(job.command(esbmc), job.folders()):
                        kept.write(build / f"{job.place}.json", job.digest, job.verdict)
            if time.monotonic() - said_at >= 10:
                said_at = time.monotonic()
                say(
                    f"prove: {done} of {len(jobs)} runs done after {said_at - begun:.0f} s; now: {'; '.join(job.name for job in running)}"
                )
            time.sleep(0.02)
    finally:
        for process in running.values():
            process.stop()


def take_kept(jobs, build):
    """Gives the runs that need not be repeated the verdict that they had; returns the others."""
    for job in jobs:
        job.verdict = kept.read(build / f"{job.place}.json", job.digest)
        if job.verdict and job.fault():
            job.verdict = None
        job.kept = job.verdict is not None
    return [job for job in jobs if not job.kept]


def alone_in(build):
    """Two at once would write each other's files. Held until the end of this program."""
    build.mkdir(parents=True, exist_ok=True)
    lock = open(build / "lock", "a", encoding="ascii")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise Stop(75, f"another one is running in {build}; wait for its end") from None
    return lock


def check_prover(esbmc):
    try:
        answer = subprocess.run([esbmc, "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Stop(70, f"the prover {esbmc} cannot be run: {error}") from None
    if VERSION not in answer.stdout + answer.stderr:
        said = (answer.stdout + answer.stderr).strip().splitlines()
        raise Stop(70, f"{esbmc} is not {VERSION}; it said: {said[0] if said else 'nothing'}")


def table(path):
    specification = importlib.util.spec_from_file_location("table_of_proofs", path)
    module = importlib.util.module_from_spec(specification)
    sys.modules[specification.name] = module
    specification.loader.exec_module(module)
    return module.PROOFS


def prove(options):
    proofs = table(options.table)
    unknown = sorted(set(options.names) - {proof.name for proof in proofs})
    if unknown:
        raise Stop(64, f"there is no proof {', '.join(name or repr(name) for name in unknown)}; prove --list names them")
    if options.names:
        proofs = [proof for proof in proofs if proof.name in options.names]
    if options.quick:
        proofs = [proof for proof in proofs if proof.quick]
    if options.list and options.json:
        print(json.dumps([{"name": proof.name, "quick": proof.quick, "says": proof.says} for proof in proofs], indent=1))
        return 0
    if options.list:
        for proof in proofs:
            print(f"{proof.name:22}{'quick  ' if proof.quick else '       '}{proof.says}")
        return 0
    if not proofs:
        raise Stop(64, "none of the proofs that were named is a quick one")
    check_prover(options.prover)
    build = pathlib.Path(options.build) / "prove"
    lock = alone_in(build)
    out = sys.stderr if options.json else sys.stdout
    begun = time.monotonic()
    jobs = [job for proof in proofs for job in jobs_of(proof, build, options.quick)]
    for job in jobs:
        job.digest = kept.digest_of(job.command(options.prover), job.folders())
    to_run = take_kept(jobs, build) if options.resume else jobs
    run(to_run, options.prover, build, lambda line: print(line, file=out, flush=True))
    rows = figures.results(proofs, jobs)
    seconds = time.monotonic() - begun
    passed = all(row["proved"] for row in rows)
    figures_file = pathlib.Path(options.build) / "figures" / "proofs.json"
    figures_file.parent.mkdir(parents=True, exist_ok=True)
    words = ["--quick"] * options.quick + ["--resume"] * options.resume + options.names
    command = " ".join(["./dev prove", *words])
    with_what = f"{VERSION}, solver Boolector, {AT_ONCE} runs at a time."
    earlier = f"{len(jobs) - len(to_run)} of {len(jobs)} runs are of earlier calls, in which the prover read the same."
    notes = [with_what] + [earlier] * options.resume
    if not options.names and not options.quick:  # a part must not stand for the whole
        figures_file.write_text(json.dumps(figures.page(rows, seconds, passed, command, notes), indent=1) + "\n")
    if options.json:
        print(json.dumps({"passed": passed, "quick": options.quick, "seconds": round(seconds, 1), "proofs": rows}, indent=1))
    bad = [row["name"] for row in rows if not row["proved"]]
    cpu = sum(row["cpu_seconds"] for row in rows)
    print(
        f"prove: {len(rows) - len(bad)} of {len(rows)} properties "
        f"{'hold, each with its first place and bug alone' if options.quick else 'proved'}, {sum(row['bugs_refuted'] for row in rows)} of "
        f"{sum(row['bugs'] for row in rows)} seeded bugs refuted, in {seconds:.0f} s ({cpu:.0f} CPU s"
        + (f"; taken from earlier calls: {len(jobs) - len(to_run)} of {len(jobs)} runs)" if options.resume else ")")
        + (f"; NOT PROVED: {', '.join(bad)}; what the prover said is in {build}/NAME/*.log" if bad else ""),
        file=out,
    )
    lock.close()
    return 0 if passed else 1


def main(words):
    parser = argparse.ArgumentParser(
        prog="prove",
        usage="./dev prove [--quick] [--resume] [--list] [--json] [NAME...]",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("prover")
    parser.add_argument("build")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument(
        "--quick", action="store_true", help="some proofs, each with its first place and its first bug: a minute"
    )
    parser.add_argument(
        "--resume", action="store_true", help="do not repeat a run if all that the prover read in it is the same"
    )
    parser.add_argument("--list", action="store_true", help="name the proofs and what they say; prove nothing")
    parser.add_argument("--json", action="store_true", help="print the results as JSON, and the progress on standard error")
    parser.add_argument("--table", default=HERE / "proofs.py", help=argparse.SUPPRESS)
    try:
        options = parser.parse_intermixed_args(words)
    except SystemExit as end:
        return 64 if end.code else 0
    try:
        return prove(options)
    except Stop as stop:
        print(f"prove: {stop}", file=sys.stderr)
        return stop.code
    except KeyboardInterrupt:
        print("prove: interrupted; nothing was proved. --resume goes on with the runs that are left", file=sys.stderr)
        return 130
    except FileNotFoundError as error:
        print(f"prove: {error.filename} is missing", file=sys.stderr)
        return 66
    except OSError as error:
        print(f"prove: {error}", file=sys.stderr)
        return 73


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    sys.exit(main(sys.argv[1:]))
