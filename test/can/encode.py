# SPDX-License-Identifier: MIT
"""Frames made by cantools and not by us: encode.py DATABASE INTERFACE <LINES, a candump log on standard output.

A line is TIME_S MESSAGE [wrong_crc] [in=SESSION] SIGNAL=VALUE ...; what is not named is zero. A message that belongs to
a bench session needs its number.
"""
import sys

import cantools
from crccheck.crc import Crc8Autosar

database = cantools.database.load_file(sys.argv[1])
for line in sys.stdin:
    time_s, name, *words = line.split()
    message = database.get_message_by_name(name)
    wrong = "wrong_crc" in words
    values = {signal.name: 0 for signal in message.signals}
    session = b""
    for word in words:
        key, _, value = word.partition("=")
        if key == "in":
            session = int(value).to_bytes(2, "little")
        elif key != "wrong_crc":
            values[key] = float(value) if value.lstrip("-").replace(".", "", 1).isdigit() else value
    data = bytearray(message.encode(values))
    data[7] = Crc8Autosar.calc(message.frame_id.to_bytes(2, "little") + session + data[:7]) ^ wrong
    print(f"({float(time_s):.6f}) {sys.argv[2]} {message.frame_id:03X}#{data.hex().upper()}")
