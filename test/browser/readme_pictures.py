# SPDX-License-Identifier: MIT
"""Usage: readme_pictures.py FANTAIL FOLDER

Makes the picture of the README from a report as it is: report.webp, which plays it four times as fast as it was flown. Needs the
packages chromium-driver and webp.
"""

import base64
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # not between the sources
import browser

FRAMES_PER_S = 15
SPEED = 4
BEGIN_S, END_S = -0.2, 10.4
# A time that is chosen stops the player: its buttons are to show what all frames together do.
TO = f"""const s = document.querySelector('.player input'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));
const [play, ...speeds] = document.querySelectorAll('.player button');
play.textContent = 'Pause';
for (const one of speeds) one.setAttribute('aria-pressed', one.textContent === '{SPEED}\u00d7');"""


def open_report(page, report):
    page.open(report.as_uri())
    page.wait_until("return document.querySelectorAll('.uplot').length >= 6")


def main():
    fantail, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        subprocess.run([fantail, "fly", "--out", place], check=True, stdout=subprocess.DEVNULL)
        with browser.Browser(780, 900) as page:
            open_report(page, place / "report.html")
            page.run("document.querySelector('.stage .note').remove()")
            stage = next(iter(page.call("POST", f"/session/{page.session}/element",
                                        {"using": "css selector", "value": ".stage"}).values()))
            frames = []
            for i in range(round((END_S - BEGIN_S) / SPEED * FRAMES_PER_S)):
                page.run(TO, BEGIN_S + SPEED * i / FRAMES_PER_S)
                frames.append(place / f"{i:03}.png")
                frames[-1].write_bytes(base64.b64decode(page.call("GET", f"/session/{page.session}/element/{stage}/screenshot")))
        subprocess.run(["img2webp", "-loop", "0", "-lossy", "-q", "70", "-d", str(round(1000 / FRAMES_PER_S)), *frames,
                        "-o", folder / "report.webp"], check=True, stdout=subprocess.DEVNULL)


main()
