# SPDX-License-Identifier: MIT
"""Pictures of pages, light and dark, as they are at first sight in a headless Chromium."""

import base64
import os
import pathlib
import re
import shutil
import sys
import time

sys.path.append(str(pathlib.Path(__file__).parents[2] / "test/browser"))
import browser

WIDTH, HEIGHT, SCALE = 1280, 900, 1


class Album:
    """In a `with`. Pages and their pictures go into the folder gallery of what MkDocs reads."""

    def __init__(self, pages):
        self.pages = pages
        self.folder = pages / "gallery"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.browser = browser.Browser(WIDTH, HEIGHT)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.browser.__exit__()

    def picture(self, file, dark):
        self.browser.screen(WIDTH, HEIGHT, dark)
        time.sleep(0.4)  # what a page draws once more
        clip = {"x": 0, "y": 0, "width": WIDTH, "height": HEIGHT, "scale": SCALE}
        picture = self.browser.devtools("Page.captureScreenshot", format="webp", quality=80, clip=clip)["data"]
        file.write_bytes(base64.b64decode(picture))

    def add(self, html, name, alt, page):
        """The page as part of the site, with the reports that it leads to; what Markdown says there of its picture."""
        place = self.folder / name
        place.mkdir()
        shutil.copy(html, place / "page.html")
        for link in re.findall(r'href="([\w./+-]+\.html)"', html.read_text(encoding="utf-8")):
            if (html.parent / link).is_file():
                (place / link).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(html.parent / link, place / link)
        self.browser.open((place / "page.html").absolute().as_uri())
        self.browser.wait_until("return document.readyState === 'complete'")
        there = os.path.relpath(place, (self.pages / page).parent)
        shown = []
        for theme in ("light", "dark"):
            self.picture(place / f"{theme}.webp", theme == "dark")
            picture = f"![{alt}]({there}/{theme}.webp#only-{theme}){{ .shot loading=lazy width={WIDTH} height={HEIGHT} }}"
            shown.append(f"[{picture}]({there}/page.html)")
        return "".join(shown)
