# SPDX-License-Identifier: MIT
"""What a built file was made of: the files that its build read, the libraries that it loads, and the packages that these are of.

Nothing is listed by hand: the build is asked (ninja), the file itself (ELF), the linker's map, and Debian (dpkg).
"""

import functools
import os
import pathlib
import re
import subprocess


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


class Build:
    """A build folder of ninja."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.made_of = {}  # of each file: the rule that makes it, and what that reads
        for line in (self.folder / "build.ninja").read_text().splitlines():
            if line.startswith("build "):
                outputs, _, rest = line[len("build "):].replace("${cmake_ninja_workdir}", "").partition(": ")
                rule, *inputs = rest.split(" || ")[0].split()  # what only has to be there before is no part of it
                for output in outputs.split():
                    self.made_of[output] = rule, [name for name in inputs if name != "|"]
        self.headers = {}
        for line in said("ninja", "-C", str(self.folder), "-t", "deps").splitlines():
            if line.startswith("    "):
                self.headers[output].append(line.strip())
            elif ": #deps" in line:
                output = line.split(": #deps")[0]
                self.headers[output] = []

    def target(self, name):
        """The file of this name that is linked."""
        found = [output for output, (rule, _) in self.made_of.items() if output.split("/")[-1] == name and "_LINKER__" in rule]
        if len(found) != 1:
            raise LookupError(f"{self.folder} links {len(found)} files named {name}, instead of one")
        return found[0]

    def files(self, target):
        """All files that were read for a target, from their beginning, but for what it only loads."""
        seen, found = set(), set()
        waiting = [target]
        while waiting:
            name = waiting.pop().removeprefix(f"{self.folder}/")
            if name in seen or (name != target and "EXECUTABLE_LINKER" in self.made_of.get(name, ("",))[0]):
                continue  # a program that made a source
            seen.add(name)
            waiting += self.headers.get(name, [])
            if name in self.made_of:
                waiting += self.made_of[name][1]
            elif not re.search(r"\.so(\.[0-9.]+)?$", name):
                found.add(os.path.normpath(self.folder / name))
        return found


def from_archives(linker_map):
    """What the linker took from libraries and objects outside of the build, by its map."""
    text = pathlib.Path(linker_map).read_text()
    return {os.path.normpath(name) for name in re.findall(r"^ *(?:LOAD )?(/\S+?(?:\.a(?=\()|\.o$))", text, re.MULTILINE)}


def loads(file):
    """The names of the libraries that an ELF file loads."""
    return sorted(re.findall(r"\(NEEDED\).*\[(.+)\]", said("readelf", "-d", str(file))))


@functools.cache
def installed_libraries():
    found = {}
    for line in said("/sbin/ldconfig", "-p").splitlines():
        name, arrow, path = line.strip().partition(" => ")
        if arrow:
            found.setdefault(name.split()[0], path)
    return found


@functools.cache
def debian_files():
    """The package of every installed file."""
    found = {}
    listed = said("dpkg-query", "-W", "-f", "${db:Status-Abbrev}\t${binary:Package}\n").splitlines()
    for package in (line.split("\t")[1] for line in listed if line.startswith("ii")):
        for name in pathlib.Path(f"/var/lib/dpkg/info/{package}.list").read_text().splitlines():
            found[name] = package.split(":")[0]
    return found


def debian_packages(paths):
    """The installed package of each file that has one. /lib is a link to /usr/lib, and dpkg knows a file by one of the two."""
    found = {}
    for path in paths:
        for name in (path, os.path.realpath(path)):
            package = debian_files().get(name) or debian_files().get(name.removeprefix("/usr"))
            if package:
                found[path] = package
    return found


# Names of licences in Debian's copyright files that SPDX has under another name; the others are the same or unknown to it.
SPDX = {"Expat": "MIT", "MPL-2": "MPL-2.0", "MPL-2.0": "MPL-2.0", "BSD-2-Clause": "BSD-2-Clause", "BSD-2-clause": "BSD-2-Clause",
        "BSD-3-Clause": "BSD-3-Clause", "BSD-3-clause": "BSD-3-Clause", "MIT": "MIT", "Zlib": "Zlib", "zlib": "Zlib",
        "Apache-2.0": "Apache-2.0", "CC0-1.0": "CC0-1.0", "ISC": "ISC", "GPL-2": "GPL-2.0-only", "GPL-2+": "GPL-2.0-or-later",
        "GPL-3+": "GPL-3.0-or-later", "LGPL-2": "LGPL-2.0-only", "LGPL-2+": "LGPL-2.0-or-later", "LGPL-2.1": "LGPL-2.1-only",
        "LGPL-2.1+": "LGPL-2.1-or-later", "LGPL-3+": "LGPL-3.0-or-later", "MPL-1.1": "MPL-1.1", "BSL-1.0": "BSL-1.0"}


def licence(package, documents="/usr/share/doc"):
    """Of an installed package: the licence of all its files that have none of their own, as SPDX writes it, or NOASSERTION; and
    what its copyright file says."""
    path = pathlib.Path(documents) / package / "copyright"
    text = path.read_text(errors="replace") if path.exists() else ""
    if not re.match(r"Format: *https?://\S+copyright-format/1\.0", text):
        return "NOASSERTION", f"{path} is not in the format that programs read."
    names = []  # the first is that of all files that have no other
    for part in re.split(r"\n\s*\n", text):
        files = re.search(r"^Files:\s*(.*)", part, re.MULTILINE)
        named = re.search(r"^License:[ \t]*(.+)", part, re.MULTILINE)
        if files and named and not files[1].startswith("debian/") and named[1].strip() not in names:
            names.insert(0 if files[1].strip() == "*" else len(names), named[1].strip())
    comment = f"{path} names: {'; '.join(names)}." if names else f"{path} names no licence of files."
    first = re.split(r" (and|or) ", names[0]) if names else [""]
    words = [word.upper() if word in ("and", "or") else SPDX.get(word) for word in first]
    return (" ".join(words) if all(words) else "NOASSERTION"), comment
