# SPDX-License-Identifier: MIT
"""The identification of one record: Fantail, brute force, Ceres, NumPy and SciPy, and whether they agree."""

import json
import pathlib
import subprocess

import identify_peers

RATES_HZ = (100, 1000)
GRID_POINTS = 1260
NODE_TOLERANCE_DEG = 0.05
# Every solver's name, and what it is called in a table.
GRIDS = {
    "grid": "Fantail, linear",
    "brute_force": "brute force, same steps",
    "ceres": "Ceres, until it has the same table",
    "ceres_default": "Ceres, with its default tolerance",
    "numpy": "NumPy, a loop over the samples, lstsq a point",
    "numpy_best": "NumPy, no loop, one QR for each alpha",
    "scipy": "SciPy least_squares, model without a loop",
}
FITS = {
    "continuous": "Fantail, continuous",
    "closed_grid": "Fantail, closed loop, grid",
    "closed_continuous": "Fantail, closed loop, continuous",
}


def load_tasks(folder):
    def load(rate_hz):
        finished = subprocess.run(
            [pathlib.Path(folder) / "write_identify_task", str(rate_hz)], stdout=subprocess.PIPE, check=True
        )
        return identify_peers.Task(json.loads(finished.stdout))

    return {rate_hz: load(rate_hz) for rate_hz in RATES_HZ}


def of_fantail(sample):
    """One sample of the C++ benchmark as the Python peers give theirs."""
    nodes = [key for key in sample if key.startswith("node_")]
    answer = {key: sample[key] for key in ("alpha_m2", "beta_m", "points", "largest_difference_deg", "squares_rad2")
              if key in sample}  # fmt: skip
    return {"seconds": 1e-9 * sample["cpu_time"], "node_deg": [sample[key] for key in sorted(nodes)], **answer}


def collect(runs, fantail, tasks):
    """Adds one round: {(solver, rate): [answer with seconds, ...]}."""
    for name, samples in fantail.items():
        if name.startswith("identify_"):
            solver, rate_hz = name.removeprefix("identify_").split("/")
            runs.setdefault((solver, int(rate_hz)), []).extend(of_fantail(sample) for sample in samples)
    for rate_hz, task in tasks.items():
        for solver in identify_peers.SOLVERS:
            runs.setdefault((solver, rate_hz), []).append(identify_peers.measure(task, solver))


def disagreements(runs):
    """A sentence for each answer that is not the linear grid's."""
    wrong = []
    for (solver, rate_hz), samples in runs.items():
        expected = runs["grid", rate_hz][0]
        who = f"{solver} at {rate_hz} Hz"
        for found in samples:
            off = max(abs(a - b) for a, b in zip(found["node_deg"], expected["node_deg"]))
            if solver in GRIDS:
                if (found["alpha_m2"], found["beta_m"]) != (expected["alpha_m2"], expected["beta_m"]):
                    wrong.append(f"{who}: best cell {found['alpha_m2']:g}, {found['beta_m']:g}")
                if off > NODE_TOLERANCE_DEG:
                    wrong.append(f"{who}: a node {off:.3f} degrees off")
            elif solver == "continuous":
                # Two rules, least squares and least mean error: near each other, not the same.
                if abs(found["alpha_m2"] - expected["alpha_m2"]) > 2 or off > NODE_TOLERANCE_DEG:
                    wrong.append(f"{who}: alpha {found['alpha_m2']:.2f}, a node {off:.3f} degrees off")
            elif solver == "closed_continuous":
                if found["squares_rad2"] > runs["closed_grid", rate_hz][0]["squares_rad2"]:
                    wrong.append(f"{who}: worse than the grid")
    return sorted(set(wrong))


def results(runs, summary):
    """{solver: {rate: {"ms": figures, "points": how many were computed, ...answer}}}."""
    table = {}
    for (solver, rate_hz), samples in runs.items():
        points = samples[0].get("points", GRID_POINTS)
        answer = {key: value for key, value in samples[0].items() if key != "seconds"}
        milliseconds = summary([1e3 * each["seconds"] * GRID_POINTS / points for each in samples])
        table.setdefault(solver, {})[rate_hz] = {**answer, "points": int(points), "ms": milliseconds}
    return table


def show(table):
    print("\nIdentification of 9 s of flight, 5 nodes; 1260 points; milliseconds of CPU time, medians")
    print(f"{'':48}{'100 Hz':>10}{'times':>7}{'1 kHz':>10}{'times':>7}  points computed")
    for solver, label in {**GRIDS, **FITS}.items():
        line = f"{label:48}"
        for rate_hz in RATES_HZ:
            milliseconds = table[solver][rate_hz]["ms"]["median"]
            times = milliseconds / table["grid"][rate_hz]["ms"]["median"] if solver in GRIDS else None
            line += f"{milliseconds:10.2f}" + (f"{times:7.0f}" if times else f"{'':7}")
        if solver in GRIDS:
            points = [table[solver][rate_hz]["points"] for rate_hz in RATES_HZ]
            line += "  " + " / ".join("all" if each == GRID_POINTS else f"{each}, extrapolated" for each in points)
        print(line)
    print(f"\n{'answers':48}{'rate':>6}{'alpha':>8}{'beta':>7}  {'nodes, degrees':38}error of the table, degrees")
    for solver, label in {**GRIDS, **FITS}.items():
        for rate_hz in RATES_HZ:
            found = table[solver][rate_hz]
            nodes = "".join(f"{each:8.3f}" for each in found["node_deg"])
            difference = f"{found['largest_difference_deg']:.0e}" if solver in GRIDS else ""
            print(f"{label:48}{rate_hz:6}{found['alpha_m2']:8.2f}{found['beta_m']:7.2f}{nodes}  {difference}")
