# SPDX-License-Identifier: MIT
"""Flies the modes of the roll law against each other; the tables of docs/control.md are what this prints.

modes_of_the_law.py FANTAIL FOLDER [--runs N]   FANTAIL is the program, FOLDER takes the flights
"""
import argparse
import csv
import json
import pathlib
import subprocess

MODEL = ["roll_model.roll_inertia_kg_m2=0.00393", "roll_model.reference_area_m2=5.0265e-5", "roll_model.damping_m2=23",
         "roll_model.torque_m=9"]
# What `fantail tune tasha3_launch2 --schedule` finds.
TUNED = ["controller.proportional_gain=0.51", "controller.derivative_gain_s=0.062", "offset.rejection=integral",
         "offset.integral_gain_per_s=0.27", "gain_schedule.speeds_m_s=[19.8,26.3,35,46.5,61.9,82.2]",
         "gain_schedule.factors=[4.16,3.13,2.35,1.77,1.33,1]"]
MODES = {
    "as published": ("tasha3_launch2", []),
    "schedule": ("tasha3_launch2", ["gain_schedule.speeds_m_s=[20,40,80]", "gain_schedule.factors=[2,1.5,1]"]),
    "integral": ("tasha3_launch2_integral", []),
    "integral, scheduled": ("tasha3_launch2", TUNED),
    "observer": ("tasha3_launch2", ["offset.rejection=observer", *MODEL]),
}
LEANING = ["flight.motion=six_dof", "launch_guide.tilt_deg=15", "launch_guide.azimuth_deg=90", "wind.speed_m_s=8",
           "wind.from_deg=90", "run.tilt_limit_deg=90"]
CANARD_1_DEAD = '\n[[faults]]\nkind = "canard_stuck"\ncanard = 1\nfrom_s = 2\nangle_deg = 0\n'
GYRO_SILENT = '\n[[faults]]\nkind = "imu_dropout"\nfrom_s = 5\nuntil_s = 5.2\n'


def offset(*nodes):
    times, angles = zip(*nodes)
    return [f"disturbance.times_s={list(times)}", f"disturbance.angles_deg={list(angles)}"]


# Beside the scenario: changes, and what is put behind the text of its file.
CASES = {
    "nothing": ([], ""),
    "canard 1 stuck at 0 from 2 s on": ([], CANARD_1_DEAD),
    "offset of -8.5 from 3 to 6 s": (offset((0, -4.9), (3, -4.9), (3.1, -8.5), (6, -8.5), (6.1, -4.9)), ""),
    "offset of -12 from 3 to 6 s": (offset((0, -4.9), (3, -4.9), (3.1, -12), (6, -12), (6.1, -4.9)), ""),
    "gyro silent from 5 to 5.2 s": (["motion.longest_gyro_gap_s=0.3"], GYRO_SILENT),
    "offset of -12 throughout": (offset((0, -12)), ""),
    "six degrees of freedom, guide leans 15 deg into 8 m/s of wind": (LEANING, ""),
}


def look(folder):
    """|phi - R| in degrees: mean and largest outside of the first second after control start and each step; and how long
    after 6.1 s it was last above 2 degrees."""
    errors, late_s = [], 0.0
    reference, counts_from_s = None, 0.0
    with open(folder / "flight.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["phase"] != "controlling":
                continue
            time_s, now = float(row["time_s"]), float(row["reference_deg"])
            if now != reference:
                reference, counts_from_s = now, time_s + 1.0
            error = abs(float(row["true_roll_angle_deg"]) - now)
            if time_s >= counts_from_s:
                errors.append(error)
            if 6.1 <= time_s < 9.0 and error > 2.0:
                late_s = time_s - 6.1
    summary = json.loads((folder / "summary.json").read_text())
    return sum(errors) / len(errors), max(errors), late_s, summary["outcome"]


def fly(program, verb, scenario, changes, folder, *more):
    sets = [word for change in changes for word in ("--set", change)]
    subprocess.run([program, verb, str(scenario), *sets, *more, "--out", str(folder)], stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, check=False)
    return look(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=200)
    options = parser.parse_args()

    print("| mode | mean of the means, deg | largest mean, deg | largest, deg | not held |\n|---|---|---|---|---|")
    for name, (scenario, changes) in MODES.items():
        seen = [fly(options.program, "predict", scenario, changes, options.folder / "run", "--run", str(run),
                    "--runs", str(options.runs)) for run in range(options.runs)]
        means = [one[0] for one in seen]
        lost = sum(one[3] != "held" for one in seen)
        print(f"| {name} | {sum(means) / len(means):.2f} | {max(means):.2f} | {max(one[1] for one in seen):.1f} | {lost} |",
              flush=True)

    print("\n| flight | " + " | ".join(MODES) + " |\n|---|" + "---|" * len(MODES))
    shipped = pathlib.Path(__file__).resolve().parents[2] / "sim/scenarios"
    options.folder.mkdir(parents=True, exist_ok=True)
    for case, (more, text) in CASES.items():
        cells = []
        for scenario, changes in MODES.values():
            path = options.folder / f"{scenario}.toml"
            plain = (shipped / f"{scenario}.toml").read_text()
            path.write_text(plain + text)
            mean, largest, late_s, outcome = fly(options.program, "fly", path, [*changes, *more], options.folder / "one")
            back = "never" if late_s > 2.89 else f"{late_s:.2f} s"
            cells.append(f"{mean:.2f}, {largest:.1f}, {back}, {outcome.replace('_', ' ')}")
        print(f"| {case} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
