# SPDX-License-Identifier: MIT
from __future__ import annotations

import csv
import functools
import gzip
import os
from collections.abc import Sequence
from typing import Any, Optional

import numpy as np

from . import _arguments, _changes, _core, _verbs
from ._log import Path
from ._scenario import Name

_TYPES = {"run": np.uint64, "seed": np.uint64, "outcome": str, "failed_by": str, "note": str}


class Campaign:
    """The runs of a campaign, or of a shard of one: each column has one value per run."""

    def __init__(self, said: dict[str, Any], folder: str) -> None:
        #: The folder with runs.csv.gz, campaign.json and, for a whole campaign, summary.json, campaign.html and the flight
        #: reports of its worst runs.
        self.folder = folder
        #: summary.json as a dict; None for a shard.
        self.summary: Optional[dict[str, Any]] = None if "shard" in said else said
        with gzip.open(os.path.join(folder, "runs.csv.gz"), "rt", encoding="utf-8", newline="") as table:
            names, *self._rows = csv.reader(table)
        self.columns = names[:names.index("note") + 1]  # then the check of its row

    @property
    def quantities(self) -> list[str]:
        """The names of the columns with drawn quantities."""
        return self.columns[self.columns.index("seed") + 1:self.columns.index("outcome")]

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, name: str) -> np.ndarray:
        """A read-only column, as in runs.csv.gz; NaN where a run has no such figure."""
        if name not in self.columns:
            raise KeyError(_changes.unknown(name, self.columns))
        place, kind = self.columns.index(name), _TYPES.get(name, float)
        values = np.array([row[place] if kind is str else kind(row[place] or "nan") for row in self._rows], dtype=kind)
        values.setflags(write=False)
        return values

    def __repr__(self) -> str:
        said = "one shard of it" if self.summary is None else self.summary["sentence"]
        return f"<fantail.Campaign of {len(self)} runs in {self.folder}: {said}>"

    def to_pandas(self) -> Any:
        """A DataFrame of all columns; needs pandas."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in self.columns})


@functools.wraps(_verbs.functions["campaign"])
def campaign(scenario: Name, set: Optional[_changes.Changes] = None, *, out: Path, **options: Any) -> Campaign:  # noqa: A002
    said = _verbs.functions["campaign"](scenario, set, out=out, **options)
    return Campaign(said, _arguments.folder("out", out))


campaign.__doc__ = (campaign.__doc__ or "").replace(
    "Returns the output of `fantail campaign --json` as a dict. Files are kept if `out` names a folder.",
    "Returns the runs, with the output of `fantail campaign --json` as `summary`. Its files are kept in the folder `out`.")


def merge_campaign(shards: Sequence[Path], out: Path) -> int:
    """Merges the folders of all shards of one campaign, with the same bytes as one flown whole. Returns its runs.

    Then `campaign()` with the same arguments, without `shard`, flies nothing and makes the summary. Raises ValueError.
    """
    folders = [_arguments.folder("shards", shard) for shard in _arguments.several("shards", shards, "folders")]
    return _core.merge_shards(folders, _arguments.folder("out", out))
