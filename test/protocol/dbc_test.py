# SPDX-License-Identifier: MIT
"""The CAN database against the program and the manual: dbc_test.py BUS_LINES PROJECT. Run by ctest."""
import math
import pathlib
import random
import re
import subprocess
import sys
import unittest

import cantools
from crccheck.crc import Crc8Autosar

PROGRAM = sys.argv[1]
PROJECT = pathlib.Path(sys.argv[2])
DATABASE = cantools.database.load_file(PROJECT / "firmware/protocol/canard_bus.dbc")  # strict: no overlaps
MESSAGES = sorted(DATABASE.messages, key=lambda message: message.frame_id)
SEED = 20260101
OPEN_SESSION = int(subprocess.run([PROGRAM, "session"], capture_output=True, text=True, check=True).stdout)
OUT_OF_RANGE = 4
WORST_BITS = 135
GIVEN_BY = {"nonce": "nonce_given", "field": "field_given", "battery": "battery_given"}  # a value, and the bit that says whether it is there
for k in "1234":
    GIVEN_BY["canard_" + k] = ("asked_", "driven_", "valid_", k)


def protected(message):
    return "crc" in message.signal_tree


def attribute(message, name):
    """Whether the database says yes."""
    found = message.dbc.attributes.get(name)
    return found is not None and found.value in (1, "yes")


def with_crc(message, data):
    data = bytearray(data)
    if protected(message):
        session = OPEN_SESSION.to_bytes(2, "little") if attribute(message, "InSession") else b""
        data[7] = Crc8Autosar.calc(message.frame_id.to_bytes(2, "little") + session + data[:7])
    return bytes(data)


def line(message, data):
    return f"{message.frame_id:03X}#{data.hex().upper()}"


def given_bit(message, name):
    """The signal without which this one has no meaning, or None."""
    bits = GIVEN_BY.get(name, ())
    if isinstance(bits, tuple):
        bits = [prefix + bits[-1] for prefix in bits[:-1]]
    else:
        bits = [bits]
    return next((bit for bit in bits if bit in message.signal_tree), None)


def raw_range(signal):
    """Lowest and highest raw value that the database allows."""
    return round(signal.minimum / signal.scale), round(signal.maximum / signal.scale)


