# SPDX-License-Identifier: MIT
"""Usage: declared_packages.py DEV HOST_BUILD ARM_BUILD

Fails when the build or the tests read a system file of a package that a bare Debian would not have after ./dev has
installed what it declares. Read are, for each build folder that exists: the headers that ninja knows of, the files in
build.ninja, CMakeCache.txt and the linker's maps, the programs in ninja's commands, the libraries that what was built
loads; and for the tests what read_log.c has written, where FANTAIL_READ_LOG names it. DEV is ./dev, asked with
`DEV packages TIER`. Exit code 77: no dpkg here.

Not seen: what ./dev itself runs, programs that a script of the build starts, libraries that are linked by -l alone and
have no header, and what read_log.c does not see. Not while something is being built in the folder.
"""

import functools
import glob
import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections import defaultdict

SYSTEM = re.compile(r"/(usr|lib|lib32|lib64|libx32|bin|sbin|etc|opt)/")
# In each build folder: what a person builds there without any test, and the tier that must be enough for it.
PRODUCTS = (("libexec/fantail-fly", "fly"), ("fantail-stm32f405.unsealed.elf", "firmware"))

# Packages that are used where they are installed and that nothing fails without.
OPTIONAL = re.compile(
    r"git"  # cmake/identity.cmake: without it the hash is "unknown"
    r"|clang(-\d+)?"  # other compilers to compare with: same_bytes.sh skips, same_bits.cmake takes g++ twice
    r"|ccache"  # cmake/flags.cmake: without it everything is compiled
    r"|lsb-release"  # pip calls it where it is, to tell the server what asks
    r"|python3-clang-19|libclang1-19|libllvm19"  # test/mutation: what makes mutants of a text is not tested without
    r"|libunicorn(-dev|2)"  # test/board: without it there is no virtual board
)
# Files that are read because this machine has them, not because anything needs them.
OF_THE_MACHINE = re.compile(
    r"/libnss_\w+\.so|"  # glibc loads what /etc/nsswitch.conf lists
    r"^/etc/ld\.so\.conf\.d/|"  # the linker reads what any package has put there
    r"^/usr/lib/llvm-\d+/lib/libLLVM[^/]*\.so|"  # where clang looks first: a link there is of LLVM's -dev package
    r"/libnuma\.so|"  # ps loads it where it is, for columns that nobody asks for
    r"/asan_ignorelist\.txt$|"  # clang looks whether its sanitizers are there, to lint what is compiled without them
    r"/locale\.alias$|"  # glibc looks there for a locale that it does not find
    r"/dist-packages/([^/]*\.pth$|_distutils_hack/)|"  # Debian's Python reads those of every package at every start
    r"^/usr/lib/ssl/openssl\.cnf$|^/etc/ssl/openssl\.cnf$"  # libcrypto works without a configuration
)
# What would be missed if no package brought it. The rest is generated: caches, indexes, configuration.
NEEDS_AN_OWNER = re.compile(r"/include/|\.(a|o|so[.\d]*|h|hh|hpp|c|cc|cpp|py|cmake|specs|ld)$")


def run(*command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, errors="replace", **options).stdout


class Packages:
    """What dpkg knows of the installed packages."""

    def __init__(self):
        fields = ("Package", "Status", "Essential", "Priority", "Provides", "Pre-Depends", "Depends")
        self.needs = defaultdict(list)  # by package: its dependencies, each a list of alternatives
        self.providers = defaultdict(set)
        self.always = set()  # on every Debian, however small
        for line in run("dpkg-query", "-W", "-f", "\t".join(f"${{{field}}}" for field in fields) + "\n").splitlines():
            name, status, essential, priority, provides, *needs = line.split("\t")
            if not status.endswith(" installed"):
                continue
            self.needs[name] += [names(alternatives, "|") for need in needs for alternatives in need.split(",") if need]
            for virtual in names(provides, ","):
                self.providers[virtual].add(name)
            if essential == "yes" or priority == "required":
                self.always.add(name)

    def closure(self, declared):
        """The packages and everything that apt installs with them, without what they only recommend."""
        found, left = set(), list(declared) + list(self.always)
        while left:
            name = left.pop()
            if name in found or name not in self.needs:
                continue
            found.add(name)
            for alternatives in self.needs[name]:
                # The first that is there, as apt would; a name that several packages provide stands for all of them.
                for alternative in alternatives:
                    candidates = {alternative} if alternative in self.needs else self.providers[alternative]
                    if candidates:
                        left += candidates
                        break
        return found


