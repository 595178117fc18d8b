# SPDX-License-Identifier: MIT
"""Checks of arguments, beyond those that the programs' own code makes."""
from __future__ import annotations

import numbers
import os
from collections.abc import Iterable
from typing import Any, Optional, Union


def in_range(name: str, value: Any, least: float, most: float) -> None:
    """A whole number if both bounds are whole; None means not given."""
    if value is None:
        return
    whole = isinstance(least, int) and isinstance(most, int)
    if not isinstance(value, numbers.Integral if whole else numbers.Real):
        raise ValueError(f"{name} = {value!r}; allowed: a {'whole ' if whole else ''}number, {least} to {most}")
    if not least <= value <= most:
        raise ValueError(f"{name} = {value}; allowed: {least} to {most}")


def utf8(name: str, value: str) -> str:
    """Python keeps bytes that are not UTF-8 as surrogates, which no library accepts as text."""
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name} = {value!r}; allowed: text in UTF-8; if this is the name of a file, rename it") from None
    return value


def path(name: str, value: Union[str, os.PathLike[str]]) -> str:
    """The name of a file, or a shipped name."""
    return utf8(name, os.fsdecode(value))


def folder(name: str, value: Union[str, os.PathLike[str]]) -> str:
    """An empty name would mean the current folder."""
    text = path(name, value)
    if not text:
        raise ValueError(f"{name}: it is empty")
    return text


def several(name: str, values: Optional[Iterable[Any]], what: str) -> list[Any]:
    """A text is not a list, although Python would iterate over its letters."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise ValueError(f"{name} = {values!r}; allowed: a list of {what}")
    return list(values)
