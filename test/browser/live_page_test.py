# SPDX-License-Identifier: MIT
"""Usage: live_page_test.py FANTAIL PICTURES BENCH_SHEETS

The live page of a flight in a real browser: what it shows against what the program says, and what stays when the program
ends; and the sheet of a bench that fills. Pictures of lift-off, step and apogee, and the figures of the run, go into the folder
PICTURES. Exit code 77: there is no Chromium here (package chromium-driver).
"""

import csv
import json
import pathlib
import re
import subprocess
import sys
import threading
import time
import unittest
import urllib.request

sys.dont_write_bytecode = True  # not between the sources
import browser

FANTAIL, PICTURES, BENCH_SHEETS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]


class Program:
    """A verb with a page, and what it says of itself."""

    def __init__(self, *words, program=FANTAIL):
        self.process = subprocess.Popen([program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.said = []
        for line in self.process.stderr:
            self.said.append(line)
            if match := re.match(r"page: (http://\S+/)", line):
                self.url = match[1]
                break
        else:
            raise AssertionError("no page: " + "".join(self.said))
        self.reader = threading.Thread(target=lambda: self.said.extend(self.process.stderr))
        self.reader.start()

    def end(self):
        out = self.process.stdout.read()
        self.reader.join()
        return self.process.wait(), out, "".join(self.said)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.process.kill()
        self.process.wait()


SHOWN = ["phase", "clock", "time", "roll", "rate", "height", "speed"]


def words_shown(page):
    """Of one frame."""
    words = page.run("return arguments[0].map((id) => document.getElementById(id).textContent)", SHOWN)
    return dict(zip(SHOWN, (word.replace("\u2212", "-") for word in words)))


def recorded_around(rows, time_s):
    """Of flight.csv the ticks that the page's time, which has hundredths of a second, can be."""
    begin = float(rows[0]["time_s"])
    return [row for row in rows if abs(float(row["time_s"]) - begin - time_s) < 0.0065]


class LivePage(unittest.TestCase):
    def compare_with_the_record(self, moments):
        """What the page has said against what the program wrote down: {moment: words}."""
        with (PICTURES / "flight" / "flight.csv").open() as file:
            rows = list(csv.DictReader(file))
        compared = {}
        for moment, words in moments.items():
            around = recorded_around(rows, float(words["time"]))
            compared[moment] = {"page": words, "record": {}}
            for id, column in (("roll", "roll_angle_deg"), ("rate", "roll_rate_deg_s"), ("height", "height_m"), ("speed", "speed_m_s")):
                values = [float(row[column]) for row in around]
                self.assertLess(min(values) - 0.051, float(words[id]), (moment, id))
                self.assertGreater(max(values) + 0.051, float(words[id]), (moment, id))
                compared[moment]["record"][id] = values[len(values) // 2]
            self.assertIn(words["phase"].lower(), {row["phase"] for row in around}, moment)
        (PICTURES / "live_page_compared.json").write_text(json.dumps(compared, indent=2) + "\n")

    def test_shows_the_flight_while_it_is_flown_and_keeps_it_when_it_is_over(self):
        # The browser first: on a busy machine it takes longer to start than a flight waits for it.
        with browser.Browser() as page, \
                Program("fly", "--realtime", "--page-at", "127.0.0.1:0", "--out", str(PICTURES / "flight")) as program:
            page.open(program.url)
            phase = "return window.fantail.figures().phase"
            page.wait_until("return ['launched', 'controlling'].includes(window.fantail.figures().phase)")
            moments = {"lift-off": words_shown(page)}
            page.picture(PICTURES / "live_lift_off.png")
            page.wait_until(f"{phase} === 'controlling' && window.fantail.figures().phase")
            begin, before = time.monotonic(), page.run("return window.fantail.figures()")
            page.wait_until("return document.getElementById('clock').textContent >= 'T+5'", 60)
            seconds, after = time.monotonic() - begin, page.run("return window.fantail.figures()")
            moments["step"] = words_shown(page)
            page.picture(PICTURES / "live_step.png")
            self.assertEqual(page.run("return document.getElementById('phase').textContent"), "CONTROLLING")
            self.assertGreater(after["drawn"], before["drawn"])
            page.wait_until(f"{phase} === 'finished' && 1", 120)
            moments["apogee"] = words_shown(page)
            page.picture(PICTURES / "live_apogee.png")
            code, out, said = program.end()
            self.assertEqual(code, 0, said)
            self.compare_with_the_record(moments)
            self.assertRegex(out, r"page +at most 1 viewer at the same time, [1-9][0-9]+ frames, [0-9]+ dropped because a viewer was slow")

            # The program is gone, as it said before; the page has what it last knew, marked.
            page.wait_until("return !window.fantail.figures().connected && document.body.classList.contains('is-old')")
            self.assertEqual(page.run("return document.getElementById('link').textContent"), "The flight has ended; the last data are shown")
            self.assertIn("--realtime --page-at 127.0.0.1:0", page.run("return document.querySelector('footer').textContent"))
            self.assertEqual(page.run("return document.getElementById('phase').textContent"), "FINISHED")
            self.assertTrue(page.run("return document.body.classList.contains('is-old')"))
            shown = page.run("return window.fantail.figures()")
            events = page.run("return [...document.querySelectorAll('#events li')].map((item) => item.textContent)")
            for words in ("Launched: launch detected", "Controlling: guide clear", "Finished: apogee"):
                self.assertTrue(any(words in event for event in events), (words, events))
            unwanted = [one for one in page.complaints() if "ERR_CONNECTION_REFUSED" not in one and "ERR_INCOMPLETE" not in one]
            self.assertEqual(unwanted, [])
            figures = {"frames_drawn_per_s": (after["drawn"] - before["drawn"]) / seconds, "seconds": seconds,
                       "frames_dropped": shown["dropped"]}
            (PICTURES / "live_page.json").write_text(json.dumps(figures, indent=2) + "\n")
            print(f"{figures['frames_drawn_per_s']:.1f} frames a second drawn over {seconds:.1f} s")

    def test_a_program_that_is_killed_has_not_ended_but_is_lost(self):
        with browser.Browser() as page, \
                Program("fly", "--realtime", "--page-at", "127.0.0.1:0", "--out", str(PICTURES / "killed")) as program:
            page.open(program.url)
            page.wait_until("return window.fantail.figures().phase")
            program.process.kill()
            page.wait_until("return document.getElementById('link').textContent.startsWith('OLD: no connection')")

    def test_on_a_phone_nothing_is_cut_off_at_the_side(self):
        with browser.Browser(width=500) as page, \
                Program("fly", "--realtime", "--page-at", "127.0.0.1:0", "--out", str(PICTURES / "phone")) as program:
            page.open(program.url)
            page.wait_until("return window.fantail.figures().phase")
            page.picture(PICTURES / "live_phone.png")
            self.assertLessEqual(page.run("return document.documentElement.scrollWidth - innerWidth"), 0)
            with urllib.request.urlopen(program.url) as answer:
                self.assertIn("nothing on it can move or arm anything", answer.read().decode())

    def test_the_sheet_of_a_bench_fills_while_the_canards_move(self):
        with browser.Browser() as page, Program("--live", program=BENCH_SHEETS) as program:
            page.open(program.url)
            sheet = "return document.getElementById('sheet').textContent"
            state = "return document.getElementById('state').textContent"
            page.wait_until(f"{state} === 'Moving' && 1")
            self.assertNotIn("Canard 1", page.run(sheet), "nothing is known of a canard that is still moving")
            page.wait_until(f"{sheet}.includes('Not finished: 3 more turns to come') && 1")
            page.wait_until("return document.getElementById('doing').textContent.startsWith('canard 3 alone: ') && 1")
            headings = "return [...document.querySelectorAll('#sheet h2')].map((one) => one.textContent)"
            self.assertEqual(page.run(headings), ["Not finished: 3 more turns to come", "Figures", "Canard 1 is healthy", "Canard 2 is healthy"])
            page.picture(PICTURES / "bench_live.png")
            page.wait_until(f"{state} === 'Ended' && 1")
            # The whole sheet is the one of the file, word for word.
            subprocess.run([BENCH_SHEETS, str(PICTURES / "bench")], check=True)
            shown = page.run(sheet)
            self.assertIn("FAIL", shown)
            code, out, said = program.end()
            self.assertEqual(code, 0, said)
            self.assertRegex(out, "^at most 1 viewer at the same time")
            time.sleep(1.5)  # the program is gone, and what it said stays
            self.assertEqual(page.run(state), "Ended")
            page.long_picture(PICTURES / "bench_live_ended.png")
            unwanted = [one for one in page.complaints() if "ERR_CONNECTION_REFUSED" not in one and "ERR_INCOMPLETE" not in one]
            page.open((PICTURES / "bench" / "reversed.html").resolve().as_uri())
            kept = page.run("document.querySelector('footer').remove(); return document.querySelector('main').textContent")
            self.assertEqual(shown.split(), kept.split())
            self.assertEqual(unwanted, [])


if __name__ == "__main__":
    browser.run_tests(PICTURES)
