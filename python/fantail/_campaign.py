# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import warnings
from collections.abc import Sequence
from typing import Any, Optional

import numpy as np

from . import _arguments, _changes, _core
from ._log import Path
from ._scenario import Name


class Campaign:
    """The runs of a campaign, one value a run in every column; those of a shard, where one was flown."""

    def __init__(self, core: Any, folder: str) -> None:
        self._core = core
        #: The folder with runs.csv.gz, campaign.json and, of a whole campaign, summary.json, campaign.html and the flight
        #: reports of its worst runs.
        self.folder = folder
        #: summary.json as a dict; None of a shard.
        self.summary: Optional[dict[str, Any]] = None if core.summary is None else json.loads(core.summary)

    @property
    def quantities(self) -> list[str]:
        """What was drawn: the names of its columns."""
        return self._core.quantities

    @property
    def columns(self) -> list[str]:
        return ["run", "seed", *self._core.quantities, "outcome", *self._core.figures, "note"]

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, name: str) -> np.ndarray:
        """A column, as in runs.csv.gz, that nobody can write to; NaN where a run has no such figure."""
        if name not in self.columns:
            raise KeyError(_changes.unknown(name, self.columns))
        of_its_own = {"run": self._core.runs, "seed": self._core.seeds, "outcome": self._core.outcomes, "note": self._core.notes}
        values = np.asarray(of_its_own[name]() if name in of_its_own else self._core.numbers(name))
        values.setflags(write=False)
        return values

    def __repr__(self) -> str:
        said = "one shard of it" if self.summary is None else self.summary["sentence"]
        return f"<fantail.Campaign of {len(self)} runs in {self.folder}: {said}>"

    def to_pandas(self) -> Any:
        """A DataFrame of all columns; needs pandas."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in self.columns})


def campaign(scenario: Name, set: Optional[_changes.Changes] = None, *, out: Path, runs: int = 1000,  # noqa: A002
             seed: Optional[int] = None, sampling: str = "independent", share: str = "outcome=held",
             at_least_percent: Optional[float] = None, until_within_percent: Optional[float] = None,
             until_decided: bool = False, shard: tuple[int, int] = (1, 1), threads: int = 0) -> Campaign:
    """Flies a scenario `runs` times over what its tables [[spread]] say is not known, on `threads` threads (0: all).

    What `fantail campaign` does, with the same files in the folder `out`; the arguments are those of its options. A call
    that was interrupted goes on when it is made again. `shard`: one part of so many, (3, 8). Raises ValueError.
    """
    for name, value, least, most in (("runs", runs, 1, 100_000_000), ("seed", seed, 0, 2**64 - 1),
                                     ("at_least_percent", at_least_percent, 0.0, 100.0),
                                     ("until_within_percent", until_within_percent, 0.1, 50.0),
                                     ("threads", threads, 0, 1024)):
        _arguments.in_range(name, value, least, most)
    out = _arguments.folder("out", out)
    if until_decided and at_least_percent is None:
        raise ValueError("until_decided needs at_least_percent")
    if not (isinstance(shard, (tuple, list)) and len(shard) == 2 and all(isinstance(each, int) for each in shard)
            and 1 <= shard[0] <= shard[1]):
        raise ValueError(f"shard = {shard!r}; allowed: (number, of), from (1, of) to (of, of)")
    request = _core.CampaignRequest()
    for name, value in {"scenario": _arguments.path("scenario", scenario), "changes": _changes.words(set), "runs": runs,
                        "seed": seed, "sampling": sampling, "share": _arguments.utf8("share", share),
                        "at_least": None if at_least_percent is None else at_least_percent / 100.0,
                        "until_within": None if until_within_percent is None else until_within_percent / 100.0,
                        "until_decided": until_decided, "shard": shard, "threads": threads,
                        "out": out}.items():
        setattr(request, name, value)
    flown = _core.fly_campaign(request)
    if flown.remark:
        warnings.warn(flown.remark, stacklevel=2)
    return Campaign(flown, out)


def merge_campaign(shards: Sequence[Path], out: Path) -> int:
    """Puts the folders of all shards of one campaign together: the bytes of the campaign flown as one. Returns its runs.

    Then `campaign()` with the same arguments, without `shard`, flies nothing and makes the summary. Raises ValueError.
    """
    folders = [_arguments.folder("shards", shard) for shard in _arguments.several("shards", shards, "folders")]
    return _core.merge_shards(folders, _arguments.folder("out", out))
