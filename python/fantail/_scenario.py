# SPDX-License-Identifier: MIT
from __future__ import annotations

import operator
import os
import warnings
from typing import Optional, Union

from . import _arguments, _changes, _core
from ._plan import Plan

Name = Union[str, "os.PathLike[str]"]


class Scenario:
    """A vehicle, a flight plan and a world. Made by `Scenario.load`; immutable."""

    def __init__(self, core: _core.Scenario) -> None:
        self._core = core

    @classmethod
    def load(cls, name_or_path: Name, set: Optional[_changes.Changes] = None,  # noqa: A002  the word of the programs
             seed: Optional[int] = None) -> Scenario:
        """A shipped scenario or a file.

        `set` changes values of plan, vehicle or scenario: {"section.key": value}, in the units of the keys. `seed`: for
        all random streams, instead of the scenario's. Doubts about the files become a UserWarning. Raises
        ValueError.
        """
        return cls._load(_arguments.path("name_or_path", name_or_path), _changes.words(set), _seed_text(seed))

    @classmethod
    def _load(cls, source: str, words: list[str], seed: str) -> Scenario:
        core = _core.Scenario.load(source, words, seed)
        for warning in core.warnings:
            warnings.warn(warning, stacklevel=3)
        return cls(core)

    def changed(self, set: Optional[_changes.Changes] = None,  # noqa: A002
                seed: Optional[int] = None) -> Scenario:
        """A copy with further changes, which override earlier ones of the same value. Its files are read again."""
        return self._load(self._core.source, self._core.changes + _changes.words(set),
                          self._core.seed_text if seed is None else _seed_text(seed))

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def vehicle(self) -> str:
        """The name of the vehicle."""
        return self._core.vehicle

    @property
    def seed(self) -> int:
        """The seed of all random streams."""
        return self._core.seed

    @property
    def plan(self) -> Plan:
        """The flight plan, with the changes."""
        return Plan(self._core.plan)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Doubts about the files, a sentence each."""
        return tuple(self._core.warnings)

    def __repr__(self) -> str:
        return f"<fantail.Scenario {self.name}: {self.vehicle}, seed {self.seed}>"


def shipped_scenarios() -> list[str]:
    """The shipped names that `Scenario.load` accepts."""
    return _core.shipped_scenarios()


def data_folder() -> str:
    """The folder of the shipped files: the environment variable FANTAIL_DATA, or else that of this package."""
    return _core.data_folder()


def asked_for(scenario: Union[Scenario, Name], set: Optional[_changes.Changes],  # noqa: A002
              seed: Optional[int]) -> Scenario:
    if not isinstance(scenario, Scenario):
        return Scenario.load(scenario, set, seed)
    return scenario.changed(set, seed) if set or seed is not None else scenario


def _seed_text(seed: Optional[int]) -> str:
    if seed is None:
        return ""
    try:
        return str(operator.index(seed))
    except TypeError:
        raise ValueError(f"seed = {seed!r}; allowed: a whole number, 0 to {2**64 - 1}") from None
