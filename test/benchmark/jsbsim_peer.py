# SPDX-License-Identifier: MIT
"""The peer of the speed comparison: the same flight in JSBSim, all of it inside JSBSim's own engine."""

import math
import os
import pathlib
import time

os.environ["JSBSIM_DEBUG"] = "0"  # before it is loaded: else it greets on standard output
import jsbsim  # noqa: E402

METRES_PER_FOOT = 0.3048
TICK_S = 1e-3
PAD_TIME_S = 10.0  # motor/ignition-s of the model, and pad_time_s of the scenario
AFTER_APOGEE_S = 1.0


def load():
    """The model on its pad, with nothing that writes, logs or draws wind."""
    executive = jsbsim.FGFDMExec(None)
    executive.set_debug_level(0)
    executive.disable_output()
    executive.set_aircraft_path(str(pathlib.Path(__file__).parent / "jsbsim"))
    executive.set_dt(TICK_S)
    if not executive.load_model("tasha3", False):
        raise RuntimeError("JSBSim refused test/benchmark/jsbsim/tasha3.xml")
    executive["ic/h-agl-ft"] = 0.0
    executive["ic/theta-deg"] = 90.0
    executive["ic/lat-geod-deg"] = 45.0  # gravity 9.806 m/s2
    executive["atmosphere/turb-type"] = 0
    executive["forces/hold-down"] = 1
    if not executive.run_ic():
        raise RuntimeError("JSBSim refused its initial conditions")
    return executive


def check():
    """Flies once, looking at every tick: what the flight was like, so that a wrong peer cannot hide."""
    executive = load()
    top_m = 0.0
    top_m_s = 0.0
    angles_deg = []  # of roll, by tick since control start
    while executive.get_sim_time() < PAD_TIME_S + 1.0 or executive["velocities/h-dot-fps"] >= 0.0:
        executive.run()
        top_m = max(top_m, executive["position/h-agl-ft"] * METRES_PER_FOOT)
        top_m_s = max(top_m_s, executive["velocities/h-dot-fps"] * METRES_PER_FOOT)
        if executive["roll/control"] == 1.0:
            angles_deg.append(math.degrees(executive["roll/angle-rad"]))

    def mean(begin_s, end_s):
        part = angles_deg[round(begin_s / TICK_S) : round(end_s / TICK_S)]
        return sum(part) / len(part)

    return {
        "apogee_m": top_m,
        "max_speed_m_s": top_m_s,
        "hold_0_deg": mean(1.0, 2.0),
        "hold_minus_20_deg": mean(4.0, 7.0),
        "duration_s": executive.get_sim_time() + AFTER_APOGEE_S,
    }


def cpu_seconds(duration_s):
    """CPU time of one flight; loading the model is not counted."""
    executive = load()
    ticks = range(round(duration_s / TICK_S))
    run = executive.run
    begin = time.process_time()
    for _ in ticks:
        run()
    return time.process_time() - begin
