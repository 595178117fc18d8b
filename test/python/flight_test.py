# SPDX-License-Identifier: MIT
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import threading
import time

import numpy
import pytest

import fantail

CHANGES = {"controller.canard_limit_deg": 9}


@pytest.fixture(scope="module")
def flight():
    return fantail.fly("tasha3_launch2", set=CHANGES, seed=7)


def test_every_column_is_that_of_the_programs_table(flight, table):
    assert list(flight) == list(table)
    for name, cells in table.items():
        values = flight[name]
        assert len(values) == len(cells)
        if name == "phase":
            assert values.tolist() == list(cells)
        elif values.dtype == bool:
            assert [str(int(value)) for value in values] == list(cells)
        else:
            written = numpy.array([float(cell) if cell else math.nan for cell in cells])
            numpy.testing.assert_allclose(values, written, rtol=0, atol=0.5000001e-6, equal_nan=True)


def test_the_summary_is_that_of_the_program_in_every_value(flight, flown):
    program = json.loads((flown / "summary.json").read_text())
    assert flight.summary.pop("made") == {**program.pop("made"), "command": "", "inputs": []}  # no command made it
    assert flight.summary == program


def test_the_files_it_writes_are_those_of_the_program_byte_for_byte(flight, flown, tmp_path):
    flight.write(tmp_path / "out")
    names = sorted(path.name for path in flown.iterdir())
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == names
    for name in names:
        ours, theirs = (tmp_path / "out" / name).read_bytes(), (flown / name).read_bytes()
        if name == "summary.json":  # its last member says by which command it was made
            ours, theirs = (text[:text.index(b'"made"')] for text in (ours, theirs))
        assert ours == theirs, name
    assert flight.log == (flown / "flight.ftl").read_bytes()


def test_events_are_those_of_the_summary_and_of_the_columns(flight):
    assert flight.events == pytest.approx(flight.summary["events"], abs=1e-6)
    first = flight["time_s"][flight["phase"] == "controlling"][0]
    assert first == pytest.approx(flight.events["control_start_s"], abs=0.0011)


def test_a_column_cannot_be_written_to_and_outlives_its_flight():
    column = fantail.fly("tasha3_launch2")["roll_rate_deg_s"]
    assert column.dtype == numpy.float64
    with pytest.raises(ValueError):
        column[0] = 1.0
    assert numpy.isfinite(column).all()


def test_no_column_can_be_written_to(flight):
    for name in flight:
        with pytest.raises(ValueError, match="read-only"):
            flight[name][0] = flight[name][1]


def test_a_column_that_is_not_there_is_named_with_those_that_are(flight):
    with pytest.raises(KeyError, match="roll_angel_deg.*did you mean roll_angle_deg.*time_s"):
        flight["roll_angel_deg"]
    assert "roll_angel_deg" not in flight


@pytest.mark.parametrize("number", [6, 6.0, 19 / 3, 1e-300, 0.1 + 0.2, numpy.float32(6.1), numpy.float64(1 / 3), numpy.int64(7)])
def test_a_number_keeps_every_bit_on_its_way(number):
    (word,) = fantail._changes.words({"controller.canard_limit_deg": number})
    assert float(word.partition("=")[2]) == float(number)
    (word,) = fantail._changes.words({"reference.step_times_s": [number, 2]})
    assert word == f"reference.step_times_s=[{word.partition('[')[2].partition(',')[0]}, 2]"


def test_changes_of_every_kind_arrive():
    plan = fantail.Scenario.load("tasha3_launch2", set={
        "controller.canard_limit_deg": 6.1, "reference.kind": "steps", "reference.step_times_s": [1, 2.5],
        "reference.step_angles_deg": numpy.array([10.0, -20.5]), "launch_detection.low_pass": True,
        "run.overrun_limit": numpy.int32(7)}).plan
    assert plan["controller.canard_limit_deg"] == 6.1 and plan["reference.kind"] == "steps"
    assert plan["reference.step_times_s"] == (1.0, 2.5) and plan["reference.step_angles_deg"] == (10.0, -20.5)
    assert plan["launch_detection.low_pass"] is True and plan["run.overrun_limit"] == 7


@pytest.mark.parametrize("changes", [
    {"controller.canard_limit_deg": 90}, {"controller.canard_limit_deg": "wide"}, {"controller.canard_limits_deg": 9},
    {"controler.canard_limit_deg": 9}, {"reference.kind": "holds"}, {"nothing": 1}, {"controller.canard_limit_deg": 1e-9},
    {"reference.step_times_s": [3, 2], "reference.step_angles_deg": [1, 2]}])
