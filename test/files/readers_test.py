# SPDX-License-Identifier: MIT
"""What each reader makes of files that others wrote, and of what it is not for."""
import datetime
import gzip
import json

import h5py
import numpy
import pandas
import pyarrow
import pyarrow.parquet
import pytest
from conftest import HERE, read_bytes, rows_of
from fantail_files import files

UNKNOWN = ""


@pytest.mark.parametrize("name", ["pyarrow_plain", "pyarrow_snappy", "pyarrow_dictionary"])
def test_parquet_of_pyarrow_is_read_however_it_is_packed(name):
    assert rows_of(files.read(HERE / f"{name}.parquet")) == [
        ["time_s", "single", "unsigned", "long", "flag", "phase"],
        ["0", "1.5", "1", "-1", "1", "armed"],
        ["0.25", UNKNOWN, "2", "2", UNKNOWN, "launched"],
        ["0.5", "-2.5", "4294967295", UNKNOWN, "0", UNKNOWN],
        ["0.75", UNKNOWN, UNKNOWN, "9007199254740992", "1", "launched"],
        ["1", UNKNOWN, "0", "0", "1", "armed"]]


# Written by GNU Octave 7.3 from the same columns in several classes, packed and not (octave_files.m).
@pytest.mark.parametrize("name", ["octave_v6", "octave_v7"])
def test_mat_of_octave_is_read_packed_and_not(name):
    table = files.read(HERE / f"{name}.mat")
    assert rows_of(table) == [["time_s", "row", "logical", "int8", "single", "phase", "status"],
                              ["0", "1.5", "1", "-7", "0.5", "armed", "ok"],
                              ["0.25", "-2.5", "0", "0", "1.5", "launched", "error"],
                              ["0.5", "1e-300", "1", "127", "2.5", "launched", "ok"]]
    assert table.not_columns == {"mass_kg": "a single value", "matrix": "a matrix of 3 x 3", "impedance": "complex numbers",
                                 "made_by": "a single value"}


@pytest.fixture
def frame():
    return pandas.DataFrame({"time_s": [0.0, 0.25, 0.5], "roll_angle_deg": [1.5, numpy.nan, -2.5], "count": [1, 2, 3],
                             "flag": [True, False, True], "phase": ["armed", "launched", "launched"]})


WANTED = [["time_s", "roll_angle_deg", "count", "flag", "phase"], ["0", "1.5", "1", "1", "armed"],
          ["0.25", UNKNOWN, "2", "0", "launched"], ["0.5", "-2.5", "3", "1", "launched"]]


@pytest.mark.parametrize("ending", [".parquet", ".feather", ".xlsx"])
def test_what_pandas_writes_by_default_is_read(frame, tmp_path, ending):
    path = tmp_path / f"log{ending}"
    writer = {".parquet": frame.to_parquet, ".feather": frame.to_feather, ".xlsx": frame.to_excel}[ending]
    writer(path, **({"index": False} if ending == ".xlsx" else {}))
    assert rows_of(files.read(path)) == WANTED


def test_csv_packed_with_gzip_is_read(frame, tmp_path):
    frame.to_csv(tmp_path / "log.csv.gz", index=False)
    rows = rows_of(files.read(tmp_path / "log.csv.gz"))
    assert [row[:3] + row[4:] for row in rows] == [row[:3] + row[4:] for row in WANTED]
    assert [row[3] for row in rows] == ["flag", "True", "False", "True"]


def test_hdf5_of_vectors_and_as_pandas_lays_it_out_is_read(tmp_path):
    with h5py.File(tmp_path / "plain.h5", "w") as file:
        file["flight/time_s"] = [0.0, 0.5]
        file["flight/phase"] = ["armed", "launched"]
        file["flight/matrix"] = numpy.eye(2)
    table = files.read(tmp_path / "plain.h5")
    assert rows_of(table) == [["phase", "time_s"], ["armed", "0"], ["launched", "0.5"]]
    assert list(table.not_columns) == ["matrix"]
    with h5py.File(tmp_path / "pandas.h5", "w") as file:  # DataFrame.to_hdf, fixed format
        file["log/axis0"] = [b"time_s", b"phase", b"count"]
        file["log/axis1"] = [0, 1]
        file["log/block0_items"], file["log/block0_values"] = [b"time_s"], [[0.0], [0.5]]
        file["log/block1_items"], file["log/block1_values"] = [b"count"], [[3], [4]]
        file["log/block2_items"] = [b"phase"]
        file["log"].create_dataset("block2_values", (1,), h5py.vlen_dtype(numpy.uint8))  # pickled
    table = files.read(tmp_path / "pandas.h5")
    assert rows_of(table) == [["time_s", "count"], ["0", "3"], ["0.5", "4"]]
    assert list(table.not_columns) == ["phase"]