def names(text, separator):
    return [part.split("(")[0].strip().partition(":")[0] for part in text.split(separator) if part.strip()]


def owners(paths):
    """Path -> packages. A path that dpkg does not know is left out."""
    found, diverted = defaultdict(set), {}
    # dpkg takes patterns, and knows what has moved to /usr by its former name or by the new one.
    spelled = {spelling: path for path in paths
               for spelling in (path, re.sub(r"^/usr(?=/(bin|sbin|lib\w*)/)", "", path))}
    questions = sorted(re.sub(r"([\\*?\[])", r"\\\1", spelling) for spelling in spelled)
    for start in range(0, len(questions), 8000):
        answer = run("dpkg-query", "-S", *questions[start : start + 8000], stderr=subprocess.DEVNULL)
        for line in answer.splitlines():
            who, _, spelling = line.partition(": ")
            if diversion := re.fullmatch(r"diversion by (\S+) from", who):
                diverted[spelled[spelling]] = diversion[1]
            elif spelling in spelled and not who.startswith(("diversion ", "local diversion ")):
                found[spelled[spelling]] |= set(names(who, ","))
    return found | {path: {name} for path, name in diverted.items()}


def links(path):
    """The file and every link on the way to it, because each may be of another package: liblcm.so, c++, awk."""
    steps = []
    while path not in steps and len(steps) < 20:
        path = os.path.join(os.path.realpath(os.path.dirname(path)), os.path.basename(path))
        steps.append(path)
        if os.path.islink(path):
            path = os.path.join(os.path.dirname(path), os.readlink(path))
    return steps


@functools.cache
def to_judge(path):
    if not SYSTEM.match(path) or OF_THE_MACHINE.search(os.path.normpath(path)):  # a program looks in bin/../lib
        return None
    # What Python compiled stands for its source.
    return re.sub(r"__pycache__/([^/]+)\.cpython-\d+(\.opt-\d)?\.pyc$", r"\1.py", path)


class Readings:
    """Who has read what, for which tier."""

    def __init__(self):
        self.of = defaultdict(dict)  # (path, tier) -> reader -> the reader's program, in the order in which they came

    def add(self, path, tier, reader, program=""):
        if judged := to_judge(path):
            self.of[judged, tier].setdefault(reader, program)

    def add_log(self, log, tier):
        for line in log.read_text(errors="replace").splitlines():
            if line.count("\t") == 2:
                program, words, path = line.split("\t")
                reader = "the guest of tools/with_vcan" if program.endswith("/linux.uml") else words.strip() or program
                self.add(path, tier, reader, program)

    def add_build(self, folder, target, target_tier, tier):
        cache = (folder / "CMakeCache.txt").read_text()
        program = re.search(r"^CMAKE_MAKE_PROGRAM:\w+=(.+)$", cache, re.M)[1]

        def ninja(*words):
            return run(program, "-C", folder, "-t", *words, check=True).splitlines()

        product = {name.removeprefix(f"{folder}/") for name in [target, *ninja("inputs", target)]}
        source = "?"
        self.add(program, target_tier, f"whoever builds in {folder.name}")
        for line in ninja("deps"):
            if line.startswith("    "):
                self.add(line[4:], tier_of_output, f"the build of {source}")
            elif line:
                output = line.partition(": #deps")[0]
                tier_of_output = target_tier if output in product else tier
                source = re.sub(r"CMakeFiles/[^/]+\.dir/|\.o(bj)?$", "", output)
        for goal, its_tier in (([target], target_tier), ([], tier)):
            for command in set(re.split(r"&&|\|\||[;|\n]", "\n".join(ninja("commands", *goal)))):
                words = [word for word in command.split() if "=" not in word]
                if words and (found := shutil.which(words[0])):
                    self.add(found, its_tier, f"the commands of {folder.name}/build.ninja")
                for path in absolute_paths(command):
                    self.add(path, its_tier, f"the commands of {folder.name}/build.ninja")
        for file in (folder / "build.ninja", folder / "CMakeCache.txt", *folder.glob("*.map")):
            doubt = " (unless the entry is an old one)" if file.suffix == ".txt" else ""
            for path in absolute_paths(file.read_text(errors="replace")):
                self.add(path, tier, f"{folder.name}/{file.name}{doubt}")
        outputs = (folder / line.partition(": ")[0] for line in ninja("targets", "all"))
        programs = [str(path) for path in outputs if is_elf_program(path)]
        loaded = os.path.relpath(programs[0], folder) if programs else ""  # of a single one ldd does not say it
        for line in run("ldd", *programs, stderr=subprocess.DEVNULL).splitlines() if programs else ():
            if line.startswith("\t"):
                for path in absolute_paths(line):
                    self.add(path, target_tier if loaded in product else tier, f"the loader of {loaded}")
            else:
                loaded = os.path.relpath(line.rstrip(":"), folder)


