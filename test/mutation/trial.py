# SPDX-License-Identifier: MIT
"""Puts one mutant on trial: compile it, link it into the test programs, run them until one of them notices.

Outcomes: `invalid` does not compile; `same` has the objects of the original, so nothing can notice it; `killed` and
`timeout` were noticed; `survived` passed every test. Whatever else happens is a ToolFailure.
"""

import concurrent.futures
import dataclasses
import itertools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import threading
import time

import workshop
from workshop import ToolFailure

# The programs that may notice a mutant of a folder: its own first.
PROGRAMS = {"core": ("core", "protocol", "avionics"), "protocol": ("protocol", "avionics"), "avionics": ("avionics",)}
SEEDS = {"RC_PARAMS": "seed=1", "FANTAIL_SEED": "1", "FANTAIL_FRAMES": "20000", "GTEST_COLOR": "no"}
# What cuts the power at every byte of the flash, or flips its bits, takes most of the time and tests the flash.
ALL_TESTS = {"avionics": "-PowerCut.*:BitFlip.*:FlightRegion.*:BootCounter.*:PlanStore.*"}
MEMORY_KB = 4 << 20


@dataclasses.dataclass
class Run:
    outcome: str  # passed, failed, timeout
    cpu_s: float
    last_words: str


def run_tests(program, pattern, cpu_limit_s, wall_limit_s):
    """One test program with a filter of googletest. What it writes goes into its folder."""
    # The shell sets the limits: what Python runs between fork and exec is not safe among threads.
    limits = f"ulimit -c 0 -v {MEMORY_KB} && ulimit -S -t {int(cpu_limit_s) + 1} && exec \"$@\""
    out = program.with_suffix(".out")
    with out.open("w+b") as stream:
        try:
            process = subprocess.Popen(["/bin/bash", "-c", limits, "limits", str(program), f"--gtest_filter={pattern}",
                                        "--gtest_fail_fast"], cwd=program.parent, env=os.environ | SEEDS,
                                       stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT,
                                       start_new_session=True)
        except OSError as error:
            raise ToolFailure(f"{program}: {error}") from error
        status, usage, late = wait(process, wall_limit_s)
        stream.seek(0)
        words = stream.read().decode(errors="replace")
    cpu_s = usage.ru_utime + usage.ru_stime
    code = os.waitstatus_to_exitcode(status)
    if late or code in (-signal.SIGXCPU, -signal.SIGKILL) and cpu_s >= cpu_limit_s:
        return Run("timeout", cpu_s, "")
    if code == 0 and not re.search(r"^\[  PASSED  \] [1-9]", words, re.M):
        raise ToolFailure(f"{program.name} --gtest_filter={pattern} ended with 0 and has passed no test: {words[-500:]}")
    if code in (77, 126, 127):
        raise ToolFailure(f"{program.name} --gtest_filter={pattern} ended with {code}: {words[-500:]}")
    failed = re.search(r"^\[  FAILED  \] ([\w./]+)", words, re.M) or re.search(r"^\[ RUN      \] (\S+)(?!.*RUN)", words, re.M)
    return Run("passed" if code == 0 else "failed", cpu_s, failed[1] if failed else f"exit code {code}")


