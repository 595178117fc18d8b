# SPDX-License-Identifier: MIT
"""Changes of a scenario or a plan, as in `--set`."""
from __future__ import annotations

import difflib
import json
import numbers
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union

from . import _arguments

Value = Union[bool, int, float, str, Sequence[Any]]
Changes = Mapping[str, Value]

# What cannot be anything but a word stands without quotes, as on the command line.
_WORD = re.compile(r"(?!(true|false|inf|nan)$)[A-Za-z_./~][\w./~ +-]*(?<! )")


def text(name: str, value: Any, *, in_list: bool = False) -> str:
    if isinstance(value, str):
        _arguments.utf8(name, value)
        return value if _WORD.fullmatch(value) and not in_list else json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):  # numpy's, too
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        if not -2**63 <= value < 2**63:  # the whole numbers of TOML
            raise ValueError(f"{name} = {value} does not fit into 64 bits; allowed: a float, or -2**63 to 2**63 - 1")
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))  # the shortest that is the same number again
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)) and not in_list:
        return "[" + ", ".join(text(name, each, in_list=True) for each in value) + "]"
    raise TypeError(f"{name}: {type(value).__name__}; allowed: a number, a bool, a str, or a list of one of these")


def unknown(name: object, known: Iterable[str]) -> str:
    """An error message, with the name that was probably meant."""
    meant = difflib.get_close_matches(str(name), list(known), n=1)
    return f"{name!r} does not exist" + (f"; did you mean {meant[0]}?" if meant else "")


def words(changes: Changes | None) -> list[str]:
    """Each as `section.key=value`. Numbers keep every bit."""
    return [f"{_arguments.utf8('set', str(name))}={text(name, value)}" for name, value in (changes or {}).items()]
