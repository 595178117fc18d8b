# SPDX-License-Identifier: MIT
"""fantail.files without the rest of the package, as the programs have it."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "python/fantail"))
import files  # noqa: E402,F401
