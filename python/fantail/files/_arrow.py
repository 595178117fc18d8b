# SPDX-License-Identifier: MIT
"""Parquet and Feather, by pyarrow."""
from __future__ import annotations

import io
import json
from typing import Any, BinaryIO

import numpy

from ._errors import BadFile
from ._table import Table, words


def read_parquet(stream: BinaryIO) -> Table:
    import pyarrow
    import pyarrow.parquet
    try:
        file = pyarrow.parquet.ParquetFile(stream, page_checksum_verification=True)
        read = file.read()
    except (pyarrow.ArrowException, OSError, ValueError) as error:
        raise BadFile(_why(stream, b"PAR1", "Parquet file", error)) from None
    if len(read) != file.metadata.num_rows:
        raise BadFile(f"is damaged: it has {len(read)} rows, but its description states {file.metadata.num_rows}")
    table = _table(read)
    _expect_described(read.schema, table)
    return table


def read_feather(stream: BinaryIO) -> Table:
    import pyarrow
    import pyarrow.feather
    try:
        return _table(pyarrow.feather.read_table(stream))
    except (pyarrow.ArrowException, OSError, ValueError) as error:
        raise BadFile(_why(stream, b"ARROW1", "Feather file", error)) from None


def _why(stream: BinaryIO, beginning: bytes, kind: str, error: Exception) -> str:
    stream.seek(0)
    if stream.read(len(beginning)) != beginning:
        return f"is not a {kind}"
    return f"is damaged: {' '.join(str(error).split())[:200]}"


def _expect_described(schema: Any, table: Table) -> None:
    """Compares the columns of a file that Fantail wrote with its description, to find a damaged name or type."""
    said = (schema.metadata or {}).get(b"fantail")
    if said is None:
        return
    try:
        listed = list(json.loads(said)["columns"])
    except (ValueError, KeyError, TypeError):
        raise BadFile("is damaged: its description cannot be read") from None
    if listed != list(table.columns):
        raise BadFile("is damaged: its columns differ from its description")


def _table(read: Any) -> Table:
    import pyarrow
    types = pyarrow.types
    if len(set(read.column_names)) != len(read.column_names):
        raise BadFile("two of its columns have the same name")
    table = Table({})
    for name, column in zip(read.column_names, read.columns):
        kind = column.type
        if types.is_dictionary(kind):
            kind = kind.value_type
            column = column.cast(kind)
        if types.is_boolean(kind) or types.is_integer(kind) or types.is_floating(kind):
            if column.null_count:
                column = column.cast(pyarrow.float64(), safe=False)
            table.columns[name] = numpy.asarray(column.to_numpy())
        elif types.is_string(kind) or types.is_large_string(kind) or types.is_string_view(kind) or types.is_null(kind):
            table.columns[name] = words(column.to_pylist())
        elif types.is_temporal(kind) or types.is_decimal(kind):
            table.not_columns[name] = "times, dates or decimal fractions"
        else:
            table.not_columns[name] = "columns within a column" if types.is_nested(kind) else "neither numbers nor flags nor texts"
    return table


def arrow_table(table: Table) -> Any:
    """Unknown values become null."""
    import pyarrow
    return pyarrow.table([pyarrow.array(column, from_pandas=True) for column in table.columns.values()], names=list(table.columns))


def parquet_of(table: Any, about: dict[str, Any] | None) -> bytes:
    """`about` stands under the key "fantail" of the file's metadata."""
    import pyarrow.parquet
    metadata = None if about is None else {"fantail": json.dumps(about, ensure_ascii=False, separators=(",", ":"))}
    out = io.BytesIO()
    pyarrow.parquet.write_table(table.replace_schema_metadata(metadata), out, compression="gzip", write_page_checksum=True)
    return out.getvalue()


def write_parquet(table: Table) -> bytes:
    return parquet_of(arrow_table(table), None)


def write_feather(table: Table) -> bytes:
    import pyarrow.feather
    out = io.BytesIO()
    pyarrow.feather.write_feather(arrow_table(table), out)
    return out.getvalue()
