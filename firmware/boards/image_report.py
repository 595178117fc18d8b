# SPDX-License-Identifier: MIT
"""Usage: image_report.py IMAGE.elf [--check] [--json]

What an image takes of the processor: flash, static memory, the flight core's share, and the deepest stack, from the
linker's map and the compiler's call graph beside it. With --check exit code 1 for what is too much or may not be in it,
77 when there is no image.
"""

import argparse
import json
import pathlib
import re
import struct
import subprocess
import sys

PREFIX = "arm-none-eabi-"
FLASH_LIMIT = 128 * 1024  # sectors 0 to 4: with one more each flashing has 128 kB more to erase
RAM_LIMIT = 64 * 1024  # half of SRAM1 and SRAM2

# Names of the C library, of libgcc and of libstdc++ that stand for something a flight image does without.
FORBIDDEN = {
    "heap": r"_?(malloc|calloc|realloc|free)(_r)?|_?sbrk(_r)?|_Zn[wa].*",
    "exceptions": r"__cxa_(throw|rethrow|begin_catch|end_catch|allocate_exception)|_Unwind_.*|__gxx_personality.*",
    "double precision": r"__aeabi_(d(add|sub|rsub|mul|div|neg|2.*|cmp.*)|c[dr]?(dcmp|rdcmp).*|(f|i|ui|l|ul)2d)"
                        r"|__(add|sub|mul|div|neg)df[23]|__(eq|ne|ge|gt|le|lt|unord)df2|__(fix|fixuns|float|floatun)\w*df\w*",
    "floats in software": r"__aeabi_(f(add|sub|rsub|mul|div)|u?l2f)|__(add|sub|mul|div)sf3",
    "libm": r"(sin|cos|tan|asin|acos|atan|atan2|sqrt|exp|exp2|log|log2|log10|pow|fmod|floor|ceil|round|lround|llround|"
            r"trunc|rint|nearbyint|fma|hypot|cbrt)f?|__ieee754_.*|__kernel_.*",
    "input and output": r"_?(printf|fprintf|vfprintf|sprintf|snprintf|puts|fwrite|write|read|open)(_r)?",
}

# Calls through a pointer, by who calls: a driver asks the clock, and whoever is above may call any function whose address
# is taken. Nobody calls back, so the graph has no circle.
POINTED_AT = [
    (re.compile(r"^_ZN?K?7fantail3hal"), re.compile(r"5Clock3nowEv")),
    (re.compile(r""), re.compile(r"")),
]
LIBRARY_FRAME = 64  # more than memcpy, memset and libgcc's divisions take; they are written in assembler and say nothing
EXCEPTION_FRAME = 108  # 26 words with the FPU's registers, and one to align


def run(tool: str, *arguments: str) -> str:
    return subprocess.run([PREFIX + tool, *arguments], check=True, capture_output=True, text=True).stdout



