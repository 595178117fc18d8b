# SPDX-License-Identifier: MIT
"""The same grid as a Python user would search it: NumPy in two ways, and SciPy.

All take the same exact steps: the roll acceleration runs straight between two samples.
"""

import os

for library in ("OPENBLAS", "OMP", "MKL"):  # before NumPy is loaded: CPU time of one thread is compared
    os.environ[f"{library}_NUM_THREADS"] = "1"
import time  # noqa: E402

import numpy  # noqa: E402
import scipy.optimize  # noqa: E402


class Task:
    """One sample rate's record, and what does not depend on alpha and beta."""

    def __init__(self, data):
        for name in ("time_s", "roll_angle_rad", "alpha_m2", "beta_m", "some_alpha_m2", "some_beta_m", "node_time_s"):
            setattr(self, name, numpy.array(data[name]))
        self.rate_begin_rad_s = data["roll_rate_rad_s"][0]
        self.expected_rad = numpy.array(data["mean_abs_angle_error_rad"]).reshape(len(self.beta_m), len(self.alpha_m2))
        speed = numpy.array(data["speed_m_s"])
        damping = 0.5 * numpy.array(data["density_kg_m3"]) * speed * data["reference_area_m2"] / data["inertia_kg_m2"]
        self.dt_s = numpy.round(numpy.diff(self.time_s) * 1e9) * 1e-9
        self.damping_per_m2_s = 0.5 * (damping[:-1] + damping[1:])
        # Roll acceleration per beta: of each node at one radian, then of the canards, then of nothing.
        hats = [numpy.interp(self.time_s, self.node_time_s, unit) for unit in numpy.eye(len(self.node_time_s))]
        columns = [*hats, numpy.array(data["canard_rad"]), numpy.zeros_like(speed)]
        self.input = (damping * speed)[:, None] * numpy.stack(columns, axis=1)


def transitions(task, alpha_m2):
    """Decay, rate per acceleration before and behind, angle per rate, angle per acceleration before and behind."""
    x = alpha_m2 * task.damping_per_m2_s * task.dt_s
    phi3 = numpy.zeros_like(x)
    for divisor in (39916800, 3628800, 362880, 40320, 5040, 720, 120, 24, 6):
        phi3 = 1.0 / divisor - x * phi3
    phi2 = 0.5 - x * phi3
    phi1 = 1.0 - x * phi2
    decay = 1.0 - x * phi1
    large = x >= 0.25  # where the series is not exact any more
    if large.any():
        decay[large] = numpy.exp(-x[large])
        phi1[large] = (1.0 - decay[large]) / x[large]
        phi2[large] = (1.0 - phi1[large]) / x[large]
        phi3[large] = (0.5 - phi2[large]) / x[large]
    dt = task.dt_s
    return decay, dt * (phi1 - phi2), dt * phi2, dt * phi1, dt * dt * (phi2 - phi3), dt * dt * phi3


def drives(task, alpha_m2, columns):
    decay, rate_0, rate_1, angle_p, angle_0, angle_1 = transitions(task, alpha_m2)
    before, behind = columns[:-1], columns[1:]
    rates = rate_0[:, None] * before + rate_1[:, None] * behind
    angles = angle_0[:, None] * before + angle_1[:, None] * behind
    return decay, angle_p, rates, angles


def angles_step_by_step(task, alpha_m2, columns, angle, rate):
    """Roll angle of each column: a loop over the samples, all columns at once."""
    decay, angle_p, rates, angles = drives(task, alpha_m2, columns)
    result = numpy.empty_like(columns)
    result[0] = angle
    for i in range(len(decay)):
        angle = angle + (angle_p[i] * rate + angles[i])
        rate = decay[i] * rate + rates[i]
        result[i + 1] = angle
    return result


def angles_without_loop(task, alpha_m2, columns, angle, rate):
    """The same by an integrating factor and sums along the samples: no loop, but e to the power of the whole record's
    damping must be a number. Here it is at most e^190."""
    decay, angle_p, rates, angles = drives(task, alpha_m2, columns)
    factor = numpy.cumprod(decay)[:, None]
    rate_behind = factor * (rate + numpy.cumsum(rates / factor, axis=0))
    rate_before = numpy.vstack([rate[None, :], rate_behind[:-1]])
    steps = angle_p[:, None] * rate_before + angles
    return numpy.vstack([angle[None, :], angle + numpy.cumsum(steps, axis=0)])


