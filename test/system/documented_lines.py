# SPDX-License-Identifier: MIT
"""Usage: documented_lines.py PROJECT FANTAIL PAGE [--in FOLDER]

The lines of a page, one by one, as a reader copies them (page_lines.py), with FANTAIL in the place of what
./dev would build. What a page shows as printed must be all that is printed, but for a line of three dots, which stands for any number
of lines. With --in the results stay there.
"""

import argparse
import os
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True  # not between the sources
import page_lines

LEAST_LINES = 4  # fewer, and the page is not read as it should be


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("project", type=pathlib.Path)
    parser.add_argument("fantail")
    parser.add_argument("page")
    parser.add_argument("--in", dest="folder")
    words = parser.parse_args()
    words.project, words.fantail = words.project.absolute(), pathlib.Path(words.fantail).absolute()
    text = (words.project / words.page).read_text(encoding="utf-8")
    steps = list(page_lines.steps_of(text))
    with tempfile.TemporaryDirectory(prefix="documented_lines.") as temporary:
        os.chdir(words.folder or temporary)
        page_lines.make_folder(words.project, words.fantail)
        count = failures = 0
        for kind, what, content in steps:
            if kind == "file":
                page_lines.save(what, content)
                continue
            count += 1
            if wrong := page_lines.run(words.fantail, what, content):
                failures += 1
                print(f"FAILED: {what}: {wrong}")
        os.chdir("/")  # out of what is removed
        print(f"{words.page}: {count} commands, {failures} failed")
        return count < LEAST_LINES or failures > 0


sys.exit(main())
