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
    with pytest.raises(ValueError, match="--method: guess not in"):
        fantail.identify(flight, method="guess")


def test_a_window_is_two_times_or_a_text(flown):
    of_a_text = fantail.identify(flown, windows="0.9:8")
    assert fantail.identify(flown, windows=[(0.9, 8)]) == of_a_text == fantail.identify(flown, windows=["0.9:8"])
    for windows in ((0.9, 8), 3, [(1, 2, 3)], [("1", "x")]):
        with pytest.raises(ValueError, match="window"):
            fantail.identify(flown, windows=windows)


def test_a_log_without_a_summary_needs_a_rocket(flown, tmp_path):
    log = tmp_path / "flight.ftl"
    log.write_bytes((flown / "flight.ftl").read_bytes())
    with pytest.raises(ValueError, match="which one flew: use --vehicle"):
        fantail.identify(log)
    assert fantail.identify(log, vehicle="tasha3_launch2", windows="0.9:8")["beta_m"] > 0


def test_a_prediction_is_the_programs(program, tmp_path):
    said = json.loads(program.run("predict", "tasha3_launch1", "--runs", "8", "--json", "--out", tmp_path / "out").stdout)
    assert fantail.predict("tasha3_launch1", runs=8) == said
    assert said["go"] is False
    assert said["made"]["command"] == "fantail predict tasha3_launch1 --runs 8"


def test_a_scenario_with_its_changes_is_an_argument():
    changed = fantail.Scenario.load("tasha3_launch1", set={"controller.canard_limit_deg": 9}, seed=3)
    here = fantail.predict(changed, damping_factor=(1, 1.5), swirl_deg=-2, runs=2)
    assert here["made"]["changes"] == ["controller.canard_limit_deg=9", "seed=3", "swirl=-2", "damping-factor=1:1.5"]


def test_what_the_program_refuses_is_refused(program):
    for values, words in (({"scenario": "tunnel_steps"}, ["tunnel_steps"]),
                          ({"scenario": "tasha3_launch1", "runs": 0}, ["tasha3_launch1", "--runs", 0]),
                          ({"scenario": "tasha3_launch1", "swirl_deg": -60}, ["tasha3_launch1", "--swirl=-60"])):
        with pytest.raises(ValueError) as refused:
            fantail.predict(**values)
        assert str(refused.value) == program.refusal("predict", *words)
    with pytest.raises(TypeError, match="swirl"):
        fantail.predict("tasha3_launch1", swirl=-2)  # without its unit
    with pytest.raises(ValueError, match="tunnel: it is empty"):
        fantail.predict("tasha3_launch1", tunnel="")
