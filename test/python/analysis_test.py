# SPDX-License-Identifier: MIT
import json

import pytest

import fantail


def test_the_roll_model_of_a_log_is_the_programs(program, flown, tmp_path):
    said = json.loads(program.run("identify", flown, "--window", "0.9:8", "--method", "both", "--json", "--out",
                                  tmp_path / "out").stdout)
    found = fantail.identify(flown, windows="0.9:8", method="both")
    assert len(found["results"]) == len(said["results"]) == 2
    for ours, theirs in zip(found["results"], said["results"]):
        for key in set(theirs) - {"vehicle"}:
            assert ours[key] == theirs[key], key


def test_a_flight_need_not_be_on_the_disk():
    flight = fantail.fly("tasha3_launch2")
    found = fantail.identify(flight, windows="0.9:8")
    assert found["alpha_m2"] > 0 and found["beta_m"] > 0
    with pytest.raises(ValueError, match="step:99"):
        fantail.identify(flight, windows="step:99")
    with pytest.raises(ValueError, match="method"):
        fantail.identify(flight, method="guess")


def test_a_window_is_two_times_or_a_text(flown):
    of_a_text = fantail.identify(flown, windows="0.9:8")
    assert fantail.identify(flown, windows=[(0.9, 8)]) == of_a_text == fantail.identify(flown, windows=["0.9:8"])
    for windows in ((0.9, 8), 3, [(1, 2, 3)], [("1", "2")]):
        with pytest.raises(ValueError) as refused:
            fantail.identify(flown, windows=windows)
        assert str(refused.value) == (f"windows = {windows!r}; allowed: a list of (begin_s, end_s) or of texts as --window has them")


def test_a_log_without_a_summary_needs_a_rocket(flown, tmp_path):
    log = tmp_path / "flight.ftl"
    log.write_bytes((flown / "flight.ftl").read_bytes())
    with pytest.raises(ValueError, match="which rocket flew"):
        fantail.identify(log)
    assert fantail.identify(log, vehicle="tasha3_launch2", windows="0.9:8")["beta_m"] > 0


def test_a_prediction_is_the_programs(program, tmp_path):
    said = json.loads(program.run("predict", "tasha3_launch1", "--runs", "8", "--json", "--out", tmp_path / "out").stdout)
    here = fantail.predict("tasha3_launch1", runs=8)
    assert said.pop("made")["command"] == "fantail predict tasha3_launch1 --runs 8"
    assert here.pop("made")["seed"] == 1  # no command made it
    assert here == said
    assert said["go"] is False


def test_what_the_program_refuses_is_refused(program):
    with pytest.raises(ValueError) as refused:
        fantail.predict("tunnel_steps")
    assert str(refused.value) == program.refusal("predict", "tunnel_steps")
    with pytest.raises(ValueError, match="runs = 0; allowed: 1 to 100000"):
        fantail.predict("tasha3_launch1", runs=0)
