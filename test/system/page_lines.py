# SPDX-License-Identifier: MIT
"""What a page of the manual shows in its blocks of code: commands, what they print, and files to be saved. And how a command is run.

A line is a command if it begins with one of PROGRAMS; a backslash or a quote that is left open continues it. What stands between it and
the next is what it prints. A comment behind a command may promise an exit code. A block of TOML whose first line is a comment with a
path is a file to be saved there. A block behind <!-- printed by COMMAND --> is a part of what that command prints.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess

PROGRAMS = re.compile(
    r"(\./dev|fantail|for|\(?cd|sudo|python3|cmake|(build|tools)/\S+|candump|ip|docker|git|echo|cp|sed|valgrind|callgrind_annotate"
    r"|lcm-\w+|javac|CLASSPATH=\S+)( |$)")
READ = ("docs", "sim", "python", "test", "tools", "firmware", "build")  # a reader is in the folder of the project
DEV = """#!/bin/sh
# The real one would build programs of its own: this one knows no verb that the real one does not know.
"{project}/dev" help | grep -q "^./dev $1 " || {{ echo "./dev knows no $1" >&2; exit 64; }}
[ "$1" != with-vcan ] || {{ shift && exec "{project}/tools/with_vcan" --timeout 240 "$@"; }}
exec "{fantail}" "$@"
"""
BUSY = re.compile("no heartbeat from the bench arrived|the canards are not judged|no verdict: ")


BLOCK = re.compile(r"(?:^<!-- printed by (\S[^\n]*) -->\n+)?^( *)```(\w*)[^\n]*\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)


def blocks_of(text):
    """Kind and text of each, and by which command it is said to be printed."""
    for command, indent, kind, block in BLOCK.findall(text):
        yield kind, re.sub(f"^{indent}", "", block, flags=re.MULTILINE), command


def is_open(line):
    """Does the next line belong to this one?"""
    try:
        shlex.split(line, comments=True)
        return line.endswith("\\")
    except ValueError:
        return True


def steps_of(text):
    """("file", path, content), ("command", line, what is said to be printed), and ("unknown", line, []) for another program's."""
    for kind, block, command in blocks_of(text):
        lines = block.splitlines()
        if command:
            yield "command", command, ["...", *(line.rstrip() for line in lines if line.strip()), "..."]
            continue
        if kind == "toml" and lines and (named := re.match(r"# (\S+\.toml)$", lines[0])):
            yield "file", named[1], block
        if kind:
            continue
        steps = []
        for line in lines:
            if steps and is_open(steps[-1][1]):
                steps[-1][1] += "\n" + line
            elif PROGRAMS.match(line):
                steps.append(["command", line, []])
            elif steps and line.strip() and not line.lstrip().startswith("#"):
                steps[-1][2].append(line.rstrip())
            elif not steps and line is lines[0] and re.match(r"[\w./-]+ (?! )", line) and shutil.which(line.split()[0]):
                steps.append(["unknown", line, []])
        yield from steps


def make_folder(project, fantail):
    """Makes of the folder at hand one in which a reader could be."""
    for name in READ:
        if (project / name).exists():
            pathlib.Path(name).symlink_to(project / name)
    pathlib.Path("dev").write_text(DEV.format(project=project, fantail=fantail), encoding="utf-8")
    pathlib.Path("dev").chmod(0o755)


def save(path, content):
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(path).write_text(content, encoding="utf-8")


def is_printed(promised, printed):
    return printed.startswith(promised[:-3]) if promised.endswith(" ...") else promised == printed


def differs(promised, printed):
    """The first line that was promised and not printed there, or nothing. Three dots stand for any lines, or for the rest of one."""
    at, anything = 0, False
    for line in promised:
        if line.strip() == "...":
            anything = True
            continue
        end = len(printed) if anything else min(at + 1, len(printed))
        found = next((i for i in range(at, end) if is_printed(line, printed[i])), None)
        if found is None:
            return line
        at, anything = found + 1, False
    return None if anything or at == len(printed) else "nothing more, but there was: " + printed[at]


def run(fantail, line, promised):
    """What is wrong with a command, or nothing."""
    environment = os.environ | {"PATH": f"{fantail.parent}:{os.environ['PATH']}"}
    for _ in range(5):
        done = subprocess.run(["/bin/sh", "-c", line], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
                              env=environment)
        if not ("with-vcan" in line and BUSY.search(done.stdout + done.stderr)):
            break  # in a guest on a busy PC the avionics waits too long for a heartbeat; that, and nothing else, is tried again
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
