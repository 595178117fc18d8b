# SPDX-License-Identifier: MIT
"""Fantail's control law flies a rocket in RocketPy: the loop is closed in RocketPy's world, and beside it in Fantail's own.

Usage: rocketpy_roll.py [--figure FILE]     needs rocketpy 1.9.0 and matplotlib; FILE ends with .png or .svg

The rocket is the shipped Tasha III of the second launch, from its vehicle file. RocketPy moves it; fantail.Autopilot, the
object that flies on the board, is called every millisecond as a controller of RocketPy's.
"""
import argparse
import math
import pathlib
import tomllib
import warnings

import matplotlib
import numpy
from rocketpy import Environment, Flight, GenericMotor, GenericSurface, Rocket
from rocketpy.control.controller import _Controller  # RocketPy has no public name for a controller but that of air brakes

import fantail

SCENARIO = "tasha3_launch2"
# What RocketPy's world is, said to Fantail: six degrees of freedom, a rail that holds the roll, the standard atmosphere.
SAME_WORLD = {"flight.motion": "six_dof", "launch_guide.roll": "held", "environment.density": "isa"}
NO_CONTROL = {"controller.proportional_gain": 0, "controller.derivative_gain_s": 0, "excitation.form": "none"}
COLUMNS = ("time_s", "phase", "reference_deg", "true_roll_angle_deg", "true_roll_rate_deg_s", "true_canard_deg")
FIN_OFFSET_DEG = -4.9  # of the scenario
G_M_S2 = 9.80665
TICK_S = 0.001
PAD_TICKS = 4000  # on the pad before ignition: the law takes the gyro's bias from 3 s of stillness
BAND_DEG = 2.0  # settled is what stays so near to where the law settles
# What Fantail takes a servo for where the vehicle does not say.
SERVO_LAG_S = 0.02
SERVO_DELAY_TICKS = 3
SERVO_RATE_RAD_S = math.radians(600)


class RollMoment(GenericSurface):
    """Fins and canards as Fantail's roll model has them: 1/2 rho v A (v beta (canards + fin offset) - alpha p)."""

    def __init__(self, area_m2, damping_m2, torque_m):
        super().__init__(area_m2, 1.0, {}, name="roll")
        self.damping_m2, self.torque_m = damping_m2, torque_m
        self.canards_rad = 0.0  # mean of the four, as they stand

    def compute_forces_and_moments(self, stream_velocity, stream_speed, stream_mach, rho, cp, omega, reynolds):
        angle_rad = self.canards_rad + math.radians(FIN_OFFSET_DEG)
        moment_n_m = 0.5 * rho * stream_speed * self.reference_area * (
            stream_speed * self.torque_m * angle_rad - self.damping_m2 * omega[2])
        return 0, 0, 0, 0, 0, moment_n_m


class Servos:
    """Four servos: a delay, then a lag with a largest rate. A step is one tick."""

    def __init__(self):
        self.angles_rad = numpy.zeros(4)
        self.waiting = [numpy.zeros(4)] * SERVO_DELAY_TICKS

    def step(self, commands_rad):
        self.waiting.append(numpy.array(commands_rad))
        wanted = (1 - math.exp(-TICK_S / SERVO_LAG_S)) * (self.waiting.pop(0) - self.angles_rad)
        self.angles_rad = self.angles_rad + numpy.clip(wanted, -SERVO_RATE_RAD_S * TICK_S, SERVO_RATE_RAD_S * TICK_S)


