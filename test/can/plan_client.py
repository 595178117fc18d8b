# SPDX-License-Identifier: MIT
"""Loads a flight plan into the avionics as a stranger would: from the manual and the database alone.

plan_client.py MANUAL DATABASE PLAN --can INTERFACE   sends the plan, waits until it is in force, and reads it back
plan_client.py MANUAL DATABASE PLAN --write FILE      writes the block instead

MANUAL is the folder with can.md and flight_plan.md, PLAN a TOML file; what it does not mention has the manual's default.
Beside the database stands plan_block.csv, the fields of the block.
Exit code 0: in force; 1: refused, with the reason on standard output.
"""
import argparse
import csv
import pathlib
import re
import struct
import time
import tomllib

import can
import cantools
from crccheck.crc import Crc8Autosar, Crc32C

REPEAT_AFTER_S = 0.05
PACE_S = 0.01
PATIENCE_S = 60.0


def rounded(value):
    """To an IEEE single."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


FACTORS = {
    "": 1.0,
    "pi/180": rounded(rounded(3.14159265358979) / 180.0),
    "180/pi": rounded(180.0 / rounded(3.14159265358979)),
    "9.80665": rounded(9.80665),
}


def rows(page, heading):
    section = page.split(heading + "\n", 1)[1].split("\n#", 1)[0]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("| ")]


class Manual:
    def __init__(self, folder, field_table):
        lines = [line for line in field_table.read_text().splitlines() if not line.startswith("#")]
        self.fields = [list(row.values()) for row in csv.DictReader(lines)]
        layout = {row[0]: row[2] for row in rows((folder / "can.md").read_text(), "### The plan block")}
        self.magic = re.search(r"`(\w{4})`", layout["0"])[1].encode()
        self.version = int(re.search(r"\d+$", layout["4"])[0])
        self.payload_size = int(re.search(r"\d+$", layout["6"])[0])
        self.schema = int(re.search(r"0x[0-9a-f]+", layout["8"])[0], 16)
        toml = re.search(r"```toml\n(.*?)```", (folder / "flight_plan.md").read_text(), re.S)[1]
        self.defaults = tomllib.loads(toml)

    def name_of(self, number):
        return self.fields[number][1]

    def block(self, plan):
        payload = b""
        for _, name, words, stored_as in self.fields:
            section, key = name.split(".")
            value = plan.get(section, {}).get(key, self.defaults[section][key])
            payload += self.words(value, words, stored_as)
        assert len(payload) == self.payload_size, "the manual contradicts itself"
        block = self.magic + struct.pack("<HHI", self.version, len(payload), self.schema) + payload
        return block + struct.pack("<I", Crc32C.calc(block))

    def words(self, value, words, stored_as):
        if words.startswith("1 + "):
            capacity = int(words[4:])
            length = struct.pack("<I", len(value))
            return length + b"".join(self.word(one, stored_as) for one in value) + bytes(4 * (capacity - len(value)))
        values = value if isinstance(value, list) else [value] * int(words)
        return b"".join(self.word(one, stored_as) for one in values)

    @staticmethod
    def word(value, stored_as):
        if stored_as.startswith("single"):
            return struct.pack("<f", rounded(value) * FACTORS[stored_as.partition("times ")[2]])
        if stored_as == "microseconds":
            return struct.pack("<I", round(value * 1e6))
        if stored_as.startswith("choice: "):
            return struct.pack("<I", stored_as.removeprefix("choice: ").split(", ").index(value))
        return struct.pack("<I", int(value))


class Avionics:
    def __init__(self, database, interface):
        self.database = cantools.database.load_file(database)
        self.bus = can.Bus(interface="socketcan", channel=interface)
        self.counter = 0
        self.tag = 0

    def send(self, name, signals):
        message = self.database.get_message_by_name(name)
        if "crc" in message.signal_tree:
            signals = signals | {"counter": self.counter % 16, "crc": 0}
            self.counter += 1
        data = bytearray(message.encode(signals))
        if "crc" in message.signal_tree:
            data[7] = Crc8Autosar.calc(message.frame_id.to_bytes(2, "little") + data[:7])
        self.bus.send(can.Message(arbitration_id=message.frame_id, data=data, is_extended_id=False))

    def hear(self, name, timeout_s, wanted=lambda signals: True):
        """The signals of the next message of this kind that is wanted, or None."""
        message = self.database.get_message_by_name(name)
        end = time.monotonic() + timeout_s
        while (left_s := end - time.monotonic()) > 0:
            frame = self.bus.recv(left_s)
            if frame is not None and frame.arbitration_id == message.frame_id and not frame.is_extended_id:
                signals = message.decode(frame.data, decode_choices=True)
                if wanted(signals):
                    return signals
        return None

    def await_(self, name, wanted):
        signals = self.hear(name, PATIENCE_S, wanted)
        if signals is None:
            raise SystemExit(f"no {name} that was waited for")
        return signals

    def ask(self, name, signals, wanted):
        """Sends until a PlanReply comes that is wanted."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            self.send(name, signals)
            if reply := self.hear("PlanReply", REPEAT_AFTER_S, wanted):
                return reply
        raise SystemExit(f"no answer to {name}")

    def load(self, block):
        self.await_("HeartbeatReport", lambda heartbeat: heartbeat["version"] == 2)
        self.await_("StatusReport", lambda status: status["phase"] == "safe" and status["at_rest"]
                    and not status["session_open"] and not status["self_test_running"])
        block_crc = Crc32C.calc(block[:-4])
        reply = self.ask("PlanBegin", {"size": len(block), "block_crc": block_crc},
                         lambda reply: reply["state"] in ("receiving", "refused"))
        for index in range(-(-len(block) // 7)):
            if reply["state"] == "refused":
                return reply
            time.sleep(PACE_S)
            part = block[7 * index:7 * index + 7].ljust(7, b"\0")
            reply = self.ask("PlanData", {"index": index} | {f"byte_{i}": byte for i, byte in enumerate(part)},
                             lambda reply: reply["state"] != "receiving" or reply["next_index"] == index + 1)
        if reply["state"] not in ("stored", "refused"):
            reply = self.await_("PlanReply", lambda reply: reply["state"] in ("stored", "refused"))
        if reply["state"] == "stored":
            self.await_("HeartbeatReport", lambda heartbeat: heartbeat["plan_crc"] == block_crc)
        return reply

    def read_back(self):
        """The block of the plan in force."""
        header = self.read(0, 12)
        return self.read(0, 12 + struct.unpack_from("<H", header, 6)[0] + 4)

    def read(self, offset, size):
        frames = -(-size // 7)
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            self.tag = (self.tag + 1) % 16
            self.send("LogRequest", {"action": "plan", "tag": self.tag, "offset": offset, "size": size})
            parts = {}
            while (part := self.hear_either("LogData", "LogReply")) is not None:
                if "index" in part:
                    parts[part["index"]] = bytes(part[f"byte_{i}"] for i in range(7))
                elif part["tag"] == self.tag:
                    if part["state"] == "refused":
                        raise SystemExit(f"not read: {part['fault']}")
                    data = b"".join(parts.get(index, b"") for index in range(frames))[:size]
                    if len(data) == part["extra"] and Crc32C.calc(data) == part["number"]:
                        return data
                    break
        raise SystemExit("the plan does not arrive")

    def hear_either(self, *names):
        messages = {self.database.get_message_by_name(name).frame_id: name for name in names}
        end = time.monotonic() + 10 * REPEAT_AFTER_S
        while (left_s := end - time.monotonic()) > 0:
            frame = self.bus.recv(left_s)
            if frame is not None and frame.arbitration_id in messages and not frame.is_extended_id:
                return self.database.decode_message(frame.arbitration_id, frame.data, decode_choices=True)
        return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("manual", type=pathlib.Path)
    parser.add_argument("database")
    parser.add_argument("plan", type=pathlib.Path)
    parser.add_argument("--can")
    parser.add_argument("--write", type=pathlib.Path)
    options = parser.parse_args()
    manual = Manual(options.manual, pathlib.Path(options.database).with_name("plan_block.csv"))
    block = manual.block(tomllib.loads(options.plan.read_text()))
    if options.write:
        options.write.write_bytes(block)
        return 0
    avionics = Avionics(options.database, options.can)
    reply = avionics.load(block)
    if reply["state"] == "stored":
        print(f"in force: {Crc32C.calc(block[:-4]):08x}")
        if avionics.read_back() != block:
            print("read back: other bytes")
            return 1
        print(f"read back: the same {len(block)} bytes")
        return 0
    field = manual.name_of(reply["field"]) if reply["field_given"] else "no field"
    print(f"refused: {reply['fault']}, {reply['block_fault']}, {field}")
    return 1


if __name__ == "__main__":
    raise SystemExit(main())
