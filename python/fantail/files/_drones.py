# SPDX-License-Identifier: MIT
"""Logs of autopilots: DataFlash of ArduPilot, by pymavlink; black boxes of Betaflight, by orangebox."""
from __future__ import annotations

import contextlib
import io
import os
import struct
from collections.abc import Iterator
from typing import Any, BinaryIO

import numpy

from ._errors import BadFile
from ._table import Table

# Of ArduPilot: the first IMU and barometer, and the fields of each.
MESSAGES = {"IMU": ("AccX", "AccY", "AccZ", "GyrX", "GyrY", "GyrZ"), "BARO": ("Alt",)}


@contextlib.contextmanager
def _as_file(stream: BinaryIO) -> Iterator[str]:
    """Both packages open a file by its name; this one is in memory alone. What they print is dropped."""
    file = os.memfd_create("log")
    try:
        os.write(file, content) if (content := stream.read()) else None
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            yield f"/proc/self/fd/{file}"
    finally:
        os.close(file)


def read_dataflash(stream: BinaryIO) -> Table:
    begin = stream.read(3)
    stream.seek(0)
    if begin != b"\xa3\x95\x80":
        raise BadFile("is not a DataFlash log of ArduPilot")
    from pymavlink import DFReader
    rows: list[dict[str, float]] = []
    there: set[str] = set()
    try:
        with _as_file(stream) as name:
            log = DFReader.DFReader_binary(name)
            while (message := log.recv_msg()) is not None:
                kind = message.get_type()
                there.add(kind)
                if kind in MESSAGES and getattr(message, "I", 0) == 0:
                    row = {f"{kind}.{field}": float(getattr(message, field)) for field in MESSAGES[kind] if hasattr(message, field)}
                    rows.append({"TimeUS": float(message.TimeUS)} | row)
    except Exception as error:  # of a damaged file that may be anything
        raise BadFile(f"is damaged: {' '.join(str(error).split())[:200] or type(error).__name__}") from None
    if "IMU" not in there:
        raise BadFile(f"has no message IMU; it has: {' '.join(sorted(there))[:400] or 'none'}")
    rows.sort(key=lambda row: row["TimeUS"])
    names = ["TimeUS"] + [f"{kind}.{field}" for kind, fields in MESSAGES.items() for field in fields]
    return Table({name: numpy.array([row.get(name, numpy.nan) for row in rows]) for name in names})


def read_blackbox(stream: BinaryIO) -> Table:
    """Of several logs in one file the longest."""
    begin = stream.read(2)
    stream.seek(0)
    if begin != b"H ":
        raise BadFile("is not a black box of Betaflight")
    import orangebox
    best: tuple[list[Any], list[str], dict[str, Any], int, bool] | None = None
    logs = 0
    with _as_file(stream) as name:
        try:
            parser = orangebox.Parser.load(name)
            logs = parser.reader.log_count
        except Exception:  # of a damaged file that may be anything
            raise BadFile("is damaged: its header cannot be read") from None
        for number in range(1, logs + 1):
            frames: list[Any] = []
            is_whole = True
            try:
                parser.set_log_index(number)
                frames.extend(frame.data for frame in parser.frames())
            except Exception:
                is_whole = False
            if frames and (best is None or len(frames) > len(best[0])):
                best = frames, list(parser.field_names), dict(parser.headers), number, is_whole
    if best is None:
        raise BadFile("holds no frame that can be read")
    return _of_frames(*best, logs)


def _of_frames(frames: list[Any], names: list[str], headers: dict[str, Any], number: int, is_whole: bool, logs: int) -> Table:
    wanted = [name for name in ("time", *(f"{what}[{i}]" for what in ("accSmooth", "gyroADC") for i in range(3))) if name in names]
    columns = {name: numpy.array([frame[names.index(name)] for frame in frames], float) for name in wanted}
    notes = [f"The file holds {logs} logs; the longest, number {number}, is read."] if logs > 1 else []
    if not is_whole:
        notes.append(f"The log is damaged or cut off behind {len(frames)} frames; these are read.")
    finer = 10.0 if headers.get("blackbox_high_resolution") else 1.0
    scale = struct.unpack("<f", struct.pack("<I", int(headers.get("gyro_scale", 0)) & 0xFFFFFFFF))[0]
    for name in [name for name in columns if name.startswith("gyroADC")]:
        if scale == 1.0:
            columns[name] = columns[name] / finer  # deg/s
        else:
            del columns[name]
    if scale != 1.0:
        notes.append("Its rates are in counts of an unknown size (gyro_scale is not 1); they are left out.")
    for name in [name for name in columns if name.startswith("accSmooth")]:
        columns[name] = columns[name] / float(headers["acc_1G"])  # g
    return Table(columns, notes=notes)
