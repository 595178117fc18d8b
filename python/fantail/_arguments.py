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


def utf8(name: str, value: str) -> str:
    """Python keeps bytes of a name that are not UTF-8 as halves of characters, and no library takes those for text."""
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name} = {value!r}; allowed: text in UTF-8; rename the file if this is the name of one") from None
    return value


def path(name: str, value: Union[str, os.PathLike[str]]) -> str:
    """The name of a file, or of what is shipped."""
    return utf8(name, os.fsdecode(value))


def folder(name: str, value: Union[str, os.PathLike[str]]) -> str:
    """An empty name would be the folder that one happens to be in."""
    text = path(name, value)
    if not text:
        raise ValueError(f"{name}: it is empty")
    return text


def several(name: str, values: Optional[Iterable[Any]], what: str) -> list[Any]:
    """A text is no list, though Python would take it for one of letters."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise ValueError(f"{name} = {values!r}; allowed: a list of {what}")
    return list(values)
