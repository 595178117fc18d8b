# SPDX-License-Identifier: MIT
"""Campaigns on Dask's workers, separate processes that talk over TCP."""
import concurrent.futures
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

OPTIONS = {"runs": 384, "set": {"controller.canard_limit_deg": 5}}
SHARDS = 2


@pytest.fixture(scope="module")
def client():
    with dask_campaign.local_cluster(2) as cluster, distributed.Client(cluster) as client:
        yield client


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The folder of the campaign flown as one, without Dask."""
    return pathlib.Path(fantail.campaign("tasha3_launch2", **OPTIONS, out=tmp_path_factory.mktemp("one") / "whole").folder)


def same(folder, whole):
    return all((folder / name).read_bytes() == (whole / name).read_bytes()
               for name in ("runs.csv.gz", "campaign.json", "summary.json"))


def kill_who_flies(client, chunks):
    """Kills the worker of shard 1 as soon as it has stored a part of it."""
    until = time.monotonic() + 60
    while not list(chunks.glob("*.csv.gz")):
        assert time.monotonic() < until, "no part of the shard was stored"
        time.sleep(0.01)
    flies, = (worker for worker, keys in client.processing().items() if any("shard_1_" in str(key) for key in keys))
    os.kill(client.run(os.getpid, workers=[flies])[flies], signal.SIGKILL)


def test_a_campaign_on_dask_is_the_campaign_flown_as_one_although_a_worker_is_killed(client, whole, tmp_path):
    with concurrent.futures.ThreadPoolExecutor() as pool:
        flown = pool.submit(dask_campaign.campaign, client, "tasha3_launch2", tmp_path, SHARDS, **OPTIONS)
        kill_who_flies(client, tmp_path / "shard_1/chunks")
        assert flown.result(60).summary["runs"] == OPTIONS["runs"]
    assert same(tmp_path / "whole", whole)
    retried = client.run_on_scheduler(lambda dask_scheduler: [
        what for key, *what in dask_scheduler.transition_log if "shard_1_" in key and "processing" in what[0]])
    assert len(retried) == 2, retried


def test_a_shard_that_is_done_twice_is_flown_once(client, tmp_path):
    options = {"runs": 2}
    shard = client.submit(dask_campaign.fly_shard, "tasha3_launch2", options, 1, 2, tmp_path, pure=False).result()
    before = {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in shard.rglob("*") if path.is_file()}
    assert shard / "runs.csv.gz" in before
    assert client.submit(dask_campaign.fly_shard, "tasha3_launch2", options, 1, 2, tmp_path, pure=False).result() == shard
    assert before == {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in shard.rglob("*") if path.is_file()}


def test_the_example_runs_from_the_command_line(tmp_path):
    said = subprocess.run([sys.executable, EXAMPLES / "dask_campaign.py", "tasha3_launch2", "out", "--runs", "4", "--shards", "2"],
                          cwd=tmp_path, capture_output=True, text=True, check=True)
    assert said.stdout == (f"{fantail.campaign('tasha3_launch2', runs=4, out=tmp_path / 'out/whole').summary['sentence']}\n"
                           f"the page is {tmp_path}/out/whole/campaign.html\n")
    assert said.stderr == ""


def test_what_the_campaign_refuses_is_said_in_its_words(tmp_path):
    said = subprocess.run([sys.executable, EXAMPLES / "dask_campaign.py", "no_such_rocket", "out", "--runs", "4"],
                          cwd=tmp_path, capture_output=True, text=True, check=False)
    assert said.returncode == 2 and "no_such_rocket" in said.stderr.splitlines()[-1]
    assert not (tmp_path / "out/whole").exists()
