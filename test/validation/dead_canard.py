# SPDX-License-Identifier: MIT
"""Flies launches with one canard broken, with and without run.canard_fault = "share"; the tables of docs/control.md.

dead_canard.py FANTAIL FOLDER [--runs N]   FANTAIL is the program, FOLDER takes the flights
"""
import argparse
import csv
import json
import pathlib
import subprocess

LAWS = {
    "launch 1 as published, limit 6 deg": ("tasha3_launch1", []),
    "launch 1, limit 9 deg": ("tasha3_launch1", ["controller.canard_limit_deg=9"]),
    "launch 2 as published": ("tasha3_launch2", []),
    "launch 2 with the integral": ("tasha3_launch2_integral", []),
}


def fault(kind, from_s, *more):
    return f'\n[[faults]]\nkind = "{kind}"\ncanard = 1\nfrom_s = {from_s}\n' + "".join(line + "\n" for line in more)


# What is put behind the text of the scenario, and from when on it counts.
CASES = {
    "torn off, from lift-off": (fault("canard_dead", 0), 0),
    "torn off at 3 s": (fault("canard_dead", 3), 3),
    "stuck at 9, from lift-off": (fault("canard_stuck", 0, "angle_deg = 9"), 0),
    "stuck at -9, from lift-off": (fault("canard_stuck", 0, "angle_deg = -9"), 0),
    "stuck at 9 at 3 s": (fault("canard_stuck", 3, "angle_deg = 9"), 3),
    "stuck at -9 at 3 s": (fault("canard_stuck", 3, "angle_deg = -9"), 3),
    "stuck at -4 at 3 s": (fault("canard_stuck", 3, "angle_deg = -4"), 3),
    "jams where it stands at 3 s": (fault("canard_stuck", 3), 3),
    "runs to its stop at 3 s": (fault("canard_hardover", 3), 3),
    "slow, from lift-off": (fault("canard_slow", 0), 0),
    "encoder noise of 22 deg at 3 s": (fault("encoder_noisy", 3, "noise_counts = 1000"), 3),
    "encoder unplugged at 3 s": (fault("encoder_unplugged", 3), 3),
}


def fly(program, scenario, changes, folder, run, runs):
    """Roll angle less reference over time, of the true columns, and the verdict."""
    sets = [word for change in changes for word in ("--set", change)]
    subprocess.run([program, "predict", str(scenario), *sets, "--run", str(run), "--runs", str(runs), "--out",
                    str(folder)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    errors = {}
    with open(folder / "flight.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["phase"] == "controlling":
                errors[row["time_s"]] = float(row["true_roll_angle_deg"]) - float(row["reference_deg"])
    return errors, json.loads((folder / "summary.json").read_text())["outcome"]


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=20)
    options = parser.parse_args()
    shipped = pathlib.Path(__file__).resolve().parents[2] / "sim/scenarios"
    options.folder.mkdir(parents=True, exist_ok=True)

    for law, (scenario, changes) in LAWS.items():
        path = options.folder / f"{scenario}.toml"
        plain = (shipped / f"{scenario}.toml").read_text()

        def flown(text, policy):
            path.write_text(plain + text)
            return [fly(options.program, path, [*changes, f"run.canard_fault={policy}"], options.folder / "run", run,
                        options.runs) for run in range(options.runs)]

        healthy = flown("", "continue")
        errors = [abs(e) for one, _ in healthy for e in one.values()]
        held = sum(outcome == "held" for _, outcome in healthy)
        print(f"\n{law}: without a fault mean {mean(errors):.2f}, largest {max(errors):.1f}, {held} held\n")
        print("| canard 1 | mean | mean, shared | largest | largest, shared | off | off, shared | held | held, shared |")
        print("|---|---|---|---|---|---|---|---|---|", flush=True)
        for case, (text, from_s) in CASES.items():
            cells = []
            for policy in ("continue", "share"):
                errors, off, held = [], [], 0
                for (one, outcome), (other, _) in zip(flown(text, policy), healthy):
                    begins_s = max(from_s, float(next(iter(one))) + 0.5)
                    now = {time: e for time, e in one.items() if float(time) >= begins_s}
                    errors += [abs(e) for e in now.values()]
                    off += [abs(e - other[time]) for time, e in now.items() if time in other]
                    held += outcome == "held"
                cells.append((f"{mean(errors):.2f}", f"{max(errors):.1f}", f"{mean(off):.2f}", f"{held}"))
            print(f"| {case} | " + " | ".join(f"{a} | {b}" for a, b in zip(*cells)) + " |", flush=True)


if __name__ == "__main__":
    main()
