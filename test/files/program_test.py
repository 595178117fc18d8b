# SPDX-License-Identifier: MIT
"""Files of other programs through the verbs of Fantail."""
import json
import os
import pathlib
import signal
import subprocess
import time

import numpy
import pandas
import pytest
from conftest import HERE
from fantail_files import files

# What the tests look at: a sheet of every field is read and written for ten seconds.
FIELDS = ("time_s,time_us,phase,saturated,command_deg,canard_deg,roll_angle_deg,roll_rate_deg_s,speed_m_s,height_m,specific_force_m_s2,"
          "rate_x_count,replayed")
FLAT = ["--inertia", "0.004", "--area", "5e-5", "--elevation", "300", "--window", "0.9:8", "--json"]


@pytest.fixture(scope="session")
def exported(program, flown):
    """Every format of one flight, beside each other."""
    for format in ("csv", "mat", "parquet", "mcap", "json", "ulog"):
        said = program.run("log", "export", "flight", "--to", format, "--fields", FIELDS, cwd=flown.parent)
        assert said.returncode == 0, said.stderr
    return flown.parent / "out/export"


@pytest.fixture(scope="session")
def table(exported):
    return files.read(exported / "flight.parquet")


def model(program, path):
    said = program.run("identify", path, *FLAT, "--out", path.parent / "identified")
    assert said.returncode == 0, said.stderr
    found = json.loads(said.stdout)
    return [found["alpha_m2"], found["beta_m"]]


def test_identify_finds_the_same_in_every_kind_of_file(program, exported, table, tmp_path):
    wanted = model(program, exported / "flight.mat")
    assert model(program, exported / "flight.parquet") == wanted
    frame = pandas.DataFrame(table.columns)
    frame.to_csv(tmp_path / "a.csv.gz", index=False)
    frame.to_excel(tmp_path / "a.xlsx", index=False)
    for name in ("a.csv.gz", "a.xlsx"):
        assert model(program, tmp_path / name) == wanted, name


def test_exports_have_the_columns_and_values_of_the_table(exported, table):
    ticks = json.loads((exported / "flight.json").read_text())["ticks"]
    assert list(ticks) == list(table.columns)
    messages = files.read(exported / "flight.mcap")
    for name, column in table.columns.items():
        if column.dtype == object:
            assert ticks[name] == list(column), name
        else:
            numbers = numpy.array([numpy.nan if value is None else value for value in ticks[name]], float)
            assert numpy.allclose(numbers, column.astype(float), rtol=0, atol=0.51e-6, equal_nan=True), name
            if name in messages.columns:
                assert numpy.allclose(messages[name].astype(float), numbers, rtol=0, atol=0, equal_nan=True), name
    assert set(messages.columns) == {name for name, values in ticks.items() if any(value is not None for value in values)}


def test_listen_hears_the_same_in_a_ulog_as_in_a_table(program, exported):
    heard = []
    for name in ("flight.ulg", "flight.parquet"):
        said = program.run("listen", exported / name, "--json", "--out", exported / "heard")
        assert said.returncode == 0, said.stderr
        heard.append(json.loads(said.stdout))
    assert heard[0]["detected_s"] == pytest.approx(heard[1]["detected_s"], abs=1e-3)


def test_convert_writes_what_the_end_of_a_name_says(program, table, tmp_path):
    table = files.Table({name: column[:200] for name, column in table.columns.items()})
    files.write(tmp_path / "a.parquet", table)
    said = program.run("convert", "a.parquet", cwd=tmp_path)
    assert (said.returncode, said.stdout) == (0, "out/convert/a.csv\n"), said.stderr
    for ending in (".mat", ".feather", ".xlsx", ".mcap"):
        assert program.run("convert", "out/convert/a.csv", "--out", f"b{ending}", cwd=tmp_path).returncode == 0
        again = files.read(tmp_path / f"b{ending}")
        assert set(again.columns) <= set(table.columns) and len(again) == len(table)
    assert program.run("convert", "a.parquet", "--out", "-", cwd=tmp_path).stdout == (tmp_path / "out/convert/a.csv").read_text()


@pytest.mark.parametrize("name, text, wanted", [
    ("altos.csv", "#version, time, acceleration\n6, -0.30, 0.5\n6, -0.29, 0.75\n", [["version", "time", "acceleration"], ["6", "-0.30", "0.5"]]),
    ("german.csv", "Time;Altitude;\n0;2,5;\n0,05;3;\n", [["Time", "Altitude", ""], ["0", "2.5", ""]]),
    ("log.pf2", "PerfectFlite SL100\n\nData: (Time, Altitude)\n0.00,1\n0.05,2\n", [["Time", "Altitude"], ["0.00", "1"]]),
    ("again.csv", "time,a,time,b\n0,1,0.5,2\n", [["time", "a", "b"], ["0", "1", ""]])])
