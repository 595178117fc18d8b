# SPDX-License-Identifier: MIT
"""What a row of the table of proofs is."""

import dataclasses
import re


@dataclasses.dataclass(frozen=True)
class Bug:
    says: str
    file: str  # below firmware/
    text: str  # stands in it exactly once
    replacement: str


@dataclasses.dataclass(frozen=True, eq=False)
class Proof:
    name: str
    says: str  # the requirement, in one sentence
    harness: str
    places: int  # its REACHABLE(1 ...) to this
    bugs: tuple
    options: tuple = ("--unwind", "5")
    stubs: tuple = ()  # folders that are searched before the sources
    checks: bool = False  # the prover's own, too: array bounds, pointers, division by zero
    refuted_by: tuple = ("claim: ",)  # how the violated property of a seeded bug begins
    quick: bool = False
    seconds: int = 120  # of the processor, for each run
    megabytes: int = 3000  # of address space

    def claims(self, folder):
        """How many its harness has: the prover must have looked at each."""
        return len(re.findall(r"^\s*CLAIM\(", (folder / self.harness).read_text(), re.MULTILINE))


# The harness looks at private members.
INSIDE = ("--unwind", "5", "-f", "no-access-control")
# Each claim by itself, with what it depends on: of many claims over many numbers that is quicker than all of them at once.
EACH_ALONE = ("--multi-property",)
