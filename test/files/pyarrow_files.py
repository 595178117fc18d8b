# SPDX-License-Identifier: MIT
"""Made the Parquet files of this folder, with pyarrow 26.0.1: python3 pyarrow_files.py"""
import pyarrow
import pyarrow.parquet

TABLE = pyarrow.table([
    pyarrow.array([0.25 * i for i in range(5)], pyarrow.float64()),
    pyarrow.array([1.5, None, -2.5, None, None], pyarrow.float32()),
    pyarrow.array([1, 2, 4294967295, None, 0], pyarrow.uint32()),
    pyarrow.array([-1, 2, None, 9007199254740992, 0], pyarrow.int64()),
    pyarrow.array([True, None, False, True, True], pyarrow.bool_()),
    pyarrow.array(["armed", "launched", None, "launched", "armed"], pyarrow.string()),
], schema=pyarrow.schema([
    pyarrow.field("time_s", pyarrow.float64(), nullable=False), ("single", pyarrow.float32()),
    ("unsigned", pyarrow.uint32()), ("long", pyarrow.int64()), ("flag", pyarrow.bool_()),
    ("phase", pyarrow.string())]))
pyarrow.parquet.write_table(TABLE, "pyarrow_plain.parquet", compression="gzip", use_dictionary=False, row_group_size=3)
pyarrow.parquet.write_table(TABLE, "pyarrow_snappy.parquet", compression="snappy", use_dictionary=False)
pyarrow.parquet.write_table(TABLE, "pyarrow_dictionary.parquet", compression="none")