def test_what_the_program_refuses_is_refused_in_its_words(program, changes):
    words = []
    for name, value in changes.items():
        words += ["--set", f"{name}={value}"]
    with pytest.raises(ValueError) as refused:
        fantail.fly("tasha3_launch2", set=changes)
    assert str(refused.value) == program.refusal("fly", "tasha3_launch2", *words)


@pytest.mark.parametrize("name", ["tasha4_launch2", "no/such.toml", "tasha3_launch2.toml"])
def test_a_scenario_that_is_not_there_is_refused_in_the_programs_words(program, name):
    with pytest.raises(ValueError) as refused:
        fantail.Scenario.load(name)
    assert str(refused.value) == program.refusal("fly", name)


@pytest.mark.parametrize("seed", [-1, 2**64])
def test_a_seed_that_is_none_is_refused_in_the_programs_words(program, seed):
    with pytest.raises(ValueError) as refused:
        fantail.fly("tasha3_launch2", seed=seed)
    assert str(refused.value) == program.refusal("fly", "tasha3_launch2", f"--seed={seed}").removesuffix(" (see --help)")


@pytest.mark.parametrize("seed", [1.5, "7"])
def test_a_seed_that_is_no_whole_number_is_refused_by_name(seed):
    for refused in (lambda: fantail.fly("tasha3_launch2", seed=seed), lambda: fantail.fly_many("tasha3_launch2", seeds=[seed])):
        with pytest.raises(ValueError, match=f"^seed = {seed!r}; allowed: a whole number, 0 to 18446744073709551615$"):
            refused()


@pytest.mark.parametrize("wrong, said", [
    ({"columns": "time_s"}, "columns = 'time_s'; allowed: a list of names"), ({"seeds": 3}, "seeds = 3; allowed: a list of seeds"),
    ({"threads": 1.5}, "threads = 1.5; allowed: a whole number, 0 to 1024")])
def test_arguments_of_many_flights_are_refused_by_name(wrong, said):
    with pytest.raises(ValueError) as refused:
        fantail.fly_many("tasha3_launch2", **wrong)
    assert str(refused.value) == said


def test_a_whole_number_that_no_plan_can_hold_is_said_to_be_too_large():
    for number in (2**63, -2**63 - 1, 10**30):
        with pytest.raises(ValueError, match=f"^controller.canard_limit_deg = {number} does not fit into 64 bits"):
            fantail.Scenario.load("tasha3_launch2", set={"controller.canard_limit_deg": number})
    for number in (2**63 - 1, -2**63, 2.0**64):
        with pytest.raises(ValueError, match="is out of range; allowed: 0.5 to 20$"):
            fantail.Scenario.load("tasha3_launch2", set={"controller.canard_limit_deg": number})


def test_a_text_where_a_number_stands_is_no_number():
    with pytest.raises(ValueError, match="canard_limit_deg"):
        fantail.Scenario.load("tasha3_launch2", set={"controller.canard_limit_deg": "9"})
    with pytest.raises(TypeError, match="canard_limit_deg.*NoneType"):
        fantail.Scenario.load("tasha3_launch2", set={"controller.canard_limit_deg": None})


def test_other_threads_run_while_a_flight_is_flown():
    ended, counted = threading.Event(), [0]

    def count():
        while not ended.is_set():
            counted[0] += 1
            time.sleep(0)  # lets go of the interpreter

    def counted_while(call):
        before = counted[0]
        call()
        return counted[0] - before

    usual = sys.getswitchinterval()
    sys.setswitchinterval(1000.0)  # nobody takes the interpreter from who does not let go of it
    other = threading.Thread(target=count)
    other.start()
    try:
        assert counted_while(lambda: sum(range(1_000_000))) == 0
        scenario = fantail.Scenario.load("tasha3_launch2")
        assert any(counted_while(lambda: fantail.fly(scenario)) > 0 for _ in range(20))
        assert any(counted_while(lambda: fantail.fly_many([scenario], columns=[])) > 0 for _ in range(20))
    finally:
        ended.set()
        sys.setswitchinterval(usual)
        other.join()


