# SPDX-License-Identifier: MIT
import math

import pytest

import fantail

G = 9.80665
STILL = ((0.0, 0.0, 0.0), (G, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))


def launched(plan):
    """A law in Controlling, in a world where the rocket goes up at 60 m/s2 and turns at 1 rad/s, and the time."""
    law = fantail.Autopilot(plan)
    time_us = 0

    def step(rate, force, encoders, **more):
        nonlocal time_us
        time_us += 1000
        return law.step(fantail.Inputs(time_us, rate, force, encoders, arm_switch_closed=True,
                                       second_specific_force_m_s2=force, **more))

    for i in range(4000):
        tick = step(*STILL, arm_command=i == 3500)
    assert tick.phase == "armed" and law.phase == "armed"
    while tick.phase != "controlling" and time_us < 8_000_000:
        tick = step((1.0, 0.0, 0.0), (60.0 + G, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))
    return law, tick, step


def test_it_waits_detects_the_launch_and_works_against_the_roll():
    law, tick, step = launched("tasha3_launch2")
    assert law.phase == "controlling" and tick.roll_rate_rad_s == pytest.approx(1.0, abs=1e-4)
    assert tick.speed_m_s > 0 and tick.height_m > 2
    tick = step((1.0, 0.0, 0.0), (G, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))
    assert tick.command_rad < 0 and tick.driven == (True,) * 4


def test_the_command_is_the_published_law_and_never_beyond_the_limit_of_the_plan():
    plan = fantail.plan("tasha3_launch2", set={"controller.canard_limit_deg": 4})
    _, tick, step = launched(plan)
    for _ in range(300):
        tick = step((1.0, 0.0, 0.0), (G, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))
        asked = (plan.controller.proportional_gain * (tick.reference_rad - tick.roll_angle_rad)
                 - plan.controller.derivative_gain_s * tick.roll_rate_rad_s + tick.signals["excitation_rad"])
        limit = math.radians(4)
        assert tick.command_rad == pytest.approx(max(-limit, min(limit, asked)), abs=1e-6)
    assert tick.saturated and tick.command_rad == pytest.approx(-limit)


def test_a_tick_outlives_the_next_one():
    law = fantail.Autopilot(fantail.plan("tasha3_launch2"))
    first = law.step(fantail.Inputs(1000, *STILL))
    law.step(fantail.Inputs(2000, *STILL))
    assert first.time_us == 1000 and first.phase == "safe" and first.reason


def test_a_gyro_that_says_nothing_is_no_rate_of_zero():
    law = fantail.Autopilot("tasha3_launch2")
    assert law.step(fantail.Inputs(1000)).signals["gyro_state"] != law.step(fantail.Inputs(2000, *STILL)).signals["gyro_state"]


def test_an_abort_ends_control():
    _, _, step = launched(fantail.plan("tasha3_launch2", set={"run.abort_input": "open_aborts"}))
    tick = step(*STILL, abort=True)
    assert tick.phase == "finished" and tick.command_rad == 0


def test_inputs_are_typed():
    with pytest.raises(TypeError):
        fantail.Inputs(0.5)
    with pytest.raises(TypeError):
        fantail.Inputs(1000, rate_rad_s=1.0)
    with pytest.raises(TypeError):
        fantail.Autopilot("tasha3_launch2").step(1000)
