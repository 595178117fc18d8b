# SPDX-License-Identifier: MIT
"""Every verb that answers with --json is a function, of the options that its program declares."""
import inspect
import json
import re

import pytest

import fantail
from fantail import _verbs

CALLS = [("airframe", {"vehicle": "tasha3_launch2", "set": {"fins.span_m": 0.07}}, ["tasha3_launch2", "--set", "fins.span_m=0.07"]),
         ("campaign hardover", {"scenario": "tasha3_launch2", "step_s": 5}, ["tasha3_launch2", "--step", 5]),
         ("campaign detection", {"plan": ["tasha3_launch2"], "events": 2, "launches": 2},
          ["--plan", "tasha3_launch2", "--events", 2, "--launches", 2]),
         ("compare", {"a": "FLOWN", "b": "FLOWN", "a_": "true", "from_s": 0.5, "to_s": 2},
          ["FLOWN", "FLOWN", "--a", "true", "--from", 0.5, "--to", 2]),
         ("plan show", {"plan": "tasha3_launch1"}, ["tasha3_launch1"]),
         ("report", {"a": "FLOWN"}, ["FLOWN"]),
         ("rules", {"pack": "launch_canada", "scenario": "tasha3_launch2"}, ["launch_canada", "tasha3_launch2"])]


@pytest.mark.parametrize("verb, values, words", CALLS, ids=[call[0] for call in CALLS])
def test_what_the_program_says_the_function_returns(verb, values, words, program, flown, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("a", "b"):
        values = values | ({name: flown} if name in values else {})
    said = program.run(*verb.split(), *[flown if word == "FLOWN" else word for word in words], "--json", cwd=tmp_path)
    assert getattr(fantail, verb.replace(" ", "_"))(**values) == json.loads(said.stdout)


def test_no_file_is_left_where_no_folder_is_named(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    fantail.airframe("tasha3_launch2")
    assert list(tmp_path.iterdir()) == []
    fantail.airframe("tasha3_launch2", out="kept")
    assert (tmp_path / "kept/airframe.html").is_file()


def test_every_verb_that_answers_is_there_or_has_an_object_of_its_own(program):
    # Of a rocket on the bus, and what only makes files, Python has no function.
    verbs = set(re.findall(r"^  ([a-z]+) +[A-Z]", program.run("--help").stdout, re.M))
    assert verbs - {name.split("_")[0] for name in _verbs.functions} == {
        "bench", "brief", "convert", "fly", "gateway", "log", "new", "node", "replay", "watch"}
    assert {"predict", "tune", "campaign_faults", "tunnel_steps", "paper", "listen"} <= set(fantail.__all__)


def test_an_argument_has_the_unit_the_range_and_the_meaning_of_its_option():
    signature = inspect.signature(fantail.predict)
    assert [*signature.parameters][:3] == ["scenario", "set", "seed"]
    assert {"swirl_deg", "servo_lag_s", "phase_margin_deg", "runs", "out"} <= {*signature.parameters}
    assert "swirl_deg: Swirl of the tunnel as a fin offset in degrees" in fantail.predict.__doc__
    assert "(from -45 to 45)" in " ".join(fantail.predict.__doc__.split())


def test_what_is_doubtful_is_a_warning():
    with pytest.warns(UserWarning, match="^The rocket is unstable at lift-off: its centre"):
        fantail.predict("tasha3_launch2", {"airframe.centre_of_pressure_m": 0.8}, runs=1, swirl_deg=0)