def test_convert_reads_the_tables_of_others_as_all_verbs_do(program, tmp_path, name, text, wanted):
    (tmp_path / name).write_text(text)
    said = program.run("convert", name, "--out", "out.csv", cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    assert [line.split(",") for line in (tmp_path / "out.csv").read_text().splitlines()][:2] == wanted
    assert program.run("convert", name, "--out", "out.parquet", cwd=tmp_path).returncode == 0
    assert set(files.read(tmp_path / "out.parquet").columns) == {column for column in wanted[0] if column}


@pytest.mark.parametrize("words, code, part", [
    (["none.mat"], 66, "none.mat: no such file"), (["a.txt"], 65, "a.txt: no row of a table"),
    (["flight.ftl"], 65, "fantail log export"), ([], 64, "FILE is missing"), (["--install", "a.mat"], 64, "--install takes no file"),
    (["a.mat"], 65, "a.mat: it is not a MAT-file"), (["a.mat", "--out", "a.txt"], 64, "its ending is not an output format"),
    (["a.mat", "--to", "csv", "--out", "a.txt"], 74, "this file exists"), (["a.mat", "--to", "xls"], 64, "xls")])
def test_convert_refuses_with_the_reason_and_without_a_file(program, tmp_path, words, code, part):
    for name in ("a.mat", "a.txt", "flight.ftl"):
        (tmp_path / name).write_text("no table")
    said = program.run("convert", *words, cwd=tmp_path)
    assert said.returncode == code and part in said.stderr, said.stderr
    assert "Traceback" not in said.stderr and not (tmp_path / "out").exists()


def refusal(program, path, *more):
    said = program.run("identify", path, *FLAT, *more, "--out", path.parent / "identified")
    assert said.returncode == 65 and "Traceback" not in said.stderr, said.stderr
    return said.stderr


def test_a_wanted_column_that_is_none_and_one_of_another_unit_are_refused(program, tmp_path, table):
    import scipy.io
    flight = {name: column.reshape(-1, 1) for name, column in table.columns.items() if column.dtype != object}
    path = tmp_path / "a.mat"

    def save(**more):
        scipy.io.savemat(path, {"flight": flight | more, "units": {"roll_rate_deg_s": "rad/s"}}, long_field_names=True)

    save()
    assert "a.mat: units.roll_rate_deg_s is rad/s, and roll_rate_deg_s is read in deg/s" in refusal(program, path)
    save(roll_angle_deg=flight["roll_angle_deg"] * 1j)
    assert "a.mat: roll_angle_deg is complex numbers; a column is" in refusal(program, path)


def test_the_row_of_what_is_wrong_is_named(program, tmp_path, table):
    columns = {name: column[:200].copy() for name, column in table.columns.items()}
    columns["time_s"][2] = columns["time_s"][0]
    files.write(tmp_path / "a.parquet", files.Table(columns))
    assert "a.parquet: row 3: time_s is" in refusal(program, tmp_path / "a.parquet")


def test_without_the_packages_the_command_that_installs_them_is_named(program, exported, tmp_path):
    bare = tmp_path / "python"
    bare.write_text(f"#!/bin/sh\nexec {os.path.realpath(os.environ['FANTAIL_PYTHON'])} -S -E \"$@\"\n")
    bare.chmod(0o755)
    for words in (["identify", exported / "flight.parquet", *FLAT], ["listen", exported / "flight.ulg"], ["convert", exported / "flight.mat"],
                  ["log", "export", exported.parents[1] / "flight", "--to", "mcap"]):
        said = program.run(*words, cwd=tmp_path, FANTAIL_PYTHON=str(bare))
        assert said.returncode == 69 and f"{bare} -m pip install -r" in said.stderr, said.stderr
    said = program.run("log", "export", exported.parents[1] / "flight", "--to", "json", cwd=tmp_path, FANTAIL_PYTHON=str(bare))
    assert said.returncode == 0, "JSON needs nothing but Python"


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGKILL])
def test_killed_half_way_it_leaves_nothing(exported, tmp_path, how):
    slow = tmp_path / "python"
    slow.write_text("#!/bin/sh\necho begun\nexec sleep 5\n")
    slow.chmod(0o755)
    program = subprocess.Popen([os.environ["FANTAIL_PROGRAM"], "convert", exported / "flight.mat"], cwd=tmp_path, text=True,
                               env=os.environ | {"FANTAIL_PYTHON": str(slow)}, stderr=subprocess.PIPE)
    time.sleep(1)
    begun = time.monotonic()
    program.send_signal(how)
    program.wait()
    assert time.monotonic() - begun < 3
    assert program.returncode == (130 if how == signal.SIGTERM else -how)
    assert sorted(os.listdir(tmp_path)) == ["python"]


def test_the_extra_of_the_package_has_the_versions_that_are_installed():
    root = HERE.parents[1]
    pinned = {line for line in (root / "python/fantail/files/requirements.txt").read_text().splitlines() if "==" in line}
    named = {line.strip(' ",') for line in (root / "pyproject.toml").read_text().splitlines() if "==" in line and "requires" not in line}
    assert named and named <= pinned
    assert pinned <= set(pathlib.Path(root / "build/test-venv/requirements.txt").read_text().splitlines())
