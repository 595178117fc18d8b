# SPDX-License-Identifier: MIT
"""compile_commands.py BUILD_FOLDER: prints its compile_commands.json with one entry for each file.

Where several files are compiled as one (cmake/together.cmake), the build's own list has only the file that includes them. A
linter or an editor asks for each alone.
"""

import json
import pathlib
import re
import sys

commands = []
for entry in json.loads(pathlib.Path(sys.argv[1], "compile_commands.json").read_text()):
    together = pathlib.Path(entry["file"])
    files = [entry["file"]]
    if together.parent.name == "Unity":
        files = re.findall(r'^#include "(.*)"', together.read_text(), re.MULTILINE)
    commands += [entry | {"file": file, "command": entry["command"].replace(entry["file"], file)} for file in files]
json.dump(commands, sys.stdout, indent=0)
