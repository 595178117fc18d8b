# SPDX-License-Identifier: MIT
"""repository.py LINES SECONDS OUT: what ./dev repository has checked, a line each with its verdict behind a tab, as figures.py reads it."""

import json
import pathlib
import sys

lines, seconds, out = sys.argv[1:]
rows = [line.split("\t") for line in pathlib.Path(lines).read_text().splitlines()]
pathlib.Path(out).write_text(json.dumps({
    "title": "The repository", "command": "./dev repository", "seconds": int(seconds), "passed": all(row[1] == "passed" for row in rows),
    "tables": [{"columns": ["checked", "verdict"], "rows": rows}]}))
