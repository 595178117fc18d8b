# SPDX-License-Identifier: MIT
"""Files of other programs as columns, and columns as files, with the packages for each kind (fantail[files]).

>>> from fantail import files
>>> table = files.read("log.parquet")      # .mat .parquet .feather .xlsx .h5 .hdf5 .csv.gz .csv .mcap .ulg ...
>>> table["time_s"], table.units           # numpy; the units that the file states
>>> files.write("log.mat", table)          # .mat .parquet .feather .xlsx .mcap .json .csv

A file of another kind raises BadFile, a ValueError. A package is imported when a kind of file needs it; a missing one raises an
ImportError. The programs of Fantail run this folder by itself (__main__.py), so nothing in it needs the rest of the package.
"""
from __future__ import annotations

import importlib
import os
import pathlib
import tempfile
from typing import TYPE_CHECKING, Any, BinaryIO, Callable, Union

from ._errors import BadFile

if TYPE_CHECKING:
    from ._table import Table

__all__ = ["BadFile", "READERS", "Table", "WRITERS", "read", "read_stream", "write", "written"]

# By the end of a file's name: a module of this folder and a function in it.
READERS = {".mat": "_mat.read_mat", ".parquet": "_arrow.read_parquet", ".feather": "_arrow.read_feather", ".xlsx": "_sheets.read_xlsx",
           ".h5": "_sheets.read_hdf5", ".hdf5": "_sheets.read_hdf5", ".gz": "_sheets.read_gzip", ".mcap": "_mcap.read_mcap",
           ".ulg": "_ulog.read_ulog", ".bin": "_drones.read_dataflash", ".bbl": "_drones.read_blackbox", ".bfl": "_drones.read_blackbox",
           ".eeprom": "_altos.read_eeprom", ".telem": "_altos.read_telem", ".csv": "_table.read_csv"}
WRITERS = {".mat": "_mat.write_mat", ".parquet": "_arrow.write_parquet", ".feather": "_arrow.write_feather", ".xlsx": "_sheets.write_xlsx",
           ".mcap": "_mcap.write_mcap", ".json": "_sheets.write_json", ".csv": "_table.write_csv"}


def __getattr__(name: str) -> Any:
    """Table is imported when it is used: it needs numpy, which other parts do not need."""
    if name == "Table":
        return importlib.import_module(f"{__name__}._table").Table
    raise AttributeError(name)


def _function(place: str) -> Callable[..., Any]:
    module, _, name = place.partition(".")
    return getattr(importlib.import_module(f"{__name__}.{module}"), name)


def read_stream(stream: BinaryIO, ending: str) -> Table:
    """`stream` must be seekable."""
    ending = ending.lower()
    if ending not in READERS:
        raise BadFile(f"files that end in {ending} are not read; allowed: {' '.join(READERS)}")
    table: Table = _function(READERS[ending])(stream)
    if not table.columns:
        raise BadFile("has no columns")
    return table


def read(path: Union[str, os.PathLike[str]]) -> Table:
    with open(path, "rb") as stream:
        return read_stream(stream, pathlib.Path(path).suffix)


def written(table: Table, ending: str) -> bytes:
    if ending not in WRITERS:
        raise BadFile(f"files that end in {ending} are not written; allowed: {' '.join(WRITERS)}")
    return _function(WRITERS[ending])(table)


def write(path: Union[str, os.PathLike[str]], table: Table) -> None:
    """Writes the whole file or none."""
    target = pathlib.Path(path)
    content = written(table, target.suffix)
    with tempfile.NamedTemporaryFile(dir=target.parent, prefix=target.name, delete=False) as part:
        try:
            part.write(content)
            part.close()
            os.chmod(part.name, 0o666 & ~_umask())
            os.replace(part.name, target)
        except BaseException:
            os.unlink(part.name)
            raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
