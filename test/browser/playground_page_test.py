# SPDX-License-Identifier: MIT
"""Usage: playground_page_test.py FANTAIL PROJECT PICTURES

The page with a simulator in it, opened as a file in a real browser: a flight, its digest against the native program's, what a
slider changes, what a link may say, and memory after many flights. Pictures go into the folder PICTURES. Exit code 77: there
is no Chromium here (package chromium-driver), or ./dev playground has never built the module.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # not between the sources
import browser

FANTAIL, PROJECT, PICTURES = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
BUILD = PROJECT / "build/playground"
IDLE = "const f = window.fantail?.figures(); return f && f.flown > 0 && !f.busy && document.getElementById('state').textContent !== 'flying'"


def text_of(page, name):
    return page.run("return document.getElementById(arguments[0]).textContent", name)


def native_digest(*words):
    with tempfile.TemporaryDirectory() as out:
        answer = subprocess.run([FANTAIL, "fly", *words, "--json", "--out", out], stdout=subprocess.PIPE, check=True, text=True)
        return json.loads(answer.stdout)["log_sha256"]


class PlaygroundPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run(["cmake", "--build", str(BUILD)], check=True, stdout=subprocess.DEVNULL)
        cls.folder = tempfile.TemporaryDirectory()
        cls.digest = native_digest("tasha3_launch2")
        native = pathlib.Path(cls.folder.name) / "native.json"
        native.write_text(json.dumps({"digests": {"tasha3_launch2": cls.digest}}))
        file = pathlib.Path(cls.folder.name) / "playground.html"
        module = BUILD / "tools/playground/playground.wasm"
        subprocess.run(["cmake", "-D", f"MODULE={module}", "-D", f"NATIVE={native}", "-D", "VERSION=0.1.0", "-D", "HASH=these",
                        "-D", f"OUT={file}", "-P", str(PROJECT / "tools/playground/make_page.cmake")], check=True)
        cls.url = file.as_uri()
        cls.page = cls.enterClassContext(browser.Browser())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def fresh(self, link="", width=1280):
        """The page loaded anew, also where only what follows its # is another one than before."""
        self.page.open("about:blank")
        self.page.screen(width, 900)
        self.page.complaints()
        self.page.open(self.url + link)
        return self.page

    def test_it_flies_by_itself_and_again_after_every_change(self):
        page = self.fresh()
        page.wait_until(IDLE)
        self.assertEqual(text_of(page, "outcome"), "Held")
        self.assertEqual(text_of(page, "digest"), self.digest)
        self.assertIn("Equal to the digest of the native program", text_of(page, "same"))
        page.wait_until("return document.getElementById('controller-canard_limit_deg')")
        page.picture(PICTURES / "playground.png")

        turn = """const slider = document.getElementById('controller-canard_limit_deg').previousSibling;
                  slider.value = 4; slider.dispatchEvent(new Event('input'))"""
        page.run(turn)
        page.wait_until(IDLE)
        self.assertEqual(text_of(page, "outcome"), "Not held")
        self.assertEqual(text_of(page, "command"), "./dev fly tasha3_launch2 --set controller.canard_limit_deg=4")
        self.assertEqual(text_of(page, "digest"), native_digest("tasha3_launch2", "--set", "controller.canard_limit_deg=4"))
        self.assertEqual(page.run("return location.hash"), "#tasha3_launch2&controller.canard_limit_deg=4")

        page.run("const s = document.getElementById('fault'); s.value = 'canard_stuck'; s.dispatchEvent(new Event('change'))")
        page.wait_until(IDLE)
        self.assertIn('kind = "canard_stuck"', text_of(page, "fault-text"))
        page.run("document.getElementById('reset').click()")
        page.wait_until("return document.getElementById('same').className === 'same'")
        self.assertEqual(page.complaints(), [])

    def test_a_link_carries_the_settings_and_a_bad_one_is_refused_in_words(self):
        page = self.fresh("#tasha3_launch1&reference.kind=hold&controller.canard_limit_deg=9")
        page.wait_until(IDLE)
        self.assertEqual(text_of(page, "digest"), native_digest(
            "tasha3_launch1", "--set", "reference.kind=hold", "--set", "controller.canard_limit_deg=9"))
        self.assertIn("reference.kind=hold", text_of(page, "others"))
        for link, words in (("tasha3_launch2&controller.proportional_gain=NaN", "out of range|not a number"),
                            ("tasha3_launch2&controller.gain=1", "unknown key controller.gain"),
                            ("<img src=x onerror=document.title='x'>", "unknown scenario"),
                            ("tasha3_launch2&%FF", "is not text"), ("tasha3_launch2&timing.time_after_end_s=3600", "at most 300 s")):
            page.run("location.hash = arguments[0]", "#" + link)
            page.wait_until("return !document.getElementById('refusal').hidden && document.getElementById('state').textContent === 'refused'", 120)
            self.assertRegex(text_of(page, "refusal-text"), words)
            self.assertNotEqual(page.run("return document.title"), "x")
            page.run("location.hash = '#tasha3_launch2'")
            page.wait_until("return document.getElementById('refusal').hidden")
        page.run("location.hash = '#tasha3_launch2&controller.gain=1'")
        page.wait_until("return !document.getElementById('refusal').hidden")
        page.picture(PICTURES / "playground_refused.png")

    def test_opened_with_a_link_that_is_refused_it_says_so_and_offers_a_scenario_as_shipped(self):
        shown = "return [...document.querySelectorAll('.results > section')].filter((one) => one.offsetHeight > 0).map((one) => one.id)"
        for link, words in (("tasha3_launch2&controller.gain=1", "unknown key controller.gain"), ("nobody", "unknown scenario"),
                            ("tasha3_launch2&%FF", "is not text")):
            page = self.fresh("#" + link)
            page.wait_until("return document.getElementById('state').textContent === 'refused'")
            self.assertIn(words, text_of(page, "refusal-text"))
            self.assertEqual(page.run(shown), ["refusal"])
            page.picture(PICTURES / "playground_refused_at_first.png")
            page.run("document.getElementById('start').click()")
            page.wait_until(IDLE)
            self.assertEqual(text_of(page, "digest"), self.digest)
            self.assertNotIn("refusal", page.run(shown))
            page.wait_until("return document.getElementById('controller-canard_limit_deg')")

    def test_a_decimal_comma_is_refused_in_words_and_stays_to_be_mended(self):
        page = self.fresh()
        page.wait_until(IDLE)
        page.wait_until("return document.getElementById('controller-proportional_gain')")
        turn = """const field = document.getElementById('controller-proportional_gain');
                  field.value = arguments[0]; field.dispatchEvent(new Event('change')); return field.value"""
        self.assertEqual(page.run(turn, "0,4"), "0,4")
        self.assertIn("write it with a decimal point, as in 0.4", text_of(page, "refusal-text"))
        self.assertEqual(page.run("return location.hash"), "#tasha3_launch2")
        page.run(turn, "0.4")
        page.wait_until(IDLE)
        self.assertTrue(page.run("return document.getElementById('refusal').hidden"))
        self.assertEqual(page.run("return location.hash"), "#tasha3_launch2&controller.proportional_gain=0.4")

    def test_a_change_during_a_long_run_is_not_kept_waiting(self):
        page = self.fresh("#tunnel_swirl_without")
        page.wait_until("return window.fantail?.figures().busy")
        page.run("location.hash = '#tasha3_launch2'")
        page.wait_until(IDLE)
        self.assertEqual(text_of(page, "digest"), self.digest)

    def test_memory_does_not_grow_while_somebody_plays(self):
        page = self.fresh()
        page.wait_until(IDLE)
        play = """const [from, to] = arguments; const slider = document.getElementById('controller-proportional_gain').previousSibling;
                  window.played = from;
                  const turn = () => {
                    if (window.fantail.figures().busy) return setTimeout(turn, 5);
                    slider.value = 0.2 + 0.005 * (window.played % 100); slider.dispatchEvent(new Event('input'));
                    if (++window.played < to) setTimeout(turn, 5);
                  };
                  turn();"""
        sizes = []
        for begin in (0, 20, 40):
            page.wait_until("return document.getElementById('controller-proportional_gain')")
            page.run(play, begin, begin + 20)
            page.wait_until(f"return window.played === {begin + 20}", 300)
            page.wait_until(IDLE)
            sizes.append(page.run("return window.fantail.figures().memory"))
        self.assertEqual(sizes[1], sizes[2])
        figures = page.run("return window.fantail.figures()")
        print(f"{figures['flown']} flights, {sizes[-1] >> 20} MB, the last in {figures['milliseconds']:.0f} ms, the slowest in {figures['slowest']:.0f} ms")

    def test_on_a_phone_nothing_is_cut_off_at_the_side(self):
        page = self.fresh(width=500)
        page.wait_until(IDLE)
        page.wait_until("return document.getElementById('controller-canard_limit_deg')")
        page.picture(PICTURES / "playground_phone.png")
        self.assertLessEqual(page.run("return document.documentElement.scrollWidth - innerWidth"), 0)


if __name__ == "__main__":
    browser.run_tests(PICTURES, [] if (BUILD / "build.ninja").exists() else ["the module, which ./dev playground builds"])
