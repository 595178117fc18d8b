# SPDX-License-Identifier: MIT
import csv
import gzip
import json
import math

import pytest

import fantail

CHANGES = {"controller.canard_limit_deg": 5}


def test_a_campaign_is_the_programs(program, tmp_path):
    said = json.loads(program.run("campaign", "tasha3_launch2", "--runs", "70", "--set", "controller.canard_limit_deg=5",
                                  "--json", "--out", tmp_path / "program").stdout)
    flown = fantail.campaign("tasha3_launch2", CHANGES, runs=70, out=tmp_path / "python")
    ours = dict(flown.summary)
    assert ours.pop("made")["seed"] == said.pop("made")["seed"]
    assert ours == said
    for name in ("runs.csv.gz", "campaign.json"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes(), name

    with gzip.open(tmp_path / "program" / "runs.csv.gz", "rt") as table:
        rows = list(csv.DictReader(table))
    assert len(flown) == len(rows) == 70
    assert "aerodynamics.torque_m" in flown.quantities
    for name in flown.columns:
        ours = flown[name]
        for value, row in zip(ours, rows):
            if name in ("outcome", "failed_by", "note"):
                assert value == row[name]
            elif row[name] == "":
                assert math.isnan(value)
            else:
                assert value == float(row[name]) if name not in ("run", "seed") else value == int(row[name])
        with pytest.raises(ValueError, match="read-only"):
            ours[0] = ours[1]
    with pytest.raises(KeyError):
        flown["apogee"]


def test_shards_that_are_merged_are_the_whole(tmp_path):
    folders = [tmp_path / f"shard_{number}" for number in (1, 2)]
    for number, folder in enumerate(folders, 1):
        assert fantail.campaign("tasha3_launch2", runs=66, shard=(number, 2), out=folder).summary is None
    assert fantail.merge_campaign(folders, tmp_path / "merged") == 66
    merged = fantail.campaign("tasha3_launch2", runs=66, out=tmp_path / "merged")
    assert merged.summary["runs"] == 66
    with pytest.raises(ValueError, match="2 shards in all; missing: 2"):
        fantail.merge_campaign(folders[:1], tmp_path / "half")


@pytest.mark.parametrize("wrong, said", [
    ({"runs": 0}, '--runs: "0": allowed: 1 to 1e+08'), ({"sampling": "halton"}, 'sampling = "halton"; allowed: '),
    ({"share": "held"}, '"held" is not a question; allowed: outcome=held'), ({"shard": (3, 2)}, '"3/2" is not a shard; allowed'),
    ({"runs": 1.5}, "--runs"), ({"at_least_percent": "many"}, "--at-least"),
    ({"until_decided": True}, "--until-decided requires --at-least")])
def test_what_makes_no_sense_is_refused(wrong, said, tmp_path):
    with pytest.raises(ValueError) as refused:
        fantail.campaign("tasha3_launch2", **{"runs": 10, "out": tmp_path / "out", **wrong})
    assert said in str(refused.value)
    assert not (tmp_path / "out").exists()


def test_the_shards_are_a_list_and_no_text(tmp_path):
    with pytest.raises(ValueError, match="^shards = 'pcs'; allowed: a list of folders$"):
        fantail.merge_campaign("pcs", tmp_path / "whole")
    assert not (tmp_path / "whole").exists()
