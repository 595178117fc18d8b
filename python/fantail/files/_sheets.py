# SPDX-License-Identifier: MIT
"""Excel workbooks by openpyxl, HDF5 of pandas and others by h5py, CSV packed with gzip, JSON."""
from __future__ import annotations

import gzip
import io
import json
import zlib
from typing import Any, BinaryIO

from ._errors import BadFile
from ._table import Table, read_csv, table_of_rows, words


def read_xlsx(stream: BinaryIO) -> Table:
    """The first sheet, whose first row has the names. A formula has the value from when the file was saved."""
    import openpyxl
    try:
        rows = openpyxl.load_workbook(stream, read_only=True, data_only=True).worksheets[0].iter_rows(values_only=True)
        listed = [list(row) for row in rows if any(cell is not None for cell in row)]
    except Exception as error:  # a workbook is a ZIP archive of XML: of a damaged one that may be anything
        raise BadFile(f"is not an Excel workbook, or is damaged: {' '.join(str(error).split())[:200] or type(error).__name__}") from None
    if not listed:
        raise BadFile("its first sheet is empty")
    return table_of_rows(listed[0], listed[1:])


def write_xlsx(table: Table) -> bytes:
    import openpyxl
    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("table")
    sheet.append(list(table.columns))
    for row in zip(*(column.tolist() for column in table.columns.values())):
        sheet.append([value if value == value else None for value in row])
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def read_gzip(stream: BinaryIO) -> Table:
    """A compressed CSV file."""
    try:
        return read_csv(io.BytesIO(gzip.GzipFile(fileobj=stream).read()))
    except (OSError, EOFError, zlib.error) as error:
        raise BadFile(f"is not a gzip file, or is damaged: {error}") from None


def read_hdf5(stream: BinaryIO) -> Table:
    """The vectors of one group, or what DataFrame.to_hdf writes by default. Nothing in it is unpickled."""
    import h5py
    try:
        with h5py.File(stream, "r") as file:
            groups: list[Any] = []
            file.visititems(lambda _, item: groups.append(item) if isinstance(item, h5py.Group) else None)
            tables = [table for table in map(_of_group, [file, *groups]) if table.columns]
    except (OSError, RuntimeError, KeyError, TypeError) as error:
        raise BadFile(f"is not an HDF5 file, or is damaged: {' '.join(str(error).split())[:200]}") from None
    if len(tables) != 1:
        raise BadFile("has no columns: no group with vectors" if not tables else "has columns in more than one group; keep one")
    return tables[0]


def _of_group(group: Any) -> Table:
    import h5py
    if "axis0" in group and "block0_items" in group:
        return _of_pandas(group)
    table = Table({})
    sets = {name: item for name, item in group.items() if isinstance(item, h5py.Dataset)}
    for name, item in sets.items():
        if item.ndim == 1 and item.dtype.kind in "biuf":
            table.columns[name] = item[()]
        elif item.ndim == 1 and h5py.check_string_dtype(item.dtype):
            table.columns[name] = words(item.asstr()[()])
        else:
            table.not_columns[name] = f"HDF5 of the shape {item.shape}"
    return Table(table.columns, not_columns=table.not_columns)


def _of_pandas(group: Any) -> Table:
    found: dict[str, Any] = {}
    table = Table({})
    for block in range(sum(name.endswith("_items") for name in group)):
        names = [name.decode() if isinstance(name, bytes) else str(name) for name in group[f"block{block}_items"][()]]
        values = group[f"block{block}_values"]
        for i, name in enumerate(names):
            if values.ndim == 2 and values.dtype.kind in "biuf" and "value_type" not in values.attrs:
                found[name] = values[:, i]
            else:
                table.not_columns[name] = "an object that only pandas reads, or times"
    names = [name.decode() if isinstance(name, bytes) else str(name) for name in group["axis0"][()]]
    return Table({name: found[name] for name in names if name in found}, not_columns=table.not_columns)


def write_json(table: Table) -> bytes:
    """A list for each column, all of one length; null is unknown."""
    columns = {name: [None if value != value else value for value in column.tolist()] for name, column in table.columns.items()}
    return (json.dumps(columns, ensure_ascii=False, separators=(",", ":")) + "\n").encode()


