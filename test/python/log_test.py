# SPDX-License-Identifier: MIT
import json
import math
import os
import signal
import subprocess
import sys
import time

import numpy
import pytest

import fantail


@pytest.fixture(scope="module")
def log(flown):
    return fantail.read_log(flown / "flight.ftl")


def test_a_log_says_what_it_holds(log, program, flown):
    info = json.loads(program.run("log", "info", flown / "flight.ftl", "--json").stdout)["flights"][0]
    (flight,) = log
    assert log.intact and flight.intact and flight.number == 1
    assert flight.ticks == info["ticks"] and flight.vehicle == info["vehicle"]
    assert flight.integrity == info["integrity"]["verdict"]
    assert [words for _, words in flight.events] == [event["words"] for event in info["events"]]
    assert [time_s - info["time_zero_s"] for time_s, _ in flight.events] == pytest.approx(
        [event["time_s"] for event in info["events"]])
    assert flight.plan["controller.canard_limit_deg"] == 9.0


def test_a_replay_gives_what_was_recorded(log, program, flown):
    replayed = fantail.replay(log)
    said = json.loads(program.run("replay", flown, "--json").stdout)
    assert replayed.equal and replayed.unreachable == 0 and replayed.first_difference is None
    assert (replayed.ticks, replayed.compared) == (said["ticks"], said["compared"])
    assert (replayed.flight["command_deg"] == fantail.read_flight(flown / "flight.ftl")["command_deg"]).all()


def test_the_replayed_commands_are_those_of_the_simulated_flight(log):
    simulated = fantail.fly("tasha3_launch2", set={"controller.canard_limit_deg": 9}, seed=7)
    replayed = fantail.replay(log).flight
    # The avionics' clock is zero where it saw the thrust begin, some ticks from the truth.
    control = [numpy.flatnonzero(each["phase"] == "controlling")[0] for each in (simulated, replayed)]
    there = slice(control[0] - control[1], control[0] - control[1] + len(replayed["time_s"]))
    assert (simulated["command_deg"][there] == replayed["command_deg"]).all()
    assert "true_roll_angle_deg" not in replayed


def test_another_plan_would_have_commanded_something_else(log, program, flown, tmp_path):
    replayed = fantail.replay(log, set={"controller.proportional_gain": 0.3})
    said = json.loads(program.run("replay", flown, "--set", "controller.proportional_gain=0.3", "--json", "--out",
                                  tmp_path / "out").stdout)
    assert not replayed.equal and 0 < said["differing"] <= replayed.differing
    assert replayed.first_difference["field"] and replayed.flight.plan["controller.proportional_gain"] == 0.3
    apart = numpy.abs(replayed.flight["command_deg"] - fantail.replay(log).flight["command_deg"]).max()
    assert apart == pytest.approx(said["largest_difference_deg"], rel=1e-6)


@pytest.mark.parametrize("change", ["sensors.imu_to_nose=plus_y", "controller.canard_limit_deg=60"])
def test_what_the_program_refuses_is_refused_in_its_words(log, program, flown, change):
    name, _, value = change.partition("=")
    with pytest.raises(ValueError) as refused:
        fantail.replay(flown / "flight.ftl", set={name: int(value) if value.isdigit() else value})
    assert str(refused.value) == program.refusal("replay", flown / "flight.ftl", "--set", change)


def test_a_file_that_is_no_log_is_refused_in_the_programs_words(program, flown, tmp_path):
    for path in (flown / "flight.csv", tmp_path / "none.ftl"):
        with pytest.raises(ValueError) as refused:
            fantail.read_log(path)
        assert str(refused.value) == program.refusal("log", "info", path)


def test_a_flight_on_the_disk_is_the_flight_that_was_flown(flown):
    simulated = fantail.fly("tasha3_launch2", set={"controller.canard_limit_deg": 9}, seed=7)
    read = fantail.read_flight(flown)
    assert read.columns == simulated.columns
    numpy.testing.assert_allclose(read["true_roll_angle_deg"], simulated["true_roll_angle_deg"], atol=1e-6)


def test_the_law_on_the_recorded_inputs_commands_every_bit_as_on_board(log):
    (flight,) = log
    law, first = flight.autopilot()
    ticks = [law.step(inputs) for inputs in flight.inputs()[first:]]
    commands = numpy.array([tick.command_rad for tick in ticks], dtype=numpy.float32)
    recorded = flight.commands_rad()[first:]
    assert len(ticks) == flight.ticks > 5000 and (recorded != 0).any()
    assert commands.tobytes() == recorded.tobytes()
    assert {tick.phase for tick in ticks} >= {"launched", "controlling", "finished"}


def test_what_a_step_comes_to_is_what_the_replay_shows(log):
    (flight,) = log
    law, first = flight.autopilot()
    columns = fantail.replay(log).flight
    for i, inputs in enumerate(flight.inputs()[first:first + 4000]):
        tick = law.step(inputs)
        if i % 500 == 0:
            assert math.degrees(tick.command_rad) == pytest.approx(columns["command_deg"][i], abs=1e-9)
            assert math.degrees(tick.roll_angle_rad) == pytest.approx(columns["roll_angle_deg"][i], abs=1e-6)
            assert [math.degrees(angle) for angle in tick.canards_rad] == pytest.approx(
                [columns[f"command_{canard}_deg"][i] for canard in (1, 2, 3, 4)], abs=1e-6)
            assert tick.phase == columns["phase"][i]
            assert tick.signals["command_rad"] == tick.command_rad and tick.signals["height_m"] == tick.height_m


# A name that another computer has given: its bytes are not UTF-8, and Python has halves of characters for them.
@pytest.mark.parametrize("ask", [fantail.read_log, fantail.read_flight, fantail.replay, fantail.identify, fantail.fly,
                                 fantail.plan, fantail.Scenario.load])
def test_a_name_that_is_no_utf8_is_refused_in_words(ask, tmp_path):
    name = os.fsencode(tmp_path) + b"/fl\xfcg.ftl"
    with open(name, "wb"):
        pass
    with pytest.raises(ValueError, match=r"fl\\udcfcg.ftl'; allowed: text in UTF-8; if this is the name of a file, rename it"):
        ask(os.fsdecode(name))


def test_ctrl_c_ends_the_waiting_for_a_pipe(tmp_path):
    os.mkfifo(tmp_path / "pipe.ftl")
    with subprocess.Popen([sys.executable, "-c", "import fantail, sys; print('now', flush=True); fantail.read_log(sys.argv[1])",
                           tmp_path / "pipe.ftl"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as waiting:
        assert waiting.stdout.readline() == "now\n"
        time.sleep(0.5)
        waiting.send_signal(signal.SIGINT)
        _, said = waiting.communicate(timeout=30)
    assert said.endswith("KeyboardInterrupt\n") and waiting.returncode == -signal.SIGINT
