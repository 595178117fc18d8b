# SPDX-License-Identifier: MIT
"""Usage: estimate_cycles.py [--begin MS] [--ticks N] [--json]

From the instructions of N ticks of tasha3_launch2, as QEMU executes fantail-count.elf from MS milliseconds after power-up
on, what they would take of a Cortex-M4 with 5 wait states of flash: two numbers between which the truth should lie, because
QEMU knows no pipeline. Every rule below that a manual leaves open counts its best case in the first and its worst in the
second. Sources: [T] Cortex-M4 Technical Reference Manual, ARM DDI 0439, tables 3-1 and 7-1; [R] RM0090 section 3.5, the
ART accelerator. Exit code 77: not possible here.
"""

import argparse
import collections
import dataclasses
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parents[2]
IMAGE = ROOT / "build/arm/fantail-count.elf"
PROGRAM = ROOT / "build/host/fantail"
TICK = "_ZN7fantail8avionics8Avionics4tickEv"
# The flash is at the other end of a link; what is packed and unpacked for it is no part of the avionics.
LINK = "_ZN7fantail10world_link5Flash4callE"
LINE = 16  # bytes of flash that are read at once [R]
WAIT = 5  # wait states at 168 MHz and 3.3 V [R, table 10]
CODE_LINES, DATA_LINES = 64, 8  # [R]
CYCLES_A_TICK = 168_000


@dataclasses.dataclass(frozen=True)
class Instruction:
    address: int
    size: int
    name: str  # without width and data type
    operands: str
    kind: str
    low: int
    high: int
    literal: int | None  # address of a constant beside the code
    indexed: bool  # a load from a table, perhaps one in flash
    ends_block: bool


def registers(operands):
    """How many a list in braces names."""
    count = 0
    for part in re.search(r"\{(.*?)\}", operands)[1].split(","):
        ends = re.findall(r"[rs](\d+)|(lr|pc|sp|ip|sl|fp)", part)
        numbers = [int(a) for a, _ in ends if a]
        count += numbers[1] - numbers[0] + 1 if "-" in part and len(numbers) == 2 else 1
    return count


def costs(name, operands):
    """(kind, fewest, most) cycles while it is not taken, from the cache, on a quiet bus."""
    if name.startswith("it"):
        return "it", 0, 1  # folded where it can be [T 3.3.1]
    if name.startswith("v"):
        if name.startswith(("vdiv", "vsqrt")):
            return "float division, root", 14, 14
        if name.startswith(("vldm", "vstm", "vpush", "vpop")):
            return "load, store of several", 1 + registers(operands), 1 + registers(operands)
        if name.startswith(("vldr", "vstr")):
            return "float load, store", 2, 2
        if name.startswith(("vmla", "vmls", "vnmla", "vnmls")):
            return "float multiply-add", 3, 4
        return "float", 1, 2  # one more when the next one needs the result [T 7.2.3]
    if name.startswith(("sdiv", "udiv")):
        return "integer division", 2, 12
    if name.startswith(("push", "pop", "ldm", "stm")):
        return "load, store of several", 1 + registers(operands), 1 + registers(operands)
    if name.startswith(("ldrd", "strd")):
        return "load, store of several", 3, 3
    if name.startswith("ldr"):
        return "load", 1, 2  # 1 behind another access [T 3.3.1]
    if name.startswith("str"):
        return "store", 1, 2
    if name.startswith(("mla", "mls")):
        return "integer", 2, 2
    return "integer", 1, 1


def is_jump(name, operands):
    if re.fullmatch(r"(b|bl|blx|bx)(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le|al)?|cbn?z|tb[bh]|bkpt|svc", name):
        return True
    return "pc" in operands and (name.startswith(("pop", "ldm")) and "pc}" in operands
                                 or name.startswith(("ldr", "mov", "add")) and operands.startswith("pc"))


