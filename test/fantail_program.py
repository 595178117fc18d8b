# SPDX-License-Identifier: MIT
"""The programs, for the tests of what is written in Python."""
import os
import subprocess

import pytest


class Program:
    def run(self, *words, cwd=None, **environment):
        return subprocess.run([os.environ["FANTAIL_PROGRAM"], *map(str, words)], cwd=cwd, capture_output=True, check=False,
                              env=os.environ | environment, text=True)

    def refusal(self, *words):
        """What it says on standard error, without its own name."""
        said = self.run(*words)
        assert said.returncode != 0
        return said.stderr.removeprefix("fantail: ").removesuffix("\n").removesuffix(" (see --help)")


@pytest.fixture(scope="session")
def program():
    return Program()
