# SPDX-License-Identifier: MIT
"""Usage: report_page_test.py FANTAIL PICTURES

The report of a flight in a real browser: the rocket that turns, what plays it, and the plots that go with it. Pictures go
into the folder PICTURES. Exit code 77: there is no Chromium here (package chromium-driver).
"""

import csv
import pathlib
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True  # not between the sources
import browser

FANTAIL, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDER = PICTURES / "report"

ANGLES = "return [...document.querySelectorAll('.scene b')].map((one) => one.textContent)"
TIME = "return document.querySelector('.player output').textContent"
# What the cursor of the first plot shows of the true roll angle.
LEGEND = "return [...document.querySelectorAll('.u-legend')][0].querySelectorAll('.u-value')[3].textContent"
SCRUB = """const slider = document.querySelector('.player input');
slider.value = arguments[0]; slider.dispatchEvent(new Event('input'));"""

# How many pixels of a rocket at a roll angle have the colour of its painted quarter; fins and body are paler, canards orange.
PAINTED = """const canvas = Object.assign(document.createElement('canvas'), {style: 'width: 400px; height: 240px'});
document.body.append(canvas);
fantailRocket(canvas)(arguments[0] * Math.PI / 180, [0, 0, 0, 0], false);
const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
canvas.remove();
let painted = 0;
for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255 && data[i + 2] > 80 && data[i] < .15 * data[i + 2]) painted++;
return painted"""


def degrees(text):
    return float(text.rstrip("°").replace("\u2212", "-"))