def starts(task):
    angle = numpy.zeros(task.input.shape[1])
    rate = numpy.zeros(task.input.shape[1])
    angle[-1] = task.roll_angle_rad[0]  # only the last column begins as measured
    rate[-1] = task.rate_begin_rad_s
    return angle, rate


class Best:
    """Errors of the points, and the best of them."""

    def __init__(self, task):
        self.task = task
        self.points = 0
        self.error_rad = numpy.inf
        self.largest_difference_rad = 0.0

    def add(self, alpha_m2, beta_m, error_rad, node_rad):
        self.points += 1
        expected = self.task.expected_rad[
            numpy.argmin(abs(self.task.beta_m - beta_m)), numpy.argmin(abs(self.task.alpha_m2 - alpha_m2))
        ]
        self.largest_difference_rad = max(self.largest_difference_rad, abs(error_rad - expected))
        if error_rad < self.error_rad:
            self.error_rad, self.alpha_m2, self.beta_m, self.node_rad = error_rad, alpha_m2, beta_m, node_rad

    def result(self):
        return {
            "alpha_m2": float(self.alpha_m2),
            "beta_m": float(self.beta_m),
            "node_deg": [float(each) for each in numpy.degrees(self.node_rad)],
            "points": self.points,
            "largest_difference_deg": float(numpy.degrees(self.largest_difference_rad)),
        }


def numpy_grid(task, best):
    """What a good NumPy user writes: a simulation of all columns for each alpha, least squares at each point."""
    for alpha_m2 in task.alpha_m2:
        angles = angles_step_by_step(task, alpha_m2, task.input, *starts(task))
        wanted = task.roll_angle_rad - angles[:, -1]
        for beta_m in task.beta_m:
            nodes = beta_m * angles[:, :-2]
            rest = wanted - beta_m * angles[:, -2]
            node_rad = numpy.linalg.lstsq(nodes, rest, rcond=None)[0]
            best.add(alpha_m2, beta_m, abs(rest - nodes @ node_rad).mean(), node_rad)


def numpy_best_grid(task, best):
    """The best we could write in NumPy: no loop over the samples, and one factorisation for all betas of an alpha."""
    for alpha_m2 in task.alpha_m2:
        angles = angles_without_loop(task, alpha_m2, task.input, *starts(task))
        nodes = angles[:, :-2]
        sides = numpy.stack([task.roll_angle_rad - angles[:, -1], angles[:, -2]], axis=1)
        q, r = numpy.linalg.qr(nodes)
        parts = q.T @ sides
        free, canard = (sides - q @ parts).T
        errors = [abs(free - beta_m * canard).mean() for beta_m in task.beta_m]
        solutions = numpy.linalg.solve(r, parts)
        for beta_m, error in zip(task.beta_m, errors):
            best.add(alpha_m2, beta_m, error, solutions[:, 0] / beta_m - solutions[:, 1])


def scipy_grid(task, best):
    """least_squares at some of the points, with a model that has no loop over the samples."""
    hats, canard = task.input[:, :-2], task.input[:, -2:-1]
    angle, rate = task.roll_angle_rad[:1], numpy.array([task.rate_begin_rad_s])
    for alpha_m2 in task.some_alpha_m2:
        for beta_m in task.some_beta_m:

            def errors(node_rad):
                acceleration = beta_m * (canard + (hats @ node_rad)[:, None])
                return task.roll_angle_rad - angles_without_loop(task, alpha_m2, acceleration, angle, rate)[:, 0]

            node_rad = scipy.optimize.least_squares(errors, numpy.zeros(hats.shape[1]), method="lm").x
            best.add(alpha_m2, beta_m, abs(errors(node_rad)).mean(), node_rad)


SOLVERS = {"numpy": numpy_grid, "numpy_best": numpy_best_grid, "scipy": scipy_grid}


def measure(task, solver):
    """CPU seconds for as many points as the solver took, and its answer."""
    best = Best(task)
    begin = time.process_time()
    SOLVERS[solver](task, best)
    return {"seconds": time.process_time() - begin, **best.result()}
