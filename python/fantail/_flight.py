# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import json
import os
import shutil
import tempfile
import weakref
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Optional, Union

import numpy

from . import _arguments, _changes, _core
from ._plan import Plan
from ._scenario import Name, Scenario, asked_for

_PHASES = numpy.array(_core.phase_names())


class Flight(Mapping):
    """A flown flight: its columns by name, `flight["roll_angle_deg"]`.

    The columns are those of flight.csv, a value a row, as read-only numpy arrays: float64, NaN where
    the value is unknown; bool for flags; words for `phase`. `time_s` is 0 at lift-off, in the tunnel at control start. The
    true_ columns hold values that only a simulator has. A column is made at its first use.
    """

    def __init__(self, core: _core.Flight) -> None:
        self._core = core
        self._columns: dict[str, numpy.ndarray] = {}

    @functools.cached_property
    def columns(self) -> tuple[str, ...]:
        """The names, in the order of flight.csv."""
        return tuple(self._core.column_names)

    def __getitem__(self, name: str) -> numpy.ndarray:
        if name not in self._columns:
            try:
                values = self._core.column(name)
            except ValueError as error:
                raise KeyError(str(error)) from None
            if name == "phase":
                values = _PHASES[values]
                values.setflags(write=False)
            self._columns[name] = values
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    @functools.cached_property
    def events(self) -> dict[str, Optional[float]]:
        """Times of the events in seconds on the clock of `time_s`; None: it did not happen, or is unknown."""
        return self._core.events

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        return json.loads(self._core.summary_json)

    @property
    def verdict(self) -> str:
        """The verdict on the flight, one sentence."""
        return self._core.verdict

    @property
    def notes(self) -> tuple[str, ...]:
        """Faults, assumptions and doubts, a sentence each."""
        return tuple(self._core.notes)

    @property
    def scenario(self) -> str:
        return self._core.scenario

    @property
    def vehicle(self) -> str:
        return self._core.vehicle

    @property
    def seed(self) -> Optional[int]:
        """The seed of a simulated flight."""
        return self._core.seed

    @property
    def plan(self) -> Optional[Plan]:
        """The flight plan that flew; None if it is unknown."""
        return Plan(self._core.plan) if self._core.knows_plan else None

    @property
    def log(self) -> bytes:
        """The avionics' own record: the content of flight.ftl. Empty if there is none."""
        return self._core.log

    def write(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Writes the files of `fantail fly` (flight.csv, summary.json, report.html, flight.ftl ...), all or none."""
        self._core.write(_arguments.folder("folder", folder))

    @functools.cached_property
    def _folder(self) -> str:
        """A folder with the files of the flight, for the verbs; deleted with the flight."""
        place = tempfile.mkdtemp()
        weakref.finalize(self, shutil.rmtree, place, True)
        folder = os.path.join(place, self.scenario)
        self.write(folder)
        return folder

    def to_pandas(self) -> Any:
        """A pandas.DataFrame of all columns. Needs pandas, which fantail does not install."""
        import pandas

        return pandas.DataFrame(dict(self))

    def __repr__(self) -> str:
        return f"<fantail.Flight {self.scenario}: {self.verdict}>"


def fly(scenario: Union[Scenario, Name], set: Optional[_changes.Changes] = None,  # noqa: A002  the word of the programs
        seed: Optional[int] = None) -> Flight:
    """Flies a scenario as `fantail fly` does; the result is the same byte for byte.

    `set` and `seed` as in `Scenario.load`. Other Python threads run meanwhile.
    """
    return Flight(_core.fly(asked_for(scenario, set, seed)._core))


def fly_many(scenarios: Union[Scenario, Name, Iterable[Union[Scenario, Name]]], seeds: Optional[Sequence[int]] = None,
             threads: int = 0, columns: Optional[Sequence[str]] = None) -> list[Flight]:
    """Flies several scenarios on several threads at once (0: as many as the machine has).

    One scenario with several `seeds` is flown once with each; several scenarios take one seed each. The results are in
    that order and do not depend on the number of threads. A whole flight takes about 10 MB; with `columns`, only these
    and the summary are kept. Other Python threads run meanwhile.
    """
    one = isinstance(scenarios, (Scenario, str, os.PathLike))
    all_scenarios = [each if isinstance(each, Scenario) else Scenario.load(each)
                     for each in ([scenarios] if one else scenarios)]
    if seeds is not None:
        seeds = _arguments.several("seeds", seeds, "seeds")
        all_scenarios *= len(seeds) if one else 1
        if len(seeds) != len(all_scenarios):
            raise ValueError(f"seeds: {len(seeds)} for {len(all_scenarios)} scenarios; allowed: the same number of both")
        all_scenarios = [each.changed(seed=seed) for each, seed in zip(all_scenarios, seeds)]
    kept = None if columns is None else _arguments.several("columns", columns, "names")
    _arguments.in_range("threads", threads, 0, 1024)
    return [Flight(core) for core in _core.fly_many([each._core for each in all_scenarios], kept, threads)]