class Avionics:
    """The law between RocketPy's state and the canards. RocketPy's body has z to the nose, Fantail's x."""

    def __init__(self, plan, surface, controlled):
        self.law, self.surface, self.servos = fantail.Autopilot(plan), surface, Servos()
        self.ticks = 0
        self.velocity_m_s = numpy.zeros(3)
        self.angle_rad = self.rate_rad_s = 0.0
        self.rows = []
        for tick in range(1, PAD_TICKS):  # who does not arm it has canards that stay where they are
            self.step((0, 0, 0), (G_M_S2, 0, 0), arm_command=controlled and tick == PAD_TICKS - 500)

    def step(self, rate_rad_s, force_m_s2, arm_command=False):
        self.ticks += 1
        tick = self.law.step(fantail.Inputs(
            self.ticks * 1000, rate_rad_s, force_m_s2, self.servos.angles_rad.tolist(), arm_switch_closed=True,
            arm_command=arm_command, second_specific_force_m_s2=force_m_s2))
        self.servos.step(tick.canards_rad)
        return tick

    def __call__(self, time, sampling_rate, state, state_history, observed_variables, interactive_objects):
        # RocketPy 1.9.0 may call a controller twice in a tick (its issue 959).
        if PAD_TICKS + round(time / TICK_S) <= self.ticks:
            return
        # What strapped-down accelerometers measure: the change of the velocity over a tick, less gravity, in the body frame.
        change_m_s2 = (numpy.array(state[3:6]) - self.velocity_m_s) / TICK_S + (0, 0, G_M_S2)
        self.velocity_m_s = numpy.array(state[3:6])
        e0, e1, e2, e3 = state[6:10]
        to_ground = numpy.array([[1 - 2 * (e2 * e2 + e3 * e3), 2 * (e1 * e2 - e0 * e3), 2 * (e1 * e3 + e0 * e2)],
                                 [2 * (e1 * e2 + e0 * e3), 1 - 2 * (e1 * e1 + e3 * e3), 2 * (e2 * e3 - e0 * e1)],
                                 [2 * (e1 * e3 - e0 * e2), 2 * (e2 * e3 + e0 * e1), 1 - 2 * (e1 * e1 + e2 * e2)]])
        force = to_ground.T @ change_m_s2
        tick = self.step((state[12], state[10], state[11]), (force[2], force[0], force[1]))
        self.surface.canards_rad = float(self.servos.angles_rad.mean())
        self.angle_rad += 0.5 * (self.rate_rad_s + state[12]) * TICK_S
        self.rate_rad_s = state[12]
        self.rows.append({
            "time_s": time, "true_roll_angle_deg": math.degrees(self.angle_rad), "true_speed_m_s": state[5],
            "true_roll_rate_deg_s": math.degrees(state[12]), "reference_deg": math.degrees(tick.reference_rad),
            "true_canard_deg": math.degrees(self.surface.canards_rad), "phase": tick.phase})


def make_rocket(vehicle, surface):
    """RocketPy's rocket, from a vehicle file of Fantail's."""
    body, airframe, masses = vehicle["body"], vehicle["airframe"], vehicle["masses"]
    curve = pathlib.Path(fantail.data_folder()) / "sim/motors" / f"{vehicle['motor']['file']}.eng"
    lines = [line.split() for line in curve.read_text(encoding="utf-8").splitlines() if not line.startswith(";")]
    propellant_kg = float(lines[0][4])
    motor = GenericMotor(
        thrust_source=[[float(time), float(thrust)] for time, thrust in lines[1:]], burn_time=float(lines[-1][0]),
        propellant_initial_mass=propellant_kg, dry_mass=1e-6, dry_inertia=(0, 0, 0),  # all that stays is the rocket's
        chamber_radius=1.5 * masses["propellant_radius_of_gyration_m"], chamber_height=masses["propellant_length_m"],
        chamber_position=airframe["length_m"] - masses["propellant_position_m"], nozzle_radius=0.015, nozzle_position=0,
        interpolation_method="linear")
    radius_m = 0.5 * airframe["diameter_m"]
    area_m2 = math.pi * radius_m**2
    across = airframe["transverse_inertia_after_burnout_kg_m2"]
    rocket = Rocket(
        radius=radius_m, mass=body["mass_kg"] - propellant_kg, inertia=(across, across, body["roll_inertia_kg_m2"]),
        power_on_drag=body["drag_area_m2"] / area_m2, power_off_drag=body["drag_area_m2"] / area_m2,
        center_of_mass_without_motor=-airframe["centre_of_gravity_after_burnout_m"],
        coordinate_system_orientation="tail_to_nose")  # zero at the tip of the nose, the tail below it
    rocket.add_motor(motor, position=-airframe["length_m"])
    # Half of the normal force to each side of its centre, so far off that pitch is damped as the vehicle says.
    slope = 0.5 * airframe["normal_force_slope_per_rad"]
    for side in (-1, 1):
        lift = GenericSurface(area_m2, airframe["diameter_m"], {
            "cL": lambda alpha, beta, mach, reynolds, pitch_rate, yaw_rate, roll_rate: slope * alpha,
            "cQ": lambda alpha, beta, mach, reynolds, pitch_rate, yaw_rate, roll_rate: -slope * beta}, name="lift")
        rocket.add_surfaces(lift, -airframe["centre_of_pressure_m"] + side * airframe["parts_spread_m"])
    rocket.add_surfaces(surface, -airframe["centre_of_pressure_m"])
    return rocket


