# SPDX-License-Identifier: MIT
import fantail
import numpy
from fantail import files


def test_files_of_other_programs_are_read_by_the_package_and_by_what_it_calls(program, flown, tmp_path):
    said = program.run("log", "export", flown, "--to", "mat", "--out", tmp_path / "flight.mat", cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    table = files.read(tmp_path / "flight.mat")
    files.write(tmp_path / "flight.parquet", table)
    again = fantail.read_flight(tmp_path / "flight.parquet")
    assert numpy.allclose(again["roll_angle_deg"], table["roll_angle_deg"], rtol=1e-12, equal_nan=True)  # radians and back
