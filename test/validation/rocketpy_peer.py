# SPDX-License-Identifier: MIT
"""The rocket of the validation in RocketPy: nose, canards, fins, motor and guide, flown in a standard atmosphere.

RocketPy 1.9.0 reads two distances from the centre of dry mass with the wrong sign (its issue 1186, with a mend under
way): while propellant is left, its rocket turns about a point on the wrong side of that centre. rocket(corrected=True)
turns both around, as the mend does; with next to no propellant there is no difference.
"""

import math

import numpy
from rocketpy import Environment, Flight, GenericMotor, Rocket

RADIUS_M = 0.04
LENGTH_M = 1.51
DRY_MASS_KG = 3.764
DRY_INERTIA_KG_M2 = 0.56
ROLL_INERTIA_KG_M2 = 0.00393
DRY_CENTRE_M = 0.875
PROPELLANT_KG = 0.226
CHAMBER_M = 0.25  # a cylinder of propellant of this length at the tail
CHAMBER_RADIUS_M = 0.025
DRAG_AREA_M2 = 0.0050
THRUST = [(0, 0), (0.05, 160), (0.70, 173), (1.30, 168), (2.55, 128), (2.98, 118), (3.20, 0)]
GUIDE_M = 4.0


def rocket(corrected):
    area_m2 = math.pi * RADIUS_M**2
    motor = GenericMotor(
        thrust_source=[list(point) for point in THRUST],
        burn_time=THRUST[-1][0],
        chamber_radius=CHAMBER_RADIUS_M,
        chamber_height=CHAMBER_M,
        chamber_position=0.5 * CHAMBER_M,
        propellant_initial_mass=PROPELLANT_KG,
        nozzle_radius=0.015,
        dry_mass=1e-6,  # all that stays is the rocket's
        center_of_dry_mass_position=0.5 * CHAMBER_M,
        dry_inertia=(0, 0, 0),
        nozzle_position=0.0,
        interpolation_method="linear",
    )
    result = Rocket(
        radius=RADIUS_M,
        mass=DRY_MASS_KG,
        inertia=(DRY_INERTIA_KG_M2, DRY_INERTIA_KG_M2, ROLL_INERTIA_KG_M2),
        power_off_drag=DRAG_AREA_M2 / area_m2,
        power_on_drag=DRAG_AREA_M2 / area_m2,
        center_of_mass_without_motor=-DRY_CENTRE_M,
        coordinate_system_orientation="tail_to_nose",  # zero at the tip of the nose, the tail below it
    )
    result.add_motor(motor, position=-LENGTH_M)
    result.add_nose(length=0.3, kind="ogive", position=0.0)
    for chord_m, tip_m, span_m, position_m in [(0.06, 0.04, 0.05, 0.36), (0.14, 0.08, 0.085, 1.36)]:
        result.add_trapezoidal_fins(
            n=4, root_chord=chord_m, tip_chord=tip_m, span=span_m, position=-position_m, sweep_length=chord_m - tip_m
        )
    if corrected:
        result.com_to_cdm_function = -1 * result.com_to_cdm_function
        result.nozzle_to_cdm = -result.nozzle_to_cdm
    return result


def airframe(rocket):
    """What Fantail's section [airframe] says of the same rocket: sums over RocketPy's own parts."""
    slopes = [surface.clalpha(0.1) for surface, _ in rocket.aerodynamic_surfaces]
    places = [-position.z + surface.cpz for surface, position in rocket.aerodynamic_surfaces]
    slope = sum(slopes)
    centre = numpy.average(places, weights=slopes)
    spread = math.sqrt(numpy.average((numpy.array(places) - centre) ** 2, weights=slopes))
    place = LENGTH_M - 0.5 * CHAMBER_M  # of the propellant
    full_kg = DRY_MASS_KG + PROPELLANT_KG
    full_centre = (DRY_MASS_KG * DRY_CENTRE_M + PROPELLANT_KG * place) / full_kg
    own = PROPELLANT_KG * (CHAMBER_RADIUS_M**2 / 4 + CHAMBER_M**2 / 12)
    full_inertia = (
        DRY_INERTIA_KG_M2
        + DRY_MASS_KG * (DRY_CENTRE_M - full_centre) ** 2
        + own
        + PROPELLANT_KG * (place - full_centre) ** 2
    )
    return {
        "diameter_m": 2 * RADIUS_M,
        "length_m": LENGTH_M,
        "normal_force_slope_per_rad": float(slope),
        "centre_of_pressure_m": float(centre),
        "parts_spread_m": float(spread),
        "centre_of_gravity_m": full_centre,
        "centre_of_gravity_after_burnout_m": DRY_CENTRE_M,
        "transverse_inertia_kg_m2": full_inertia,
        "transverse_inertia_after_burnout_kg_m2": DRY_INERTIA_KG_M2,
    }


def fly(rocket, tilt_deg, azimuth_deg, wind_m_s, from_deg):
    air = Environment(elevation=0, gravity=9.80665)
    blows_to = math.radians(from_deg + 180)
    air.set_atmospheric_model(
        type="custom_atmosphere",
        pressure=None,  # the standard atmosphere's
        temperature=None,
        wind_u=wind_m_s * math.sin(blows_to),  # towards the east
        wind_v=wind_m_s * math.cos(blows_to),
    )
    flight = Flight(
        rocket=rocket,
        environment=air,
        rail_length=GUIDE_M,
        inclination=90 - tilt_deg,
        heading=azimuth_deg,
        terminate_on_apogee=True,
        max_time_step=0.01,
        rtol=1e-8,
    )
    return {
        "apogee_m": float(flight.apogee),
        "apogee_after_guide_s": float(flight.apogee_time - flight.out_of_rail_time),
        "top_speed_m_s": float(flight.max_speed),
        "guide_exit_m_s": float(flight.out_of_rail_velocity),
        "north_m": float(flight.apogee_y),
        "east_m": float(flight.apogee_x),
        "tilt_at_apogee_deg": float(90 - flight.attitude_angle(flight.apogee_time)),
    }
