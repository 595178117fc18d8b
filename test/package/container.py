# SPDX-License-Identifier: MIT
"""Usage: container.py KEPT DOCKERFILE...
Runs the steps of each in bare Debian systems, a stage in one of its own, and then the entry point; the context is the folder at
hand. Docker is not needed, and not tested: only that the steps succeed one after another. An instruction that is not known
here is refused."""
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

import bare

SUITES = {"debian:12": "bookworm", "debian:12-slim": "bookworm"}
# What the slim ones leave out of every package that is installed later.
SLIM = """path-exclude /usr/share/doc/*
path-include /usr/share/doc/*/copyright
path-exclude /usr/share/info/*
path-exclude /usr/share/man/*
path-exclude /usr/share/locale/*
"""


class Stage:
    def __init__(self, system):
        self.system = system
        self.folder, self.user, self.entry, self.command = "/", "root", [], []
        self.variables = {"PATH": bare.PATH}

    def run(self, *words, **options):
        return self.system.run(*words, user=self.user, folder=self.folder, environment=self.variables, **options)


class Build:
    def __init__(self, project, kept):
        self.project, self.kept, self.stages, self.now = pathlib.Path(project), pathlib.Path(kept), {}, None
        lines = (self.project / ".dockerignore").read_text(encoding="utf-8").splitlines()
        self.ignored = [line for line in lines if line and not line.startswith("#")]
        if any(mark in line for line in self.ignored for mark in "!*?[/"):
            raise ValueError(".dockerignore has more than names in the project's folder")

    def do_from(self, text):
        image, *name = text.split(" AS ")
        name = name[0] if name else "last"
        system = bare.System(bare.base(SUITES[image], self.kept), self.kept / ("container-" + name))
        if image.endswith("-slim"):
            (system.folder / "etc/dpkg/dpkg.cfg.d/slim").write_text(SLIM, encoding="utf-8")
        self.now = self.stages[name] = Stage(system)

    def do_workdir(self, text):
        self.now.folder = text
        (self.now.system.folder / text.lstrip("/")).mkdir(parents=True, exist_ok=True)

    def do_user(self, text):
        self.now.user = text

    def do_env(self, text):
        self.now.variables.update(word.split("=", 1) for word in shlex.split(text))

    def do_run(self, text):
        self.now.run("sh", "-c", text)

    def do_copy(self, text):
        *sources, place = text.split()
        origin = self.project
        if sources[0].startswith("--from="):
            origin = self.stages[sources.pop(0).removeprefix("--from=")].system.folder
        target = self.now.system.folder / str(pathlib.PurePosixPath(self.now.folder, place)).lstrip("/")
        for pattern in sources:
            found = [origin] if pattern == "." else sorted(origin.glob(pattern.lstrip("/")))
            if not found:
                raise ValueError(f"COPY {text}: nothing is called {pattern}")
            for source in found:
                self.copy(source, target, place.endswith("/"))

    def copy(self, source, target, into):
        """Of a folder its contents are copied, as Docker does it."""
        if source.is_dir():
            shutil.copytree(source, target, symlinks=True, dirs_exist_ok=True,
                            ignore=lambda folder, names: self.ignored if pathlib.Path(folder) == self.project else [])
        else:
            target.mkdir(parents=True, exist_ok=True) if into else target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)

    def do_entrypoint(self, text):
        self.now.entry = json.loads(text)

    def do_cmd(self, text):
        self.now.command = json.loads(text)


def instructions(text):
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    for line in "\n".join(lines).replace("\\\n", " ").splitlines():
        word, _, rest = line.strip().partition(" ")
        yield word, rest.strip()


def timed(what, action):
    begun = time.monotonic()
    result = action()
    print(f"container: {what}: passed, {time.monotonic() - begun:.1f} s", flush=True)
    return result


def steps_of(file):
    """The instructions of a Dockerfile, all of which are known."""
    steps = list(instructions(pathlib.Path(file).read_text(encoding="utf-8")))
    unknown = [word for word, _ in steps if not hasattr(Build, "do_" + word.lower())]
    if unknown:
        raise ValueError(f"{file} has instructions that are not known here: {', '.join(unknown)}")
    return steps


def run_entry(image):
    for words in (image.command, ["--version"], ["fly"]):
        timed(" ".join(image.entry + words), lambda words=words: image.run(*image.entry, *words))
    if not image.system.holds(image.folder + "/out/tasha3_launch2/report.html"):
        raise RuntimeError("the flight made no report")


def main(kept, *files):
    refusal = bare.why_not()
    if refusal:
        print(f"container: not run, because {refusal}", file=sys.stderr)
        return 69
    for file in files:
        build = Build(".", kept)
        for word, rest in steps_of(file):
            timed(f"{word} {rest}", lambda word=word, rest=rest: getattr(build, "do_" + word.lower())(rest))
        print(f"container: {file}: the last stage takes {bare.said('du', '-sm', build.now.system.folder).split()[0]} MB", flush=True)
        if build.now.entry:
            run_entry(build.now)
        for stage in build.stages.values():
            stage.system.remove()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(*sys.argv[1:]))
    except (ValueError, KeyError, RuntimeError, subprocess.CalledProcessError) as error:
        print(f"container: NOT PASSED: {error}", file=sys.stderr)
        sys.exit(1)
