# SPDX-License-Identifier: MIT
"""Normal force, centre of pressure and roll of random rockets as RocketPy computes them, for the tests of airframe/model.

Usage: rocketpy_airframe.py > peer_airframes.csv, in an environment with requirements.txt.
"""

import math
import random

from rocketpy import NoseCone, TrapezoidalFins

NOSES = {"cone": "conical", "ogive": "tangent", "ellipsoid": "elliptical", "haack": "von karman"}
COLUMNS = (
    "nose diameter_m nose_length_m count position_m root_chord_m tip_chord_m span_m sweep_m "
    "slope_per_rad centre_of_pressure_m roll_torque_m3 roll_damping_m4"
)


def row(draw):
    nose = draw.choice(sorted(NOSES))
    radius_m = draw.uniform(0.02, 0.1)
    nose_m = radius_m * draw.uniform(3, 10)
    count = draw.choice((3, 4, 5, 6, 8))
    root_m = radius_m * draw.uniform(0.5, 4)
    tip_m = root_m * draw.uniform(0.1, 0.95)
    span_m = radius_m * draw.uniform(0.3, 3)
    sweep_m = root_m * draw.uniform(0.05, 0.9)
    position_m = nose_m + draw.uniform(0.1, 1)
    area_m2 = math.pi * radius_m**2
    cone = NoseCone(length=nose_m, kind=NOSES[nose], base_radius=radius_m, rocket_radius=radius_m)
    fins = TrapezoidalFins(count, root_m, tip_m, span_m, radius_m, cant_angle=0, sweep_length=sweep_m)
    slopes = cone.clalpha(0), fins.clalpha_multiple_fins(0)
    places = abs(cone.cpz), position_m + abs(fins.cpz)
    slope = sum(slopes)
    centre_m = sum(a * b for a, b in zip(slopes, places)) / slope
    forcing, damping, _ = fins.roll_parameters
    diameter_m = 2 * radius_m
    # Its coefficients: torque 1/2 rho v^2 A d (forcing * cant - damping * p d / 2v). In the damping it takes the slope of
    # one fin on the body's cross-section, where the integral over strips of the fin needs it on the fin's own area.
    torque_m3 = area_m2 * diameter_m * forcing(0)
    fin_area_m2 = 0.5 * span_m * (root_m + tip_m)
    damping_m4 = area_m2 * diameter_m * damping(0) * diameter_m / 2 * area_m2 / fin_area_m2
    numbers = (diameter_m, nose_m, count, position_m, root_m, tip_m, span_m, sweep_m, slope, centre_m, torque_m3, damping_m4)
    return ",".join([nose] + [f"{number:.9g}" for number in numbers])


def main():
    draw = random.Random(1)
    print(COLUMNS.replace(" ", ","))
    for _ in range(40):
        print(row(draw))


if __name__ == "__main__":
    main()