def disassembled(image):
    code = {}
    text = subprocess.run(["arm-none-eabi-objdump", "-d", image], check=True, capture_output=True, text=True).stdout
    function = ""
    for line in text.splitlines():
        title = re.match(r"[0-9a-f]+ <(.*)>:", line)
        if title:
            function = title[1]
            continue
        m = re.match(r"\s*([0-9a-f]+):\t([0-9a-f ]+?)\s*\t(\S+)\t?([^;@]*)(.*)", line)
        if not m or m[3].startswith("."):
            continue
        address, size = int(m[1], 16), len(m[2].replace(" ", "")) // 2
        name, operands = re.sub(r"\.(w|n|f32|s32|u32|32|8|16|64|f64).*", "", m[3]), m[4].strip()
        kind, low, high = costs(name, operands)
        near = re.search(r"\(?([0-9a-f]{6,8}) <", m[5] or "") if "[pc" in operands else None
        indexed = name.startswith("ldr") and bool(re.search(r"\[\w+, r\d|\[\w+, (sl|fp|ip|lr)", operands))
        if indexed and "crc32c" in function:  # 4 kB of tables in flash, for which there are 128 bytes of cache
            low, high, indexed = low + WAIT, high + WAIT, False
        code[address] = Instruction(address, size, name, operands, kind, low, high, int(near[1], 16) if near else None,
                                    indexed, is_jump(name, operands))
    return code


class Lines:
    """The least recently used goes. [R]"""

    def __init__(self, room):
        self.room = room
        self.kept = collections.OrderedDict()

    def hit(self, line, keep=True):
        if line in self.kept:
            self.kept.move_to_end(line)
            return True
        if keep:
            self.kept[line] = None
            if len(self.kept) > self.room:
                self.kept.popitem(last=False)
        return False


