# SPDX-License-Identifier: MIT
"""The programs, and tables to write and to compare."""
import csv
import io
import pathlib

import numpy
import pytest
from fantail_files import files
from fantail_program import program  # noqa: F401  a fixture

HERE = pathlib.Path(__file__).parent


@pytest.fixture(scope="session")
def flown(program, tmp_path_factory):
    """The folder of a flight that the program has flown."""
    folder = tmp_path_factory.mktemp("flown") / "flight"
    said = program.run("fly", "tasha3_launch2", "--out", folder)
    assert said.returncode == 0, said.stderr
    return folder


@pytest.fixture
def table():
    """Every kind of column, with values that are not known."""
    phase = numpy.empty(4, object)
    phase[:] = ["armed", "launched", None, "launched"]
    return files.Table({"time_s": numpy.array([0.0, 0.001, 0.002, 0.003]),
                        "roll_rate_deg_s": numpy.array([1e-300, numpy.nan, -0.1, 1.0 / 3.0]),
                        "sequence": numpy.array([0, 4294967295, 2, -7]), "saturated": numpy.array([True, False, False, True]),
                        "phase": phase}, units={"time_s": "s"})


def rows_of(table):
    """As the programs get them."""
    return list(csv.reader(io.StringIO(files.written(table, ".csv").decode())))


def read_bytes(content, ending):
    return files.read_stream(io.BytesIO(content), ending)
