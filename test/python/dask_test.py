# SPDX-License-Identifier: MIT
"""Campaigns on Dask's workers, separate processes that talk over TCP."""
import concurrent.futures
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import distributed
import pytest

import fantail

EXAMPLES = pathlib.Path(__file__).parents[2] / "python/examples"
sys.path.insert(0, str(EXAMPLES))
import dask_campaign  # noqa: E402  an example, in no package

OPTIONS = {"runs": 192}  # three parts of 64: two of them for shard 2
SHARDS = 2
PATIENCE_S = 200  # other tests take most of a small machine


@pytest.fixture(scope="module")
def client():
    with dask_campaign.local_cluster(2) as cluster, distributed.Client(cluster) as client:
        yield client


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The folder of the campaign flown as one, without Dask."""
    return pathlib.Path(fantail.campaign("tasha3_launch2", **OPTIONS, out=tmp_path_factory.mktemp("one") / "whole").folder)


def kill_who_flies(client, campaign, parts):
    """Kills the worker of shard 2 as soon as it has stored a part of it."""
    until = time.monotonic() + PATIENCE_S
    while not list(parts.glob("*.part")):
        assert not campaign.done(), f"it ended before a part of the shard was seen: {campaign.exception()}"
        assert time.monotonic() < until, f"no part of the shard was stored; workers: {client.processing()}"
        time.sleep(0.01)
    flies, = (worker for worker, keys in client.processing().items() if any("shard_2_" in str(key) for key in keys))
    os.kill(client.run(os.getpid, workers=[flies])[flies], signal.SIGKILL)


@pytest.fixture(scope="module")
def flown(client, tmp_path_factory):
    """The folder of a campaign in which a worker was killed."""
    out = tmp_path_factory.mktemp("dask")
    with concurrent.futures.ThreadPoolExecutor() as pool:
        campaign = pool.submit(dask_campaign.campaign, client, "tasha3_launch2", out, SHARDS, **OPTIONS)
        kill_who_flies(client, campaign, out / "shard_2/parts")
        assert len(campaign.result(PATIENCE_S)) == OPTIONS["runs"]
    return out


def test_a_campaign_on_dask_is_the_campaign_flown_as_one_although_a_worker_was_killed(client, flown, whole):
    for name in ("runs.csv.gz", "campaign.json", "summary.json"):
        assert (flown / "whole" / name).read_bytes() == (whole / name).read_bytes(), name
    begun = client.run_on_scheduler(lambda dask_scheduler: [
        key for key, _, finish, *_ in dask_scheduler.transition_log if "shard_2_" in str(key) and finish == "processing"])
    assert len(begun) >= 2  # it was given out again: to the other worker, or to the one that took the place of the first


def files(folder):
    every = [path for path in folder.rglob("*") if path.is_file()]
    return {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in every}


def test_a_shard_that_is_done_twice_is_flown_once(client, flown):
    before = files(flown / "shard_2")
    assert flown / "shard_2/runs.csv.gz" in before
    again = client.submit(dask_campaign.fly_shard, "tasha3_launch2", OPTIONS, 2, SHARDS, flown, pure=False)
    assert again.result(PATIENCE_S) == flown / "shard_2"
    assert files(flown / "shard_2") == before


def run_example(*words, cwd):
    return subprocess.run([sys.executable, EXAMPLES / "dask_campaign.py", *words], cwd=cwd, capture_output=True, text=True,
                          check=False)


def test_the_example_runs_from_the_command_line_and_a_second_time_flies_nothing(flown, whole):
    before = [files(flown / f"shard_{number}") for number in range(1, SHARDS + 1)]
    said = run_example("tasha3_launch2", flown, "--runs", str(OPTIONS["runs"]), "--shards", str(SHARDS), cwd=flown)
    assert (said.returncode, said.stderr) == (0, "")
    summary = json.loads((whole / "summary.json").read_text(encoding="utf-8"))
    assert said.stdout == f"{summary['sentence']}\nthe page is {flown}/whole/campaign.html\n"
    assert [files(flown / f"shard_{number}") for number in range(1, SHARDS + 1)] == before


@pytest.mark.parametrize("words, complaint", [
    (["no_such_rocket"], 'no_such_rocket'), (["tasha3_launch2", "--shards", "0"], "--shards 0; allowed: 1 or more"),
    (["tasha3_launch2", "--runs", "0"], "--runs 0; allowed: 1 or more"),
    (["tasha3_launch2", "--runs", "129", "--shards", "4"], "--shards 4; allowed: 1 to 3, because 129 runs are flown by 64 together"),
    (["tasha3_launch2", "--scheduler", "nonsense://here"], "--scheduler nonsense://here: unknown address scheme"),
    (["tasha3_launch2", "--scheduler", "tcp://127.0.0.1:1"], "--scheduler tcp://127.0.0.1:1: Timed out")])
def test_what_makes_no_sense_is_refused_before_anything_is_started(words, complaint, tmp_path, monkeypatch):
    monkeypatch.setenv("DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT", "200ms")
    said = run_example(words[0], "out", *words[1:], cwd=tmp_path)
    assert said.returncode == 2 and complaint in said.stderr and "Traceback" not in said.stderr
    assert not (tmp_path / "out").exists()


def test_what_a_worker_refuses_is_said_without_a_traceback(tmp_path):
    (tmp_path / "out").write_text("no folder")
    said = run_example("tasha3_launch2", "out", "--runs", "64", "--shards", "1", cwd=tmp_path)
    assert said.returncode == 2 and "Traceback" not in said.stderr
    assert said.stderr.endswith(f"error: {tmp_path}/out/shard_1/parts: Not a directory\n")
