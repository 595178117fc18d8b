# SPDX-License-Identifier: MIT
"""Which variables of a MAT-file make a table."""
import io

import numpy
import pytest
import scipy.io
import scipy.sparse
from conftest import read_bytes, rows_of
from fantail_files import files

TIME = numpy.array([[0.0], [0.1]])


def saved(**variables):
    out = io.BytesIO()
    scipy.io.savemat(out, variables)
    return out.getvalue()


def read(**variables):
    return read_bytes(saved(**variables), ".mat")


def texts(*lines):
    cell = numpy.empty((len(lines), 1), object)
    cell[:, 0] = lines
    return cell


def test_the_variables_or_the_only_struct_with_columns_are_taken():
    assert list(read(time_s=TIME, mass_kg=12.5, note="a note").columns) == ["time_s"], "single values are no columns"
    assert rows_of(read(mass_kg=12.5, data={"time_s": TIME, "name": "dart"})) == [["time_s"], ["0"], ["0.1"]]
    assert list(read(speed=TIME, flight={"time_s": TIME}).columns) == ["time_s"], "what is called flight comes first"
    with pytest.raises(files.BadFile, match="more than one place: variables, the struct data"):
        read(time_s=TIME, data={"time_s": TIME})


def test_a_cell_of_texts_has_words():
    assert rows_of(read(time_s=numpy.arange(3.0), phase=texts("armed", "", "armed")))[1:] == [["0", "armed"], ["1", ""], ["2", "armed"]]


def test_words_are_places_in_a_list():
    two = texts("armed", "launched")
    assert [row[1] for row in rows_of(read(time_s=TIME, phase=[[1], [numpy.nan]], words={"phase": two}))] == ["phase", "armed", ""]
    with pytest.raises(files.BadFile, match="phase has the value 3, and words.phase has 2 texts"):
        read(time_s=TIME, phase=[[1], [3]], words={"phase": two})
    with pytest.raises(files.BadFile, match="the value 1.5"):
        read(time_s=TIME, phase=[[1], [1.5]], words={"phase": two})
    with pytest.raises(files.BadFile, match="words.phase is not a list"):
        read(time_s=TIME, phase=[[1], [2]], words={"phase": TIME})


def test_columns_that_make_no_table_are_refused():
    with pytest.raises(files.BadFile, match="gains has 3 values and time_s has 2"):
        read(gains=numpy.ones((3, 1)), time_s=TIME)
    with pytest.raises(files.BadFile, match="has no columns"):
        read(note="a note")


@pytest.mark.parametrize("value, kind", [
    (TIME * 1j, "complex numbers"), (scipy.sparse.csc_matrix(TIME), "a sparse matrix"), (1.0, "a single value"),
    (numpy.eye(2), "a matrix of 2 x 2"), (texts(TIME, TIME), "a cell with something else than texts"), ({"a": 1.0}, "a struct")])
def test_what_is_no_column_is_named_with_what_it_is(value, kind):
    assert read(time_s=TIME, angle=value).not_columns == {"angle": kind}
    assert read(flight={"time_s": TIME, "angle": value}).not_columns == {"angle": kind}
    assert read(time_s=TIME, angle=numpy.empty((0, 0))).not_columns == {}, "nothing is in it"


def test_two_variables_of_one_name_are_refused():
    content = saved(time_s=TIME)
    with pytest.raises(files.BadFile, match="has two variables with .*time_s"):
        read_bytes(content + content[128:], ".mat")


def test_one_row_in_flight_has_columns():
    assert rows_of(read(flight={"time_s": 1.0, "roll_angle_deg": 30.0})) == [["time_s", "roll_angle_deg"], ["1", "30"]]


def test_what_octave_saves_of_its_own_says_how_to_save_it():
    with pytest.raises(files.BadFile, match="-v7"):
        read_bytes(b"# Created by Octave 7.3.0\n# name: x\n", ".mat")