class Processor:
    """Best or worst case of what the manuals leave open."""

    def __init__(self, worst):
        self.worst = worst
        self.code, self.data = Lines(CODE_LINES), Lines(DATA_LINES)
        self.line, self.in_line = None, 0
        self.last_was_access, self.jumped = False, True

    def fetch(self, address, size):
        """Wait states until the instruction is there."""
        waits = 0
        for line in dict.fromkeys((address // LINE, (address + size - 1) // LINE)):
            if line == self.line:
                continue
            sequential = not self.jumped and self.line is not None and line == self.line + 1
            if sequential and not self.worst:
                self.code.hit(line)  # prefetched in time, and kept
            elif sequential:
                if not self.code.hit(line, keep=False):  # prefetched since the last line began
                    waits += max(0, 1 + WAIT - self.in_line)
            elif not self.code.hit(line):
                waits += WAIT
            self.line, self.in_line = line, 0
            self.jumped = False
        return waits

    def run(self, instruction, taken):
        """(cycles of the processor, wait states)."""
        i = instruction
        waits, cycles = self.fetch(i.address, i.size), i.high if self.worst else i.low
        access = i.kind in ("load", "store")
        if i.kind == "load" and not self.worst and not self.last_was_access:
            cycles += 1
        self.last_was_access = access
        if i.literal is not None:
            if not self.data.hit(i.literal // LINE):
                waits += WAIT
        elif i.indexed and self.worst:
            waits += WAIT
        if taken:
            cycles += 3 if self.worst else 1  # the pipeline is filled again [T table 3-1: P]
            self.jumped = True
        self.in_line += cycles
        return cycles, waits


class Estimate:
    def __init__(self, code):
        self.code = code
        self.processors = Processor(False), Processor(True)
        self.histogram = collections.Counter()
        self.ticks = []

    def block(self, start, following, tick):
        """Where it ends."""
        address = start
        while address in self.code:
            i = self.code[address]
            end = address + i.size
            taken = i.ends_block and following != end
            self.histogram["branch taken" if taken else "branch not taken" if i.ends_block else i.kind] += 1
            tick[0] += 1
            for n, processor in enumerate(self.processors):
                cycles, waits = processor.run(i, taken)
                tick[1 + 2 * n] += cycles
                tick[2 + 2 * n] += waits
            if i.ends_block or end == following:
                return end
            address = end
        raise SystemExit(f"estimate_cycles: nothing is known of the code at {address:#x}")


def trace(begin_ms, ticks, entry, behind_calls, take):
    """Flies, and gives take() the blocks of each tick: their addresses, the last one behind its return."""
    with tempfile.TemporaryDirectory() as folder:
        fifo = pathlib.Path(folder, "trace")
        os.mkfifo(fifo)
        wrapper = pathlib.Path(folder, "qemu-system-arm")
        wrapper.write_text(f'#!/bin/sh\nexec {shutil.which("qemu-system-arm")} "$@" -d exec,nochain -D {fifo}\n')
        wrapper.chmod(0o755)
        flight = subprocess.Popen(
            [PROGRAM, "fly", "tasha3_launch2", "--on", "emulator", "--image", IMAGE, "--out", f"{folder}/out"],
            env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}, stdout=subprocess.DEVNULL, start_new_session=True)
        number, blocks = -1, None
        try:
            with open(fifo, "rb", buffering=1 << 20) as lines:
                for line in lines:
                    at = line.find(b"/")
                    if at < 0 or not line.startswith(b"Trace"):
                        continue
                    address = int(line[at + 1:line.find(b"/", at + 1)], 16) & ~1
                    if address == entry:
                        number += 1
                        blocks = [] if number >= begin_ms else None
                    if blocks is None:
                        continue
                    blocks.append(address)
                    if address in behind_calls:
                        take(blocks)
                        blocks = None
                        if number + 1 >= begin_ms + ticks:
                            return
            raise SystemExit("estimate_cycles: the flight ended before that")
        finally:
            os.killpg(flight.pid, signal.SIGKILL)
            flight.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--begin", type=int, default=13_000, metavar="MS", help="13000: controlling, with the chirp")
    parser.add_argument("--ticks", type=int, default=1000)
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    for needed in (IMAGE, PROGRAM):
        if not needed.exists() or not shutil.which("qemu-system-arm"):
            print(f"SKIPPED: {needed} has not been built, or qemu-system-arm is not installed", file=sys.stderr)
            return 77
    code = disassembled(IMAGE)
    symbols = subprocess.run(["arm-none-eabi-nm", IMAGE], check=True, capture_output=True, text=True).stdout
    entry, link = (int(re.search(rf"^([0-9a-f]+) T {name}", symbols, re.M)[1], 16) for name in (TICK, LINK))
    behind = {i.address + i.size for i in code.values() if i.name == "bl" and i.operands.startswith(f"{entry:x} ")}
    estimate = Estimate(code)

    def take(blocks):
        tick, end, back = [0] * 5, None, None
        for start, following in zip(blocks, blocks[1:]):
            if start == link:
                back = end
            if back is None or start == back:
                back = None
                end = estimate.block(start, following, tick)
        estimate.ticks.append(tick)

    trace(arguments.begin, arguments.ticks, entry, behind, take)
    count = len(estimate.ticks)
    mean = [sum(column) / count for column in zip(*estimate.ticks)]
    longest = max(estimate.ticks, key=lambda tick: tick[3] + tick[4])
    result = {
        "ticks": count,
        "classes": {kind: n / count for kind, n in estimate.histogram.most_common()},
        **{name: {"instructions": t[0], "cycles": [t[1], t[3]], "wait_states": [t[2], t[4]],
                  "share": [(t[1] + t[2]) / CYCLES_A_TICK, (t[3] + t[4]) / CYCLES_A_TICK]}
           for name, t in (("mean", mean), ("longest", longest))},
    }
    if arguments.json:
        print(json.dumps(result, indent=1))
        return 0
    print(f"{count} ticks from {arguments.begin} ms on, instructions a tick:")
    for kind, number in result["classes"].items():
        print(f"  {kind:<24}{number:>8.0f}")
    for name in ("mean", "longest"):
        r = result[name]
        print(f"{name}: {r['instructions']:.0f} instructions; processor {r['cycles'][0]:.0f} to {r['cycles'][1]:.0f} cycles, "
              f"flash {r['wait_states'][0]:.0f} to {r['wait_states'][1]:.0f}; "
              f"{100 * r['share'][0]:.1f} to {100 * r['share'][1]:.1f} % of a millisecond at 168 MHz")
    return 0


if __name__ == "__main__":
    sys.exit(main())
