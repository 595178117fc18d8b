# SPDX-License-Identifier: MIT
"""Usage: check_site.py SITE

Every href and src of every page of a folder: is the file there, and the place in it? Nothing may be fetched from a network; links
that a reader follows to elsewhere are counted, and only their form is checked. Exit code 1: a link leads nowhere.
"""

import html.parser
import pathlib
import sys
import urllib.parse

FETCHED = {"link", "script", "img", "iframe", "source", "video", "audio", "object", "embed"}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.places, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(values[name] for name in ("id", "name") if values.get(name))
        # A link with rel="canonical" or so is not fetched.
        fetched = tag in FETCHED and (tag != "link" or values.get("rel") in ("stylesheet", "icon", "preload"))
        self.links += [(values[name], fetched) for name in ("href", "src", "data") if values.get(name) is not None and name in values]


def wrong(pages, file, link, fetched):
    """What is wrong with a link of a page, or nothing."""
    url = urllib.parse.urlsplit(link)
    if url.scheme in ("data", "javascript", "mailto", "blob"):
        return None
    if url.scheme or url.netloc:
        if fetched:
            return "fetched from a network"
        return None if url.scheme in ("http", "https") and "." in url.netloc else "no address"
    if url.path.startswith("/"):
        return None if file.name == "404.html" else "not from this folder"
    target = (file.parent / urllib.parse.unquote(url.path)).resolve() if url.path else file
    if target.is_dir():
        target = target / "index.html"
    if not target.is_file():
        return "no such file"
    place = urllib.parse.unquote(url.fragment)
    if place and target in pages and place not in pages[target].places and not place.startswith("__"):
        return "no such place"
    return None


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in site.rglob("*.html")}
    inside, outside, failures = 0, set(), 0
    for file, page in sorted(pages.items()):
        for link, fetched in page.links:
            if what := wrong(pages, file, link, fetched):
                print(f"{file.relative_to(site)}: {what}: {link}")
                failures += 1
            if urllib.parse.urlsplit(link).netloc:
                outside.add(link)
            else:
                inside += 1
    print(f"docs: {inside} links within {len(pages)} pages checked, {failures} lead nowhere; {len(outside)} addresses elsewhere, "
          "not called", file=sys.stderr)
    return failures > 0


sys.exit(main())
