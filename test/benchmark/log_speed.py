# SPDX-License-Identifier: MIT
"""Reading the log of one flight: Fantail, pyulog and LCM's log reader, each its own format of the same ticks."""

import pathlib
import subprocess
import tempfile
import time

import lcm
import pyulog

READERS = {"pyulog": "pyulog, the ULog of it", "lcm": "LCM's log reader, the LCM log of it"}


def write_logs(folder):
    """A folder that lasts as long as what is returned."""
    logs = tempfile.TemporaryDirectory(prefix="fantail_logs_")
    subprocess.run([pathlib.Path(folder) / "write_logged_flight", logs.name], check=True)
    return logs


def read_ulog(path):
    return sum(len(data.data["timestamp"]) for data in pyulog.ULog(str(path)).data_list)


def read_lcm(path):
    return sum(1 for _ in lcm.EventLog(str(path), "r"))


def measure(logs, reader):
    """Seconds of CPU time and what was found; the bytes are in the page cache by then."""
    name, read = {"pyulog": ("flight.ulg", read_ulog), "lcm": ("flight.lcmlog", read_lcm)}[reader]
    path = pathlib.Path(logs.name) / name
    begin = time.process_time()
    records = read(path)
    return {"seconds": time.process_time() - begin, "records": records, "bytes": path.stat().st_size}


def results(fantail, peers, summary):
    def rates(name, counter, scale):
        return summary([scale * sample[counter] for sample in fantail[name]])

    table = {
        "write_ns_per_tick": rates("log_write", "time_per_tick", 1e9),
        "check_mb_per_s": rates("log_check", "bytes_per_s", 1e-6),
        "read_mb_per_s": rates("log_read", "bytes_per_s", 1e-6),
        "read_ticks_per_s": rates("log_read", "ticks_per_s", 1.0),
        "replay_ticks_per_s": rates("log_replay", "ticks_per_s", 1.0),
        "to_csv_s": rates("log_to_csv", "time_per_flight", 1.0),
    }
    for reader, samples in peers.items():
        table[reader] = {
            "records": samples[0]["records"],
            "mb_per_s": summary([1e-6 * each["bytes"] / each["seconds"] for each in samples]),
            "records_per_s": summary([each["records"] / each["seconds"] for each in samples]),
        }
    return table


def show(table):
    print("\nThe log of 30 s of flight, 1000 ticks a second; CPU time, medians")
    for label, key, form in (
        ("recording one tick                        ns", "write_ns_per_tick", "{:10.0f}"),
        ("finding and checking frames             MB/s", "check_mb_per_s", "{:10.0f}"),
        ("reading into ticks                      MB/s", "read_mb_per_s", "{:10.0f}"),
        ("reading into ticks                   ticks/s", "read_ticks_per_s", "{:10.0f}"),
        ("replaying, every output compared     ticks/s", "replay_ticks_per_s", "{:10.0f}"),
        ("from log to CSV, replay included           s", "to_csv_s", "{:10.3f}"),
    ):
        print(f"{label:48}{form.format(table[key]['median'])}")
    for reader, label in READERS.items():
        found = table[reader]
        print(
            f"{label:48}{found['mb_per_s']['median']:10.1f} MB/s, "
            f"{found['records_per_s']['median']:.0f} records/s of {found['records']}"
        )
