# SPDX-License-Identifier: MIT
"""Which tests can notice a change of a line: those that reach it.

Every test runs alone, once, on the product of the variant `traced`: GCC calls a function of runner.cpp at the beginning of each
basic block, and the table of lines says which lines a block has. A line that no table has, and what the compiler may have
computed itself (a constant, a constexpr function), is reached by every test that reaches the file; of a header, by every
test that reaches a file that reads it.
"""

import bisect
import collections
import hashlib
import json
import re
import struct
import sys

import workshop
from workshop import ToolFailure

# What cuts the power at every byte of the flash, or flips its bits, takes most of the time and tests the flash.
LEFT_OUT = {"avionics": ("PowerCut", "BitFlip", "FlightRegion", "BootCounter", "PlanStore")}
TRACE_LIMIT_S = 600
CALL_BYTES = 5  # E8 and a distance


class Reach:
    """`tests`: program -> [(name, CPU seconds)]. The sets of tests are bits: the first test is bit 0."""

    def __init__(self, shop):
        self.shop = shop
        self.tests, self.lines, self.files = {}, {}, {}

    def prepare(self, run_tests, pool, say):
        """Runs every test on the traced product, if test or product have changed since. `run_tests` is trial.run_tests."""
        waiting = []
        for program in workshop.FOLDERS:
            place = self.shop.folder / "traced" / program
            place.mkdir(parents=True, exist_ok=True)
            key = self.key(program)
            cache = place / "reach.json"
            data = json.loads(cache.read_text()) if cache.exists() else {}
            if data.get("key") == key:
                self.take(program, data)
            else:
                waiting.append((program, place, cache, key))
        for program, place, cache, key in waiting:
            built = self.link(program, place)
            names = [n for n in list_tests(built) if n.split(".")[0] not in LEFT_OUT.get(program, ())]
            # One after another each, in parts, so that every processor has one.
            parts = [names[i::4] for i in range(4) if names[i::4]]
            said = f"what {len(names)} tests of {program} reach"
            say(said)
            jobs = [pool.submit(trace, run_tests, built, place / f"part{i}", part) for i, part in enumerate(parts)]
            done = {}
            for number, job in enumerate(jobs, 1):
                done |= job.result()
                say(f"{said}: {number} of {len(jobs)} parts")
            data = {"key": key, "tests": [[name, done[name][0]] for name in names]}
            data["lines"], data["files"] = lines_of(built, [done[name][1] for name in names])
            cache.write_text(json.dumps(data))
            self.take(program, data)

    def key(self, program):
        digest = hashlib.sha256(json.dumps([workshop.SEEDS, LEFT_OUT]).encode())
        objects, libraries = self.shop.links[program]
        for path in (*objects, *libraries, self.shop.folder / "traced/originals.a", self.shop.folder / "runner.o", __file__):
            with open(path, "rb") as stream:
                digest.update(stream.read())
        return digest.hexdigest()

    def take(self, program, data):
        self.tests[program] = [tuple(test) for test in data["tests"]]
        self.lines[program] = {file: {int(line): int(tests, 16) for line, tests in lines.items()}
                               for file, lines in data["lines"].items()}
        self.files[program] = {file: int(tests, 16) for file, tests in data["files"].items()}

    def link(self, program, place):
        """Every object of the product that it needs stands first: an inline function is the product's, which is traced."""
        folder = self.shop.folder / "traced"
        _, said = self.shop.link(place, program, [], folder / "originals.a", "-Wl,--trace")
        members = sorted(set(re.findall(r"originals\.a\(([^()\s]+\.o)\)", said)))
        if not members:
            raise ToolFailure(f"the linker does not say what test_{program} takes from originals.a: {said[-500:]}")
        return self.shop.link(place, program, [folder / name for name in members], folder / "originals.a")[0]

    def of(self, mutant, program, readers, exports):
        """[(test, CPU seconds)] of those that can notice it. `readers`: the files of the product that read this header;
        `exports`: whether an object of the file has data that other files see."""
        name = mutant.file.rsplit("/", 1)[1]
        every = (1 << len(self.tests[program])) - 1
        lines, files = self.lines[program].get(name, {}), self.files[program]
        found = [lines[line] for line in range(mutant.line, mutant.last_line + 1) if line in lines]
        if exports and (mutant.early or not found):
            mask = every
        elif mutant.early or not found or mutant.file == workshop.ALWAYS_INLINED:
            mask = files.get(name, 0)
            for reader in readers:
                mask |= files.get(reader.rsplit("/", 1)[1], 0)
        else:
            mask = 0
            for tests in found:
                mask |= tests
            if workshop.ALWAYS_INLINED in readers: # it has optimised copies of what it reads
                mask |= files.get(workshop.ALWAYS_INLINED.rsplit("/", 1)[1], 0)
        return [test for bit, test in enumerate(self.tests[program]) if mask >> bit & 1]


