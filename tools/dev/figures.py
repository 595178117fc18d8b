# SPDX-License-Identifier: MIT
# A page of figures, made from what the tools measured; nothing on it is typed by hand.
#
#   figures.py PAGE TITLE COMMAND FILE...   PAGE: docs/figures/NAME.md
#
# Each FILE is the JSON of one tool: title, command, seconds, passed, tables (caption, columns, rows), notes. Its name is the anchor
# of its part of the page, which a requirement of the safety case names. The page is short: of a list of checks it has how many there
# are and those that have not passed, and of a table that ends in the row "all" that row. Exit code 1 if a tool has not passed, 66 if a
# file is missing.
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys


def processor():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def commit(root="."):
    said = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=root, capture_output=True, text=True, check=False)
    return said.stdout.strip() or "a tree without git"


def cell(value):
    return str(value).replace("|", "\\|").replace("\n", " ")


def is_list_of_checks(table):
    return table["columns"] == ["checked", "verdict"]  # what checked.py writes


def shortened(table):
    """The rows of a table that stand on the page."""
    rows = table["rows"]
    if is_list_of_checks(table):
        return [row for row in rows if row[1] != "passed"]
    if len(rows) > 1 and rows[-1][0] == "all":
        return [[f"all {len(rows) - 1}", *rows[-1][1:]]]
    return rows


def part(path):
    tool = json.loads(path.read_text())
    checks = [row for table in tool["tables"] if is_list_of_checks(table) for row in table["rows"]]
    passed = sum(row[1] == "passed" for row in checks)
    lines = [f'## {tool["title"]} <a id="{path.stem}"></a>', ""]
    lines += [f'`{tool["command"]}`, {round(tool["seconds"])} s: {"passed" if tool["passed"] else "**not passed**"}'
              f'{f" ({passed} of {len(checks)} checks)" if checks else ""}.', ""]
    for table in tool["tables"]:
        rows = shortened(table)
        if not rows:
            continue
        if table.get("caption"):
            lines += [table["caption"], ""]
        lines.append("| " + " | ".join(map(cell, table["columns"])) + " |")
        lines.append("|" + "---|" * len(table["columns"]))
        lines += ["| " + " | ".join(map(cell, row)) + " |" for row in rows]
        lines.append("")
    lines += [f"- {note}" for note in tool.get("notes", [])] + ([""] if tool.get("notes") else [])
    return lines, tool["passed"]


def main(arguments):
    if len(arguments) < 4:
        print("usage: figures.py PAGE TITLE COMMAND FILE...", file=sys.stderr)
        return 64
    page, title, command, *files = arguments
    files = [pathlib.Path(file) for file in files]
    missing = [str(file) for file in files if not file.exists()]
    if missing:
        print(f"figures: not measured: {', '.join(missing)}", file=sys.stderr)
        return 66
    lines = [f"# {title}", "", f"Written by `{command}` on {datetime.date.today()}, at {commit()}, on {processor()} with "
             f"{os.cpu_count()} cores. Nothing here is typed by hand.", ""]
    passed = True
    for file in files:
        more, fine = part(file)
        lines += more
        passed = passed and fine
    target = pathlib.Path(page)
    target.parent.mkdir(parents=True, exist_ok=True)
    target.with_suffix(".new").write_text("\n".join(lines).rstrip() + "\n")
    target.with_suffix(".new").replace(target)
    print(f"figures: {page}")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
