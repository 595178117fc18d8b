# SPDX-License-Identifier: MIT
from __future__ import annotations

import dataclasses
import functools
import json
import os
from collections.abc import Iterator, Mapping
from typing import Any, Optional, Union

from . import _arguments, _changes, _core


@dataclasses.dataclass(frozen=True)
class PlanField:
    """One row of the table from which plans, their manual and the firmware are made."""

    section: str
    key: str
    kind: str  #: "number", "integer", "choice" or "flag"
    unit: str  #: of the value, here and in files; empty for a pure number
    minimum: Optional[float]  #: smallest allowed number or integer
    maximum: Optional[float]
    choices: tuple[str, ...]  #: of a choice
    default: Any  #: for each value, if there are several
    slots: int  #: 1; 4: one per canard; the longest list
    is_list: bool
    meaning: str

    @property
    def name(self) -> str:
        return f"{self.section}.{self.key}"


class Plan(Mapping):
    """A flight plan, with every number of the avionics: `plan["controller.canard_limit_deg"]`, or
    `plan.controller.canard_limit_deg`.

    Values have the units of their names; `fields` has range, default and meaning of each. A plan is immutable.
    """

    def __init__(self, core: _core.Plan) -> None:
        object.__setattr__(self, "_core", core)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name}: a plan is immutable; plan.changed() makes another")

    def __delattr__(self, name: str) -> None:
        self.__setattr__(name, None)

    @classmethod
    def load(cls, name_or_path: Union[str, os.PathLike[str]], set: Optional[_changes.Changes] = None) -> Plan:  # noqa: A002
        """A shipped plan or a file, with changes: {"section.key": value}. Raises ValueError."""
        return cls(_core.Plan.load(_arguments.path("name_or_path", name_or_path), _changes.words(set)))

    @functools.cached_property
    def fields(self) -> dict[str, PlanField]:
        """The description of every value, by its name."""
        return _fields()

    def changed(self, set: _changes.Changes) -> Plan:  # noqa: A002
        """A copy with some values changed; all others keep all their bits. Raises ValueError."""
        return Plan(self._core.changed(_changes.words(set)))

    @functools.cached_property
    def _values(self) -> dict[str, Any]:
        return {name: tuple(value) if isinstance(value, list) else value
                for name, value in json.loads(self._core.values_json).items()}

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            raise KeyError(_changes.unknown(name, self._values))
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __getattr__(self, section: str) -> Any:
        if section.startswith("_"):
            raise AttributeError(section)
        values = {field.key: self[name] for name, field in self.fields.items() if field.section == section}
        if not values:
            raise AttributeError(f"a plan has no section {section}")
        return _section(section)(**values)

    @property
    def block(self) -> bytes:
        """The block that is loaded into a board, as `fantail plan compile` writes it."""
        return self._core.block

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Plan) and self._core.block == other._core.block

    def __hash__(self) -> int:
        return hash(self._core.block)

    def __str__(self) -> str:
        """A plan file with every field."""
        return self._core.table

    def __repr__(self) -> str:
        return f"<fantail.Plan of {len(self)} values>"


def plan(name_or_path: Union[str, os.PathLike[str], None] = None,
         set: Optional[_changes.Changes] = None) -> Plan:  # noqa: A002  the word of the programs
    """A shipped plan or a file; without a name, all defaults."""
    if name_or_path is not None:
        return Plan.load(name_or_path, set)
    return Plan(_core.Plan.default().changed(_changes.words(set)))


@functools.cache
def _section(name: str) -> type:
    """A type for the values of one section, which cannot be assigned to."""
    keys = [field.key for field in _fields().values() if field.section == name]
    return dataclasses.make_dataclass(name, keys, frozen=True)


@functools.cache
def _fields() -> dict[str, PlanField]:
    rows = [PlanField(**{**row, "choices": tuple(row["choices"])}) for row in json.loads(_core.plan_fields_json())]
    return {row.name: row for row in rows}
