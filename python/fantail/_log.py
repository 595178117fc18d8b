# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
import json
import os
from collections.abc import Iterator, Sequence
from typing import Any, Optional, Union

import numpy

from . import _arguments, _changes, _core
from ._flight import Flight
from ._plan import Plan

Path = Union[str, "os.PathLike[str]"]


class LoggedFlight:
    """One flight of a log as the avionics recorded it. Times are seconds since its power-up."""

    def __init__(self, core: _core.LoggedFlight, log: str) -> None:
        self._core = core
        self._log = log

    @property
    def number(self) -> int:
        """Its number in its file, from 1."""
        return self._core.number

    @property
    def vehicle(self) -> str:
        return self._core.vehicle

    @property
    def firmware_version(self) -> str:
        return self._core.firmware_version

    @property
    def plan(self) -> Optional[Plan]:
        """The flight plan that flew; None if it cannot be used."""
        return None if self._core.plan is None else Plan(self._core.plan)

    @property
    def ticks(self) -> int:
        """The number of recorded ticks."""
        return self._core.ticks

    @property
    def from_s(self) -> float:
        return self._core.from_s

    @property
    def to_s(self) -> float:
        return self._core.to_s

    @property
    def intact(self) -> bool:
        return self._core.intact

    @property
    def integrity(self) -> str:
        """The same in words: how many records are present and missing."""
        return self._core.integrity

    @property
    def events(self) -> list[tuple[float, str]]:
        """Time (s) and text of each event."""
        return self._core.events

    def inputs(self) -> list[_core.Inputs]:
        """Inputs of the control law, one per tick."""
        return self._core.inputs()

    def commands_rad(self) -> numpy.ndarray:
        """The recorded roll commands, float32, one per tick."""
        return self._core.commands_rad()

    def autopilot(self) -> tuple[_core.Autopilot, int]:
        """The control law as it was on board, and the index of the tick whose inputs it needs first."""
        return self._core.autopilot(self._log)

    def __repr__(self) -> str:
        return f"<fantail.LoggedFlight {self.number} of {self._log}: {self.integrity}>"


class Log(Sequence):
    """The flights in a flight log."""

    def __init__(self, core: _core.Log) -> None:
        self._core = core

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def intact(self) -> bool:
        """All records are present and undamaged, with nothing between them."""
        return self._core.intact

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        return LoggedFlight(self._core.flight(range(len(self))[index]), self.name)

    def __iter__(self) -> Iterator[LoggedFlight]:
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"<fantail.Log {self.name}: {len(self)} flight{'' if len(self) == 1 else 's'}>"


@dataclasses.dataclass(frozen=True)
class Replay:
    """The recorded inputs of a flight, run through the control code again."""

    equal: bool  #: every output byte of every replayed tick is as recorded
    ticks: int  #: on record
    compared: int
    unreachable: int  #: ticks that no recorded state of the law leads to
    differing: int
    first_difference: Optional[dict[str, Any]]
    flight: Flight  #: as replayed, without truth


def read_log(path: Path) -> Log:
    """A flight log (.ftl), or a folder with a flight.ftl. Raises ValueError if it is not one; the readable part of a
    damaged log is read."""
    return Log(_core.Log.read(_arguments.path("path", path)))


def read_flight(path: Path) -> Flight:
    """A flight on the disk: a log (.ftl), a table with columns of flight.csv, or a folder of `fantail fly`.
    Raises ValueError."""
    return Flight(_core.read_flight(_arguments.path("path", path)))


def replay(log: Union[Log, LoggedFlight, Path], set: Optional[_changes.Changes] = None) -> Replay:  # noqa: A002
    """Replays a recorded flight, the only one of its log.

    `set` changes values of its plan. Then the differences are the effect of the change on the commands in open loop:
    the recorded sensors do not react to it, so only its immediate effect is what would have flown.
    """
    if not isinstance(log, LoggedFlight):
        log = log if isinstance(log, Log) else read_log(log)
        if len(log) != 1:
            raise ValueError(f"{log.name} contains {len(log)} flights; choose one: replay(log[0]) to replay(log[-1])")
        log = log[0]
    result, flown = log._core.replay(log._log, _changes.words(set))
    return Replay(**json.loads(result), flight=Flight(flown))
