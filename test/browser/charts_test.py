# SPDX-License-Identifier: MIT
"""Usage: charts_test.py FANTAIL PICTURES

The charts of a page under a pointer: the cursor reads what the files beside the page have, a drag zooms, a double click shows all again,
and paper has no folds. Exit code 77: there is no Chromium (package chromium-driver).
"""

import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # not between the sources
import browser

FANTAIL, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
# A chart by what it shows, and a pointer at shares of its frame from the left and from the top.
POINTER = """
const [label, type, right, down] = arguments;
const svg = [...document.querySelectorAll('svg.chart')].find((one) => one.ariaLabel === label && one.getBoundingClientRect().width > 0);
const box = svg.querySelector('.catch').getBoundingClientRect();
svg.querySelector('.catch').dispatchEvent(new PointerEvent(type, {bubbles: true, pointerType: 'mouse',
  clientX: box.left + right * box.width, clientY: box.top + down * box.height}));
const texts = (list) => [...list].filter((one) => one.style.display !== 'none').map((one) => one.textContent);
return {cursor: texts(svg.querySelectorAll('.cursor text')),
        across: texts(svg.querySelectorAll(':scope > text[text-anchor=middle]:not([class]), .again text[text-anchor=middle]')),
        upwards: texts(svg.querySelectorAll(':scope > text[text-anchor=end]:not([class]), .again text[text-anchor=end]'))};"""


def number(text):
    return float(text.replace("\u2212", "-"))