def list_tests(program):
    code, text = workshop.tool([str(program), "list"], program.parent, f"the list of {program.name}")
    names = re.findall(r"^[\w/]+\.[\w/]+$", text, re.M)
    if code != 0 or not names:
        raise ToolFailure(f"{program.name} names no tests: {text[-500:]}")
    if disabled := [name for name in names if "DISABLED_" in name]:
        print(f"mutate: {program.name}: these tests are disabled and can notice nothing: {', '.join(disabled)}", file=sys.stderr)
    return [name for name in names if name not in disabled]


def trace(run_tests, program, place, names):
    """name -> (CPU seconds, places)."""
    place.mkdir(parents=True, exist_ok=True)
    hits = place / "hits.txt"
    run = run_tests(program, [(name, TRACE_LIMIT_S) for name in names], place, hits)
    if run.outcome != "passed":
        raise ToolFailure(f"{program.name} fails without any mutant: {run.outcome} {run.test}")
    places = {words[0]: [int(word) for word in words[1:]] for words in map(str.split, hits.read_text().splitlines())}
    hits.unlink()
    return {name: (run.seconds[name], places[name]) for name in names}


def call_sites(program):
    """The addresses behind each call of the function that notes a place."""
    text = output(["nm", program])
    callee = int(re.search(r"^(\w+) \w __sanitizer_cov_trace_pc$", text, re.M)[1], 16)
    match = re.search(r"\s\.text\s+PROGBITS\s+(\w+)\s+(\w+)\s+(\w+)", output(["readelf", "-SW", program]))
    address, offset, size = (int(word, 16) for word in match.groups())
    with open(program, "rb") as stream:
        stream.seek(offset)
        code = stream.read(size)
    sites, at = [], code.find(b"\xe8")
    while 0 <= at <= size - CALL_BYTES:
        behind = address + at + CALL_BYTES
        if behind + struct.unpack_from("<i", code, at + 1)[0] == callee:
            sites.append(behind)
        at = code.find(b"\xe8", at + 1)
    return sites, address


def lines_of(program, reached_by):
    """(file -> line -> tests, file -> tests), the tests as hexadecimal digits. `reached_by`: the places of each test."""
    tests = collections.defaultdict(int)
    for bit, reached in enumerate(reached_by):
        for place in reached:
            tests[place] |= 1 << bit
    sites, begin = call_sites(program)
    places = set(sites)
    if not tests.keys() <= places:
        raise ToolFailure(f"{program.name}: a place was reached that is none")
    lines, rows = collections.defaultdict(lambda: collections.defaultdict(int)), []
    for file, line, address in re.findall(r"^(\S+\.[ch]pp) +(\d+|-) +0x(\w+)", output(
            ["objdump", "-w", "-WL", program]), re.M):
        rows.append((file.rsplit("/", 1)[-1], line, int(address, 16)))
    for (file, line, address), (_, _, end) in zip(rows, rows[1:]):
        if line == "-" or address < begin:
            continue
        # The block that the line begins in, unless it begins with a block, and those that begin in it. The call at its end
        # belongs to what comes behind it.
        first = max(bisect.bisect_right(sites, address) - (address + CALL_BYTES not in places), 0)
        reached = 0
        for site in sites[first : max(bisect.bisect_left(sites, end), first + 1)]:
            reached |= tests.get(site, 0)
        lines[file][int(line)] |= reached
    if not lines:
        raise ToolFailure(f"objdump knows no lines of {program}")
    files = {}
    for file, of_file in lines.items():
        files[file] = 0
        for mask in of_file.values():
            files[file] |= mask
    return ({file: {line: f"{mask:x}" for line, mask in of_file.items()} for file, of_file in lines.items()},
            {file: f"{mask:x}" for file, mask in files.items()})


def output(words):
    code, text = workshop.tool([str(word) for word in words], None, words[0])
    if code != 0:
        raise ToolFailure(f"{words[0]}: {text[-500:]}")
    return text
