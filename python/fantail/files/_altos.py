# SPDX-License-Identifier: MIT
"""What Altus Metrum's computers leave behind: the image of their flash (.eeprom) and their radio packets (.telem), with the columns and
units of the CSV export of AltosUI. Layouts: its ao_log.h and ao_telemetry.h; checked against exports of the same flights."""
from __future__ import annotations

import json
import struct
from typing import Any, BinaryIO, NamedTuple

import numpy

from ._errors import BadFile
from ._table import Table, words

TICKS_PER_S = 100
GRAVITY_M_S2 = 9.80665
NO_VALUE = 2147483647
MINI, METRUM, METRUM_1 = (6, 8, 12, 14), (7,), (1,)
# Of the IMU of a mega: counts per g and per deg/s, and for each of along, across, through and roll, pitch, yaw the place and the sign.
OWN_AXES = ((0, 1), (1, 1), (2, 1)), ((0, 1), (1, 1), (2, 1))
Y_ALONG = ((1, 1), (0, 1), (2, 1)), ((1, 1), (0, 1), (2, 1))
X_ALONG = ((0, 1), (1, -1), (2, 1)), ((0, 1), (1, -1), (2, 1))
MEGA = {10: (2048, 16.3835, Y_ALONG), 15: (2048, 16.3835, Y_ALONG), 16: (2048, 16.3835, X_ALONG), 19: (2048, 16.3835, X_ALONG),
        21: (2048, 16.3835, OWN_AXES), 22: (1365, 16.384, OWN_AXES), 24: (1365, 16.384, OWN_AXES)}


class Record(NamedTuple):
    kind: str
    tick: int
    data: bytes  # from byte 4 on


def read_eeprom(stream: BinaryIO) -> Table:
    text = stream.read().decode("ascii", "replace")
    about, records, broken = _json_image(text) if text.lstrip().startswith("{") else _text_image(text)
    form = about.get("log_format")
    if form is None:
        raise BadFile("is not the flash image of a computer of Altus Metrum")
    if form not in (*MINI, *METRUM, *METRUM_1, *MEGA):
        raise BadFile(f"has the log format {form}, which is not read; AltosUI makes a table of it: File, Export data")
    flight = next((record for record in records if record.kind == "F"), None)
    sensors = [record for record in _unwrapped(records) if record.kind == "A"]
    if flight is None or not sensors:
        raise BadFile(f"holds no flight that can be read; damaged records: {broken}" if broken else "holds no flight")
    columns: dict[str, Any] = {"time": _time_s(sensors, flight.tick)}
    try:
        _pressure_and_height(columns, about, form, flight, sensors)
        _forces_and_rates(columns, about, form, flight, sensors)
    except (struct.error, KeyError, TypeError, ValueError) as error:
        if isinstance(error, BadFile):
            raise
        raise BadFile(f"is damaged: {error}") from None
    notes = [f"Damaged records, which are left out: {broken}."] if broken else []
    return _table(columns, about, form, notes)


def _table(columns: dict[str, Any], about: dict[str, Any], form: Any, notes: list[str]) -> Table:
    rows = len(columns["time"])
    first = {"version": form, "serial": about.get("serial", 0), "flight": about.get("flight", 0)}
    return Table({name: numpy.full(rows, value) for name, value in first.items()} | columns, notes=notes)


def _json_image(text: str) -> tuple[dict[str, Any], list[Record], int]:
    try:
        about, end = json.JSONDecoder().raw_decode(text.lstrip())
    except ValueError:
        raise BadFile("is damaged: its settings cannot be read") from None
    tokens = text.lstrip()[end:].split()
    if tokens and len(tokens[-1]) == 1:  # cut off in a byte
        tokens.pop()
    try:
        image = bytes.fromhex("".join(tokens))
    except ValueError:
        raise BadFile("is damaged: what stands behind its settings are not the bytes of a flash") from None
    config = about.get("config_data", about)
    about = {name: value for name, value in (about | config).items() if value != NO_VALUE}
    form = about.get("log_format")
    size = 32 if form in MEGA else 8 if form in METRUM_1 else 16
    raw = [image[at:at + size] for at in range(0, len(image) - size + 1, size)]
    raw = [one for one in raw if one.strip(b"\xff")]
    good = [one for one in raw if (0x5A + sum(one)) & 0xFF == 0]
    return about, [Record(chr(one[0]), one[2] | one[3] << 8, one[4:]) for one in good], len(raw) - len(good)


