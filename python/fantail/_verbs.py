# SPDX-License-Identifier: MIT
"""Every verb of the programs that answers with --json, as a function, made from the options that its program declares."""
from __future__ import annotations

import contextlib
import inspect
import json
import keyword
import numbers
import os
import tempfile
import textwrap
import warnings
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from . import _arguments, _changes, _core
from ._flight import Flight
from ._scenario import Scenario

_UNITS = {"S", "M", "M2", "KG_M2", "M/S", "KG/M3", "DEG", "DEG/S", "RPM", "PERCENT"}
_OLD_NAMES = {"windows": "window", "reference_area_m2": "area_m2"}
_OF_A_TERMINAL = {"--help", "--color", "--json"}


def _name(row: dict[str, Any]) -> str:
    """The name of the argument, with its unit."""
    name = row["name"].lstrip("-").lower() + (f"_{row['value'].lower()}" if row["value"] in _UNITS else "")
    name = name.replace("-", "_").replace("/", "_")
    return name + "_" if keyword.iskeyword(name) else name


class _Call:
    """The words of a command line, and temporary folders that are deleted with it."""

    def __init__(self, folders: contextlib.ExitStack) -> None:
        self._folders = folders
        self.words: list[str] = []

    def folder(self) -> str:
        return self._folders.enter_context(tempfile.TemporaryDirectory())

    def add(self, row: dict[str, Any], name: str, value: Any) -> None:
        if value is None or value is False or (name == "threads" and value == 0):
            return
        if isinstance(value, Scenario):
            self.words += [value._core.source, *(word for change in value._core.changes for word in ("--set", change))]
            self.words += ["--seed", value._core.seed_text] if value._core.seed_text else []
            return
        option = row["name"] if row["name"].startswith("-") else ""
        for text in self._texts(row, name, value) if row["value"] else [""]:
            self.words += [f"{option}={text}"] if option and text.startswith("-") else [word for word in (option, text) if word]

    def _texts(self, row: dict[str, Any], name: str, value: Any) -> list[str]:
        if isinstance(value, Mapping) and not isinstance(value, Flight):
            return _changes.words(value)
        several = row["repeated"] and isinstance(value, Iterable) and not isinstance(value, (str, os.PathLike, Flight))
        return [self._text(name, each) for each in (value if several else [value])]

    def _text(self, name: str, value: Any) -> str:
        if isinstance(value, (tuple, list)):  # 1:1.6, of a shard 3/8
            return ("/" if name == "shard" else ":").join(self._text(name, each) for each in value)
        if isinstance(value, Flight):
            return value._folder
        if isinstance(value, numbers.Number):
            return _changes.text(name, value).removesuffix(".0")
        return _arguments.folder(name, value)


def _call(verb: str, rows: dict[str, dict[str, Any]], values: Mapping[str, Any]) -> dict[str, Any]:
    with contextlib.ExitStack() as folders:
        call = _Call(folders)
        for name, value in values.items():
            call.add(rows[name], name, value)
        if values.get("out") is None and "out" in rows and rows["out"]["is_folder"]:
            call.words += ["--out", call.folder()]
        try:
            printed, said = _core.run_verb(verb, [*verb.split()[1:], *call.words, "--json"])
        except ValueError as error:
            raise ValueError(str(error).removesuffix(" (see --help)")) from None
    for line in said:
        if line.startswith("fantail: "):
            warnings.warn(line.removeprefix("fantail: ").removeprefix("warning: ").strip(), stacklevel=3)
    return json.loads(printed)


def _parameter(name: str, row: dict[str, Any]) -> inspect.Parameter:
    is_option = row["name"].startswith("-") and name not in ("set", "seed")
    usual = inspect.Parameter.empty if row["required"] else False if row["value"] == "" else None
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY if is_option else inspect.Parameter.POSITIONAL_OR_KEYWORD,
                             default=usual)


def _line(name: str, row: dict[str, Any]) -> str:
    more = "; ".join(part for part in (row["allowed"], f"usually {row['usual']}" if row["usual"] else "") if part)
    return textwrap.fill(f"{name}: {row['meaning']}" + (f" ({more})" if more else ""), 100, subsequent_indent="    ")


def _function(verb: str, meaning: str, rows: list[dict[str, Any]]) -> Callable[..., dict[str, Any]]:
    named: dict[str, dict[str, Any]] = {}
    for row in rows:
        if row["name"] not in _OF_A_TERMINAL:
            named[_name(row) + ("_" if _name(row) in named else "")] = row  # of compare, A and --a
    first = sorted(named, key=lambda name: (named[name]["name"].startswith("-"), name != "set", name != "seed"))
    parameters = [_parameter(name, named[name]) for name in first]
    signature = inspect.Signature(parameters, return_annotation=dict[str, Any])

    def function(*args: Any, **kwargs: Any) -> dict[str, Any]:
        given = {_OLD_NAMES.get(name, name): value for name, value in kwargs.items()}
        return _call(verb, named, signature.bind(*args, **given).arguments)

    function.__name__ = function.__qualname__ = verb.replace(" ", "_")
    function.__doc__ = (f"{meaning}.\n\nReturns the output of `fantail {verb} --json` as a dict. Files are kept if `out` names a folder. "
                        "Raises ValueError.\n\n" + "\n".join(_line(name, named[name]) for name in first))
    function.__signature__ = signature  # type: ignore[attr-defined]
    return function


functions = {verb.replace(" ", "_"): _function(verb, meaning, rows) for verb, meaning, rows in _core.verbs()}
