# SPDX-License-Identifier: MIT
# The long tests, as many at once as there are cores; their figures as JSON for a page of docs/figures.
#
#   soak.py ROOT [--short] [--resume | --failed] [--only NAME...]
#
# Each step writes build/soak/NAME.log and NAME.json as it ends; --resume leaves out those that the same sources have passed, --failed
# those that any sources have passed: then the page says of each row of which commit it is.
# Exit code 1 if a step failed or could not be read, 66 if the program of one is not there, 130 after an interrupt.
import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time

from figures import commit
from soak_steps import STEPS

# What a step is made of: a program of what ninja says and of what is always there; the proofs, and what is no program of a build:
PROOFS = ("firmware", "hal", "test/proof")
EVERYTHING = ("CMakeLists.txt", "CMakePresets.json", "cmake", "firmware", "hal", "sim", "third_party", "tools", "test")
ALWAYS = ("CMakeLists.txt", "CMakePresets.json", "cmake", "firmware/plans", "sim/*/*.toml", "sim/*/*.csv")
TESTS_PASSED = ("tests passed", r"\[  PASSED  \] ([1-9]\d*) tests?\b")


def seeds_of(target, folder, root):
    """The files that a fuzzer begins from; what it finds goes into the build folder, not into the sources."""
    (folder / f"found_{target}").mkdir(parents=True, exist_ok=True)
    place = folder / f"seeds_{target}"
    if target == "csv":
        if not place.exists():
            place.symlink_to(root / "test/fuzz/csv_corpus")
        return
    place.mkdir(exist_ok=True)
    writer = "write_log_seeds" if target == "log" else f"{target}_seeds"
    subprocess.run([root / "build/fuzz/test/fuzz" / writer, place], check=True)


class Step:
    def __init__(self, row, arguments, folder, builds):
        self.name, self.title, self.unit, count, command, environment, self.reads = row
        if "--gtest_filter=" in command:  # a name that no test has would pass
            self.reads = [*self.reads, TESTS_PASSED]
        self.count = max(count // 1000, 1) if arguments.short else count
        fill = {"n": self.count, "seed": arguments.seed, "host": "build/host", "fuzz": "build/fuzz",
                **({"every": 1000, "false": 0.1, "missed": 2, "proofs": "--quick"} if arguments.short else
                   {"every": 10, "false": 0.0001, "missed": 0.05, "proofs": ""})}
        self.command = command.format(**fill)
        self.program = self.command.split()[0]
        self.environment = {name: value.format(**fill) for name, value in environment.items()}
        self.environment["FANTAIL_SEED"] = str(arguments.seed)
        self.log = folder / f"{self.name}.log"
        self.file = folder / f"{self.name}.json"
        self.key = f"{builds.digest(self.name, self.command)} {self.count}"
        self.process = None

    @property
    def anchored_title(self):
        """The safety case names a row of the page by the step's name."""
        return f'<a id="{self.name}"></a>{self.title}'

    def passed_before(self, with_any_sources):
        try:
            kept = json.loads(self.file.read_text())
            return (with_any_sources or kept["key"] == self.key) and kept["count"] == self.count and kept["passed"]
        except (OSError, ValueError, KeyError):
            return False

    def start(self, root):
        self.file.unlink(missing_ok=True)
        self.begun = time.monotonic()
        self.commit = commit(root)
        with self.log.open("w") as log:
            self.process = subprocess.Popen(self.command.split(), cwd=root, stdout=log, stderr=subprocess.STDOUT,
                                            env={**os.environ, **self.environment}, start_new_session=True)

    def end(self):
        seconds = time.monotonic() - self.begun
        text = self.log.read_text(errors="replace")
        found = []
        for what, pattern in self.reads:
            values = re.findall(pattern, text)
            found.append([what, values[-1] if values else "not said"])
        passed = self.process.returncode == 0 and "[  FAILED  ]" not in text and all(value != "not said" for _, value in found)
        result = {"key": self.key, "title": self.title, "unit": self.unit, "count": self.count, "seconds": seconds, "passed": passed,
                  "found": found, "commit": self.commit, "command": self.command, "environment": self.environment}
        new = self.file.with_suffix(".new")
        new.write_text(json.dumps(result))
        new.replace(self.file)
        print(f"soak: {self.name}: {'passed' if passed else f'FAILED, see {self.log}'}, {seconds:.0f} s", flush=True)
        return passed


class Asked:
    """To end. An exception in the middle of the start of a step would leave a process that nobody knows."""

    to_end = False

    def __call__(self, number, frame):
        self.to_end = True


def run(steps, root):
    waiting, running, failed = list(steps), [], False
    said = begun = time.monotonic()
    asked = Asked()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, asked)
    try:
        while waiting or running:
            if asked.to_end:
                raise KeyboardInterrupt
            while waiting and len(running) < (os.cpu_count() or 1):
                running.append(waiting.pop(0))
                running[-1].start(root)
            time.sleep(0.2)
            for step in [one for one in running if one.process.poll() is not None]:
                running.remove(step)
                failed = not step.end() or failed
            if time.monotonic() - said >= 10:
                said = time.monotonic()
                print(f"soak: {said - begun:.0f} s, {len(waiting)} waiting, running: {', '.join(one.name for one in running)}",
                      file=sys.stderr, flush=True)
    finally:
        for step in running:
            if step.process and step.process.poll() is None:
                os.killpg(step.process.pid, signal.SIGKILL)
                step.process.wait()
    return not failed


