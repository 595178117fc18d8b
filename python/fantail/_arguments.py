# SPDX-License-Identifier: MIT
"""What arguments of the functions must be, beyond what the programs' own code refuses."""
from __future__ import annotations

import numbers
import os
from collections.abc import Iterable
from typing import Any, Optional, Union


def in_range(name: str, value: Any, least: float, most: float) -> None:
    """A whole number where both ends are; None is nobody's choice."""
    if value is None:
        return
    whole = isinstance(least, int) and isinstance(most, int)
    if not isinstance(value, numbers.Integral if whole else numbers.Real):
        raise ValueError(f"{name} = {value!r}; allowed: a {'whole ' if whole else ''}number, {least} to {most}")
    if not least <= value <= most:
        raise ValueError(f"{name} = {value}; allowed: {least} to {most}")


def folder(name: str, value: Union[str, os.PathLike[str]]) -> str:
    """An empty name would be the folder that one happens to be in."""
    text = os.fspath(value)
    if not text:
        raise ValueError(f"{name}: it is empty")
    return text


def several(name: str, values: Optional[Iterable[Any]], what: str) -> list[Any]:
    """A text is no list, though Python would take it for one of letters."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise ValueError(f"{name} = {values!r}; allowed: a list of {what}")
    return list(values)
