# SPDX-License-Identifier: MIT
# No function of the firmware and its drivers has a cyclomatic complexity above 15 (NPR 7150.2D, SWE-220). As lizard counts it, with
# a switch as one decision, so that a table of names is not the most complex of all.
#
#   complexity.py ROOT [--json FILE]
import argparse
import json
import pathlib
import sys
import time

import lizard

MOST = 15
FOLDERS = ("firmware", "hal")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    begun = time.monotonic()
    functions = []
    rows = []
    for folder in FOLDERS:
        files = sorted(str(path) for path in (arguments.root / folder).rglob("*.[ch]pp"))
        of_folder = [
            (one.cyclomatic_complexity, one.long_name.split("(")[0].strip(), pathlib.Path(file.filename).relative_to(arguments.root), one.start_line)
            for file in lizard.analyze_files(files, exts=lizard.get_extensions(["modified"]))
            for one in file.function_list
        ]
        if not of_folder:
            sys.exit(f"complexity: no function found in {arguments.root / folder}")
        functions += of_folder
        most = max(of_folder, key=lambda one: one[0])
        mean = sum(one[0] for one in of_folder) / len(of_folder)
        rows.append([folder, len(of_folder), f"{mean:.1f}", most[0], most[1]])
    beyond = [one for one in functions if one[0] > MOST]
    for complexity, name, file, line in sorted(beyond, key=lambda one: -one[0]):
        print(f"{file}:{line}: {name} has a complexity of {complexity}, more than {MOST}", file=sys.stderr)
    if arguments.json:
        arguments.json.write_text(json.dumps({
            "title": "Complexity", "command": "./dev trace", "seconds": time.monotonic() - begun, "passed": not beyond,
            "tables": [{"caption": f"Cyclomatic complexity, a switch counted as one; at most {MOST} is allowed.",
                        "columns": ["folder", "functions", "mean", "most", "which"], "rows": rows}], "notes": []}))
    print(f"complexity: {len(functions)} functions, {len(beyond)} above {MOST}")
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
