# SPDX-License-Identifier: MIT
"""Puts one mutant on trial: compile it, link it into the test programs, run their tests until one of them notices.

Outcomes: `invalid` does not compile; `same` has the objects of the original, so nothing can notice it; `killed` and
`timeout` were noticed, by a test that passes on the original; `survived` passed every test that
reaches it (reach.py), and every short one of its programs.
Whatever else happens is a ToolFailure.
"""

import collections
import concurrent.futures
import dataclasses
import itertools
import os
import re
import shutil
import signal
import subprocess
import threading

import reach
import symbols
import workshop
from workshop import LinkFailure, ToolFailure

# The programs that may notice a mutant of a folder: its own first.
PROGRAMS = {"core": ("core", "protocol", "avionics"), "protocol": ("protocol", "avionics"), "avionics": ("avionics",)}
MEMORY_KB = 4 << 20
LEAST_LIMIT_S = 2  # of the processor, for a test that takes no time
SHORT_S = 0.5  # as traced; the longer tests take three quarters of the time, and are asked only when they reach a mutant
KILLERS = 8  # so many tests, which have noticed mutants of the file last, come first


@dataclasses.dataclass
class Run:
    outcome: str  # passed, failed, timeout
    test: str  # that ended it; empty if all have passed
    seconds: dict  # test -> of the processor


RUNNING = set()  # the groups of processes of test programs


def end_group(group):
    try:
        os.killpg(group, signal.SIGKILL)
    except ProcessLookupError:
        pass


def end_all():
    """For an interruption: what runs has nobody any more who would listen."""
    for group in list(RUNNING):
        end_group(group)


