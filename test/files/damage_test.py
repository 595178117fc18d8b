# SPDX-License-Identifier: MIT
"""A bit of every byte flipped and every byte cut off: a file is read as the table that it was, or refused."""
import os
import random

import pytest
from conftest import HERE, read_bytes, rows_of
from fantail_files import files
from files import _arrow


def of_fantail(table):
    """A Parquet file as fantail log export writes it: with a description of its columns."""
    return _arrow.parquet_of(_arrow.arrow_table(table), {"columns": {name: {"unit": "-"} for name in table.columns}})


def damaged(content):
    seed = int(os.environ.get("FANTAIL_SEED") or random.randrange(2**32))
    print(f"seed {seed}; the same again with FANTAIL_SEED={seed}")
    for bit in range(seed % 9, 8 * len(content), 9):  # of the next byte the next bit; nine seeds are every bit
        flipped = bytearray(content)
        flipped[bit // 8] ^= 1 << bit % 8
        yield bytes(flipped)
    for size in range(len(content)):
        yield content[:size]


@pytest.mark.parametrize("ending", [".parquet", ".mat", ".mcap"])
def test_no_damaged_file_is_read_as_another_table(table, ending):
    content = {".parquet": lambda: of_fantail(table), ".mat": lambda: (HERE / "octave_v7.mat").read_bytes(),
               ".mcap": lambda: files.written(table, ".mcap")}[ending]()
    wanted = rows_of(read_bytes(content, ending))
    refused = 0
    for trial in damaged(content):
        try:
            assert rows_of(read_bytes(trial, ending)) == wanted
        except files.BadFile:
            refused += 1
    assert refused > len(content)
