# SPDX-License-Identifier: MIT
"""The programs, to compare the package with."""
import csv

import pytest
from fantail_program import program  # noqa: F401  a fixture


@pytest.fixture(scope="session")
def flown(program, tmp_path_factory):
    """The folder of a flight that the program has flown."""
    folder = tmp_path_factory.mktemp("flown") / "wide"
    said = program.run("fly", "tasha3_launch2", "--set", "controller.canard_limit_deg=9", "--seed", "7", "--out", folder)
    assert said.returncode == 0, said.stderr
    return folder


@pytest.fixture(scope="session")
def table(flown):
    """Its flight.csv: the columns as texts."""
    with open(flown / "flight.csv", newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, zip(*rows)))
