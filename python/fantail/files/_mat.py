# SPDX-License-Identifier: MIT
"""MAT-files: version 4, 5 (-v6, -v7) by SciPy and 7.3 (HDF5) by h5py; and which of their variables make a table."""
from __future__ import annotations

import dataclasses
import io
import struct
import warnings
import zlib
from typing import Any, BinaryIO, Union

import numpy

from ._errors import BadFile
from ._table import Table, words


@dataclasses.dataclass
class Other:
    """A value from which no column can be made: a single value, or a matrix of texts."""

    kind: str
    empty: bool = False


@dataclasses.dataclass
class Texts:
    """A matrix of characters or a cell of texts: one text a row."""

    lines: list[str]


Variable = Union[numpy.ndarray, Texts, Other, "dict[str, Any]"]


def read_mat(stream: BinaryIO) -> Table:
    beginning = stream.read(128)
    stream.seek(0)
    if not beginning:
        raise BadFile("it is empty")
    if beginning.startswith(b"MATLAB 7.3 MAT-file") or beginning.startswith(b"\x89HDF"):
        return table_of(_hdf5_variables(stream))
    if beginning.startswith((b"# Created by Octave", b"Octave-1-")):
        raise BadFile("it is in Octave's own format; save it with -v7")
    if not beginning.startswith(b"MATLAB 5.0"):
        raise BadFile("it is not a MAT-file of version 5 or 7.3, which save -v7, -v6 and -v7.3 write")
    _expect_whole(stream)
    return table_of(_scipy_variables(stream))


def _expect_whole(stream: BinaryIO) -> None:
    """SciPy reads only part of a packed variable, and so misses its checksum."""
    file = stream.read()
    stream.seek(0)
    order = "<" if file[126:128] == b"IM" else ">"
    at = 128
    while at < len(file):
        if at + 8 > len(file):
            raise BadFile("it ends within a variable")
        kind, size = struct.unpack_from(order + "II", file, at)
        at += 8
        if kind not in (14, 15):
            raise BadFile(f"it has an element of type {kind} in place of a variable")
        if at + size > len(file):
            raise BadFile("it ends within a variable")
        if kind == 15:
            packed = zlib.decompressobj()
            rest = file[at:at + size]
            try:
                while rest:  # piece by piece: what unpacks to more than there is memory is never whole in it
                    packed.decompress(rest, 1 << 24)
                    rest = packed.unconsumed_tail
            except zlib.error:
                raise BadFile("a packed variable is damaged") from None
            if not packed.eof:
                raise BadFile("a packed variable is damaged")
        at += size


def _scipy_variables(stream: BinaryIO) -> dict[str, Variable]:
    import scipy.io
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            names = [name for name, _, _ in scipy.io.whosmat(stream)]
            stream.seek(0)
            read = scipy.io.loadmat(stream)
    except Exception as error:  # SciPy raises what its parts do: of a damaged file that may be anything
        twice = "Duplicate variable name" in str(error)
        raise BadFile(f"has two variables with the same name: {_short(error)}" if twice else f"is damaged: {_short(error)}") from None
    for name in names:
        if names.count(name) > 1:
            raise BadFile(f"has two variables with the name {name}")
    return {name: _of_scipy(value) for name, value in read.items() if not name.startswith("__")}


def _short(error: Exception) -> str:
    return " ".join(str(error).split())[:200] or type(error).__name__


def _of_scipy(value: Any) -> Variable:
    from scipy.io import matlab
    if isinstance(value, (matlab.MatlabFunction, matlab.MatlabObject, matlab.MatlabOpaque)):
        return Other("an object or a function")
    if not isinstance(value, numpy.ndarray):
        return Other("a sparse matrix")
    if value.dtype.names is not None:
        if value.size != 1:
            return Other("an array of structs", empty=value.size == 0)
        return {name: _of_scipy(value.flat[0][name]) for name in value.dtype.names}
    if value.dtype == object:
        return _cell(value.shape, [_of_scipy(element) for element in value.flat])
    if value.dtype.kind == "U":
        return Texts([str(line).rstrip(" ") for line in value.flat])
    return _numbers(value)


def _cell(shape: tuple[int, ...], elements: list[Variable]) -> Variable:
    if 1 not in shape[:2]:
        return Other(f"a cell of {_size(shape)}", empty=0 in shape)
    lines = []
    for element in elements:
        empty = isinstance(element, (Other, numpy.ndarray)) and _is_empty(element)
        if not empty and not (isinstance(element, Texts) and len(element.lines) <= 1):
            return Other("a cell with something else than texts")
        lines.append("" if empty else "".join(element.lines))  # type: ignore[union-attr]
    return Texts(lines)


def _numbers(value: numpy.ndarray) -> Variable:
    if value.dtype.kind == "c":
        return Other("complex numbers")
    if value.dtype.kind not in "biuf":
        return Other("neither numbers nor texts")
    if value.size > 1 and max(value.shape) != value.size:
        return Other(f"a matrix of {_size(value.shape)}")
    return value.reshape(-1).astype(float)