def column_at(file, name, time_s):
    """Of the row nearest to a time."""
    with open(FOLDER / file, newline="") as table:
        rows = [(abs(float(row["time_s"]) - time_s), float(row[name])) for row in csv.DictReader(table) if row[name]]
    return min(rows)[1]


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([FANTAIL, "fly", "--out", FOLDER], check=True, stdout=subprocess.DEVNULL)

    def setUp(self):
        self.page = self.enterContext(browser.Browser(1280, 1043))  # 900 of which are the page's
        self.page.open((FOLDER / "report.html").absolute().as_uri())
        self.page.wait_until("return document.querySelectorAll('.uplot').length >= 6")

    def tearDown(self):
        self.assertEqual(self.page.complaints(), [])

    def test_the_cursor_shows_one_time_on_all_plots(self):
        self.page.run("""const plot = document.querySelector('.u-over'), at = plot.getBoundingClientRect();
for (const kind of ['mouseenter', 'mousemove'])
  plot.dispatchEvent(new MouseEvent(kind, {clientX: at.left + 137, clientY: at.top + 20, bubbles: true}));""")
        times = self.page.run("return [...document.querySelectorAll('.u-legend')].map((one) => one.querySelector('.u-value').textContent)")
        self.assertGreaterEqual(len(times), 6)
        self.assertRegex(times[0], r"^[0-9]+\.[0-9]{3} s$")
        self.assertEqual(set(times), {times[0]})

    def test_the_first_plot_is_in_sight_before_anybody_scrolls(self):
        self.assertGreater(self.page.run("return document.querySelector('.uplot').getBoundingClientRect().bottom"), 300)
        self.assertLess(self.page.run("return document.querySelector('.u-wrap').getBoundingClientRect().bottom"), 900)
        self.page.picture(PICTURES / "report_first.png")

    def test_a_time_that_is_chosen_turns_both_rockets_and_the_plots_show_it(self):
        for time_s in (1.5, 3.0, 8.0):
            self.page.run(SCRUB, time_s)
            flown, free = (degrees(one) for one in self.page.run(ANGLES))
            self.assertAlmostEqual(flown, column_at("flight.csv", "true_roll_angle_deg", time_s), delta=0.1)
            self.assertAlmostEqual(free, column_at("without_control.csv", "true_roll_angle_deg", time_s), delta=1.0)
            self.assertAlmostEqual(degrees(self.page.run(LEGEND)), flown, delta=1.0)
        label = self.page.run("return document.querySelector('.scene canvas').getAttribute('aria-label')")
        self.assertRegex(label, r"^As flown, 8\.00 s: rolled by .*° ?, .* turns from zero$")

    def test_the_painted_quarter_is_seen_when_it_is_turned_to_the_viewer_and_hidden_when_it_is_turned_away(self):
        # The viewer stands at 180 - atan(0.34 / 0.72) = 154.7 degrees from y to z, and the paint of a rocket that has not rolled
        # at 90: it faces the viewer at a roll of 64.7. At 90 degrees more or less an eighth of the body shows half of it.
        facing, hidden = (self.page.run(PAINTED, 154.7 - 90 + turned) for turned in (0, 180))
        self.assertGreater(facing, 1000)
        self.assertEqual(hidden, 0)
        for aside in (-90, 90):
            self.assertTrue(0 < self.page.run(PAINTED, 154.7 - 90 + aside) < facing / 2)

    def test_a_roll_of_nothing_has_no_minus(self):
        with open(FOLDER / "flight.csv", newline="") as table:
            turned = ((float(row["time_s"]), float(row["true_roll_angle_deg"])) for row in csv.DictReader(table))
            time_s = next(time_s for time_s, roll_deg in turned if -0.045 < roll_deg < -0.01 and time_s > -0.9)
        self.page.run(SCRUB, time_s)
        self.assertEqual(self.page.run(ANGLES)[0], "0.0°")
        self.assertEqual(self.page.run("return document.querySelector('.scene figcaption').lastChild.textContent"), "0.00 turns from zero")

    def test_what_is_below_the_rockets_stays_where_it_is_while_their_numbers_grow(self):
        tops = []
        for width_px in (390, 780, 1280):
            self.page.screen(width_px, 900, phone=width_px == 390)
            for time_s in (-0.2, 5.0, 10.3):
                self.page.run(SCRUB, time_s)
                tops.append((width_px, self.page.run("return document.querySelector('.player').getBoundingClientRect().top + scrollY")))
        self.assertEqual(len(set(tops)), 3, tops)

    def test_played_it_goes_on_by_itself_at_the_speed_that_is_chosen_and_can_be_stopped(self):
        play = "document.querySelector('.play').click();"
        self.page.run("document.querySelector('.player button[aria-label^=\"4 \"]').click();" + play)
        self.page.wait_until("return parseFloat(document.querySelector('.player output').textContent) > 2 && 1")
        self.page.run(play)
        stood = self.page.run(TIME)
        self.assertEqual(self.page.run(TIME), stood)
        self.assertEqual(self.page.run("return document.querySelector('.play').textContent"), "Play")
        self.page.run(play)  # on from there, to the end
        self.page.wait_until("return document.querySelector('.play').textContent === 'Play' && 1")
        self.assertGreater(float(self.page.run(TIME).split()[0]), 10.0)
        self.assertRegex(self.page.run(play + TIME), "^\u2212[01]\\.")  # again from the beginning

    def test_on_paper_both_rockets_stay_beside_each_other_with_their_time_and_the_buttons_do_not(self):
        self.page.run("dispatchEvent(new Event('beforeprint'))")
        boxes = "return [...document.querySelectorAll(arguments[0])].map((one) => one.getBoundingClientRect()).filter(({width}) => width > 0)"
        flown, free = self.page.run(boxes, ".scene canvas")
        self.assertAlmostEqual(flown["top"], free["top"], delta=1)
        self.assertAlmostEqual(flown["width"], free["width"], delta=1)
        self.assertLess(flown["right"], free["left"])
        self.assertEqual(len(self.page.run(boxes, ".player output")), 1)
        self.assertEqual(self.page.run(boxes, ".player button, .player input"), [])

    def test_a_pointer_over_a_plot_turns_the_rocket_to_its_time(self):
        before = self.page.run(ANGLES)
        self.page.run("""const over = document.querySelector('.u-over'), box = over.getBoundingClientRect();
            const at = {clientX: box.left + box.width / 3, clientY: box.top + 50, bubbles: true};
            over.dispatchEvent(new MouseEvent('mouseenter', at)); over.dispatchEvent(new MouseEvent('mousemove', at));""")
        self.assertNotEqual(self.page.run(ANGLES), before)

    def test_a_finger_that_is_drawn_along_a_plot_moves_the_cursor_of_all_plots_and_turns_the_rocket(self):
        self.page.screen(390, 844, phone=True)
        self.page.run("document.querySelector('.u-over').scrollIntoView({block: 'center'})")
        left, top, width = self.page.run("const box = document.querySelector('.u-over').getBoundingClientRect(); return [box.left, box.top, box.width]")

        def touch(kind, *points):
            self.page.devtools("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in points])

        seen = []
        touch("touchStart", (left + .2 * width, top + 50))
        for share in (.3, .5, .7):
            touch("touchMove", (left + share * width, top + 50))
            cursors = "[...document.querySelectorAll('.u-cursor-x')].map((one) => one.getBoundingClientRect().left)"
            self.page.wait_until(f"return Math.abs({cursors}[0] - {left + share * width}) < 2 && 1")  # with the next frame
            self.assertGreater(self.page.run(f"return {cursors}[1]"), left)
            time_s = float(self.page.run(TIME).split()[0].replace("\u2212", "-"))
            seen.append(time_s)
            self.assertAlmostEqual(degrees(self.page.run(ANGLES)[0]), column_at("flight.csv", "true_roll_angle_deg", time_s), delta=0.5)
        touch("touchEnd")
        self.assertEqual(seen, sorted(set(seen)))
        self.assertGreater(seen[-1] - seen[0], 3.0)

    def test_each_canard_alone_is_shown_when_it_is_asked_for(self):
        titles = "return [...document.querySelectorAll('.plot')].filter((one) => one.offsetHeight > 0).map((one) => one.textContent)"
        self.assertFalse(any("Canard 3" in one for one in self.page.run(titles)))
        self.page.run("[...document.querySelectorAll('.toolbar button')].find((one) => one.textContent === 'Each canard alone').click()")
        self.assertTrue(any("Canard 3" in one for one in self.page.run(titles)))
        self.assertEqual(self.page.run("return document.querySelectorAll('.uplot').length"), 10)


class SixDofPage(unittest.TestCase):
    def test_on_a_telephone_the_path_has_the_width_of_the_page(self):
        folder = PICTURES / "six_dof"
        subprocess.run([FANTAIL, "fly", "--set", "flight.motion=six_dof", "--out", folder], check=True, stdout=subprocess.DEVNULL)
        with browser.Browser(1280, 1043) as page:
            page.screen(390, 844, phone=True)
            page.open((folder / "report.html").absolute().as_uri())
            page.wait_until("return document.querySelectorAll('.uplot').length >= 6")
            width_px, height_px = page.run("const box = document.querySelector('.scene .path canvas').getBoundingClientRect(); return [box.width, box.height]")
            self.assertGreater(width_px, 340)
            self.assertGreater(height_px, 200)
            self.assertEqual(page.complaints(), [])


class ShortTable(unittest.TestCase):
    def test_of_one_row_or_two_or_of_equal_values_makes_a_page_without_errors(self):
        head = "time_s,phase,roll_angle_deg,roll_rate_deg_s,height_m,speed_m_s\n"
        PICTURES.mkdir(parents=True, exist_ok=True)
        with browser.Browser(1280, 1043) as page:
            for name, times_s in (("one", [3]), ("repeated", [3, 3, 3]), ("two", [3, 3.000001]), ("equal", [0, 1, 2, 3])):
                table = PICTURES / f"{name}_rows.csv"
                table.write_text(head + "".join(f"{time_s},controlling,5,0,10,20\n" for time_s in times_s))
                subprocess.run([FANTAIL, "report", table, "--out", PICTURES / name], check=True, stdout=subprocess.DEVNULL)
                page.open((PICTURES / name / "report.html").absolute().as_uri())
                page.wait_until("return document.querySelectorAll('.uplot').length >= 4")
                self.assertEqual(page.complaints(), [], name)


if __name__ == "__main__":
    browser.run_tests(PICTURES)