def fly_in_rocketpy(controlled):
    """Columns by the names of Fantail's, and what happened when: in seconds after lift-off, as Fantail counts."""
    path = pathlib.Path(fantail.data_folder()) / "sim/vehicles" / f"{SCENARIO}.toml"
    vehicle = tomllib.loads(path.read_text(encoding="utf-8"))
    air, plan = vehicle["aerodynamics"], fantail.plan(SCENARIO)
    surface = RollMoment(air["reference_area_m2"], air["damping_m2"], air["torque_m"])
    rocket = make_rocket(vehicle, surface)
    avionics = Avionics(plan, surface, controlled)
    rocket._add_controllers(_Controller([surface], avionics.__call__, sampling_rate=1 / TICK_S, name="Fantail"))
    warnings.filterwarnings("ignore", ".*`min_step`")  # RocketPy gives it to every solver
    # A solver that stops at every tick: RocketPy's usual one, LSODA, steps over nearly all of them (with SciPy 1.17.1).
    flight = Flight(rocket=rocket, environment=Environment(elevation=0, gravity=G_M_S2), rail_length=plan["guide.length_m"],
                    inclination=90, heading=0, terminate_on_apogee=True, time_overshoot=False, ode_solver="RK23")
    columns = {name: numpy.array([row[name] for row in avionics.rows]) for name in avionics.rows[0]}
    liftoff_s = columns["time_s"][columns["true_speed_m_s"] > 0][0] - TICK_S
    columns["time_s"] = columns["time_s"] - liftoff_s
    return columns, {"control_start_s": when(columns, "controlling"), "guide_clear_s": flight.out_of_rail_time - liftoff_s,
                     "apogee_s": flight.apogee_time - liftoff_s, "apogee_m": float(flight.apogee),
                     "max_speed_m_s": float(flight.max_speed)}


def fly_in_fantail(controlled):
    flight = fantail.fly(SCENARIO, set={**SAME_WORLD, **({} if controlled else NO_CONTROL)})
    up = flight["time_s"] <= flight.events["apogee_s"]
    heights = {name: flight.summary[name] for name in ("apogee_m", "max_speed_m_s")}
    return {name: flight[name][up] for name in COLUMNS}, {**flight.events, **heights}


def when(columns, phase):
    """The first time in a phase; None: never."""
    times_s = columns["time_s"][columns["phase"] == phase]
    return float(times_s[0]) if len(times_s) else None


def figures(columns, events):
    """What a flight came to."""
    plan = fantail.plan(SCENARIO)
    time_s, angle_deg = columns["time_s"], columns["true_roll_angle_deg"]
    begin_s = events["control_start_s"] + plan["reference.step_times_s"][0]
    settles_deg = plan["reference.step_angles_deg"][0] + FIN_OFFSET_DEG / plan["controller.proportional_gain"]
    far = (time_s > begin_s) & (numpy.abs(angle_deg - settles_deg) > BAND_DEG)
    return {"settles_s": float(time_s[far][-1] - begin_s), "last_angle_deg": float(angle_deg[-1]), "settles_deg": settles_deg}


