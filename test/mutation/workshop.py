# SPDX-License-Identifier: MIT
"""Compiles files and links test programs with the flags of the build, next to the build.

The sources of the product are compiled one by one, once for each variant, into an archive; a test program is linked from its
objects in the build, with the main function of runner.cpp, and that archive. An object that is given to the linker before
the archive takes the place of its member, so a mutant costs one compilation and one link.

Variants:
  own     the flags of the build
  plain   every inline function is called. What a header defines is in many objects: the linker takes the first definition
          that it meets, and the object with the mutant comes first
  traced  not optimised, with a call at each place that a jump can lead to, and the lines of the places (reach.py)
"""

import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import threading

# Nothing that one function knows of another is used. Eigen without inlining is ten times slower, so its file is as ever.
# The library checks each index and each access to an optional value, as the sanitizers do in ./dev test.
PLAIN = ("-D_GLIBCXX_ASSERTIONS -O1 -fno-inline -fno-ipa-pure-const -fno-ipa-modref -fno-ipa-reference -fno-ipa-profile -fno-ipa-ra").split()
ALWAYS_INLINED = "firmware/core/motion_estimator.cpp"
TRACED = ["-fsanitize-coverage=trace-pc", "-g1"]
FLAGS = {"own": [], "plain": PLAIN, "traced": ["-O0", *TRACED]}
MOST_HEADERS = 8  # precompiled ones that are kept; each is large
COMPILER = re.compile(r"(^|/)(c\+\+|g\+\+|clang\+\+)[-.\d]*$")
FOLDERS = ("core", "protocol", "avionics")
RUNNER = "test/mutation/runner.cpp"
SEEDS = {"RC_PARAMS": "seed=1", "FANTAIL_SEED": "1", "FANTAIL_FRAMES": "20000", "GTEST_COLOR": "no"}


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


class LinkFailure(ToolFailure):
    """The objects do not fit each other: a header that only some of them read anew may have changed the name of a function."""