def test_mat_of_version_7_3_is_read(tmp_path):
    path = tmp_path / "flown.mat"
    with h5py.File(path, "w", userblock_size=512) as file:  # as MATLAB lays it out: turned, with a class for each
        def put(name, values, kind, **more):
            item = file.create_dataset(name, data=values)
            item.attrs["MATLAB_class"] = numpy.bytes_(kind)
            item.attrs.update(more)
            return item

        put("flight/time_s", [[0.0, 0.5]], "double")
        put("flight/armed", numpy.array([[1, 0]], numpy.uint8), "logical", MATLAB_int_decode=1)
        put("flight/status", numpy.array([[111, 102], [107, 102]], numpy.uint16), "char", MATLAB_int_decode=2)  # ["ok"; "ff"]
        texts = [put(f"#refs#/{i}", [[ord(sign)] for sign in text], "char").ref for i, text in enumerate(["armed", "launched"])]
        put("flight/phase", numpy.array([texts], h5py.ref_dtype), "cell")
        put("flight/matrix", numpy.eye(2), "double")
        put("flight/none", numpy.array([0, 0], numpy.uint64), "double", MATLAB_empty=1)
        put("units/time_s", [[ord("s")]], "char")
        file["flight"].attrs["MATLAB_class"] = file["units"].attrs["MATLAB_class"] = numpy.bytes_("struct")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(512))
    table = files.read(path)
    assert rows_of(table) == [["armed", "phase", "status", "time_s"], ["1", "armed", "ok", "0"], ["0", "launched", "ff", "0.5"]]
    assert (table.units, table.not_columns) == ({"time_s": "s"}, {"matrix": "a matrix of 2 x 2"})


def test_columns_that_are_no_numbers_are_named_with_what_they_are(tmp_path):
    time = pyarrow.array([datetime.datetime(2026, 1, 1)])
    pyarrow.parquet.write_table(pyarrow.table({"time_s": [0.0], "when": time, "parts": [[1, 2]], "raw": [b"\1"]}), tmp_path / "a.parquet")
    table = files.read(tmp_path / "a.parquet")
    assert list(table.columns) == ["time_s"]
    assert table.not_columns == {"when": "times, dates or decimal fractions", "parts": "columns within a column",
                                 "raw": "neither numbers nor flags nor texts"}


@pytest.mark.parametrize("ending", [".parquet", ".feather", ".xlsx", ".mat", ".mcap"])
def test_what_is_written_is_read_again(table, ending):
    again = read_bytes(files.written(table, ending), ending)
    assert list(again.columns) == list(table.columns)
    assert rows_of(again) == rows_of(table)


def test_json_has_a_list_for_each_column(table):
    assert json.loads(files.written(table, ".json")) == {
        "time_s": [0.0, 0.001, 0.002, 0.003], "roll_rate_deg_s": [1e-300, None, -0.1, 1.0 / 3.0], "sequence": [0, 4294967295, 2, -7],
        "saturated": [True, False, False, True], "phase": ["armed", "launched", None, "launched"]}


@pytest.mark.parametrize("ending", [ending for ending in files.READERS if ending != ".csv"])
@pytest.mark.parametrize("content", [b"", b"time_s,roll_angle_deg\n0,1\n", b"PAR1", b"MATLAB 5.0 MAT-file", bytes(4096)])
def test_another_file_is_refused_by_every_reader(ending, content):
    with pytest.raises(files.BadFile):
        read_bytes(content, ending)


def test_a_damaged_gzip_file_is_refused():
    packed = gzip.compress(b"time_s,a\n" + b"0,1\n" * 1000)
    assert len(read_bytes(packed, ".gz")) == 1000
    for content in (packed[:-9], packed[:20] + b"xx" + packed[22:]):
        with pytest.raises(files.BadFile, match="gzip"):
            read_bytes(content, ".gz")