class Charts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        for words in (["campaign", "tasha3_launch2", "--runs", "20"], ["campaign", "hardover", "tasha3_launch2", "--step", "5", "--set", "recovery.drag_area_m2=1"]):
            subprocess.run([FANTAIL, *words, "--out", cls.folder / words[1]], check=True, stdout=subprocess.DEVNULL)
        words = ["tune", "tasha3_launch2", "--flights", "1", "--plan", cls.folder / "tuned.toml", "--out", cls.folder / "tune"]
        subprocess.run([FANTAIL, *words], check=True, stdout=subprocess.DEVNULL)
        cls.page = cls.enterClassContext(browser.Browser(1280, 900))

    def at(self, label, kind, right, down=0.5):
        return self.page.run(POINTER, label, kind, right, down)

    def zoom(self, label, begin, end):
        self.at(label, "pointerdown", *begin)
        self.at(label, "pointermove", *end)
        return self.at(label, "pointerup", *end)

    def band_at(self, time_s):
        """Of band.csv, between its rows."""
        with open(self.folder / "tasha3_launch2/band.csv", encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(file)]
        after = next(i for i, row in enumerate(rows) if row["time_s"] >= time_s)
        a, b = rows[max(after - 1, 0)], rows[after]
        share = (time_s - a["time_s"]) / (b["time_s"] - a["time_s"]) if after else 0.0
        return [a[key] + share * (b[key] - a[key]) for key in ("roll_angle_p50_deg", "roll_angle_p5_deg", "roll_angle_p95_deg")]

    def expect_band(self, cursor):
        time_s = number(re.fullmatch(r"time after lift-off: (.*)", cursor[0])[1])
        middle, low, high = self.band_at(time_s)
        said = dict(line.split(": ") for line in cursor[1:])
        self.assertAlmostEqual(number(said["middle of the runs"]), middle, delta=0.3)
        edges = [number(edge) for edge in said["5 to 95 % of the runs"].split(" to ")]
        self.assertAlmostEqual(edges[0], low, delta=0.3)
        self.assertAlmostEqual(edges[1], high, delta=0.3)

    def test_the_cursor_reads_what_the_file_has_also_after_a_zoom_and_a_double_click_shows_all_again(self):
        self.page.open((self.folder / "tasha3_launch2/campaign.html").as_uri())
        roll = "roll angle / deg"
        before = self.at(roll, "pointermove", 0.61)
        self.expect_band(before["cursor"])
        times = [number(text) for text in before["across"]]
        left, right = times[0], times[-1]  # the frame begins at lift-off
        zoomed = self.zoom(roll, (0.5, 0.5), (0.75, 0.52))
        shown = [number(text) for text in zoomed["across"]]
        self.assertGreater(len(shown), 4)
        self.assertGreater(shown[0], left + 0.45 * (right - left))
        self.assertLess(shown[-1], left + 0.85 * (right - left))
        self.assertEqual(before["upwards"][0], zoomed["upwards"][0], "along a line the drag is about x alone")
        self.expect_band(self.at(roll, "pointermove", 0.3)["cursor"])
        again = self.at(roll, "dblclick", 0.5)
        self.assertEqual(again["across"], before["across"])
        self.page.picture(PICTURES / "campaign_cursor.png")

    def test_a_drag_among_dots_is_about_both_axes(self):
        self.page.open((self.folder / "hardover/hardover.html").as_uri())
        where = "Where the apogee lies over ground, seen from above"
        before = self.at(where, "pointermove", 0.5)
        zoomed = self.zoom(where, (0.3, 0.3), (0.6, 0.6))
        for axis in ("across", "upwards"):
            all_of_it, part = ([number(text) for text in said[axis]] for said in (before, zoomed))
            self.assertLess(max(part) - min(part), 0.5 * (max(all_of_it) - min(all_of_it)), axis)

    def test_a_flat_drag_on_a_map_is_about_both_axes_alike(self):
        self.page.open((self.folder / "hardover/hardover.html").as_uri())
        for where in ("Where the apogee lies over ground, seen from above", "Where the rocket lands, seen from above"):
            before = self.at(where, "pointermove", 0.5)
            zoomed = self.zoom(where, (0.4, 0.5), (0.6, 0.5))
            for axis in ("across", "upwards"):
                all_of_it, part = ([number(text) for text in said[axis]] for said in (before, zoomed))
                self.assertLess(max(part) - min(part), 0.25 * (max(all_of_it) - min(all_of_it)), axis)
                middle = 0.5 * (max(all_of_it) + min(all_of_it))
                self.assertLess(abs(0.5 * (max(part) + min(part)) - middle), 0.15 * (max(all_of_it) - min(all_of_it)), axis)

    def test_a_logarithmic_axis_is_read_and_zoomed_in_ratios(self):
        self.page.open((self.folder / "tune/tune.html").as_uri())
        gain = "Gain of the open roll loop over frequency"
        svg = f"const svg = [...document.querySelectorAll('svg.chart')].find((one) => one.ariaLabel === '{gain}');"
        low, high = self.page.run(svg + "return svg.dataset.x.split(' ').map(Number)")
        between = lambda share: low * (high / low) ** share
        reads = lambda share: number(re.fullmatch(r"frequency: (.*)", self.at(gain, "pointermove", share)["cursor"][0])[1])
        for share in (0.2, 0.5, 0.9):
            self.assertAlmostEqual(reads(share) / between(share), 1, delta=0.02)
        # Where the phase chart says that the gain of a speed is one, its curve stands at 0 dB.
        names = self.page.run("return [...document.querySelectorAll('svg.chart path[data-name]')].map((one) => one.dataset.name)")
        speed, crossover_hz = next(re.fullmatch(r"(.*): phase margin .* at (.*) Hz", name).groups() for name in names if "phase margin" in name)
        share = math.log(float(crossover_hz) / low) / math.log(high / low)
        line = next(line for line in self.at(gain, "pointermove", share)["cursor"] if line.startswith(speed))
        self.assertAlmostEqual(number(line.split(": ")[-1]), 0, delta=0.3)
        before = self.at(gain, "pointermove", 0.5)["across"]
        zoomed = [number(text) for text in self.zoom(gain, (0.3, 0.5), (0.6, 0.52))["across"]]
        self.assertGreater(len(zoomed), 2)
        self.assertGreaterEqual(zoomed[0], 0.98 * between(0.3))
        self.assertLessEqual(zoomed[-1], 1.02 * between(0.6))
        self.assertAlmostEqual(reads(0.5) / between(0.45), 1, delta=0.03)
        self.assertEqual(self.at(gain, "dblclick", 0.5)["across"], before)
        self.page.picture(PICTURES / "tune_bode.png")

    def test_paper_has_no_folds(self):
        self.page.open((self.folder / "tasha3_launch2/campaign.html").as_uri())
        opened = "return [...document.querySelectorAll('details')].map((one) => one.open)"
        self.assertNotIn(True, self.page.run(opened))
        self.page.run("dispatchEvent(new Event('beforeprint'))")
        self.assertNotIn(False, self.page.run(opened))


if __name__ == "__main__":
    browser.run_tests(PICTURES)
