# SPDX-License-Identifier: MIT
"""Compiles files and links test programs with the flags of the build, next to the build.

The sources of the product are compiled one by one, once, into an archive; a test program is linked from its objects in the
build and that archive. An object that is given to the linker before the archive takes the place of its member, so a mutant
costs one compilation and one link.

What a header defines is in many objects. For its mutants there is a second archive, `plain`, compiled so that every inline
function is called: then the linker takes the first definition that it meets, and the object with the mutant comes first.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess

# Nothing that one function knows of another is used. Eigen without inlining is ten times slower, so its file is as ever.
PLAIN = ("-O1 -fno-inline -fno-ipa-pure-const -fno-ipa-modref -fno-ipa-reference -fno-ipa-profile -fno-ipa-ra").split()
ALWAYS_INLINED = "firmware/core/motion_estimator.cpp"
COMPILER = re.compile(r"(^|/)(c\+\+|g\+\+|clang\+\+)[-.\d]*$")
FOLDERS = ("core", "protocol", "avionics")


class ToolFailure(Exception):
    """The compiler, the linker or a test program could not do its work: nothing is known of the mutant."""


def tool(arguments, cwd, what):
    """Runs a compiler or linker: (exit code, its messages). ToolFailure when it did not end by itself."""
    try:
        done = subprocess.run(arguments, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", check=False)
    except OSError as error:
        raise ToolFailure(f"{what}: {error}") from error
    if done.returncode < 0 or "internal compiler error" in done.stdout or "No space left" in done.stdout:
        raise ToolFailure(f"{what} ended with {done.returncode}: {done.stdout[-2000:]}")
    return done.returncode, done.stdout


class Workshop:
    def __init__(self, root, build, folder):
        self.root, self.build, self.folder = pathlib.Path(root), pathlib.Path(build), pathlib.Path(folder)
        self.commands = self.read_commands()
        self.product = sorted(file for file in self.commands
                              if re.match(rf"firmware/({'|'.join(FOLDERS)})/", file) or file.endswith("/identity.cpp"))
        self.links = {name: self.link_line(name) for name in FOLDERS}

    def read_commands(self):
        """File below the root -> the words that compile it, without source and output. Of files that are compiled as one
        each has the words of all."""
        commands = {}
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            files = [entry["file"]]
            if "/Unity/" in entry["file"]:
                files = re.findall(r'^#include "(.*)"', pathlib.Path(entry["file"]).read_text(), re.M)
            words = shlex.split(entry["command"])
            while words and not COMPILER.search(words[0]):  # a compiler cache before it
                words.pop(0)
            if "_sanitized.dir" in entry["command"] or not words:
                continue
            out, source = words.index("-o"), words.index("-c")
            del words[max(out, source) : max(out, source) + 2], words[min(out, source) : min(out, source) + 2]
            for file in files:
                commands.setdefault(file.removeprefix(f"{self.root}/"), words)
        return commands

    def link_line(self, name):
        """(objects, libraries that are not ours) of test_<name>."""
        target = f"test/{name}/test_{name}"
        code, text = tool(["ninja", "-C", str(self.build), "-t", "commands", target], None, "ninja")
        if code != 0:
            raise ToolFailure(f"ninja does not know {target}: {text[-500:]}")
        words = shlex.split(text.splitlines()[-1])
        ours = {f"firmware/{folder}/libfantail_{folder}.a" for folder in FOLDERS}
        objects = [str(self.build / word) for word in words if word.endswith(".o")]
        libraries = [word if word.startswith("/") else str(self.build / word)
                     for word in words if word.endswith((".a", ".so")) and word not in ours]
        if not objects:
            raise ToolFailure(f"the command that links {target} names no object: {text[-500:]}")
        # A mutant of the protocol stands in front of the archive in every program, and calls the generated code.
        generated = self.build / "firmware/protocol/libfantail_protocol_generated.a"
        if str(generated) not in libraries and generated.exists():
            libraries.append(str(generated))
        return objects, libraries

    def parse_arguments(self, file):
        """What libclang needs of the flags: of a header those of a file beside it."""
        beside = next((f for f in self.product if f.startswith(os.path.dirname(file) + "/")), None)
        words = self.commands.get(file) or self.commands[beside]
        keep, take = [], False
        for word in words:
            if take or word.startswith(("-I", "-D", "-std=")) or word == "-isystem":
                keep.append(word)
                take = word == "-isystem" and not take
        builtin = "/usr/lib/llvm-19/lib/clang/19"
        return [*keep, *(["-resource-dir", builtin] if os.path.isdir(builtin) else []), "-x", "c++"]

    def compile(self, place, file, plain, text=None, overlay=()):
        """The object of `file`, with `text` instead of its own, made in the folder `place`: (object, "") or (None, the
        errors). `overlay`: (name in an #include, text) of headers that are other than they were."""
        shutil.rmtree(place / "source", ignore_errors=True)
        shutil.rmtree(place / "overlay", ignore_errors=True)
        (place / "source").mkdir(parents=True)
        for name, header in overlay:
            path = place / "overlay" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(header)
        source = pathlib.Path("source", os.path.basename(file))
        (place / source).write_bytes((self.root / file).read_bytes() if text is None else text)
        out = place / (file.replace("/", "_") + ".o")
        out.unlink(missing_ok=True)
        words = self.commands[file]
        more = PLAIN if plain and file != ALWAYS_INLINED and not file.startswith("test/") else []
        # -w: a mutant may leave a variable unused. The folder of the file, for what a test includes from beside it.
        command = [words[0], "-Ioverlay", *words[1:], *more, "-w", "-iquote", str((self.root / file).parent),
                   "-MMD", "-MF", out.name + ".d", "-c", str(source), "-o", out.name]
        code, messages = tool(command, place, f"compiling {file}")
        if code != 0:
            if "error:" not in messages:
                raise ToolFailure(f"compiling {file} failed without an error: {messages[-2000:]}")
            return None, messages
        if not out.is_file() or out.stat().st_size == 0:
            raise ToolFailure(f"the compiler said that it has compiled {file}, and has written nothing")
        return out, ""

    def dependents(self, header, archive):
        """The files of the product that read this header, from what the compiler noted in `archive`'s folder."""
        found = []
        for file in self.product:
            note = archive / (file.replace("/", "_") + ".o.d")
            if any(word.endswith("/" + header.removeprefix("firmware/")) for word in note.read_text().split()):
                found.append(file)
        return found

    def link(self, place, name, first, archive):
        """test_<name> with the objects `first` before all others."""
        objects, libraries = self.links[name]
        program = place / f"test_{name}"
        program.unlink(missing_ok=True)
        command = ["c++", "-fuse-ld=gold", *map(str, first), *objects, str(archive), *libraries, "-o", str(program)]
        code, messages = tool(command, place, f"linking test_{name}")
        if code != 0 or not program.is_file():
            raise ToolFailure(f"test_{name} cannot be linked: {messages[-2000:]}")
        return program


def defined_functions(obj, function):
    """The symbols of the inline functions of this name that the object has a copy of."""
    code, text = tool(["nm", "-C", "--defined-only", str(obj)], None, "nm")
    if code != 0:
        raise ToolFailure(f"nm {obj}: {text[-500:]}")
    word = re.compile(rf"(?<![\w~]){re.escape(function)}(?!\w)")
    return {line[19:] for line in text.splitlines() if line[17:18] in "WVu" and word.search(line)}


def fewest(symbols_of):
    """Object -> symbols: few objects that have all of the symbols between them."""
    left, chosen = set().union(*symbols_of.values()), []
    while left:
        best = max(symbols_of, key=lambda o: (len(symbols_of[o] & left), o))
        chosen.append(best)
        left -= symbols_of[best]
    return chosen
