# SPDX-License-Identifier: MIT
"""Usage: pages_test.py FANTAIL BENCH_SHEETS AXE PICTURES [NAME...]

Every kind of page in a real browser, or those that are named: on a telephone, on a desk in light and in dark, and printed on
A4 and Letter. page_checks.js asks what is cut off, scrolls without a cue, or lies on something else; AXE is the file
axe.min.js of axe-core, which asks what a keyboard, a screen reader or weak eyes would miss. Pictures of a page with a fault go
into the folder PICTURES; with FANTAIL_PICTURES=all in the environment those of every page. Exit code 77: there is no Chromium
(package chromium-driver), no pdftotext (poppler-utils) or no axe-core here.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.dont_write_bytecode = True  # not between the sources
import browser

FANTAIL, BENCH_SHEETS, AXE, PICTURES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4]).resolve()
MADE = PICTURES.with_name(PICTURES.name + "_made")
CHECKS = (pathlib.Path(__file__).parent / "page_checks.js").read_text()
SHEETS = {"A4": (21.0, 29.7), "Letter": (21.59, 27.94)}
PHONE_PX, DESK_PX = 390, 1280  # wide
EVERY_PICTURE = os.environ.get("FANTAIL_PICTURES") == "all"
SIX_DOF = "--set flight.motion=six_dof --set wind.speed_m_s=5 --set wind.from_deg=270"

# The name of a page, the command that makes it in a folder of that name beside the others, and its file there. Without a file:
# what others need.
PAGES = [
    ("flight", "fly tasha3_launch2", "report.html"),
    ("six_dof", f"fly tasha3_launch2 {SIX_DOF}", "report.html"),
    ("failed", "fly tasha3_launch1", "report.html"),
    ("gimbal", "fly gimbal", "report.html"),
    ("logged", "report {}/flight/flight.ftl", "report.html"),
    ("two_flights", "report {}/flight/flight.ftl {}/six_dof", "report.html"),
    ("compare", "compare {}/flight {}/six_dof", "compare.html"),
    ("what_if", "replay {}/flight --set controller.proportional_gain=0.3", "what_if.html"),
    ("identify", "identify {}/flight --method both", "report.html"),
    ("one_window", "identify {}/flight", None),
    ("together", "identify {}/flight {}/six_dof --shared alpha,beta", "report.html"),
    ("validate", "identify {}/six_dof --validate {}/one_window", "report.html"),
    ("tunnel_steps", "fly tunnel_steps", "report.html"),
    ("steps", "tunnel steps {}/tunnel_steps", "report.html"),
    ("tunnel_stability", "fly tunnel_stability", "report.html"),
    ("stability", "tunnel stability {}/tunnel_stability", "report.html"),
    ("swirl_without", "fly tunnel_swirl_without", None),
    ("swirl_with", "fly tunnel_swirl_with", None),
    ("swirl", "tunnel swirl {}/swirl_without {}/swirl_with", "report.html"),
    ("tunnel_flow", "fly tunnel_flow", None),
    ("flow", "tunnel flow {}/tunnel_flow", "report.html"),
    ("predict", "predict tasha3_launch2 --runs 20", "predict.html"),
    ("no_go", "predict tasha3_launch1 --runs 20", "predict.html"),
    ("campaign", "campaign tasha3_launch2 --runs 20", "campaign.html"),
    ("detection", "campaign detection --plan tasha3_launch2 --events 20 --launches 20", "detection.html"),
    ("event", "campaign detection --kind shaking --event 1234", "shaking_1234.html"),
    ("faults", "campaign faults tasha3_launch2 --device processor --fault stands_45ms --every 2000", "faults.html"),
    ("hardover", "campaign hardover tasha3_launch2 --step 5", "hardover.html"),
    ("brief", "brief tasha3_launch2 --rules irec --step 5 --set recovery.drag_area_m2=0.8 --set wind.speed_m_s=4", "brief.html"),
    ("tune", "tune tasha3_launch2 --flights 2 --plan {}/tuned.toml --force", "tune.html"),
    ("airframe", "airframe tasha3_launch2", "airframe.html"),
    ("listen", "listen {}/flight/flight.csv", "listen.html"),
    ("paper", "paper", "paper.html"),
]


def make(name, command):
    words = command.replace("{}", str(MADE)).split()
    made = subprocess.run([FANTAIL, *words, "--out", str(MADE / name)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return "" if made.returncode in (0, 1) else f"{command}: exit code {made.returncode}: {made.stdout[-600:]}"


def words_of(pdf):
    """Of each printed page its size in points, and its words with their boxes."""
    text = subprocess.run(["pdftotext", "-bbox", str(pdf), "-"], stdout=subprocess.PIPE, text=True, check=True).stdout
    pages = []
    for page in re.findall(r'<page width="([\d.]+)" height="([\d.]+)">(.*?)</page>', text, re.S):
        words = re.findall(r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">(.*?)</word>', page[2])
        pages.append((float(page[0]), float(page[1]), sorted((*map(float, word[:4]), word[4]) for word in words)))
    return pages


def on_each_other(words):
    """Of words in order of their left edges the pairs that share a third of the smaller one's area."""
    for i, (left, top, right, bottom, word) in enumerate(words):
        for other in words[i + 1:]:
            if other[0] >= right:
                break
            if other[0] - left < 0.5 and word == other[4]:
                continue  # a word with a rim is printed twice in one place
            shared = (min(right, other[2]) - other[0]) * (min(bottom, other[3]) - max(top, other[1]))
            smaller = min((right - left) * (bottom - top), (other[2] - other[0]) * (other[3] - other[1]))
            if other[1] < bottom and top < other[3] and shared > smaller / 3:
                yield f'"{word}" lies on "{other[4]}"'