def _text_image(text: str) -> tuple[dict[str, Any], list[Record], int]:
    """Before AltOS 1.8: settings in lines, then a record a line; of TeleMetrum 1 its two numbers, else its bytes."""
    about: dict[str, Any] = {"ms5607": {}}
    records: list[Record] = []
    broken = 0
    for line in text.splitlines():
        words = line.split()
        if len(words) > 2 and len(words[0]) == 1 and len(words[1]) == 4 and words[0].isupper():
            try:
                if len(words) not in (4, 14):
                    raise ValueError
                numbers = [int(word, 16) for word in words[1:]]
                data = struct.pack("<2H", *numbers[1:]) if len(words) == 4 else bytes(numbers[1:])
                records.append(Record(words[0], numbers[0], data))
            except (ValueError, struct.error):
                broken += 1
        elif words[:1] == ["log-format"]:
            about["log_format"] = int(words[-1])
        elif words[:1] == ["ms5607"] and len(words) == 3:
            about["ms5607"][words[1].rstrip(":")] = int(words[2])
        elif line.startswith("Accel cal +1g:"):
            about |= {"accel_cal_plus": int(words[3]), "accel_cal_minus": int(words[5])}
        elif words[:1] == ["product"]:
            about["product"] = words[-1]
        elif words[:1] == ["serial-number"]:
            about["serial"] = int(words[-1])
    if "log_format" not in about and str(about.get("product", "")).startswith("TeleMetrum"):
        about["log_format"] = 1
    return about, records, broken


def _unwrapped(records: list[Record]) -> list[Record]:
    """In the order of their times. The counter has 16 bits; records before the launch stand behind that of the flight."""
    out, before = [], None
    for record in records:
        tick = record.tick
        if before is not None:
            tick = before + (tick - before + 0x8000) % 0x10000 - 0x8000
        before = tick
        out.append(record._replace(tick=tick))
    return sorted(out, key=lambda record: record.tick)


def _time_s(sensors: list[Record], zero: int) -> numpy.ndarray:
    return numpy.array([record.tick - zero for record in sensors]) / TICKS_PER_S


def _numbers(records: list[Record], form: str, at: int) -> numpy.ndarray:
    return numpy.array([struct.unpack_from(form, record.data, at - 4)[0] for record in records], numpy.int64)


def _pressure_and_height(columns: dict[str, Any], about: dict[str, Any], form: int, flight: Record, sensors: list[Record]) -> None:
    if form in METRUM_1:
        pressure = ((_numbers(sensors, "<h", 6) / 16) / 2047 + 0.095) / 0.009 * 1000
        ground = pressure[:10].mean()
    else:
        if form in MINI:
            raw, temperature = (numpy.array([int.from_bytes(record.data[at:at + 3], "little") for record in sensors]) for at in (0, 3))
        else:
            raw, temperature = _numbers(sensors, "<I", 4), _numbers(sensors, "<I", 8)
        calibration = about.get("ms5607", {})
        if not {"sens", "off", "tcs", "tco", "tref", "tempsens"} <= calibration.keys():
            raise BadFile("lacks the calibration of its barometer")
        pressure = _ms5607_pa(raw, temperature, calibration)
        ground = struct.unpack_from("<i", flight.data, 4)[0]
    columns["pressure"] = pressure
    columns["height"] = _altitude_m(pressure) - _altitude_m(numpy.array([ground]))[0]


def _ms5607_pa(raw: numpy.ndarray, temperature: numpy.ndarray, c: dict[str, int]) -> numpy.ndarray:
    """The data sheet's integers, second order included."""
    ms5611 = bool(c.get("ms5611"))
    raw, temperature = raw.astype(object), temperature.astype(object)  # Python's integers do not overflow
    change = temperature - (c["tref"] << 8)
    centi_deg_c = 2000 + (change * c["tempsens"] >> 23)
    off = (c["off"] << (16 if ms5611 else 17)) + (c["tco"] * change >> (7 if ms5611 else 6))
    sens = (c["sens"] << (15 if ms5611 else 16)) + (c["tcs"] * change >> (8 if ms5611 else 7))
    for i, celsius in enumerate(centi_deg_c):
        if celsius < 2000:
            below = celsius - 2000
            off_2, sens_2 = 61 * below * below >> 4, 2 * below * below
            if celsius < -1500:
                off_2 += 15 * (celsius + 1500) ** 2
                sens_2 += 8 * (celsius + 1500) ** 2
            off[i] -= off_2
            sens[i] -= sens_2
    return (((raw * sens >> 21) - off) >> 15).astype(float)