class Workshop:
    def __init__(self, root, build, folder):
        self.root, self.build, self.folder = pathlib.Path(root), pathlib.Path(build), pathlib.Path(folder)
        self.units = {}  # object of the build -> (its source, the words that compile it)
        self.commands = self.read_commands()
        self.product = sorted(file for file in self.commands
                              if re.match(rf"firmware/({'|'.join(FOLDERS)})/", file) or file.endswith("/identity.cpp"))
        self.links = {name: self.link_line(name) for name in FOLDERS}
        self.headers, self.lock = {}, threading.Lock()  # flags -> the precompiled header
        self.hashes = {}  # path -> of its bytes

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
            obj = self.build / words[out + 1]
            del words[max(out, source) : max(out, source) + 2], words[min(out, source) : min(out, source) + 2]
            self.units[obj] = entry["file"], words
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

    def compile(self, place, file, variant, text=None, overlay=()):
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
        out = place / self.object_name(file)
        # -w: a mutant may leave a variable unused. The folder of the file, for what a test includes from beside it.
        words = self.words(file, variant)
        command = [words[0], "-Ioverlay", *words[1:], "-w", "-iquote", str((self.root / file).parent),
                   "-MMD", "-MF", out.name + ".d", "-c", str(source)]
        return self.run_compiler(command, place, file, out)

    @staticmethod
    def run_compiler(command, place, file, out):
        out.unlink(missing_ok=True)
        code, messages = tool([*command, "-o", out.name], place, f"compiling {file}")
        if code != 0:
            if "error:" not in messages:
                raise ToolFailure(f"compiling {file} failed without an error: {messages[-2000:]}")
            return None, messages
        if not out.is_file() or out.stat().st_size == 0:
            raise ToolFailure(f"the compiler said that it has compiled {file}, and has written nothing")
        return out, ""

    @staticmethod
    def object_name(file):
        return file.replace("/", "_") + ".o"

    def words(self, file, variant):
        """The words that compile it; a header that the build has precompiled is precompiled with the flags of the variant."""
        words = self.commands[file]
        flags = FLAGS[variant]
        if file == ALWAYS_INLINED and variant != "own":
            flags = ["-O1", *TRACED] if variant == "traced" else []
        words = [*words, *flags]
        if not flags or "-include" not in words:
            return words
        at = words.index("-include") + 1
        # Where its own headers are makes no difference to those of the system.
        key = json.dumps([word for word in words if not word.startswith("-I")] + [self.compiler_version(words[0])])
        with self.lock:
            if key not in self.headers:
                digest = hashlib.sha256(key.encode() + self.hash_of(words[at])).hexdigest()
                self.headers[key] = self.precompile(words, at, self.folder / f"header-{digest[:16]}")
        words[at] = str(self.headers[key])
        return words

    def precompile(self, words, at, folder):
        header = folder / os.path.basename(words[at])
        if header.exists():  # made last
            return header
        for old in sorted(self.folder.glob("header-*"), key=os.path.getmtime)[:-MOST_HEADERS]:
            shutil.rmtree(old)
        folder.mkdir(parents=True, exist_ok=True)
        out = header.with_name(header.name + ".gch")
        command = [*words[: at - 1], *words[at + 1 :], "-w", "-x", "c++-header", words[at]]
        if self.run_compiler(command, folder, header.name, out)[0] is None:
            raise ToolFailure(f"{header} cannot be precompiled")
        shutil.copy(words[at], header)
        return header

    def keep(self, place, folder, file, variant):
        """Compiles the original in `place` into `folder`, for this run and others of the same sources."""
        obj, errors = self.compile(place, file, variant)
        if obj is None:
            raise ToolFailure(f"{file} does not compile as it is: {errors[-2000:]}")
        for path in (obj.with_name(obj.name + ".d"), obj):
            path.rename(folder / path.name)
        (folder / (obj.name + ".key")).write_text(self.key(folder, file, variant))

    def fresh(self, folder, file, variant):
        """Whether `folder` has the object of the file as it is now."""
        key = folder / (self.object_name(file) + ".key")
        return key.exists() and key.read_text() == self.key(folder, file, variant)

    def key(self, folder, file, variant):
        """Of all that decides the object: the flags, the file, and what the compiler noted that it reads."""
        words = [self.commands[file], FLAGS[variant], self.compiler_version(self.commands[file][0])]
        digest = hashlib.sha256(json.dumps(words).encode() + self.hash_of(self.root / file))
        note = (folder / (self.object_name(file) + ".d")).read_text().replace("\\\n", " ")
        for path in sorted(set(note.split(":", 1)[1].split())):
            if path.startswith(str(self.root)) and not path.endswith(".gch") and "/cmake_pch" not in path:
                digest.update(path.encode() + self.hash_of(path))
        return digest.hexdigest()

    def hash_of(self, path):
        if path not in self.hashes:
            try:
                self.hashes[path] = hashlib.sha256(pathlib.Path(path).read_bytes()).digest()
            except OSError:
                self.hashes[path] = b"it is gone"
        return self.hashes[path]

    def compiler_version(self, compiler):
        if compiler not in self.hashes:
            self.hashes[compiler] = tool([compiler, "--version"], None, compiler)[1]
        return self.hashes[compiler]

    def dependents(self, header, archive):
        """The files of the product that read this header, from what the compiler noted in `archive`'s folder."""
        found = []
        for file in self.product:
            note = archive / (self.object_name(file) + ".d")
            if any(word.endswith("/" + header.removeprefix("firmware/")) for word in note.read_text().split()):
                found.append(file)
        return found

    def tests_with(self, place, name, header, text):
        """The objects of test_<name> that read this header, compiled with `text` instead of it: object -> new object.
        None when one of them is not C++ then."""
        include, made = header.removeprefix("firmware/"), {}
        path = place / "overlay" / include
        shutil.rmtree(place / "overlay", ignore_errors=True)
        path.parent.mkdir(parents=True)
        path.write_bytes(text)
        for obj in self.links[name][0]:
            code, read = tool(["ninja", "-C", str(self.build), "-t", "deps", os.path.relpath(obj, self.build)], None, "ninja")
            known = code == 0 and "deps not found" not in read
            if known and not any(line.endswith("/" + include) for line in read.splitlines()):
                continue
            source, words = self.units[pathlib.Path(obj)]
            out = place / f"test{len(made)}.o"
            command = [words[0], "-Ioverlay", *words[1:], "-w", "-c", source]
            if self.run_compiler(command, place, source, out)[0] is None:
                return None
            made[obj] = out
        return made

    def runner(self):
        """Compiles runner.cpp, if that has not been done."""
        command = ["c++", "-O1", "-std=c++20", "-c", str(self.root / RUNNER)]
        words = json.dumps([command, self.compiler_version("c++")]).encode()
        digest = hashlib.sha256(words + self.hash_of(self.root / RUNNER)).hexdigest()
        key, out = self.folder / "runner.key", self.folder / "runner.o"
        if key.exists() and out.exists() and key.read_text() == digest:
            return
        key.unlink(missing_ok=True)
        obj, errors = self.run_compiler(command, self.folder, RUNNER, out)
        if obj is None:
            raise ToolFailure(f"{RUNNER} cannot be compiled: {errors[-2000:]}")
        key.write_text(digest)

    def link(self, place, name, first, archive, *options, instead=()):
        """test_<name> with the objects `first` before all others, and of its own those in `instead` (object -> another):
        (the program, what the linker says)."""
        objects, libraries = self.links[name]
        objects = [str(dict(instead).get(obj, obj)) for obj in objects]
        program = place / f"test_{name}"
        program.unlink(missing_ok=True)
        command = ["c++", "-fuse-ld=gold", *options, *map(str, first), str(self.folder / "runner.o"), *objects, str(archive),
                   *libraries, "-o", str(program)]
        code, messages = tool(command, place, f"linking test_{name}")
        if code != 0 or not program.is_file():
            raise LinkFailure(f"test_{name} cannot be linked: {messages[-2000:]}")
        return program, messages