def wait(process, wall_limit_s):
    """(status, rusage, whether it had to be killed because of the wall clock)."""
    end = time.monotonic() + wall_limit_s
    pause = 0.002
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return status, usage, False
        if time.monotonic() > end:
            os.killpg(process.pid, signal.SIGKILL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            return status, usage, True
        time.sleep(pause)
        pause = min(pause * 1.5, 0.1)


class Court:
    """What the mutants have in common: the archives of the originals, and how long the tests take on them."""

    def __init__(self, shop, say=lambda text: None):
        self.shop, self.say = shop, say
        self.archives = {}  # plain -> the archive
        self.baseline = {}  # (plain, program, filter) -> CPU seconds
        self.lock = threading.Lock()

    def prepare(self, plain_too, reuse=False):
        """Compiles the originals. `reuse`: those of a run of the same sources are taken as they are."""
        check_compiler(self.shop)
        for plain in (False, True) if plain_too else (False,):
            place = self.place_of(plain)
            archive = place / "originals.a"  # made last, so one that is there is whole
            if not (reuse and archive.exists()):
                archive.unlink(missing_ok=True)
                place.mkdir(parents=True, exist_ok=True)
                self.fill(archive, place, plain)
            self.archives[plain] = archive

    def fill(self, archive, place, plain):
        done, own = itertools.count(1), threading.local()
        names = itertools.count()

        def compile_one(file):
            if not hasattr(own, "place"):
                own.place = place / f"place{next(names)}"
                own.place.mkdir(exist_ok=True)
            obj, errors = self.shop.compile(own.place, file, plain)
            if obj is None:
                raise ToolFailure(f"{file} does not compile as it is: {errors[-2000:]}")
            for path in (obj, obj.with_name(obj.name + ".d")):
                path.rename(place / path.name)
            self.say(f"originals{', not inlined' if plain else ''}: {next(done)} of {len(self.shop.product)}")
            return str(place / obj.name)

        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            objects = list(pool.map(compile_one, self.shop.product))
        code, text = workshop.tool(["ar", "rcs", str(archive), *objects], place, "ar")
        if code != 0:
            raise ToolFailure(f"ar: {text[-500:]}")

    def place_of(self, plain):
        return self.shop.folder / ("plain" if plain else "own")

    def limit(self, plain, program, pattern):
        """CPU seconds that a mutant may take; the first time, the originals are run: their tests must pass."""
        key = (plain, program, pattern)
        with self.lock:
            if key not in self.baseline:
                place = self.shop.folder / f"baseline_{'plain' if plain else 'own'}"
                place.mkdir(parents=True, exist_ok=True)
                built = place / f"test_{program}"
                if not any(k[:2] == key[:2] for k in self.baseline):
                    built = self.shop.link(place, program, [], self.archives[plain])
                run = run_tests(built, pattern, 600, 1800)
                if run.outcome != "passed":
                    raise ToolFailure(f"test_{program} fails without any mutant: {run.outcome} {run.last_words}")
                self.baseline[key] = run.cpu_s
            return 3 + 5 * self.baseline[key]

    def patterns(self, mutant):
        """(program, filter): first the tests of that name, those without a board before them, then all of every program."""
        folder, stem = mutant.file.split("/")[1], pathlib.Path(mutant.file).stem
        for names in (f"{stem}_alone_test.cpp", f"{stem}*_test.cpp"):
            suites = set()
            for test in (self.shop.root / "test" / folder).glob(names):
                suites |= set(re.findall(r"^\s*(?:TEST(?:_[FP])?|TYPED_TEST|RC_GTEST_(?:FIXTURE_)?PROP)\(\s*(\w+)",
                                         test.read_text(), re.M))
            if suites:
                yield folder, ":".join(f"{suite}.*:*/{suite}.*:{suite}/*" for suite in sorted(suites))
        for program in PROGRAMS[folder]:
            yield program, ALL_TESTS.get(program, "*")

    def try_mutant(self, mutant, place):
        """(outcome, by which program and test)."""
        text = mutant.of((self.shop.root / mutant.file).read_bytes())
        if mutant.file.endswith(".cpp"):
            obj, _ = self.shop.compile(place, mutant.file, False, text)
            if obj is None:
                return "invalid", ""
            if obj.read_bytes() == (self.place_of(False) / obj.name).read_bytes():
                return "same", ""
            return self.tests(mutant, place, [obj], False)
        return self.try_header(mutant, place, text)

    def try_header(self, mutant, place, text):
        """First the fewest objects that have the function, then all of the product that read the header. Tests are not
        optimised: they call the function of the first object, too."""
        overlay = [(mutant.file.removeprefix("firmware/"), text)]
        archive = self.place_of(True)
        dependents = self.shop.dependents(mutant.file, archive)
        chosen = []
        if mutant.function:
            symbols = {f: workshop.defined_functions(archive / (f.replace("/", "_") + ".o"), mutant.function)
                       for f in dependents}
            chosen = workshop.fewest(symbols) if symbols else []
        stages = [chosen, dependents] if chosen and len(chosen) < len(dependents) else [dependents]
        outcome = "same", ""
        for files in stages:
            objects, differs = [], False
            for file in files:
                obj, _ = self.shop.compile(place, file, True, overlay=overlay)
                if obj is None:
                    return "invalid", ""
                differs = differs or obj.read_bytes() != (archive / obj.name).read_bytes()
                objects.append(obj)
            if not differs:
                continue
            outcome = self.tests(mutant, place, objects, True)
            if outcome[0] != "survived":
                return outcome
        return outcome

    def tests(self, mutant, place, objects, plain):
        linked = {}
        for program, pattern in self.patterns(mutant):
            limit = self.limit(plain, program, pattern)
            if program not in linked:
                linked[program] = self.shop.link(place, program, objects, self.archives[plain])
            run = run_tests(linked[program], pattern, limit, 60 + 20 * limit)
            if run.outcome != "passed":
                return {"failed": "killed"}.get(run.outcome, run.outcome), f"test_{program} {run.last_words}".strip()
        return "survived", ""


def check_compiler(shop):
    """A compiler that takes anything, or gives always the same, would make every mutant look harmless."""
    place, file = shop.folder / "check", shop.product[0]
    place.mkdir(parents=True, exist_ok=True)
    text = (shop.root / file).read_bytes()
    if shop.compile(place, file, False, text + b"\n#error no program\n")[0] is not None:
        raise ToolFailure("the compiler takes a file with an #error in it")
    objects = set()
    for more in (b"", b"\nint fantail_is_another_program = 1;\n"):
        obj, errors = shop.compile(place, file, False, text + more)
        if obj is None:
            raise ToolFailure(f"{file} does not compile as it is: {errors[-2000:]}")
        objects.add(obj.read_bytes())
    if len(objects) == 1:
        raise ToolFailure("the compiler makes the same object of two different programs")
    shutil.rmtree(place)
