# SPDX-License-Identifier: MIT
"""Usage: documented_lines.py PROJECT FANTAIL PAGE [--section HEADING]... [--in FOLDER]

The lines of a page, or of some of its sections, one by one, as a reader copies them: in a block of code each line that begins with
./dev is run, by FANTAIL, because the real ./dev would build one of its own. What stands between it and the next is what it prints, and
all that it prints, but for a line of three dots, which stands for any number of lines. A comment behind a command may promise an
exit code. A block of TOML whose first line is a comment with a path is a file to be saved there. With --in the results stay there.
"""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

LEAST_LINES = 4  # fewer, and the page is not read as it should be


def sections_of(text, headings):
    for heading in headings:
        if not (match := re.search(rf"^## {re.escape(heading)}.*?(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)):
            raise SystemExit(f"FAILED: there is no section {heading}")
        yield match[0]


def steps_of(text):
    """Files to be saved, as (path, content), and commands, as (line, what is said to be printed)."""
    for kind, block in re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        lines = block.splitlines()
        if kind == "toml" and (named := re.match(r"# (\S+\.toml)$", lines[0])):
            yield "file", named[1], block
        elif not kind:
            commands = [i for i, line in enumerate(lines) if line.startswith("./dev ")]
            for i, end in zip(commands, [*commands[1:], len(lines)]):
                yield "command", lines[i], [line.rstrip() for line in lines[i + 1:end] if line.strip()]


def differs(promised, printed):
    """The first line that was promised and not printed there, or nothing."""
    at, anything = 0, False
    for line in promised:
        if line.strip() == "...":
            anything = True
        elif line in (printed[at:] if anything else printed[at:at + 1]):
            at, anything = printed.index(line, at) + 1, False
        else:
            return line
    return None if anything or at == len(printed) else "nothing more, but there was: " + printed[at]


def run(project, fantail, line, promised):
    """What is wrong with a command, or nothing."""
    words = shlex.split(line, comments=True)[1:]
    verbs = subprocess.run([project / "dev", "help"], capture_output=True, text=True, check=True).stdout
    if not re.search(rf"^\./dev {words[0]} ", verbs, re.MULTILINE):
        return f"./dev knows no {words[0]}"
    done = subprocess.run([fantail, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    said = done.stdout or done.stderr  # beside a result, progress, which depends on the time
    code = re.search(r"#.*exit code (\d+)", line)
    if done.returncode != int(code[1] if code else 0):
        return f"exit code {done.returncode}\n{done.stdout}{done.stderr}"
    # Every page that is named must be there.
    for page in re.findall(r"^  (?:report|page) +(\S.*)$", said, re.MULTILINE):
        if not os.path.getsize(page):
            return f"no {page}"
    printed = [one.rstrip() for one in said.splitlines() if one.strip()]
    wrong = differs(promised, printed) if promised else None
    return f"it does not print: {wrong}\n{said}" if wrong else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("project", type=pathlib.Path)
    parser.add_argument("fantail")
    parser.add_argument("page")
    parser.add_argument("--section", action="append")
    parser.add_argument("--in", dest="folder")
    words = parser.parse_args()
    words.project, words.fantail = words.project.absolute(), pathlib.Path(words.fantail).absolute()
    text = (words.project / words.page).read_text(encoding="utf-8")
    steps = list(steps_of("".join(sections_of(text, words.section)) if words.section else text))
    with tempfile.TemporaryDirectory(prefix="documented_lines.") as temporary:
        os.chdir(words.folder or temporary)
        pathlib.Path("docs").symlink_to(words.project / "docs")  # readers are in the folder of the project
        count = failures = 0
        for kind, what, content in steps:
            if kind == "file":
                pathlib.Path(what).parent.mkdir(parents=True, exist_ok=True)
                pathlib.Path(what).write_text(content, encoding="utf-8")
                continue
            count += 1
            if wrong := run(words.project, words.fantail, what, content):
                failures += 1
                print(f"FAILED: {what}: {wrong}")
        print(f"{words.page}: {count} commands, {failures} failed")
        return count < LEAST_LINES or failures > 0


sys.exit(main())
