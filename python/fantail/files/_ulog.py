# SPDX-License-Identifier: MIT
"""ULog, by pyulog: the motion and height of a PX4 log, or the ticks that fantail log export wrote."""
from __future__ import annotations

import contextlib
import io
from typing import BinaryIO

import numpy

from ._errors import BadFile
from ._table import Table

# The topics that make a table together, the first of which must be there.
TOPICS = (("sensor_combined", "vehicle_air_data"), ("fantail_recorded", "fantail_replayed"))
# Before the time in the header, which is when the logger began, and after it: what says otherwise is damaged.
MOST_BEFORE_US, MOST_AFTER_US = 60_000_000, 6 * 3600 * 1_000_000


class _Watched(io.BytesIO):
    """Says whether the file ends within a message, which pyulog does not, and ends a reading that goes round in circles, as
    pyulog's does where the size of a definition is damaged: a message has three bytes at least, and is read in two pieces."""

    cut_off = False
    at = 0
    _reads = 0
    _of_a_message = False

    def read(self, size: int | None = -1) -> bytes:
        self._reads += 1
        if self._reads > self.getbuffer().nbytes + 100:
            raise RuntimeError("the size of a message is wrong")
        self.at = self.tell()
        content = super().read(size)
        self.cut_off = size is not None and len(content) < size and (bool(content) or self._of_a_message)
        self._of_a_message = size == 3 and len(content) == 3 and not self._of_a_message
        return content


def read_ulog(stream: BinaryIO) -> Table:
    import pyulog
    file = _Watched(stream.read())
    if not file.getvalue().startswith(b"ULog\x01\x12\x35"):
        raise BadFile(f"is not a ULog; it begins with {file.getvalue()[:7].decode('ascii', 'replace')!r}")
    names = [name for group in TOPICS for name in group]
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # pyulog prints what it finds damaged
            log = pyulog.ULog(file)
    except Exception as error:  # pyulog raises what its parts do: of a damaged file that may be anything
        raise BadFile(f"is damaged: {' '.join(str(error).split())[:200] or type(error).__name__}") from None
    there = {data.name: data.data for data in log.data_list if data.multi_id == 0 and data.name in names and "timestamp" in data.data}
    group = next((group for group in TOPICS if group[0] in there), None)
    if group is None:
        topics = ", ".join(sorted({data.name for data in log.data_list}))
        raise BadFile(f"has no message of the topic {TOPICS[0][0]}; its topics are: {topics[:400] or 'none'}")
    notes = []
    if file.cut_off:
        notes.append(f"The ULog is cut off in a message at byte {file.at}.")
    if log.file_corruption:
        notes.append("The ULog is damaged; what could not be read is left out.")
    parts = [_in_order(name, there[name], log.start_timestamp, notes) for name in group if name in there]
    dropped = sum(dropout.duration for dropout in log.dropouts)
    if dropped:
        notes.append(f"The logger reports that it dropped {dropped} ms.")
    return Table(_one_tick_a_row(parts) if group is TOPICS[1] else _one_message_a_row(parts), notes=notes)


def _in_order(topic: str, data: dict[str, numpy.ndarray], start: int, notes: list[str]) -> dict[str, numpy.ndarray]:
    """A topic's messages come in the order of their times. One that stands alone with its time is damaged and left out;
    where the others go back too, nobody knows what was when."""
    time = data["timestamp"].astype(numpy.float64)
    believable = (time + MOST_BEFORE_US >= start) & (time <= start + MOST_BEFORE_US + MOST_AFTER_US)
    if not believable.all():
        notes.append(f"{(~believable).sum()} messages with a time that is not near the start of the ULog are left out.")
    rows = numpy.flatnonzero(believable)
    times = time[rows]
    kept: list[int] = []
    alone = 0
    for i, row in enumerate(rows.tolist()):
        last = times[kept[-1]] if kept else -numpy.inf
        following = times[i + 1] if i + 1 < len(times) else numpy.inf
        next_fits = i + 1 < len(times) and last <= following
        if last <= times[i] and (times[i] <= following or not next_fits):
            kept.append(i)
        elif next_fits or i + 1 == len(times):
            alone += 1
        else:
            raise BadFile(f"time goes back in the topic {topic}: from {last * 1e-6:.6f} s to {times[i] * 1e-6:.6f} s")
    if 100 * alone > len(times):
        raise BadFile(f"time goes back repeatedly: {alone} of {len(times)} messages")
    if alone:
        notes.append("One message that stands alone with its time is left out." if alone == 1 else
                     f"{alone} messages that stand alone with their time are left out.")
    return {name: values[rows[kept]] for name, values in data.items()}


def _one_message_a_row(parts: list[dict[str, numpy.ndarray]]) -> dict[str, numpy.ndarray]:
    """In order of time; of a row what its topic does not have is NaN."""
    time = numpy.concatenate([part["timestamp"] for part in parts])
    order = numpy.argsort(time, kind="stable")
    columns = {"timestamp": time[order].astype(numpy.int64)}
    begin = 0
    for part in parts:
        rows = slice(begin, begin + len(part["timestamp"]))
        begin = rows.stop
        for name, values in part.items():
            if name not in columns:  # a name that an earlier topic has, too, is the earlier topic's
                merged = numpy.full(len(time), numpy.nan)
                merged[rows] = values
                columns[name] = merged[order]
    return columns


def _one_tick_a_row(parts: list[dict[str, numpy.ndarray]]) -> dict[str, numpy.ndarray]:
    """The topics of fantail log export have the same times, except for ticks that a replay cannot reach."""
    columns = dict(parts[0])
    for part in parts[1:]:
        at = numpy.searchsorted(part["timestamp"], columns["timestamp"]).clip(max=len(part["timestamp"]) - 1)
        there = part["timestamp"][at] == columns["timestamp"]
        columns |= {name: numpy.where(there, values[at].astype(float), numpy.nan) for name, values in part.items() if name not in columns}
    return columns