def test_flights_on_many_threads_are_those_of_one_after_the_other_with_their_seeds():
    together = fantail.fly_many("tasha3_launch2", seeds=[1, 2, 3], threads=3)
    assert [each.seed for each in together] == [1, 2, 3]
    for each in together:
        alone = fantail.fly("tasha3_launch2", seed=each.seed)
        assert each.summary == alone.summary
        assert (each["roll_angle_deg"] == alone["roll_angle_deg"]).all()
    assert len({each["roll_angle_deg"][-1] for each in together}) == 3


def test_only_the_columns_that_are_asked_for_are_kept(tmp_path):
    whole, thin = (fantail.fly_many(["tasha3_launch2"], columns=columns)[0] for columns in (None, ["roll_angle_deg", "phase"]))
    assert thin.columns == ("roll_angle_deg", "phase")
    assert (thin["roll_angle_deg"] == whole["roll_angle_deg"]).all() and (thin["phase"] == whole["phase"]).all()
    for key in ("events", "verdict"):
        assert thin.summary[key] == whole.summary[key]
    with pytest.raises(ValueError, match="only some columns"):
        thin.write(tmp_path)
    with pytest.raises(ValueError, match="rol_angle_deg"):
        fantail.fly_many(["tasha3_launch2"], columns=["rol_angle_deg"])
    with pytest.raises(ValueError, match="seeds: 1 for 2 scenarios"):
        fantail.fly_many(["tasha3_launch2"] * 2, seeds=[1])


def test_it_works_from_another_folder_and_for_data_that_lies_elsewhere(tmp_path):
    source = pathlib.Path(__file__).parents[2]
    said = subprocess.run([sys.executable, "-c", "import fantail; print(fantail.fly('tasha3_launch2').verdict)"],
                          cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert said.strip() == fantail.fly("tasha3_launch2").verdict
    for folder in ("scenarios", "vehicles", "motors", "tunnel_results"):
        (tmp_path / "sim" / folder).mkdir(parents=True)
    only = tmp_path / "sim/scenarios/only.toml"
    only.write_bytes((source / "sim/scenarios/tasha3_launch2.toml").read_bytes())
    names = subprocess.run([sys.executable, "-c", "import fantail; print(fantail.shipped_scenarios())"],
                           env={**os.environ, "FANTAIL_DATA": str(tmp_path)}, capture_output=True, text=True, check=True)
    assert names.stdout.strip() == "['only']"


def test_what_a_wheel_is_made_of_has_its_data_within(tmp_path):
    source = pathlib.Path(__file__).parents[2]
    build = pathlib.Path(os.environ["FANTAIL_PROGRAM"]).parent
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", tmp_path], check=True,
                   stdout=subprocess.DEVNULL)
    assert [path.name for path in tmp_path.iterdir()] == ["fantail"]  # no programs, no headers
    for file in (source / "python/fantail").glob("*.py"):
        shutil.copy(file, tmp_path / "fantail")
    environment = {name: value for name, value in os.environ.items() if name != "FANTAIL_DATA"}
    said = subprocess.run(
        [sys.executable, "-c", "import fantail; print(fantail.data_folder()); print(fantail.fly('tasha3_launch1').verdict)"],
        env={**environment, "PYTHONPATH": str(tmp_path)}, cwd="/", capture_output=True, text=True, check=True)
    assert said.stdout.splitlines() == [str(tmp_path / "fantail/data"), fantail.fly("tasha3_launch1").verdict]


def test_pandas_gets_every_column(flight, monkeypatch):
    class Pandas:
        @staticmethod
        def DataFrame(columns):  # noqa: N802  as pandas has it
            return columns

    monkeypatch.setitem(sys.modules, "pandas", Pandas)
    frame = flight.to_pandas()
    assert tuple(frame) == flight.columns and (frame["time_s"] == flight["time_s"]).all()


def test_a_folder_without_a_name_is_refused_and_nothing_written(flight, program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    words = program.refusal("fly", "tasha3_launch2", "--out", "").removeprefix("--out: ").removesuffix(" (see --help)")
    for argument, refused in (("folder", lambda: flight.write("")),
                              ("out", lambda: fantail.campaign("tasha3_launch2", runs=1, out="")),
                              ("out", lambda: fantail.merge_campaign(["shard"], "")),
                              ("shards", lambda: fantail.merge_campaign([""], "whole"))):
        with pytest.raises(ValueError) as said:
            refused()
        assert str(said.value) == f"{argument}: {words}"
    assert not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_written_is_an_os_error(flight, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="file"):
        flight.write(tmp_path / "file" / "out")
