# SPDX-License-Identifier: MIT
"""checked.py TITLE COMMAND LINES SECONDS OUT: what a verb has checked, a line each with its verdict behind a tab, as figures.py reads it."""

import json
import pathlib
import sys

title, command, lines, seconds, out = sys.argv[1:]
rows = [line.split("\t") for line in pathlib.Path(lines).read_text().splitlines()]
pathlib.Path(out).write_text(json.dumps({
    "title": title, "command": command, "seconds": int(seconds), "passed": all(row[1] == "passed" for row in rows),
    "tables": [{"columns": ["checked", "verdict"], "rows": rows}]}))