def sentences_of(sheet):
    """Headings, labels and notes of a bench sheet; what is measured is left out."""
    texts = re.findall(r'<(?:h2|th|dt|figcaption|p class="note"|li|tr><td)[^>]*>([^<]+)', sheet.read_text(encoding="utf-8"))
    return {sentence for text in texts for sentence in re.split(r"(?<=\.) ", re.sub(r"\d+(?:\.\d+)?", "#", text))}


class KeptSheets(unittest.TestCase):
    def test_a_bench_sheet_of_the_manual_has_the_sentences_that_the_program_writes_now(self):
        kept = pathlib.Path(__file__).parents[2] / "docs/sheets"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BENCH_SHEETS, folder], check=True)
            for made, name in (("healthy", "bench_healthy"), ("reversed", "bench_canard3_reversed")):
                written = sentences_of(pathlib.Path(folder) / f"{made}.html")
                self.assertGreater(len(written), 25)
                self.assertEqual(written - sentences_of(kept / f"{name}.html"), set(), "tools/docs/manual_pictures.py makes it anew")


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = cls.enterClassContext(browser.Browser())
        cls.page.patience(100)
        cls.axe = AXE.read_text()

    def test_every_kind_of_page_is_whole_on_a_telephone_in_the_dark_on_paper_and_for_a_screen_reader(self):
        wanted = sys.argv[5:] or [name for name, _, _ in PAGES]
        shutil.rmtree(MADE, ignore_errors=True)
        done, failures = {name: threading.Event() for name, _, _ in PAGES}, {}

        def make_all():
            for name, command, _ in PAGES:
                failures[name] = make(name, command)
                done[name].set()

        subprocess.run([BENCH_SHEETS, str(MADE / "bench")], check=True)
        threading.Thread(target=make_all, daemon=True).start()
        for name in ("healthy", "reversed", "odd_names", "no_data"):
            self.look_at("bench_" + name, MADE / "bench" / f"{name}.html")
        for name, _, file in PAGES:
            if name in wanted:
                done[name].wait()
                with self.subTest(name):
                    self.assertEqual(failures[name], "")
                if file and not failures[name]:
                    self.look_at(name, MADE / name / file)

    def test_the_live_page_is_whole_too(self):
        with subprocess.Popen([FANTAIL, "fly", "--realtime", "--page-at", "127.0.0.1:0", "--out", str(MADE / "live")],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as program:
            try:
                url = next(match[1] for line in program.stderr if (match := re.match(r"page: (http://\S+/)", line)))
                self.page.open(url)
                self.page.wait_until("return ['launched', 'controlling'].includes(window.fantail.figures().phase)")
                self.judge("live")
            finally:
                program.kill()
                program.stderr.read()

    def test_the_live_sheet_of_a_bench_is_whole_too(self):
        with subprocess.Popen([BENCH_SHEETS, "--live"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as program:
            try:
                self.page.open(next(match[1] for line in program.stderr if (match := re.match(r"page: (http://\S+/)", line))))
                self.page.wait_until("return document.querySelectorAll('#sheet h2').length > 0")
                self.judge("bench_live")
            finally:
                program.kill()
                program.stderr.read()

    def look_at(self, name, file):
        self.page.screen(PHONE_PX, 844, phone=True)
        self.page.open(file.as_uri())
        self.assertNotIn("Fantail Fantail", file.read_text(encoding="utf-8"), name)
        self.judge(name)

    def judge(self, name):
        page, begin = self.page, time.monotonic()
        page.screen(PHONE_PX, 844, phone=True)
        page.run(CHECKS)
        page.run(self.axe)
        found = ["on a telephone: " + one for one in page.run("return fantailChecks.all(arguments[0])", PHONE_PX)]
        found += ["on a telephone: " + one for one in self.violations()]
        self.keep(f"{name}_phone", found)
        page.screen(DESK_PX, 900)
        found += ["on a desk: " + one for one in page.run("return fantailChecks.all(arguments[0])", DESK_PX)]
        self.keep(f"{name}_light", found)
        page.screen(DESK_PX, 900, dark=True)
        found += ["in the dark: " + one for one in self.violations(["color-contrast"])]
        self.keep(f"{name}_dark", found)
        for sheet, size in SHEETS.items():  # while the screen is dark
            found += [f"on {sheet}: {one}" for one in self.printed(name, sheet, *size)]
        # A live page whose flight is over asks for its program again and again.
        found += ["in the console: " + one for one in page.complaints() if not re.search("ERR_(CONNECTION_REFUSED|INCOMPLETE)", one)]
        with self.subTest(name):
            self.assertEqual(found, [])
        print(f"{name}: {time.monotonic() - begin:.1f} s")

    def keep(self, name, found):
        """A picture takes longer than what is asked of the page."""
        if found or EVERY_PICTURE:
            self.page.long_picture(PICTURES / f"{name}.png")

    def violations(self, rules=None):
        options = {"resultTypes": ["violations"], **({"runOnly": rules} if rules else {})}
        return self.page.run_async("""const [options, done] = arguments;
            axe.run(document, options).then((result) => done(result.violations
              .filter(({impact}) => impact === "serious" || impact === "critical")
              .map(({id, impact, nodes}) => `${impact}: ${id}: ${nodes.length} of ${nodes[0].html.slice(0, 150)}: ${nodes[0].failureSummary}`)),
              (error) => done([String(error)]));""", options)

    def printed(self, name, sheet, width_cm, height_cm):
        pdf = PICTURES / f"{name}_{sheet}.pdf"
        self.page.print(pdf, width_cm, height_cm)
        pages = words_of(pdf)
        if name == "brief" and sheet == "A4" and len(pages) != 1:
            yield f"{len(pages)} pages instead of one"
        for number, (width, height, words) in enumerate(pages, 1):
            if abs(width - width_cm * 72 / 2.54) > 1 or abs(height - height_cm * 72 / 2.54) > 1:
                yield f"page {number} is {width} by {height} points"
            if not words:
                yield f"page {number} is empty"
            if any(left < 0 or top < 0 or right > width or bottom > height for left, top, right, bottom, _ in words):
                yield f"words stick out of page {number}"
            yield from (f"page {number}: {one}" for one in on_each_other(words))
        if sheet == "A4" and EVERY_PICTURE:
            subprocess.run(["pdftoppm", "-r", "80", "-png", "-singlefile", str(pdf), str(pdf.with_name(f"{name}_paper"))], check=True)


if __name__ == "__main__":
    browser.run_tests(PICTURES, [*([] if shutil.which("pdftotext") else ["pdftotext (package poppler-utils)"]),
                                 *([] if AXE.is_file() else ["axe-core in build/axe, which ./dev test --all fetches"])])