def ask(lines):
    answer = subprocess.run([PROGRAM], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
    return answer.stdout.splitlines()


class Values(unittest.TestCase):
    def check(self, message, raw_values):
        """Encodes sets of raw values with cantools and compares what the program understands and sends back."""
        frames = []
        for raw in raw_values:
            for name in raw:
                bit = given_bit(message, name)
                if bit and not raw[bit]:
                    raw[name] = 0
            frames.append(with_crc(message, message.encode(raw, scaling=False, strict=False)))
        for raw, frame, answer in zip(raw_values, frames, ask([line(message, f) for f in frames]), strict=True):
            words = answer.split()
            self.assertNotEqual(words[0], "refused", (message.name, raw))
            self.assertEqual(words[0], line(message, frame))
            found = {name: float(value) for name, value in (word.split("=") for word in words[1:])}
            wanted = message.decode(frame, decode_choices=False)
            wanted.pop("crc", None)
            self.assertEqual(found.keys(), wanted.keys(), message.name)
            for name, value in wanted.items():
                scale = message.get_signal_by_name(name).scale
                tolerance = 0.01 * scale if scale != 1 else 0
                self.assertLessEqual(abs(found[name] - value), tolerance, (message.name, name, raw))

    def test_every_value_of_short_signals_and_many_of_long_ones_mean_the_same_to_cantools_and_to_us(self):
        generator = random.Random(SEED)
        print("seed", SEED)
        for message in MESSAGES:
            sets = []
            for signal in message.signals:
                low, high = raw_range(signal)
                if high - low < 256:
                    values = range(low, high + 1)
                else:
                    values = [low, low + 1, high - 1, high] + [generator.randint(low, high) for _ in range(300)]
                for value in values:
                    others = {s.name: generator.randint(*raw_range(s)) for s in message.signals}
                    sets.append(others | {signal.name: value})
            self.check(message, sets)

    def test_a_value_next_to_the_range_of_the_database_is_refused(self):
        for message in MESSAGES:
            for signal in message.signals:
                low, high = raw_range(signal)
                lowest = -(1 << signal.length - 1) if signal.is_signed else 0
                highest = lowest + (1 << signal.length) - 1
                for value in {low - 1, high + 1, lowest, highest}:
                    if low <= value <= high or not lowest <= value <= highest:
                        continue
                    raw = {s.name: int(s.name.startswith(("asked", "driven", "valid"))) for s in message.signals}
                    raw[signal.name] = value
                    frame = with_crc(message, message.encode(raw, scaling=False, strict=False))
                    self.assertEqual(ask([line(message, frame)]), [f"refused {OUT_OF_RANGE}"], (message.name, signal))


class Database(unittest.TestCase):
    def test_every_frame_is_eight_little_endian_bytes_with_a_comment_a_sender_and_a_period(self):
        for message in MESSAGES:
            self.assertEqual(message.length, 8)
            self.assertFalse(message.is_extended_frame)
            self.assertTrue(message.comment)
            self.assertEqual(len(message.senders), 1)
            self.assertEqual(bool(message.cycle_time), message.name != "LogData")
            for signal in message.signals:
                self.assertEqual(signal.byte_order, "little_endian")
                self.assertEqual(signal.offset, 0)
                self.assertEqual(set(signal.receivers), {"AVIONICS", "BENCH"} - set(message.senders))

    def test_counter_and_crc_lie_at_the_same_place_in_every_frame_that_has_them(self):
        for message in MESSAGES:
            if protected(message):
                counter, crc = message.get_signal_by_name("counter"), message.get_signal_by_name("crc")
                self.assertEqual((counter.start, counter.length, crc.start, crc.length), (52, 4, 56, 8))

    def test_the_words_of_a_signal_are_its_whole_range(self):
        for message in MESSAGES:
            for signal in message.signals:
                if signal.choices:
                    low, high = raw_range(signal)
                    self.assertEqual(sorted(signal.choices), list(range(low, high + 1)), signal.name)
                    self.assertEqual(low, 0)

    def test_signals_that_the_program_treats_alike_are_alike(self):
        for pattern in (r"canard_\d", r"limited_\d", r"verdict_\d", "gyro|accelerometer"):
            for groups in ([m for m in MESSAGES if m.name != "LimitReport"], [DATABASE.get_message_by_name("LimitReport")]):
                kinds = {
                    (s.length, s.scale, s.is_signed, s.minimum, s.maximum, str(s.choices))
                    for m in groups if m.name != "ArmReply" for s in m.signals if re.fullmatch(pattern, s.name)
                }
                self.assertLessEqual(len(kinds), 1, pattern)

    def test_the_program_knows_the_same_frames_and_bounds(self):
        catalogue = subprocess.run([PROGRAM, "catalogue"], capture_output=True, text=True, check=True).stdout
        wanted = [
            f"{m.frame_id} {m.name} {m.senders[0]} {m.length} {m.cycle_time or 0} {int(protected(m))} {int(can_move(m))}"
            f" {bound_us(m) if m.cycle_time else 'none'}"
            for m in MESSAGES
        ]
        self.assertEqual(catalogue.splitlines(), wanted)


def can_move(message):
    return attribute(message, "CanMove")


def bound_us(message):
    """Blocking by one frame, then every more urgent one as often as it may come; by stepping through the time. Of a
    frame with a period; the one without is the least urgent, so it is never among the more urgent ones."""
    urgent = [m for m in MESSAGES if m.frame_id < message.frame_id]
    blocking = WORST_BITS if message is not MESSAGES[-1] else 0
    worst, earlier = 0, 0
    while True:
        start = blocking + earlier * WORST_BITS
        while True:
            due = sum(math.floor(start / (1000 * m.cycle_time)) + 1 for m in urgent)
            if blocking + (earlier + due) * WORST_BITS <= start:
                break
            start += 1
        worst = max(worst, start + WORST_BITS - earlier * 1000 * message.cycle_time)
        earlier += 1
        if start + WORST_BITS <= earlier * 1000 * message.cycle_time:
            return worst


class Manual(unittest.TestCase):
    def setUp(self):
        self.text = (PROJECT / "docs/can.md").read_text()

    def rows(self, heading):
        section = self.text.split("## " + heading, 1)[1].split("\n## ", 1)[0]
        rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in section.splitlines() if row.startswith("|")]
        return rows[2:]

    def test_its_table_of_frames_and_their_latency_bounds_is_the_database(self):
        wanted = [
            [f"0x{m.frame_id:03X}", m.name, m.senders[0].lower(), f"{m.cycle_time}" if m.cycle_time else "",
             f"{bound_us(m)}" if m.cycle_time else "", "**yes**" if can_move(m) else ""]
            for m in MESSAGES
        ]
        self.assertEqual([row[:6] for row in self.rows("Frames")], wanted)
        self.assertLessEqual(bound_us(DATABASE.get_message_by_name("BenchRequest")), 270)

    def test_its_contents_name_signals_of_the_database_only(self):
        for message, row in zip(MESSAGES, self.rows("Frames"), strict=True):
            for name in re.findall(r"`(\w+)`", row[6]):
                self.assertTrue(any(re.fullmatch(name + r"(_\d)?", s.name) for s in message.signals), (message.name, name))

    def test_the_bits_of_board_faults_are_those_of_the_hardware_layer_everywhere(self):
        header = (PROJECT / "hal/include/hal/board.hpp").read_text()
        body = re.search(r"enum class BoardFault [^{]*\{(.*?)\};", header, re.S).group(1)
        faults = re.findall(r"^\s*(\w+),", body, re.M)
        self.assertGreater(len(faults), 10)
        self.assertEqual([row[:2] for row in self.rows("Faults of the board")],
                         [[str(bit), f"`{fault}`"] for bit, fault in enumerate(faults)])
        comment = DATABASE.get_message_by_name("BoardReport").comment
        self.assertIn("from the lowest: " + ", ".join(faults) + ".", comment)

    def test_its_bus_load_is_that_of_everything_at_its_fastest(self):
        periodic = [m for m in MESSAGES if m.cycle_time]
        load = sum(WORST_BITS * 1000 / m.cycle_time for m in periodic) / 1e6
        self.assertLess(load, 0.40)
        self.assertIn(f"{100 * load:.1f} %", self.text)
        frames = sum(1000 / m.cycle_time for m in periodic)
        self.assertIn(f"{frames:.0f} frames", self.text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
