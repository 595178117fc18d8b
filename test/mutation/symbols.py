# SPDX-License-Identifier: MIT
"""What the symbols of an object say of it."""

import re

from workshop import ToolFailure, tool


def defined_functions(obj, function):
    """The symbols of the inline functions of this name that the object has a copy of."""
    code, text = tool(["nm", "-C", "--defined-only", str(obj)], None, "nm")
    if code != 0:
        raise ToolFailure(f"nm {obj}: {text[-500:]}")
    word = re.compile(rf"(?<![\w~]){re.escape(function)}(?!\w)")
    return {line[19:] for line in text.splitlines() if line[17:18] in "WVu" and word.search(line)}


def exports_data(obj):
    """Whether other files see data of this object, so that they need not call it to notice a change."""
    code, text = tool(["nm", "--defined-only", "--extern-only", str(obj)], None, "nm")
    if code != 0:
        raise ToolFailure(f"nm {obj}: {text[-500:]}")
    return re.search(r"^\w* [BDGRSVu] ", text, re.M) is not None


def fewest(symbols_of):
    """Object -> symbols: few objects that have all of the symbols between them."""
    left, chosen = set().union(*symbols_of.values()), []
    while left:
        best = max(symbols_of, key=lambda o: (len(symbols_of[o] & left), o))
        chosen.append(best)
        left -= symbols_of[best]
    return chosen
