# SPDX-License-Identifier: MIT
"""One slip in one file."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    begin: int  # of the bytes that are replaced
    end: int
    replacement: str
    operator: str
    line: int
    column: int
    function: str  # that encloses it; empty at the level of a namespace or class
    was: str  # the lines that it changes, with single spaces
    now: str
    last_line: int = 0  # that it changes
    early: bool = False  # whether the compiler may have computed it before any test runs

    @property
    def id(self):
        return f"{self.file}:{self.line}:{self.column}:{self.operator}"

    def of(self, text):
        """The mutated text of the file whose bytes are `text`."""
        return text[: self.begin] + self.replacement.encode() + text[self.end :]
