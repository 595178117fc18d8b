# SPDX-License-Identifier: MIT
"""Threads of one program write into one folder at once: the result of one of them is there, whole."""

import hashlib
import json
import threading

import fantail

ROUNDS = 10


def test_threads_leave_one_whole_result(tmp_path):
    flights = fantail.fly_many("tasha3_launch2", seeds=[1, 2])
    for number in range(ROUNDS):
        folder = tmp_path / str(number)
        failures = []

        def write(flight, folder=folder, failures=failures):
            try:
                flight.write(folder)
            except Exception as error:  # noqa: BLE001  any is one too many
                failures.append(error)

        threads = [threading.Thread(target=write, args=(flight,)) for flight in flights]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert not failures
        assert not [path.name for path in folder.iterdir() if path.name.startswith(".")]
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        log = (folder / "flight.ftl").read_bytes()
        assert hashlib.sha256(log).hexdigest() == summary["log_sha256"], f"round {number}: a mixture"
