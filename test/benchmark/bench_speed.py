# SPDX-License-Identifier: MIT
"""How fast the autopilot, a whole simulated flight, identification and flight log are, beside peers in the same run.

Usage: bench_speed.py FOLDER [--json] [--rounds N], the folder being where the benchmark was built.

All times are CPU time. All take turns: whatever else the machine is doing meets each of them. Ends with 1 when the
identifications do not agree.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys

import identify_speed
import jsbsim_peer
import log_speed
import rocketpy_speed

REPETITIONS = 3  # of each benchmark in a round
NANOSECONDS = 1e9


def fantail_samples(executable):
    """One round: {benchmark: [{counter: value}, ...]}, a sample a repetition."""
    finished = subprocess.run(
        [executable, "--benchmark_format=json", f"--benchmark_repetitions={REPETITIONS}", "--benchmark_min_time=0.2"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        check=True,
    )
    samples = {}
    for run in json.loads(finished.stdout)["benchmarks"]:
        if run.get("error_occurred"):
            sys.exit(f"bench_speed: {run['name']}: {run['error_message']}")
        if run["run_type"] == "iteration":
            samples.setdefault(run["run_name"], []).append(run)
    return samples


def summary(values):
    mean = statistics.fmean(values)
    return {
        "mean": mean,
        "median": statistics.median(values),
        "lowest": min(values),
        "highest": max(values),
        "cv": statistics.stdev(values) / mean if len(values) > 1 else 0.0,
        "samples": len(values),
    }


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown"


def measure(folder, rounds):
    flight = jsbsim_peer.check()
    tasks = identify_speed.load_tasks(folder)
    logs = log_speed.write_logs(folder)
    log_peers = {reader: [] for reader in log_speed.READERS}
    identified = {}
    milliseconds = 1e3 * flight["duration_s"]
    fantail = {}
    peer_s = []
    rocketpy_s = []
    for _ in range(rounds):
        of_round = fantail_samples(pathlib.Path(folder) / "bench_speed")
        for name, samples in of_round.items():
            fantail.setdefault(name, []).extend(samples)
        identify_speed.collect(identified, of_round, tasks)
        for reader, samples in log_peers.items():
            samples += [log_speed.measure(logs, reader) for _ in range(REPETITIONS)]
        peer_s += [jsbsim_peer.cpu_seconds(flight["duration_s"]) for _ in range(REPETITIONS)]
        ascents_s, rocketpy_apogee_m = rocketpy_speed.measure(REPETITIONS)
        rocketpy_s += ascents_s

    def time_ns(name, counter):
        return summary([NANOSECONDS * sample[counter] for sample in fantail[name]])

    result = {
        "processor": processor(),
        "load_average": os.getloadavg()[0],
        "autopilot_step_controlling_ns": time_ns("autopilot_step_controlling", "time_per_step"),
        "autopilot_step_armed_ns": time_ns("autopilot_step_armed", "time_per_step"),
        "avionics_tick_ns": time_ns("avionics_tick", "time_per_tick"),
        "world_ms_ns": time_ns("whole_flight", "time_per_world_ms"),
        "flights_per_s": summary([sample["flights_per_s"] for sample in fantail["whole_flight"]]),
        "campaign_flights_per_s": summary([sample["flights_per_s"] for sample in fantail["campaign_run"]]),
        "rocketpy_ascents_per_s": summary([1.0 / each for each in rocketpy_s]),
        "rocketpy_apogee_m": rocketpy_apogee_m,
        "jsbsim_flights_per_s": summary([1.0 / each for each in peer_s]),
        "times_real_time": summary([sample["times_real_time"] for sample in fantail["whole_flight"]]),
        "six_dof_ms_ns": time_ns("whole_flight_six_dof", "time_per_world_ms"),
        "six_dof_times_real_time": summary(
            [sample["times_real_time"] for sample in fantail["whole_flight_six_dof"]]
        ),
        "jsbsim_ms_ns": summary([NANOSECONDS * each / milliseconds for each in peer_s]),
        "jsbsim_times_real_time": summary([flight["duration_s"] / each for each in peer_s]),
        "jsbsim_flight": flight,
        "identification": identify_speed.results(identified, summary),
        "flight_log": log_speed.results(fantail, log_peers, summary),
        "disagreements": identify_speed.disagreements(identified),
    }
    result["ratio"] = result["jsbsim_ms_ns"]["median"] / result["world_ms_ns"]["median"]
    return result


def show(result):
    print(f"{result['processor']}, load {result['load_average']:.1f}; CPU time, scenario tasha3_launch2\n")
    print(f"{'':44}{'median':>10}{'mean':>10}{'lowest':>10}{'highest':>10}{'cv':>8}")
    rows = [
        ("autopilot.step, controlling with chirp    ns", "autopilot_step_controlling_ns"),
        ("autopilot.step, armed on the pad          ns", "autopilot_step_armed_ns"),
        ("avionics.tick                             ns", "avionics_tick_ns"),
        ("whole world, one millisecond              ns", "world_ms_ns"),
        ("the same in six degrees of freedom, wind  ns", "six_dof_ms_ns"),
        ("JSBSim, one millisecond                   ns", "jsbsim_ms_ns"),
        ("whole world, times real time", "times_real_time"),
        ("the same in six degrees of freedom, wind", "six_dof_times_real_time"),
        ("JSBSim, times real time", "jsbsim_times_real_time"),
        ("whole world, flights a second", "flights_per_s"),
        ("campaign, flights a second and core", "campaign_flights_per_s"),
        ("JSBSim, flights a second", "jsbsim_flights_per_s"),
        ("RocketPy, ascents without control, a second", "rocketpy_ascents_per_s"),
    ]
    for label, key in rows:
        row = result[key]
        figures = "".join(f"{row[column]:10.1f}" for column in ("median", "mean", "lowest", "highest"))
        print(f"{label:44}{figures}{100 * row['cv']:7.1f}%")
    flight = result["jsbsim_flight"]
    print(f"\nFantail is {result['ratio']:.0f} times as fast as JSBSim (medians of this run).")
    print(
        f"JSBSim's flight: apogee {flight['apogee_m']:.1f} m (421.5 expected), {flight['max_speed_m_s']:.1f} m/s (82.2);\n"
        f"roll held at {flight['hold_0_deg']:.2f} deg (expected R + u_d/kp = -9.80), then at "
        f"{flight['hold_minus_20_deg']:.2f} (-29.80)."
    )
    print(f"RocketPy's ascent: apogee {result['rocketpy_apogee_m']:.1f} m, two degrees off the vertical in 5 m/s of wind.")
    log_speed.show(result["flight_log"])
    identify_speed.show(result["identification"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--json", action="store_true", help="one object on standard output")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    result = measure(arguments.folder, arguments.rounds)
    if arguments.json:
        print(json.dumps(result, indent=2))
    else:
        show(result)
    if result["disagreements"]:
        sys.exit("bench_speed: the answers differ: " + "; ".join(result["disagreements"]))


if __name__ == "__main__":
    main()
