# SPDX-License-Identifier: MIT
"""A peer of the campaigns: the ascent of a like rocket in RocketPy, without control, as its Monte Carlo flies it."""

import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "validation"))
import rocketpy_peer  # noqa: E402


def measure(repetitions):
    """CPU seconds of each ascent, on one thread, the rocket being made beforehand; and the last one's apogee in metres."""
    rocket = rocketpy_peer.rocket(corrected=True)
    seconds = []
    for _ in range(repetitions):
        begin = time.process_time()
        flight = rocketpy_peer.fly(rocket, tilt_deg=2, azimuth_deg=90, wind_m_s=5, from_deg=270)
        seconds.append(time.process_time() - begin)
    return seconds, flight["apogee_m"]
