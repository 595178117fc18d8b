# SPDX-License-Identifier: MIT
"""A source as a page with a place for each line: source/sim/world.cpp.html#L-12."""

import html
import os

import pygments
from pygments.formatters import HtmlFormatter
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound

FORMAT = HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True)
PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{name}</title>
<link rel="stylesheet" href="{up}assets/source.css"></head><body>
<header><a href="{up}index.html">Fantail</a> <b>{name}</b></header>
{content}</body></html>
"""


def place(name):
    return f"source/{name}.html"


def inside(project, folder):
    return sorted(f"{folder}/{file.name}" for file in (project / folder).iterdir() if file.is_file())


def of(project, name):
    """Of a folder, the list of its files."""
    file = project / name
    if file.is_dir():
        content = "".join(f'<p><a href="{os.path.relpath(place(one), "source/" + os.path.dirname(name))}">{html.escape(one)}</a></p>\n'
                          for one in inside(project, name))
    else:
        text = file.read_text(encoding="utf-8")
        try:
            lexer = get_lexer_for_filename(name, stripnl=False)
        except ClassNotFound:
            lexer = TextLexer(stripnl=False)
        content = pygments.highlight(text, lexer, FORMAT)
    return PAGE.format(name=html.escape(name), up="../" * place(name).count("/"), content=content)