def run_tests(program, tests, place, hits=None):
    """One test program with [(test, limit of the processor's seconds)]. What it writes goes into the folder `place`."""
    listed = place / "tests.txt"
    listed.write_text("".join(f"{limit} {name}\n" for name, limit in tests))
    words = ["trace", listed.name, str(hits)] if hits else ["run", listed.name]
    # The shell sets the limits: what Python runs between fork and exec is not safe among threads.
    try:
        process = subprocess.Popen(["/bin/bash", "-c", f"ulimit -c 0 -v {MEMORY_KB} && exec \"$@\"", "limits", str(program), *words],
                                   cwd=place, env=os.environ | workshop.SEEDS, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    except OSError as error:
        raise ToolFailure(f"{program}: {error}") from error
    RUNNING.add(process.pid)
    try:
        said = process.communicate()[0]
    finally:
        RUNNING.discard(process.pid)
        end_group(process.pid)  # what a test has left behind
    ended = re.findall(r"^(passed|failed|timeout) (\S+) (\S+)$", said, re.M)
    run = Run(ended[-1][0] if ended else "", ended[-1][1] if ended else "", {name: float(s) for _, name, s in ended})
    whole = len(ended) == len(tests) if run.outcome == "passed" else run.outcome != ""
    if not whole or not said.endswith("end\n") or process.returncode != (0 if run.outcome == "passed" else 1):
        raise ToolFailure(f"{program.name} ended with {process.returncode} and has not run what it should: {said[-500:]}")
    if run.outcome == "passed":
        run.test = ""
    return run


class Court:
    """What the mutants have in common: the archives of the originals, and which tests reach what."""

    def __init__(self, shop, say=lambda text: None):
        self.shop, self.say = shop, say
        self.reach = reach.Reach(shop)
        self.originals = {}  # program -> the test program without a mutant
        self.confirmed = {}  # (program, test) -> its limit: it passes on the original
        self.killers = collections.defaultdict(lambda: collections.deque(maxlen=KILLERS))  # file -> tests, the last first
        self.lock, self.compiling = threading.Lock(), threading.Lock()

    def prepare(self):
        """Compiles the originals and runs their tests; what an earlier run has left of the same sources is taken as it is."""
        check_compiler(self.shop)
        self.shop.runner()
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            try:
                for variant in ("plain", "traced"):
                    self.fill(variant, pool)
                self.reach.prepare(run_tests, pool, self.say)
            except BaseException:
                end_all()
                pool.shutdown(cancel_futures=True)
                raise

    def fill(self, variant, pool):
        folder = self.shop.folder / variant
        folder.mkdir(parents=True, exist_ok=True)
        stale = [file for file in self.shop.product if not self.shop.fresh(folder, file, variant)]
        archive = folder / "originals.a"  # made last, so one that is there is whole
        if not stale and archive.exists():
            return
        archive.unlink(missing_ok=True)
        own, names, done = threading.local(), itertools.count(), itertools.count(1)

        def compile_one(file):
            if not hasattr(own, "place"):
                own.place = folder / f"place{next(names)}"
                own.place.mkdir(exist_ok=True)
            self.shop.keep(own.place, folder, file, variant)
            self.say(f"originals, {variant}: {next(done)} of {len(stale)}")

        list(pool.map(compile_one, stale))
        objects = [str(folder / self.shop.object_name(file)) for file in self.shop.product]
        code, text = workshop.tool(["ar", "rcs", str(archive), *objects], folder, "ar")
        if code != 0:
            raise ToolFailure(f"ar: {text[-500:]}")

    def archive(self, variant):
        return self.shop.folder / variant / "originals.a"

    def confirm(self, program, test, limit):
        """The test must pass on the original, or it says nothing of a mutant."""
        with self.lock:
            if (program, test) in self.confirmed:
                return
            place = self.shop.folder / "plain" / program
            place.mkdir(parents=True, exist_ok=True)
            if program not in self.originals:
                self.originals[program] = self.shop.link(place, program, [], self.archive("plain"))[0]
            run = run_tests(self.originals[program], [(test, limit)], place)
            if run.outcome != "passed":
                raise ToolFailure(f"test_{program} fails without any mutant: {run.outcome} {run.test}")
            self.confirmed[program, test] = limit

    def try_mutant(self, mutant, place):
        """(outcome, by which program and test)."""
        text = mutant.of((self.shop.root / mutant.file).read_bytes())
        if mutant.file.endswith(".cpp"):
            return self.try_source(mutant, place, text)
        return self.try_header(mutant, place, text)

    def try_source(self, mutant, place, text):
        obj, _ = self.shop.compile(place, mutant.file, "plain", text)
        if obj is None:
            return "invalid", ""
        original = self.shop.folder / "plain" / obj.name
        if obj.read_bytes() == original.read_bytes():
            return "same", ""
        asked, outcome = self.tests(mutant, place, [obj], [], symbols.exports_data(original))
        if outcome[0] != "survived":
            return outcome
        # The optimiser sees more: if the product's own flags make no difference of it, there is none.
        folder, apart = self.shop.folder / "own", place / "own"
        folder.mkdir(exist_ok=True)
        apart.mkdir(exist_ok=True)
        with self.compiling:
            if not self.shop.fresh(folder, mutant.file, "own"):
                self.shop.keep(apart, folder, mutant.file, "own")
        obj, errors = self.shop.compile(apart, mutant.file, "own", text)
        if obj is None:
            raise ToolFailure(f"{mutant.id} compiles only without inlining: {errors[-2000:]}")
        if obj.read_bytes() == (folder / obj.name).read_bytes():
            return "same", ""
        return self.others(mutant, place, [place / original.name], asked)

    def try_header(self, mutant, place, text):
        """First the fewest objects that have the function, then all of the product that read the header. Tests are not
        optimised: they call the function of the first object, too."""
        overlay = [(mutant.file.removeprefix("firmware/"), text)]
        folder = self.shop.folder / "plain"
        dependents = self.shop.dependents(mutant.file, folder)
        chosen = []
        if mutant.function:
            found = {f: symbols.defined_functions(folder / self.shop.object_name(f), mutant.function) for f in dependents}
            chosen = symbols.fewest(found) if found else []
        stages = [chosen, dependents] if chosen and len(chosen) < len(dependents) else [dependents]
        exports = any(symbols.exports_data(folder / self.shop.object_name(f)) for f in dependents) if mutant.early else False
        outcome, asked, changed = ("same", ""), set(), []
        for files in stages:
            objects, differs = [], False
            for file in files:
                obj, _ = self.shop.compile(place, file, "plain", overlay=overlay)
                if obj is None:
                    return "invalid", ""
                differs = differs or obj.read_bytes() != (folder / obj.name).read_bytes()
                objects.append(obj)
            if not differs:
                continue
            changed = objects
            try:
                asked, outcome = self.tests(mutant, place, objects, dependents, exports)
            except LinkFailure:
                if not mutant.early:
                    raise
                outcome = "survived", ""  # the tests are compiled with it, too, in others()
            if outcome[0] != "survived":
                return outcome
        return self.others(mutant, place, changed, asked, text) if changed else outcome

    def tests(self, mutant, place, objects, readers, exports):
        """By those that reach it: (which, outcome)."""
        asked = set()
        for program in PROGRAMS[mutant.file.split("/")[1]]:
            with self.lock:
                killers = list(self.killers[mutant.file])
            tests = sorted(self.reach.of(mutant, program, readers, exports),
                           key=lambda t: (killers.index(t[0]) - KILLERS if t[0] in killers and t[1] < 1 else t[1]))
            asked |= {(program, name) for name, _ in tests}
            if tests and (noticed := self.noticed(mutant, place, program, objects, tests)):
                return asked, noticed
        return asked, ("survived", "")

    def others(self, mutant, place, objects, asked, header=None):
        """By all short tests, because reach.py may be wrong. `header`: the text of one; a test that reads it may have values
        of its own from it, and is asked again."""
        compiled = header is not None and mutant.early
        count = 0
        for program in PROGRAMS[mutant.file.split("/")[1]]:
            instead = self.shop.tests_with(place, program, mutant.file, header) if compiled else {}
            if instead is None:
                return "invalid", ""
            tests = sorted(((name, seconds) for name, seconds in self.reach.tests[program]
                            if seconds < SHORT_S and (instead or (program, name) not in asked)), key=lambda t: t[1])
            count += len({(program, name) for name, _ in tests} - asked)
            if tests and (noticed := self.noticed(mutant, place, program, objects, tests, instead)):
                return noticed
        return "survived", f"{len(asked)} tests reach it, nor do {count} others notice it"

    def noticed(self, mutant, place, program, objects, tests, instead=()):
        """(outcome, by which program and test), or None."""
        linked, _ = self.shop.link(place, program, objects, self.archive("plain"), instead=instead)
        limits = {name: LEAST_LIMIT_S + int(5 * seconds) for name, seconds in tests}
        run = run_tests(linked, list(limits.items()), place)
        if run.outcome == "passed":
            return None
        self.confirm(program, run.test, limits[run.test])
        with self.lock:
            if run.test in self.killers[mutant.file]:
                self.killers[mutant.file].remove(run.test)
            self.killers[mutant.file].appendleft(run.test)
        return {"failed": "killed"}.get(run.outcome, run.outcome), f"test_{program} {run.test}"


def check_compiler(shop):
    """A compiler that takes anything, or gives always the same, would make every mutant look harmless."""
    place, file = shop.folder / "check", shop.product[0]
    place.mkdir(parents=True, exist_ok=True)
    text = (shop.root / file).read_bytes()
    if shop.compile(place, file, "plain", text + b"\n#error no program\n")[0] is not None:
        raise ToolFailure("the compiler takes a file with an #error in it")
    objects = set()
    for more in (b"", b"\nint fantail_is_another_program = 1;\n"):
        obj, errors = shop.compile(place, file, "plain", text + more)
        if obj is None:
            raise ToolFailure(f"{file} does not compile as it is: {errors[-2000:]}")
        objects.add(obj.read_bytes())
    if len(objects) == 1:
        raise ToolFailure("the compiler makes the same object of two different programs")
    shutil.rmtree(place)
