# SPDX-License-Identifier: MIT
"""The table that readers return and writers take, and its text as CSV."""
from __future__ import annotations

import csv
import dataclasses
import datetime
import io
from collections.abc import Iterable, Iterator
from typing import Any, BinaryIO

import numpy

from ._errors import BadFile


@dataclasses.dataclass
class Table:
    """Columns of one length: numbers (float64, NaN is unknown; int64; bool) or words (objects; None is unknown)."""

    columns: dict[str, numpy.ndarray]
    units: dict[str, str] = dataclasses.field(default_factory=dict)
    not_columns: dict[str, str] = dataclasses.field(default_factory=dict)  # a name, and what stands there instead
    notes: list[str] = dataclasses.field(default_factory=list)  # a sentence each: damage that was read around

    def __post_init__(self) -> None:
        longest = max(self.columns, key=lambda name: len(self.columns[name]), default="")
        for name, column in self.columns.items():
            if len(column) != len(self.columns[longest]):
                raise BadFile(f"{longest} has {len(self.columns[longest])} values and {name} has {len(column)}; save only columns of one "
                              "length, or put them into a struct flight")

    def __getitem__(self, name: str) -> numpy.ndarray:
        return self.columns[name]

    def __len__(self) -> int:
        """The number of rows."""
        return len(next(iter(self.columns.values()), ()))


def column_of(values: Iterable[Any]) -> numpy.ndarray | str:
    """Of anything that a cell may hold; what it is instead, where that is no column."""
    cells = [None if value == "" else value for value in values]
    known = [value for value in cells if value is not None]
    if all(isinstance(value, bool) for value in known) and len(known) == len(cells) and cells:
        return numpy.array(cells, bool)
    if all(isinstance(value, int) and abs(value) < 2**63 for value in known) and len(known) == len(cells) and cells:
        return numpy.array(cells, numpy.int64)
    if all(isinstance(value, (bool, int, float)) for value in known):
        return numpy.array([numpy.nan if value is None else float(value) for value in cells])
    if all(isinstance(value, (bool, int, float, str)) for value in known):
        return words(None if value is None else str(value) for value in cells)
    if any(isinstance(value, (datetime.date, datetime.time, datetime.timedelta)) for value in known):
        return "times or dates"
    return "neither numbers nor texts"


def words(texts: Iterable[str | None]) -> numpy.ndarray:
    listed = list(texts)
    column = numpy.empty(len(listed), object)
    column[:] = listed
    return column


def table_of_rows(header: list[Any], rows: Iterable[Iterable[Any]]) -> Table:
    """Of a sheet, by its first row."""
    names = ["" if name is None else str(name).strip() for name in header]
    named = [name for name in names if name]
    if len(set(named)) != len(named):
        raise BadFile(f"two of its columns are called {next(name for name in named if named.count(name) > 1)}")
    filled = (list(row)[:len(names)] for row in rows)
    cells = list(zip(*(row + [None] * (len(names) - len(row)) for row in filled))) or [() for _ in names]
    table = Table({})
    for name, values in zip(names, cells):
        column = column_of(values)
        if not name:
            continue
        if isinstance(column, str):
            table.not_columns[name] = column
        else:
            table.columns[name] = column
    return table


def read_csv(stream: BinaryIO) -> Table:
    """A CSV file whose cells are numbers where all of a column are."""
    try:
        text = stream.read().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadFile(f"is not text in UTF-8: byte {error.start + 1}") from None
    lines = (line for line in text.splitlines() if line.strip(" ,") and not line.startswith("#"))
    rows = csv.reader(lines, skipinitialspace=True)
    header = next(rows, [])
    return table_of_rows(list(header), ([_cell(cell) for cell in row] for row in rows))


def _cell(text: str) -> Any:
    text = text.strip()
    for kind in (int, float):
        try:
            return kind(text) if "_" not in text else text
        except ValueError:
            pass
    return text


def csv_lines(table: Table) -> Iterator[str]:
    """A header, then a row each: the shortest digits that give a number again, nothing where it is not known."""
    yield ",".join(map(_quoted, table.columns))
    for row in zip(*(_cells(column) for column in table.columns.values())):
        yield ",".join(row)


def _cells(column: numpy.ndarray) -> Iterator[str]:
    if column.dtype == object:
        return ("" if text is None else _quoted(str(text)) for text in column)
    if column.dtype.kind == "f":
        return ("" if value != value else repr(value).removesuffix(".0") for value in column.astype(float).tolist())
    return (str(int(value)) for value in column.tolist())


def _quoted(text: str) -> str:
    text = " ".join(text.splitlines())
    return '"' + text.replace('"', '""') + '"' if any(sign in text for sign in ',"') else text


def write_csv(table: Table) -> bytes:
    out = io.StringIO()
    out.writelines(line + "\n" for line in csv_lines(table))
    return out.getvalue().encode()
