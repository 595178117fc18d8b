# SPDX-License-Identifier: MIT
"""A flight from fantail log export, as a file of another program: a line of JSON, then the values of every column as
float64, NaN if unknown. Flags are 0 and 1, words are places in a list. JSON needs only Python itself."""
from __future__ import annotations

import array
import json
from collections.abc import Iterator
from typing import Any, BinaryIO, Union

Value = Union[None, bool, int, float, str]


class Flight:
    """`about` is what is not of a single tick, `fields` describe the columns, `times_us` is the board's clock."""

    def __init__(self, stream: BinaryIO) -> None:
        self.head: dict[str, Any] = json.loads(stream.readline())
        self.about: dict[str, Any] = self.head["about"]
        self.fields: list[dict[str, Any]] = self.head["fields"]
        self.times_us = [int(time) for time in self._block(stream)]
        self.blocks = [self._block(stream) for _ in self.fields]

    def _block(self, stream: BinaryIO) -> array.array[float]:
        block = array.array("d")
        block.frombytes(stream.read(8 * self.head["rows"]))
        return block

    def values(self, i: int) -> Iterator[Value]:
        """Of a column, to the six decimals of a CSV."""
        kind, texts = self.fields[i]["type"], self.fields[i]["words"]
        for value in self.blocks[i]:
            if value != value:
                yield None
            elif kind == "number":
                rounded = round(value, 6)
                yield int(rounded) if rounded == int(rounded) else rounded
            elif kind == "integer":
                yield int(value)
            else:
                yield value != 0.0 if kind == "flag" else texts[int(value)]


def to_json(flight: Flight) -> bytes:
    """One object: everything of `about`, and under "ticks" a list for each field, all of one length."""
    lines = json.dumps(flight.about, ensure_ascii=False, indent=2)[:-2]
    ticks = ",\n".join(f"    {json.dumps(field['name'])}: {json.dumps(list(flight.values(i)), ensure_ascii=False, separators=(',', ':'))}"
                       for i, field in enumerate(flight.fields))
    return f'{lines},\n  "ticks": {{\n{ticks}\n  }}\n}}\n'.encode()


def to_parquet(flight: Flight) -> bytes:
    """A column for each field; null is unknown. Under the key "fantail" of its metadata stands `about`."""
    import pyarrow as arrow
    import pyarrow.compute as compute

    from ._arrow import parquet_of
    columns = []
    for field, block in zip(flight.fields, flight.blocks):
        numbers = arrow.Array.from_buffers(arrow.float64(), len(block), [None, arrow.py_buffer(block)])
        numbers = compute.if_else(compute.is_nan(numbers), arrow.scalar(None, arrow.float64()), numbers)
        if field["type"] == "word":
            places = numbers.cast(arrow.int32())
            columns.append(arrow.DictionaryArray.from_arrays(places, arrow.array(field["words"], arrow.string())).cast(arrow.string()))
        else:
            kinds = {"number": arrow.float64(), "integer": arrow.int64(), "flag": arrow.bool_()}
            columns.append(numbers.cast(kinds[field["type"]]))
    return parquet_of(arrow.table(columns, names=[field["name"] for field in flight.fields]), flight.about)


def to_mcap(flight: Flight) -> bytes:
    """The topics of a flight: what stands in the log, what the replay made again, health, and events with gaps."""
    from ._mcap import described, json_schema, write_messages
    kinds = {"number": "number", "integer": "integer", "flag": "boolean", "word": "string"}
    topics, parts = [], []
    for name, replayed in (("Recorded", False), ("Replayed", True)):
        chosen = [i for i, field in enumerate(flight.fields) if field["replayed"] is replayed]
        if chosen:
            fields = [flight.fields[i] for i in chosen]
            properties = {field["name"]: described(kinds[field["type"]], field["unit"], field["description"]) for field in fields}
            topics.append((f"/fantail/{name.lower()}", f"fantail.{name}", json_schema(f"fantail.{name}", properties)))
            parts.append(([field["name"] for field in fields], zip(*(flight.values(i) for i in chosen))))
    properties = {"verdicts": {"type": "array", "items": {"type": "string"}}}
    properties |= {field["name"]: described(field["type"], field["unit"], field["description"]) for field in flight.head["health_fields"]}
    topics.append(("/fantail/health", "fantail.Health", json_schema("fantail.Health", properties)))
    topics.append(("/fantail/events", "foxglove.Log", json_schema("foxglove.Log", _log_properties())))

    def messages() -> Iterator[tuple[int, int, dict[str, Any]]]:
        notes = sorted([(time, len(parts), health) for time, health in zip(flight.head["health_us"], flight.about["health"])] +
                       [(time, len(parts) + 1, _log(time, warns, text)) for time, warns, text in flight.head["log"]],
                       key=lambda note: (note[0], -note[1]))
        notes.reverse()
        for time in flight.times_us:
            while notes and notes[-1][0] <= time:
                yield _placed(notes.pop())
            for topic, (names, rows) in enumerate(parts):
                # What is unknown is not in the message; where nothing is known, there is none.
                known = {name: value for name, value in zip(names, next(rows)) if value is not None}
                if known:
                    yield topic, time, known
        while notes:
            yield _placed(notes.pop())

    metadata = {key: value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
                for key, value in flight.about.items() if key not in ("columns", "events", "health")}
    return write_messages(topics, messages(), metadata)


def _placed(note: tuple[int, int, dict[str, Any]]) -> tuple[int, int, dict[str, Any]]:
    return note[1], note[0], note[2]


def _log_properties() -> dict[str, Any]:
    """As Foxglove defines it, so that its log panel shows the events."""
    whole, text = {"type": "integer"}, {"type": "string"}
    time = {"type": "object", "title": "time", "properties": {"sec": whole, "nsec": whole}}
    return {"timestamp": time, "level": whole, "message": text, "name": text, "file": text, "line": whole}


def _log(time_us: int, warns: bool, text: str) -> dict[str, Any]:
    return {"timestamp": {"sec": time_us // 1_000_000, "nsec": time_us % 1_000_000 * 1000}, "level": 3 if warns else 2, "message": text,
            "name": "fantail", "file": "", "line": 0}


EXPORTS = {"json": to_json, "parquet": to_parquet, "mcap": to_mcap}
