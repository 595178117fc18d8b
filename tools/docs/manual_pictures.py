# SPDX-License-Identifier: MIT
"""Usage: manual_pictures.py PROJECT FANTAIL [NAME...]

Makes anew what README and manual keep of pages that programs write: the bench sheets in docs/sheets, and the pictures in docs/images, all
or those that are named. FANTAIL is the program of a build with every verb. Needs the packages chromium-driver and webp.
"""

import base64
import pathlib
import shlex
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # not between the sources
sys.path.append(str(pathlib.Path(__file__).parents[2] / "test/browser"))
import browser

WIDTH, HEIGHT = 1280, 900
# The text of a page is 960 wide, and the picture of it as wide as the window: letters stay sharp where a page shows it smaller.
SCALE, QUALITY = 4 / 3, 72
# A picture, the command whose page it shows, from its top to the end of this element.
ANSWER = ".verdict + section figure"
PAGES = {
    "predict": ("predict tasha3_launch2", ANSWER),
    "campaign": ("campaign tasha3_launch2 --runs 200", ANSWER),
    "faults": ("campaign faults tasha3_launch2 --device servo", ANSWER),
    "hardover": ("campaign hardover tasha3_launch2", ANSWER),
    "airframe": ("airframe tasha3_launch2", ANSWER),
}
SHEETS = ("bench_healthy", "bench_canard3_reversed")
BENCH_SHEET = ("bench_canard3_reversed", ".verdict + section .table")

FRAMES_PER_S = 15
SPEED = 4
BEGIN_S, END_S = -0.2, 10.4
# A time that is chosen stops the player: its buttons are to show what all frames together do.
TO = f"""const s = document.querySelector('.player input'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));
const [play, ...speeds] = document.querySelectorAll('.player button');
play.textContent = 'Pause';
for (const one of speeds) one.setAttribute('aria-pressed', one.textContent === '{SPEED}\u00d7');"""


def run(fantail, command, place):
    print(f"fantail {command}", file=sys.stderr)
    done = subprocess.run([fantail, *command.split(), "--out", place], cwd=place, stdout=subprocess.DEVNULL, check=False)
    if done.returncode not in (0, 1):  # 1: the answer is no
        raise SystemExit(f"manual_pictures: fantail {command} ended with {done.returncode}")


def picture(page, html, last, file):
    page.screen(WIDTH, HEIGHT)
    page.open(html.absolute().as_uri())
    page.wait_until("return document.readyState === 'complete'")
    # Shadows that show where a figure scrolls leave a thin line at its edges when the picture is scaled.
    page.run("document.head.append(Object.assign(document.createElement('style'), {textContent: 'figure, .table { background: none; }'}))")
    left, right, bottom = page.run("""const main = document.querySelector('main').getBoundingClientRect();
        return [main.left, main.right, document.querySelector(arguments[0]).getBoundingClientRect().bottom + scrollY]""", last)
    clip = {"x": left, "y": 0, "width": right - left, "height": bottom + 8, "scale": SCALE}
    taken = page.devtools("Page.captureScreenshot", format="webp", quality=QUALITY, captureBeyondViewport=True, clip=clip)["data"]
    file.write_bytes(base64.b64decode(taken))
    print(f"{file}: {round(SCALE * clip['width'])} x {round(SCALE * clip['height'])}, {file.stat().st_size // 1000} kB", file=sys.stderr)


def report(fantail, file, place):
    """The two rockets of a flight's report, played four times as fast as they were flown."""
    run(fantail, "fly tasha3_launch2", place)
    with browser.Browser(780, HEIGHT) as page:
        page.open((place / "report.html").as_uri())
        page.wait_until("return document.querySelectorAll('.uplot').length >= 6")
        page.run("document.querySelector('.stage .note').remove()")
        stage = next(iter(page.call("POST", f"/session/{page.session}/element", {"using": "css selector", "value": ".stage"}).values()))
        frames = []
        for i in range(round((END_S - BEGIN_S) / SPEED * FRAMES_PER_S)):
            page.run(TO, BEGIN_S + SPEED * i / FRAMES_PER_S)
            frames.append(place / f"{i:03}.png")
            frames[-1].write_bytes(base64.b64decode(page.call("GET", f"/session/{page.session}/element/{stage}/screenshot")))
    subprocess.run(["img2webp", "-loop", "0", "-lossy", "-q", "70", "-d", str(round(1000 / FRAMES_PER_S)), *frames, "-o", file],
                   check=True, stdout=subprocess.DEVNULL)


def sheet(project, fantail, scenario, file, place):
    """A simulated rocket on a virtual bus, and `bench limits` beside it."""
    print(f"bench limits of {scenario}", file=sys.stderr)
    program, out = shlex.quote(str(fantail)), shlex.quote(str(place))
    both = (f"{program} node {scenario} --can vcan0 >/dev/null 2>&1 & {program} bench limits --can vcan0 --wait 60 --vehicle tasha3_bench "
            f"--plan tasha3_launch2 --out {out}; code=$?; kill $!; exit $code")
    done = subprocess.run([project / "tools/with_vcan", "--timeout", "300", "sh", "-c", both], cwd=place, stdout=subprocess.DEVNULL, check=False)
    if done.returncode not in (0, 1):  # 1: the sheet says FAIL
        raise SystemExit(f"manual_pictures: the sheet of {scenario} ended with {done.returncode}")
    file.write_bytes((place / "sheet.html").read_bytes())


def main():
    project, fantail = (pathlib.Path(word).absolute() for word in sys.argv[1:3])
    images, sheets = project / "docs/images", project / "docs/sheets"
    wanted = sys.argv[3:] or ["sheets", "report", "bench_sheet", *PAGES]
    with tempfile.TemporaryDirectory() as name, browser.Browser(WIDTH, HEIGHT) as page:
        for one in wanted:
            place = pathlib.Path(name) / one
            place.mkdir()
            if one == "sheets":
                for scenario in SHEETS:
                    sheet(project, fantail, scenario, sheets / f"{scenario}.html", place)
            elif one == "report":
                report(fantail, images / "report.webp", place)
            elif one == "bench_sheet":
                picture(page, sheets / f"{BENCH_SHEET[0]}.html", BENCH_SHEET[1], images / "bench_sheet.webp")
            else:
                command, last = PAGES[one]
                run(fantail, command, place)
                picture(page, next(place.glob("*.html")), last, images / f"{one}.webp")


main()
