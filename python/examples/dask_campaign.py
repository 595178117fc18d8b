# SPDX-License-Identifier: MIT
"""Flies a campaign on Dask: its shards as tasks, merged when all are there.

Usage: dask_campaign.py SCENARIO OUT [--runs N] [--shards N] [--scheduler ADDRESS] [--workers N]

Without --scheduler it starts a cluster on this machine: a scheduler and worker processes that talk over TCP. On many
machines the folder OUT must be one that all of them see. Needs distributed 2026.8.0.
"""
import argparse
import contextlib
import math
import pathlib

import distributed

import fantail

RUNS_OF_A_PART = 64  # a shard has one at least


def fly_shard(scenario, options, number, shards, out):
    """One shard, on one core. Called again after its worker has died, it goes on from what is stored; when it is flown
    already, it flies nothing. Two at once are refused by a lock on the folder. A refusal is returned: of one that is
    raised Dask prints a traceback."""
    folder = out / f"shard_{number}"
    try:
        fantail.campaign(scenario, **options, shard=(number, shards), threads=1, out=folder)
    except (ValueError, OSError) as refused:
        return refused
    return folder


def campaign(client, scenario, out, shards, **options):
    """fantail.campaign(scenario, out=out / "whole", **options), flown on the workers of a Dask client."""
    out = pathlib.Path(out).absolute()
    tasks = [client.submit(fly_shard, scenario, options, number, shards, out, key=f"shard_{number}_{out}", pure=False)
             for number in range(1, shards + 1)]
    folders = client.gather(tasks)
    for refused in folders:
        if isinstance(refused, Exception):
            raise refused
    fantail.merge_campaign(folders, out / "whole")
    return fantail.campaign(scenario, **options, out=out / "whole")  # flies nothing: makes the summary and the page


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenario", help="a shipped name, or a path that every worker can read")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--shards", type=int, default=4, help="number of parts, each of at least 64 runs; several for each worker")
    parser.add_argument("--scheduler", help="address of a running cluster, for example tcp://10.0.0.1:8786")
    parser.add_argument("--workers", type=int, default=2, help="processes on this machine, without --scheduler")
    options = parser.parse_args()
    for name in ("runs", "shards", "workers"):
        if getattr(options, name) < 1:
            parser.error(f"--{name} {getattr(options, name)}; allowed: 1 or more")
    parts = math.ceil(options.runs / RUNS_OF_A_PART)
    if options.shards > parts:
        parser.error(f"--shards {options.shards}; allowed: 1 to {parts}, because {options.runs} runs are flown by "
                     f"{RUNS_OF_A_PART} together")
    with contextlib.ExitStack() as stack:
        try:
            fantail.Scenario.load(options.scenario)  # a mistake in its name needs no cluster
        except ValueError as refused:
            parser.error(str(refused))
        address = options.scheduler or stack.enter_context(local_cluster(options.workers))
        try:
            client = stack.enter_context(distributed.Client(address))
        except (ValueError, OSError) as refused:
            parser.error(f"--scheduler {address}: {refused}")
        try:
            flown = campaign(client, options.scenario, options.out, options.shards, runs=options.runs)
        except (ValueError, OSError) as refused:
            parser.error(str(refused))
    print(flown.summary["sentence"])
    print(f"the page is {flown.folder}/campaign.html")


def local_cluster(workers):
    """A scheduler and worker processes, one thread each, that talk over TCP on this machine."""
    return distributed.LocalCluster(n_workers=workers, threads_per_worker=1, host="127.0.0.1", protocol="tcp://",
                                    dashboard_address="127.0.0.1:0")


if __name__ == "__main__":  # each worker process imports this file
    main()
