# SPDX-License-Identifier: MIT
"""Mass and centres of designs as OpenRocket has stored them in its files, beside what Fantail reads: the table of docs/validation.md.

Usage: openrocket_designs.py FANTAIL FILE.ork... (Python alone). Of each file the first flight that OpenRocket counts as up to date is taken,
with a motor made from the thrust and the masses stored with it. "doubted" are those of which `fantail airframe` says that they do not agree.
Versions before 22.02 do not store what the motor's case weighs: of theirs the centre of pressure alone is compared, within 0.2 calibres.
"""

import gzip
import io
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
import zipfile

NAMES = {"time": ("Time", "Zeit", "time"), "thrust": ("Thrust", "Schub", "thrust_force"), "mass": ("Mass", "Masse", "mass"),
         "motor": ("Motor mass", "motor_mass"),
         "gravity": ("CG location", "Position vom CG", "cg_location"), "pressure": ("CP location", "Position vom CP", "cp_location"),
         "angle": ("Angle of attack", "Angriffswinkel", "aoa"), "mach": ("Mach number", "Machzahl", "mach_number")}

CLUSTERS = {"double": 2, "3-row": 3, "4-row": 4, "3-ring": 3, "4-ring": 4, "5-ring": 5, "6-ring": 6, "3-star": 4, "4-star": 5, "5-star": 6,
            "6-star": 7, "9-grid": 9, "9-star": 9}


def tree_of(path):
    content = path.read_bytes()
    if content[:2] == b"PK":
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            content = archive.read(next(name for name in archive.namelist() if name.endswith(".ork")))
    elif content[:2] == b"\x1f\x8b":
        content = gzip.decompress(content)
    return ET.fromstring(content)


def number(word):
    try:
        return float(word)
    except ValueError:
        return math.nan


class Flight:
    """The rows of a stored flight, by quantity."""

    def __init__(self, branch):
        types = [name.strip() for name in branch.get("types").split(",")]
        self.columns = {what: next((types.index(name) for name in names if name in types), None) for what, names in NAMES.items()}
        self.rows = [[number(word) for word in point.text.split(",")] for point in branch.findall("datapoint")]

    def of(self, what, row):
        column = self.columns[what]
        return math.nan if column is None else row[column]

    def calm(self):
        """The row of the slow ascent with the smallest angle of attack that has a centre of pressure."""
        rows = [row for row in self.rows if self.of("pressure", row) > 0 and not self.of("mach", row) > 0.5]
        return min(rows, key=lambda row: abs(self.of("angle", row)), default=None)


def motor_file(flight, motor, count, folder):
    mass_kg = flight.of("motor", flight.rows[0]) if flight.columns["motor"] is not None else 0.0
    burnt_kg = flight.of("mass", flight.rows[0]) - min(flight.of("mass", row) for row in flight.rows[: len(flight.rows) // 2 + 1])
    name = re.sub(r"\s", "_", motor.findtext("designation"))
    lines = [f"{name} {1000 * float(motor.findtext('diameter')):g} {1000 * float(motor.findtext('length')):g} P {burnt_kg / count:.6f} "
             f"{max(mass_kg, burnt_kg) / count:.6f} X"]
    points = []
    for row in flight.rows:
        time_s, thrust_n = flight.of("time", row), max(0.0, flight.of("thrust", row)) / count
        if (points or thrust_n > 0) and (not points or time_s > points[-1][0]):
            points.append((time_s, thrust_n))
            if thrust_n == 0:
                break
    path = folder / "motor.eng"
    path.write_text("\n".join(lines + [f"{time_s:.5f} {thrust_n:.4f}" for time_s, thrust_n in points]) + "\n")
    return path


def stored(tree):
    motors = {}
    for motor in tree.iter("motor"):
        motors.setdefault(motor.get("configid"), motor)
    for simulation in tree.iter("simulation"):
        branch = simulation.find("flightdata/databranch")
        motor = motors.get(simulation.findtext("conditions/configid"))
        if branch is not None and motor is not None and simulation.get("status") in ("uptodate", "loaded", "external"):
            flight = Flight(branch)
            if flight.rows and flight.columns["thrust"] is not None:
                return flight, motor
    return None


def compared(fantail, path):
    found = stored(tree_of(path))
    if found is None:
        return "stores no flight", None
    flight, motor = found
    count = 1
    for tube in tree_of(path).iter("innertube"):
        if tube.find("motormount/motor") is not None:
            count = CLUSTERS.get(tube.findtext("clusterconfiguration"), 1)
            break
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        new = [fantail, "new", str(folder / "rocket"), "--from", str(path), "--motor", str(motor_file(flight, motor, count, folder))]
        made = subprocess.run(new, capture_output=True, text=True, check=False)
        if made.returncode != 0:
            return "refused: " + made.stderr.strip().split(": ", 2)[-1], None
        answer = subprocess.run([fantail, "airframe", str(folder / "rocket/vehicle.toml"), "--json", "--out", str(folder / "page")],
                                capture_output=True, text=True, check=True)
    result = json.loads(answer.stdout)
    ours = {line["what"]: line["computed"] for line in result["numbers"]}
    calm = flight.calm()
    pressure_m = flight.of("pressure", calm) if calm else math.nan
    if flight.columns["motor"] is None:
        is_near = abs(pressure_m - ours["centre of pressure"]) <= 0.2 * result["diameter_m"]
        return "agrees" if is_near else "doubted", (None, None, (pressure_m, ours["centre of pressure"]))
    word = "agrees" if result["agrees_with_design"] else "doubted"
    return word, ((flight.of("mass", flight.rows[0]), ours.get("mass at lift-off")),
                  (flight.of("gravity", flight.rows[0]), ours.get("centre of gravity at lift-off")),
                  (pressure_m, ours["centre of pressure"]))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print("| design | mass, kg: stored, read | centre of gravity, m | centre of pressure, m | |\n|---|---|---|---|---|")
    for name in sys.argv[2:]:
        path = pathlib.Path(name)
        word, numbers = compared(sys.argv[1], path)
        cells = [f"{pair[0]:.3f}, {pair[1]:.3f}" if pair and pair[1] is not None else "" for pair in numbers or (None, None, None)]
        print(f"| {path.stem.replace('_', ' ')} | {' | '.join(cells)} | {word} |")


if __name__ == "__main__":
    main()