def _altitude_m(pressure_pa: numpy.ndarray) -> numpy.ndarray:
    """Of the standard atmosphere of 1976, to 32 km."""
    base_m, base_k, base_pa, lapses = 0.0, 288.15, 101325.0, ((11000.0, -0.0065), (20000.0, 0.0), (32000.0, 0.001))
    gas = 287.053
    out = numpy.zeros(len(pressure_pa))
    for top_m, lapse in lapses:
        ratio = numpy.maximum(pressure_pa, 1.0) / base_pa
        if lapse:
            layer = base_m + base_k / lapse * (ratio ** (-lapse * gas / GRAVITY_M_S2) - 1)
            top_pa = base_pa * ((base_k + lapse * (top_m - base_m)) / base_k) ** (-GRAVITY_M_S2 / (lapse * gas))
        else:
            layer = base_m - base_k * gas / GRAVITY_M_S2 * numpy.log(ratio)
            top_pa = base_pa * numpy.exp(-GRAVITY_M_S2 * (top_m - base_m) / (gas * base_k))
        out = numpy.where((pressure_pa <= base_pa) | (base_m == 0.0), layer, out)
        base_m, base_k, base_pa = top_m, base_k + lapse * (top_m - base_m), top_pa
    return out


def _forces_and_rates(columns: dict[str, Any], about: dict[str, Any], form: int, flight: Record, sensors: list[Record]) -> None:
    if form in MINI:
        return  # no accelerometer
    columns["call"] = words([about.get("callsign")] * len(sensors))  # as the export of a computer with a radio has
    place = {True: 30, False: 12}[form in MEGA] if form not in METRUM_1 else 4
    ground = struct.unpack_from("<h", flight.data, 0 if form in METRUM_1 else 2)[0]
    plus, minus = about.get("accel_cal_plus"), about.get("accel_cal_minus")
    if plus is None or minus is None or plus == minus:
        raise BadFile("lacks the calibration of its accelerometer")
    columns["acceleration"] = (_numbers(sensors, "<h", place) - ground) / ((plus - minus) / 2) * GRAVITY_M_S2
    if form not in MEGA:
        return
    counts_per_g, counts_per_deg_s, (force, rate) = MEGA[form]
    zeros = [about.get(f"accel_zero_{axis}", 0) for axis in ("along", "across", "through")]
    for name, (axis, sign), zero in zip(("accel_x", "accel_y", "accel_z"), force, zeros):
        columns[name] = (sign * _numbers(sensors, "<h", 12 + 2 * axis) - zero) / counts_per_g * GRAVITY_M_S2
    still = [struct.unpack_from("<i", flight.data, at)[0] / 512 for at in (16, 20, 24)]
    for name, (axis, sign), zero in zip(("gyro_roll", "gyro_pitch", "gyro_yaw"), rate, still):
        columns[name] = (sign * _numbers(sensors, "<h", 18 + 2 * axis) - zero) / counts_per_deg_s


# Packets with what the computer itself computed, by their type: where acceleration / 16, speed / 16 and height stand. That of a TeleMini
# makes its acceleration from the barometer: none.
TOLD = {0x01: (18, 20, 22), 0x09: (26, 28, 30), 0x0A: (14, 16, 18), 0x11: (None, 20, 22)}


def read_telem(stream: BinaryIO) -> Table:
    packets: dict[int, list[tuple[int, bytes]]] = {}
    lines = lost = 0
    for line in stream.read().decode("ascii", "replace").splitlines():
        if not line.startswith("TELEM "):
            continue
        lines += 1
        try:
            content = bytes.fromhex(line[6:])
        except ValueError:
            content = b""
        # The radio's own check stands in the last bit of its status.
        if len(content) < 36 or (0x5A + sum(content[1:-1])) & 0xFF != content[-1] or not content[-2] & 0x80:
            lost += 1
            continue
        serial, tick, kind = struct.unpack_from("<HHB", content, 1)
        if kind in TOLD:
            packets.setdefault(serial, []).append((tick, content[1:33]))
    if not packets:
        raise BadFile("holds no packet of a flight computer of Altus Metrum")
    serial = max(packets, key=lambda one: len(packets[one]))
    records = _unwrapped([Record(chr(packet[4]), tick, packet) for tick, packet in packets[serial]])
    columns: dict[str, Any] = {"time": _time_s(records, records[0].tick), "call": words([None] * len(records))}
    for name, place, per_unit in (("acceleration", 0, 16), ("speed", 1, 16), ("height", 2, 1)):
        values = [None if TOLD[ord(record.kind)][place] is None else
                  struct.unpack_from("<h", record.data, TOLD[ord(record.kind)][place])[0] / per_unit for record in records]
        if any(value is not None for value in values):
            columns[name] = numpy.array([numpy.nan if value is None else value for value in values])
    notes = [f"Damaged packets, which are left out: {lost} of {lines}."] if lost else []
    if len(packets) > 1:
        notes.append(f"The file has packets of {len(packets)} computers; those of number {serial}, which are most, are read.")
    return _table(columns, {"serial": serial}, 0, notes)
