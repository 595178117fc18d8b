# SPDX-License-Identifier: MIT
"""Flies the same rocket in six degrees of freedom with Fantail and with RocketPy, side by side.

Usage: validate.py FANTAIL [--write]. --write keeps RocketPy's figures for the tests (peer_rocket.txt, peer_flights.csv)
and puts the table into docs/validation.md. Ends with 1 when a flight differs by more than is promised there.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import rocketpy_peer

HERE = pathlib.Path(__file__).parent
PAGE = HERE.parent.parent / "docs" / "validation.md"
CASES = [  # tilt and azimuth of the guide, wind and where it comes from
    (0, 0, 0, 0),
    (5, 0, 0, 0),
    (10, 90, 0, 0),
    (15, 0, 0, 0),
    (0, 0, 3, 270),
    (0, 0, 5, 270),
    (5, 270, 5, 270),
    (5, 90, 5, 270),
]
CASE_NAMES = ("guide_tilt_deg", "guide_azimuth_deg", "wind_m_s", "wind_from_deg")
CALM_SHARE = 0.02
WINDY_SHARE = 0.05


def overrides(airframe):
    return [f"airframe.{key}={value!r}" for key, value in airframe.items()] + [
        "airframe.body_lift_area_m2=0",
        "flight.motion=six_dof",
        "environment.density=isa",
        f"launch_guide.length_m={rocketpy_peer.GUIDE_M}",
    ]


def of_case(case):
    tilt_deg, azimuth_deg, wind_m_s, from_deg = case
    return [
        f"launch_guide.tilt_deg={tilt_deg}",
        f"launch_guide.azimuth_deg={azimuth_deg}",
        f"wind.speed_m_s={wind_m_s}",
        f"wind.from_deg={from_deg}",
    ]


def fly(fantail, changes):
    with tempfile.TemporaryDirectory() as folder:
        words = [fantail, "fly", "tasha3_launch2", "--json", "--out", folder]
        finished = subprocess.run(
            words + [word for change in changes for word in ("--set", change)], capture_output=True, text=True, check=False
        )
        if not finished.stdout:
            sys.exit(finished.stderr)
        summary = json.loads(finished.stdout)
        with open(pathlib.Path(folder) / "trajectory.csv", encoding="utf-8") as file:
            path = list(csv.DictReader(file))
    speed_m_s = [math.hypot(*(float(row[name]) for name in ("north_m_s", "east_m_s", "up_m_s"))) for row in path]
    clear_s = summary["events"]["guide_clear_s"]
    exit_row = next(i for i, row in enumerate(path) if float(row["time_s"]) >= clear_s)
    top = summary["at_apogee"]
    return {
        "apogee_m": top["height_m"],
        "apogee_after_guide_s": summary["events"]["apogee_s"] - clear_s,
        "top_speed_m_s": max(speed_m_s),
        "guide_exit_m_s": speed_m_s[exit_row],
        "north_m": top["north_m"],
        "east_m": top["east_m"],
        "tilt_at_apogee_deg": top["tilt_deg"],
    }


def table(rows):
    """Markdown: of each figure Fantail's beside RocketPy's."""
    lines = [
        "| guide | wind | apogee, m | top speed, m/s | guide to apogee, s | drift at apogee, m | tilt at apogee, deg |",
        "|---|---|---|---|---|---|---|",
    ]
    for case, ours, theirs in rows:
        tilt_deg, azimuth_deg, wind_m_s, from_deg = case

        def pair(value, digits, ours=ours, theirs=theirs):
            return f"{value(ours):.{digits}f} / {value(theirs):.{digits}f}"

        lines.append(
            f"| {f'{tilt_deg} deg to {azimuth_deg}' if tilt_deg else 'upright'} "
            f"| {f'{wind_m_s} m/s from {from_deg}' if wind_m_s else 'calm'} "
            f"| {pair(lambda f: f['apogee_m'], 1)} | {pair(lambda f: f['top_speed_m_s'], 2)} "
            f"| {pair(lambda f: f['apogee_after_guide_s'], 2)} "
            f"| {pair(lambda f: math.hypot(f['north_m'], f['east_m']), 1)} "
            f"| {pair(lambda f: f['tilt_at_apogee_deg'], 1)} |"
        )
    return "\n".join(lines)


def largest_difference(rows, windy):
    """Of apogee and top speed, and of the drift, each as a share of RocketPy's."""
    worst = 0.0
    for case, ours, theirs in rows:
        if bool(case[2]) != windy:
            continue
        drift = [math.hypot(f["north_m"], f["east_m"]) for f in (ours, theirs)]
        pairs = [(ours[key], theirs[key]) for key in ("apogee_m", "top_speed_m_s")]
        if drift[1] > 1.0:
            pairs.append(tuple(drift))
        worst = max(worst, *(abs(a / b - 1.0) for a, b in pairs))
    return worst


def keep(airframe, rows, text):
    (HERE / "peer_rocket.txt").write_text("\n".join(overrides(airframe)) + "\n", encoding="utf-8")
    with open(HERE / "peer_flights.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*CASE_NAMES, *rows[0][2]])
        writer.writerows([*case, *(f"{value:.6f}" for value in theirs.values())] for case, _, theirs in rows)
    page = PAGE.read_text(encoding="utf-8")
    begin = page.index("<!-- flights -->") + len("<!-- flights -->\n")
    end = page.index("<!-- end of flights -->")
    PAGE.write_text(page[:begin] + text + "\n" + page[end:], encoding="utf-8")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("fantail")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    rocket = rocketpy_peer.rocket(corrected=True)
    airframe = rocketpy_peer.airframe(rocket)
    rows = [
        (case, fly(options.fantail, overrides(airframe) + of_case(case)), rocketpy_peer.fly(rocket, *case))
        for case in CASES
    ]
    text = table(rows)
    calm = largest_difference(rows, windy=False)
    windy = largest_difference(rows, windy=True)
    print("Fantail / RocketPy\n\n" + text)
    print(f"\nlargest difference of apogee, top speed and drift: {100 * calm:.2f} % in calm air, {100 * windy:.2f} % in wind")
    if options.write:
        keep(airframe, rows, text)
    return 0 if calm <= CALM_SHARE and windy <= WINDY_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