def differences(ours, theirs):
    """Of two flights, over the time under control in both: root mean square and largest, of angle and rate."""
    time_s = ours["time_s"]
    both = (ours["phase"] == "controlling") & (time_s >= when(theirs, "controlling")) & (time_s <= theirs["time_s"][-1])
    found = {}
    for name in ("true_roll_angle_deg", "true_roll_rate_deg_s"):
        other = numpy.interp(time_s[both], theirs["time_s"], theirs[name])
        off = numpy.abs(ours[name][both] - other)
        found[name] = float(numpy.sqrt(numpy.mean(off**2))), float(off.max())
    return found


def draw(path, fantails, rocketpys, free):
    matplotlib.use("Agg")
    from matplotlib import pyplot  # after the choice of what draws

    panels = {"true_roll_angle_deg": "roll angle, deg", "true_roll_rate_deg_s": "roll rate, deg/s",
              "true_canard_deg": "canards, deg"}
    figure, axes = pyplot.subplots(len(panels), sharex=True, figsize=(9, 7), layout="constrained")
    for axis, (name, label) in zip(axes, panels.items()):
        axis.plot(fantails["time_s"][::5], fantails[name][::5], color="tab:blue", label="in Fantail's world")
        axis.plot(rocketpys["time_s"][::5], rocketpys[name][::5], "--", color="tab:orange", label="in RocketPy's world")
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    held = fantails["phase"] == "controlling"
    axes[0].plot(fantails["time_s"][held], fantails["reference_deg"][held], ":", color="gray", label="reference")
    axes[1].plot(free["time_s"][::5], free["true_roll_rate_deg_s"][::5], color="tab:red", label="RocketPy, canards at 0")
    axes[0].legend(loc="upper right")
    axes[1].legend(loc="lower right")
    axes[-1].set_xlabel("time after lift-off, s")
    axes[-1].set_xlim(0, fantails["time_s"][-1])
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--figure", type=pathlib.Path, help="writes a figure")
    options = parser.parse_args()
    if options.figure is not None and options.figure.suffix not in (".png", ".svg"):
        parser.error(f"--figure {options.figure}: allowed: a name that ends with .png or .svg")

    worlds = {"RocketPy": fly_in_rocketpy, "Fantail": fly_in_fantail}
    flights = {name: fly(controlled=True) for name, fly in worlds.items()}
    free = {name: fly(controlled=False) for name, fly in worlds.items()}
    print(f"{'':44}{'RocketPy':>12}{'Fantail':>12}")

    def line(what, of, digits):
        print(f"{what:44}" + "".join(f"{of(name):12.{digits}f}" for name in flights))

    found = {name: figures(*flight) for name, flight in flights.items()}
    line("apogee, m", lambda name: flights[name][1]["apogee_m"], 2)
    line("top speed, m/s", lambda name: flights[name][1]["max_speed_m_s"], 2)
    line("guide clear, s after lift-off", lambda name: flights[name][1]["guide_clear_s"], 3)
    line("control start, s after lift-off", lambda name: flights[name][1]["control_start_s"], 3)
    line("canards at 0: largest roll rate, deg/s", lambda name: abs(free[name][0]["true_roll_rate_deg_s"]).max(), 1)
    line("canards at 0: roll at apogee, deg", lambda name: free[name][0]["true_roll_angle_deg"][-1], 1)
    line("controlled: largest roll rate, deg/s", lambda name: abs(flights[name][0]["true_roll_rate_deg_s"]).max(), 1)
    line("controlled: roll at apogee, deg", lambda name: found[name]["last_angle_deg"], 2)
    line(f"controlled: within {BAND_DEG:g} deg, s after the step", lambda name: found[name]["settles_s"], 2)
    off = differences(flights["Fantail"][0], flights["RocketPy"][0])
    print("\nbetween the two worlds, under control (root mean square, largest):")
    for what, (rms, largest) in zip(("roll angle, deg", "roll rate, deg/s"), off.values()):
        print(f"{what:44}{rms:12.3f}{largest:12.3f}")
    if options.figure is not None:
        draw(options.figure, flights["Fantail"][0], flights["RocketPy"][0], free["RocketPy"][0])


if __name__ == "__main__":
    main()