class CallGraph:
    """Of all functions that are in the image, from the compiler's .ci files."""

    def __init__(self, build: pathlib.Path, image: str, linked: dict[str, tuple[int, int]]):
        self.frames: dict[str, int] = {}
        self.calls: dict[str, set[str]] = {}
        self.dynamic: list[str] = []
        for file in [*build.glob("firmware/**/*.ci"), *build.glob("hal/**/*.ci")]:
            program = re.search(r"CMakeFiles/(fantail-[^/]+)\.dir", str(file))
            if program and program[1] != image:  # each has a main
                continue
            text = file.read_text()
            for title, label in re.findall(r'^node: \{ title: "([^"]+)" label: "([^"]*)"', text, re.M):
                frame = re.search(r"\\n(\d+) bytes \((\w+)", label)
                if frame:
                    name = title.rsplit(":", 1)[-1]
                    self.frames[name] = max(self.frames.get(name, 0), int(frame[1]))
                    if frame[2] == "dynamic" and name in linked:
                        self.dynamic.append(name)
            for source, target in re.findall(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', text, re.M):
                self.calls.setdefault(source.rsplit(":", 1)[-1], set()).add(target.rsplit(":", 1)[-1])
        # A complete object's constructor is its base's under another name.
        for name in list(self.frames):
            for base, complete in (("C2E", "C1E"), ("D2E", "D1E"), ("C2I", "C1I")):
                if base in name:
                    self.frames.setdefault(name.replace(base, complete), self.frames[name])
                    self.calls.setdefault(name.replace(base, complete), self.calls.get(name, set()))

    def deepest(self, root: str, pointed_at: set[str]) -> tuple[int, list[str]]:
        done: dict[str, tuple[int, list[str]]] = {}
        under_way: set[str] = set()

        def visit(name: str) -> tuple[int, list[str]]:
            if name in done:
                return done[name]
            if name in under_way:
                raise SystemExit(f"image_report: {name} calls itself, so its stack has no bound")
            under_way.add(name)
            best: tuple[int, list[str]] = (0, [])
            for callee in self.calls.get(name, ()):
                targets = {callee}
                if callee == "__indirect_call":
                    pattern = next(callees for callers, callees in POINTED_AT if callers.search(name))
                    targets = {t for t in pointed_at if pattern.search(t)}
                for target in targets:
                    below = visit(target)
                    if below[0] > best[0]:
                        best = below
            under_way.discard(name)
            own = self.frames.get(name, LIBRARY_FRAME)
            done[name] = (own + best[0], [f"{name} {own}", *best[1]])
            return done[name]

        sys.setrecursionlimit(10_000)
        return visit(root)


def symbols_of(elf: pathlib.Path) -> dict[str, tuple[int, int]]:
    found = {}
    for line in run("nm", "-S", str(elf)).splitlines():
        parts = line.split()
        if len(parts) >= 3:
            size = int(parts[1], 16) if len(parts) == 4 else 0
            found[parts[-1]] = (int(parts[0], 16), size)
    return found


def words_of_memory(elf: pathlib.Path) -> dict[int, bytes]:
    sections = {}
    for line in run("readelf", "-SW", str(elf)).splitlines():
        m = re.match(r"\s*\[\s*\d+\]\s+(\S+)\s+PROGBITS\s+([0-9a-f]+)\s+([0-9a-f]+)\s+([0-9a-f]+)\s+\S+\s+A", line)
        if m or re.match(r"\s*\[\s*\d+\]\s+(\S+)\s+PROGBITS\s+([0-9a-f]+)\s+([0-9a-f]+)\s+([0-9a-f]+)\s+\S+\s+[WAX]+", line):
            m = re.match(r"\s*\[\s*\d+\]\s+(\S+)\s+PROGBITS\s+([0-9a-f]+)\s+([0-9a-f]+)\s+([0-9a-f]+)", line)
            address, offset, size = (int(m[i], 16) for i in (2, 3, 4))
            sections[address] = elf.read_bytes()[offset:offset + size]
    return sections


def pointed_at(elf: pathlib.Path, functions: dict[int, str]) -> set[str]:
    """Functions whose address stands in the constants of the image: in vtables and in tables of functions."""
    found = set()
    for data in words_of_memory(elf).values():
        for (word,) in struct.iter_unpack("<I", data[: len(data) // 4 * 4]):
            if word & 1 and word - 1 in functions:
                found.add(functions[word - 1])
    return found


def facts(elf: pathlib.Path) -> dict:
    build = elf.parent
    symbols = symbols_of(elf)
    functions = {address & ~1: name for name, (address, _) in symbols.items() if address >> 24 == 0x08}
    handlers = {n for n in symbols if n.endswith("_handler")}
    graph = CallGraph(build, elf.stem, symbols)
    callable_by_pointer = pointed_at(elf, functions) - handlers - {"main"}
    main_depth, main_path = graph.deepest("main", callable_by_pointer)
    interrupts = [graph.deepest(h, callable_by_pointer)
                  for h in sorted(handlers - {"reset_handler", "crash_handler"})] or [(0, [])]
    interrupt_depth, interrupt_path = max(interrupts)
    reset = graph.frames.get("reset_handler", LIBRARY_FRAME)
    map_text = (build / (elf.stem + ".map")).read_text()
    core = sum(int(size, 16) for size in re.findall(
        r"^ \.text\S*\s+0x0*8\w+\s+(0x\w+)\s+\S*libfantail_core\.a\(", map_text.replace("\n                0x", " 0x"), re.M))
    load = sum(len(d) for a, d in words_of_memory(elf).items() if a >> 24 in (0x08, 0x20))
    ram = sum(symbols[e][0] - symbols[b][0] for b, e in (("data_begin", "data_end"), ("bss_begin", "bss_end")))
    objects = [*build.glob("firmware/**/*.obj"), *build.glob("hal/**/*.obj")]
    without_graph = sorted(str(o.relative_to(build)) for o in objects if not o.with_suffix(".ci").exists())
    is_whole = objects and not without_graph
    return {
        "image": elf.name,
        "build": str(build),
        "flash_bytes": load,
        "flash_limit": FLASH_LIMIT,
        "static_ram_bytes": ram,
        "static_ram_limit": RAM_LIMIT,
        "core_code_bytes": core,
        "stack_reserved_bytes": symbols["stack_top"][0] - symbols["stack_bottom"][0],
        "stack_worst_bytes": reset + main_depth + EXCEPTION_FRAME + interrupt_depth if is_whole else None,
        "stack_path": main_path,
        "interrupt_path": interrupt_path,
        "dynamic_frames": graph.dynamic,
        "objects": len(objects),
        "without_call_graph": without_graph,
        "largest_objects": sorted(((size, name) for name, (address, size) in symbols.items()
                                   if address >> 24 == 0x20 and size), reverse=True)[:5],
        "forbidden": {what: sorted(n for n in symbols if re.fullmatch(pattern, n)) for what, pattern in FORBIDDEN.items()},
    }


def failures(f: dict) -> list[str]:
    wrong = [f"{what}: {', '.join(names)}" for what, names in f["forbidden"].items() if names]
    if f["flash_bytes"] > f["flash_limit"]:
        wrong.append(f"{f['flash_bytes']} bytes of flash, allowed are {f['flash_limit']}")
    if f["static_ram_bytes"] > f["static_ram_limit"]:
        wrong.append(f"{f['static_ram_bytes']} bytes of static memory, allowed are {f['static_ram_limit']}")
    if f["stack_worst_bytes"] is None:
        without = f["without_call_graph"]
        wrong.append(f"the deepest stack is not known: {len(without)} of {f['objects']} objects have no call graph "
                     f"(-fcallgraph-info){', as ' + without[0] if without else ''}; rm -rf {f['build']} and build it again")
    elif 2 * f["stack_worst_bytes"] > f["stack_reserved_bytes"]:
        wrong.append(f"a stack of {f['stack_worst_bytes']} bytes, allowed is half of {f['stack_reserved_bytes']}")
    if f["dynamic_frames"]:
        wrong.append(f"stack frames without a fixed size: {', '.join(f['dynamic_frames'])}")
    return wrong


def demangled(names: list[str]) -> list[str]:
    return subprocess.run([PREFIX + "c++filt"], input="\n".join(names), capture_output=True, text=True,
                          check=True).stdout.splitlines()


def show(f: dict) -> None:
    def row(label: str, value: int, limit: str) -> None:
        print(f"  {label:<22}{value:>8} bytes   {limit}")

    print(f["image"])
    row("flash", f["flash_bytes"], f"of {f['flash_limit']} that we allow ourselves, of 1048576")
    row("  flight core", f["core_code_bytes"], "code only")
    row("static memory", f["static_ram_bytes"], f"of {f['static_ram_limit']} that we allow ourselves, of 131072")
    if f["stack_worst_bytes"] is not None:
        row("deepest stack", f["stack_worst_bytes"], f"of {f['stack_reserved_bytes']} reserved")
        print("\n  the deepest way down:")
        for line in demangled(f["stack_path"]):
            name, frame = line.rsplit(" ", 1)
            print(f"    {frame:>5}  {re.sub(r'[(<].*', '', name)}")
    print("\n  the largest objects:")
    for size, name in f["largest_objects"]:
        print(f"    {size:>6}  {demangled([name])[0]}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("elf", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    if not arguments.elf.exists():
        print(f"SKIPPED: {arguments.elf} has not been built: ./dev firmware", file=sys.stderr)
        return 77
    found = facts(arguments.elf)
    wrong = failures(found)
    if arguments.json:
        print(json.dumps({**found, "failures": wrong}, indent=1))
    else:
        show(found)
    for sentence in wrong:
        print(f"image_report: {arguments.elf.name}: {sentence}", file=sys.stderr)
    return 1 if arguments.check and wrong else 0


sys.exit(main())