def figures(steps, earlier, seconds, arguments, root):
    rows, passed, others, now = [], True, 0, commit(root)
    for step in steps:
        try:
            kept = json.loads(step.file.read_text())
        except (OSError, ValueError):
            passed = False
            rows.append([step.anchored_title, f"{step.count:,} {step.unit}", "not run", ""])
            continue
        passed = passed and kept["passed"]
        more = ", ".join(f"{value} {what}" for what, value in kept["found"])
        if arguments.failed and kept["commit"] != now:
            others += 1
            more += f"{', ' if more else ''}at {kept['commit']}"
        rows.append([step.anchored_title, f"{kept['count']:,} {step.unit}", "none" if kept["passed"] else "**yes**", f"{kept['seconds']:.0f}"
                     + (f"; {more}" if more else "")])
    notes = [f"The seed was {arguments.seed}."]
    if others:
        notes.append(f"{others} of {len(steps)} passed in an earlier call, at the commit that their rows name, and were not run again with what "
                     "has changed since. Their time is not in the whole.")
    elif earlier:
        notes.append(f"{earlier} of {len(steps)} are of an earlier call with the same sources, and with its seed; their time is not in the whole.")
    words = "".join(f" --{word}" for word in ("short", "resume", "failed") if getattr(arguments, word))
    return {"title": "The long tests", "command": "./dev soak" + words, "seconds": seconds, "passed": passed,
            "tables": [{"caption": "", "columns": ["test", "how many", "failures", "time in s; more"], "rows": rows}],
            "notes": notes}


def digest_of(root, paths):
    """Another file, or other words in one, and what hangs on it does not count as passed before."""
    digest = hashlib.sha256()
    for path in sorted(paths):
        digest.update(f"{path.relative_to(root)}\n".encode() + path.read_bytes())
    return digest.hexdigest()


def below(root, parts):
    tops = [path for part in parts for path in root.glob(part)]
    return {path for top in tops for path in [top, *top.rglob("*")] if path.is_file() and "__pycache__" not in path.parts}


class Builds:
    """What the programs of build folders are compiled from."""

    def __init__(self, root):
        self.root, self.read = root, {}

    def ninja(self, build, *words):
        done = subprocess.run(["ninja", "-C", build, "-t", *words], cwd=self.root, capture_output=True, text=True, check=False)
        return done.stdout if done.returncode == 0 else ""

    def sources(self, command):
        """Files below the root; none for a command that is no program of a build folder."""
        match = re.match(r"(build/(?:host|fuzz))/(\S+)", command)
        programs = [match[2], "fantail-campaign"] if match and match[2] == "fantail" else [match[2]] if match else []
        inputs = set(self.ninja(match[1], "inputs", *programs).split()) if programs else set()
        if not inputs:
            return set()
        if match[1] not in self.read:
            self.read[match[1]], target = {}, None
            for line in self.ninja(match[1], "deps").splitlines():
                if line.startswith(" "):
                    self.read[match[1]][target].append(line.strip())
                elif line:
                    target = line.split(":")[0]
                    self.read[match[1]][target] = []
        files = {file for name in inputs for file in [name, *self.read[match[1]].get(name, [])]}
        paths = {(self.root / match[1] / file).resolve() for file in files}  # headers are links in the build folder
        paths = {path for path in paths if path.is_relative_to(self.root) and not path.is_relative_to(self.root / "build")}
        return {path for path in paths if path.is_file()}

    def digest(self, name, command):
        if name == "proofs":
            return digest_of(self.root, below(self.root, PROOFS))
        sources = self.sources(command)
        if "build/arm/" in command:  # the image
            sources |= below(self.root, ("firmware", "hal"))
        return digest_of(self.root, sources | below(self.root, ALWAYS) if sources else below(self.root, EVERYTHING))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    for word in ("--short", "--resume", "--failed"):
        parser.add_argument(word, action="store_true")
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1, 2**24))
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    folder = root / "build/soak"
    folder.mkdir(parents=True, exist_ok=True)
    builds = Builds(root)
    unknown = set(arguments.only) - {row[0] for row in STEPS}
    if unknown:
        print(f"soak: unknown step {', '.join(sorted(unknown))}; allowed: {', '.join(row[0] for row in STEPS)}", file=sys.stderr)
        return 64
    steps = [Step(row, arguments, folder, builds) for row in STEPS
             if (not arguments.only or row[0] in arguments.only) and not (arguments.short and row[0] == "cuts")]
    to_run = [step for step in steps if not ((arguments.resume or arguments.failed) and step.passed_before(arguments.failed))]
    for step in to_run:  # not after an hour
        if not (root / step.program).exists() and not shutil.which(step.program):
            print(f"soak: {step.name} cannot run: there is no {step.program}", file=sys.stderr)
            return 66
    print(f"soak: {len(to_run)} of {len(steps)} steps, seed {arguments.seed}", flush=True)
    for step in to_run:
        if step.name.startswith("fuzz_"):
            seeds_of(step.name[5:], folder, root)
        if not arguments.resume:  # a campaign goes on from what it finds there
            shutil.rmtree(folder / f"out_{step.name}", ignore_errors=True)
    begun = time.monotonic()
    try:
        passed = run(to_run, root)
    except KeyboardInterrupt:
        print("soak: interrupted; ./dev soak --resume runs the unfinished steps", file=sys.stderr)
        return 130
    result = figures(steps, len(steps) - len(to_run), time.monotonic() - begun, arguments, root)
    (root / "build/figures").mkdir(exist_ok=True)
    (root / "build/figures/soak.json").write_text(json.dumps(result))
    return 0 if passed and result["passed"] else 1


if __name__ == "__main__":
    sys.exit(main())
