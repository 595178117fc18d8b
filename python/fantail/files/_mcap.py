# SPDX-License-Identifier: MIT
"""MCAP with JSON messages, by the package mcap."""
from __future__ import annotations

import io
import json
from collections.abc import Iterable, Iterator
from typing import Any, BinaryIO

from ._errors import BadFile
from ._table import Table, column_of

# What fantail log export writes of every tick.
TICKS = ("/fantail/recorded", "/fantail/replayed")


def read_mcap(stream: BinaryIO) -> Table:
    """The two topics of a flight's ticks as one table, or the only topic of a file; a row for each time."""
    import mcap.reader
    messages: dict[str, dict[int, dict[str, Any]]] = {}
    others = set()
    try:
        for _, channel, message in mcap.reader.make_reader(stream, validate_crcs=True).iter_messages():
            if channel.message_encoding != "json":
                others.add(f"{channel.topic} ({channel.message_encoding})")
                continue
            content = json.loads(message.data)
            if isinstance(content, dict):
                messages.setdefault(channel.topic, {}).setdefault(message.log_time, {}).update(content)
    except Exception as error:  # the reader raises what its parts do: of a damaged file that may be anything
        kind = "is no MCAP file" if type(error).__name__ == "InvalidMagic" else "is damaged"
        raise BadFile(f"{kind}: {' '.join(str(error).split())[:200] or type(error).__name__}") from None
    topics = [topic for topic in TICKS if topic in messages] or list(messages)
    if len(topics) != 1 and not set(topics) <= set(TICKS):
        raise BadFile(f"has more than one topic: {', '.join(sorted(messages))}; keep one")
    if not topics:
        raise BadFile(f"has no message in JSON; its topics are: {', '.join(sorted(others)) or 'none'}")
    rows: dict[int, dict[str, Any]] = {}
    for topic in topics:
        for time, content in messages[topic].items():
            rows.setdefault(time, {}).update(content)
    return _table([rows[time] for time in sorted(rows)], sorted(rows))


def _table(rows: list[dict[str, Any]], times_ns: list[int]) -> Table:
    names = list(dict.fromkeys(name for row in rows for name in row))
    table = Table({})
    for name in names:
        column = column_of(row.get(name) for row in rows)
        if isinstance(column, str):
            table.not_columns[name] = column
        else:
            table.columns[name] = column
    if not table.columns.keys() & {"time_s", "time_us", "timestamp"}:
        column = column_of(time / 1000 for time in times_ns)
        assert not isinstance(column, str)
        table.columns = {"timestamp": column} | table.columns  # microseconds, as a ULog has them
    return table


def json_schema(title: str, properties: dict[str, Any]) -> bytes:
    return json.dumps({"title": title, "type": "object", "properties": properties}, ensure_ascii=False).encode()


def described(kind: str, unit: str, description: str) -> dict[str, str]:
    """Units go with the description: JSON Schema has no place for them."""
    return {"type": kind, "description": f"[{unit}] {description}"}


def write_messages(topics: Iterable[tuple[str, str, bytes]], messages: Iterable[tuple[int, int, dict[str, Any]]],
                   metadata: dict[str, str]) -> bytes:
    """A topic is its name, its schema's name and its schema; a message the place of its topic, its time in microseconds
    and what it says."""
    import mcap.writer
    out = io.BytesIO()
    writer = mcap.writer.Writer(out)
    writer.start(profile="", library="fantail")
    channels = [writer.register_channel(name, "json", writer.register_schema(schema_name, "jsonschema", schema))
                for name, schema_name, schema in topics]
    if metadata:
        writer.add_metadata("fantail", metadata)
    for topic, time_us, content in messages:
        writer.add_message(channels[topic], time_us * 1000, json.dumps(content, ensure_ascii=False, separators=(",", ":")).encode(),
                           time_us * 1000)
    writer.finish()
    return out.getvalue()


def write_mcap(table: Table) -> bytes:
    """One topic with a message a row, by its column time_s, time_us or timestamp (microseconds)."""
    clock = next((name for name in ("time_us", "timestamp", "time_s") if name in table.columns), None)
    if clock is None or table[clock].dtype == object:
        raise BadFile("MCAP needs a time: a column time_s, time_us or timestamp with numbers")
    scale = 1e6 if clock == "time_s" else 1.0
    times = table[clock].astype(float) * scale
    begin = min(0.0, min((time for time in times.tolist() if time == time), default=0.0))  # MCAP has no time before zero
    kinds = {"f": "number", "i": "integer", "u": "integer", "b": "boolean", "O": "string"}
    properties = {name: described(kinds[column.dtype.kind], table.units.get(name, "-"), "") for name, column in table.columns.items()}

    def messages() -> Iterator[tuple[int, int, dict[str, Any]]]:
        for time, row in zip(times.tolist(), zip(*(column.tolist() for column in table.columns.values()))):
            if time == time:
                yield 0, round(time - begin), {name: value for name, value in zip(table.columns, row) if value is not None and value == value}

    return write_messages([("/table", "Table", json_schema("Table", properties))], messages(), {})