def absolute_paths(text):
    return set(re.findall(r"(?<![\w./+-])/(?:usr|lib\w*|s?bin|etc|opt)/[\w./+@~%-]+", text))


def is_elf_program(path):
    if path.suffix in (".o", ".elf") or not path.is_file() or not os.access(path, os.X_OK):
        return False
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def complaints(readings, packages, tiers):
    """(package, tier) -> what is read and not declared, with its reader; no package where nobody owns it. And how many
    files of how many packages were looked at."""
    chains = {path: links(path) for path, _ in readings.of if os.path.isfile(path)}
    programs = {program for by in readings.of.values() for program in by.values() if program}
    owner = owners({step for chain in chains.values() for step in chain} | programs)
    closures = {tier: packages.closure(declared) for tier, declared in tiers.items()}
    # nm, ar and their like load every plugin that is installed: LLVM's, with all its libraries.
    plugins = packages.closure({name for who in owners(glob.glob("/usr/lib/bfd-plugins/*")).values() for name in who})
    missing, looked_at = defaultdict(list), set()
    for (path, tier), by in sorted(readings.of.items()):
        # What a program reads that is not declared itself follows from it.
        needed_by = {reader: owner.get(program, set()) for reader, program in by.items()
                     if program not in owner or owner[program] & closures[tier]}
        if path not in chains or not needed_by:
            continue
        owned = {frozenset(owner[step]) for step in chains[path] if step in owner}
        for who in owned:
            looked_at |= who
            readers = [reader for reader, its_owner in needed_by.items()
                       if not (who & plugins and any(name.startswith("binutils") for name in its_owner))]
            if readers and not who & closures[tier] and not all(OPTIONAL.fullmatch(name) for name in who):
                missing[" or ".join(sorted(who)), tier].append((os.path.normpath(path), readers[0]))
        if not owned and not path.startswith("/etc/") and (os.access(path, os.X_OK) or NEEDS_AN_OWNER.search(path)):
            missing["", tier].append((os.path.normpath(path), next(iter(needed_by))))
    return missing, len(chains), len(looked_at)


def main(dev, *folders):
    if not shutil.which("dpkg-query"):
        print("SKIPPED: no dpkg here, so nobody knows whether ./dev names every package that is needed")
        return 77
    builds = [(pathlib.Path(folder).resolve(), *product) for folder, product in zip(folders, PRODUCTS, strict=True)]
    builds = [build for build in builds if (build[0] / "build.ninja").exists()]
    tier = "all" if len(builds) > 1 else "test"  # the tests for the ARM processor skip without its build
    readings = Readings()
    for folder, target, target_tier in builds:
        readings.add_build(folder, target, target_tier, tier)
    if log := os.environ.get("FANTAIL_READ_LOG"):
        known = len(readings.of)
        readings.add_log(pathlib.Path(log), tier)
        if len(readings.of) == known:
            print(f"{log} says nothing: is read_log.so in LD_PRELOAD?")
            return 1
    tiers = {tier: run(dev, "packages", tier, check=True).split() for tier in {tier for _, tier in readings.of}}
    missing, files, looked_at = complaints(readings, Packages(), tiers)
    for (package, its_tier), read in sorted(missing.items()):
        for path, reader in read if not package else ():
            print(f"{path}, read by {reader}, belongs to no package, so a bare machine has none of it")
        if package:
            others = "".join(f", {path}" for path, _ in read[1:3]) + (", ..." if len(read) > 3 else "")
            print(f"{package} is not declared for ./dev's {its_tier}: {read[0][0]}, read by {read[0][1]}{others}")
    if not missing:
        print(f"{files} files of {looked_at} packages: all of them declared"
              + ("" if log else "; what the tests read was not looked at, which ./dev test does"))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