def _size(shape: tuple[int, ...]) -> str:
    return f"{shape[0]} x {int(numpy.prod(shape[1:]))}"


def _hdf5_variables(stream: BinaryIO) -> dict[str, Variable]:
    import h5py
    try:
        with h5py.File(stream, "r") as file:
            return {name: _of_hdf5(h5py, file, value) for name, value in file.items() if not name.startswith("#")}
    except (OSError, RuntimeError, KeyError, ValueError, TypeError) as error:
        raise BadFile(f"is damaged: {_short(error)}") from None


def _of_hdf5(h5py: Any, file: Any, value: Any) -> Variable:
    """MATLAB stores arrays transposed, with their class in an attribute, and only the size of an empty one."""
    kind = value.attrs.get("MATLAB_class", b"").decode()
    if isinstance(value, h5py.Group):
        return Other("a sparse matrix") if "MATLAB_sparse" in value.attrs else {name: _of_hdf5(h5py, file, value[name]) for name in value}
    if value.attrs.get("MATLAB_empty", 0):
        return numpy.empty(0)
    if "MATLAB_object_decode" in value.attrs and kind not in ("char", "logical"):
        return Other("an object or a function")
    content = numpy.asarray(value[()]).T
    if kind == "char":
        return Texts(["".join(map(chr, row)).rstrip(" ") for row in numpy.atleast_2d(content)])
    if value.dtype == h5py.ref_dtype:
        if kind != "cell":
            return Other("an array of structs")
        return _cell(content.shape, [_of_hdf5(h5py, file, file[reference]) for reference in content.reshape(-1, order="F")])
    return Other("complex numbers") if content.dtype.names else _numbers(content)


def _is_empty(value: Variable) -> bool:
    return value.empty if isinstance(value, Other) else isinstance(value, numpy.ndarray) and value.size == 0


def _columns(variables: dict[str, Variable], rows: int) -> dict[str, numpy.ndarray]:
    """Those with at least so many rows."""
    found = {}
    for name, value in variables.items():
        if isinstance(value, numpy.ndarray) and len(value) >= rows:
            found[name] = value
        elif isinstance(value, Texts) and len(value.lines) >= rows:
            found[name] = words(value.lines)
    return found


def table_of(variables: dict[str, Variable]) -> Table:
    """The members of the struct `flight`, or of the only struct that has columns, or the variables. In `flight` a column
    may have a single value, where it has nothing longer. A struct `words` has texts for numbers that are places in them,
    from 1 on; a struct `units` has a text for each column."""
    place = _place(variables)
    columns = _columns(place, 2)
    if not columns and place is variables.get("flight"):
        columns = _columns(place, 1)
    if not columns:
        raise BadFile("has no columns: neither vectors nor a struct of vectors")
    table = Table(columns)
    table.not_columns = {name: _kind(value) for name, value in place.items() if name not in columns and not _is_empty(value)}
    units, lists = variables.get("units"), variables.get("words")
    if isinstance(units, dict):
        table.units = {name: unit.lines[0] for name, unit in units.items() if isinstance(unit, Texts) and len(unit.lines) == 1}
    if isinstance(lists, dict):
        for name in columns.keys() & lists.keys():
            columns[name] = _placed(name, columns[name], lists[name])
    return table


def _place(variables: dict[str, Variable]) -> dict[str, Variable]:
    flight = variables.get("flight")
    if isinstance(flight, dict):
        return flight
    places = [("variables", variables)] if _columns(variables, 2) else []
    places += [(f"the struct {name}", value) for name, value in variables.items()
               if isinstance(value, dict) and name != "words" and _columns(value, 2)]
    if len(places) > 1:
        raise BadFile(f"has columns in more than one place: {', '.join(name for name, _ in places)}; keep one, or name the struct "
                      "of the flight 'flight'")
    return places[0][1] if places else variables


def _kind(value: Variable) -> str:
    if isinstance(value, Other):
        return value.kind
    return "a struct" if isinstance(value, dict) else "a single value"


def _placed(name: str, column: numpy.ndarray, texts: Variable) -> numpy.ndarray:
    if not isinstance(texts, Texts) or column.dtype == object:
        raise BadFile(f"words.{name} is not a list of texts for the numbers of {name}")
    lines: list[str | None] = [None, *texts.lines]
    for value in column:
        if value == value and not (1 <= value < len(lines) and value == int(value)):
            raise BadFile(f"{name} has the value {value:g}, and words.{name} has {len(texts.lines)} texts")
    return words(lines[0 if value != value else int(value)] for value in column)


def write_mat(table: Table) -> bytes:
    """The structs `flight` and `units`, which table_of() reads."""
    import scipy.io
    out = io.BytesIO()
    known = {name: words(text or "" for text in column) if column.dtype == object else column for name, column in table.columns.items()}
    flight = {name: column.reshape(-1, 1) for name, column in known.items()}
    scipy.io.savemat(out, {"flight": flight, "units": table.units}, do_compression=True, long_field_names=True)
    return out.getvalue()
