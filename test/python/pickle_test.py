# SPDX-License-Identifier: MIT
"""What cannot go to another process says how to pass it instead, and what it says works."""

import copy
import multiprocessing
import pickle

import numpy
import pytest

import fantail


def fly_elsewhere(source, changes, seed):
    return fantail.fly(fantail.Scenario.load(source, set=changes, seed=seed))["roll_angle_deg"][-1]


@pytest.fixture(scope="module")
def flight():
    return fantail.fly(fantail.Scenario.load("tasha3_launch2", seed=3))


def test_objects_of_the_library_say_how_to_pass_them(flight, tmp_path):
    flight.write(tmp_path)
    log = fantail.read_log(tmp_path / "flight.ftl")
    plan = fantail.Plan.load("tasha3_launch2")
    for thing, words in ((fantail.Scenario.load("tasha3_launch2"), "call Scenario.load() there"), (flight, "dict(flight)"),
                         (log, "call read_log() there"), (log[0], "read_log(path)[place]"), (plan, "call Plan.load() there"),
                         (fantail.Autopilot(plan), "make an Autopilot")):
        for act in (pickle.dumps, copy.deepcopy):
            with pytest.raises(TypeError) as said:
                act(thing)
            assert "cannot be pickled; " in str(said.value) and words in str(said.value)


def test_what_they_say_works(flight):
    columns = pickle.loads(pickle.dumps(dict(flight)))
    assert numpy.array_equal(columns["time_s"], flight["time_s"])
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(fly_elsewhere, ("tasha3_launch2", {}, 3)) == flight["roll_angle_deg"][-1]
