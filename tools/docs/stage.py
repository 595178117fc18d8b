# SPDX-License-Identifier: MIT
"""Usage: stage.py PROJECT XML PAGES

Puts together what MkDocs reads: the manual as it is, where it is, with its pictures and sheets; notebooks as pages; pages on the
headers, of what Doxygen has written into XML; and a page for each source that a page links to, because a browser shows no line of a .cpp.
"""

import itertools
import os
import pathlib
import re
import shutil
import sys

sys.dont_write_bytecode = True  # not between the sources
import api
import notebook
import source_page

LINK = re.compile(r"(\]\()([^)\s#]+)(#[^)\s]*)?(\))")
SHOWN = {".png", ".webp", ".svg", ".html", ".ork"}


def of_commands(block):
    """A block of commands and what they print, as tutorials have it: its lines are long and wrap, and the commands are marked."""
    commands = [str(number) for number, line in enumerate(block.splitlines()[1:], 1) if line.startswith("./dev ")]
    marked = f'``` {{ .text .wrap hl_lines="{" ".join(commands)}" }}'
    return block.replace("```", marked, 1) if block.startswith("```\n./dev ") else block


class Stage:
    def __init__(self, project, pages):
        self.project, self.pages = project, pages
        self.sources = set()

    def write(self, name, text):
        file = self.pages / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def notebook(self, name, file):
        number = itertools.count(1)

        def picture(content):
            place = self.pages / name.with_name(f"{name.stem}_{next(number)}.png")
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
            return place.name

        self.page(str(name.with_suffix(".md")), notebook.as_page(file, picture))

    def led(self, page, match):
        """The link as it is in the site."""
        begin, target, anchor, end = match.groups(default="")
        if ":" in target:
            return match[0]
        name = os.path.normpath(os.path.join(os.path.dirname(page), target))
        if name.endswith((".md", *SHOWN)) or not (self.project / name).exists():
            return match[0]  # of what is not there MkDocs tells
        if name.endswith(".ipynb"):
            return f"{begin}{target.removesuffix('.ipynb')}.md{end}"
        self.sources.add(name)
        there = os.path.relpath(source_page.place(name), os.path.dirname(page) or ".")
        return f"{begin}{there}{anchor.replace('#L', '#L-')}{end}"

    def page(self, name, text):
        parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
        if name.startswith("docs/tutorials/"):
            parts[1::2] = [of_commands(part) for part in parts[1::2]]
        parts[::2] = [LINK.sub(lambda match: self.led(name, match), part) for part in parts[::2]]
        self.write(name, "".join(parts))


def main():
    project, xml, pages = (pathlib.Path(word) for word in sys.argv[1:])
    shutil.rmtree(pages, ignore_errors=True)
    stage = Stage(project, pages)
    for file in sorted([*project.glob("*.md"), *project.glob("docs/**/*")]):
        name = str(file.relative_to(project))
        if file.suffix == ".md":
            stage.page(name, file.read_text(encoding="utf-8"))
        elif file.suffix == ".ipynb":
            stage.notebook(pathlib.PurePath(name), file)
        elif file.suffix in SHOWN and name != "docs/playground.html":  # which ./dev playground makes and the gallery shows
            (pages / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, pages / name)
    for name, text in api.pages(xml).items():
        stage.page(name, text)
    shutil.copytree(project / "tools/docs/assets", pages / "assets")
    for name in sorted(stage.sources):
        if (project / name).is_dir():
            stage.sources.update(source_page.inside(project, name))
    for name in sorted(stage.sources):
        stage.write(source_page.place(name), source_page.of(project, name))
    print(f"docs: {len(list(pages.rglob('*.md')))} pages and {len(stage.sources)} sources", file=sys.stderr)


main()
