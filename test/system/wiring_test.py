# SPDX-License-Identifier: MIT
"""Usage: wiring_test.py PROJECT

Is the stored drawing of the wiring what the pin map gives, is no text in it written over another, and is a pin map that the drawing
cannot follow refused?
"""

import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1)).absolute()
PIN_MAP, DRAWING = "firmware/boards/stm32f405/pin_map.hpp", "docs/images/wiring.svg"
TEXT = re.compile(r'<text x="([\d.]+)" y="([\d.]+)" class="(\w*)" text-anchor="(\w+)">([^<]+)</text>')
LETTER = 0.58  # the width of a letter over the size of its font: the mean, of a wide font
TABLE_LINE = "    select('A', 4),  // IMU select\n"


def place(found):
    """Left, right, top, bottom."""
    x, baseline, size = float(found[1]), float(found[2]), 11 if found[3] == "soft" else 12
    wide = LETTER * size * len(found[5])
    left = x - {"start": 0, "middle": wide / 2, "end": wide}[found[4]]
    return left, left + wide, baseline - 0.7 * size, baseline


class Wiring(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.map = (PROJECT / PIN_MAP).read_text(encoding="utf-8")
        for file in (PIN_MAP, DRAWING):
            (self.folder / file).parent.mkdir(parents=True)
        self.assertIn(TABLE_LINE, self.map)

    def drawn(self, *change, check=False):
        (self.folder / PIN_MAP).write_text(self.map.replace(*change) if change else self.map, encoding="utf-8")
        command = [sys.executable, "-B", PROJECT / "tools/docs/wiring.py", self.folder, *(["--check"] if check else [])]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def test_the_stored_drawing_is_what_the_pin_map_gives(self):
        self.assertEqual(self.drawn(), (0, ""))
        self.assertEqual((self.folder / DRAWING).read_text(encoding="utf-8"), (PROJECT / DRAWING).read_text(encoding="utf-8"),
                         "python3 tools/docs/wiring.py . draws it anew")
        self.assertEqual(self.drawn(check=True), (0, ""))

    def test_its_colours_are_literal_for_programs_that_know_no_variables(self):
        drawing = (PROJECT / DRAWING).read_text(encoding="utf-8")
        self.assertNotIn("var(", drawing)
        self.assertIn("prefers-color-scheme: dark", drawing)

    def test_a_pin_that_has_moved_is_noticed_and_drawn(self):
        self.assertEqual(self.drawn(), (0, ""))
        moved = (TABLE_LINE, TABLE_LINE.replace("'A', 4", "'D', 2"))
        code, said = self.drawn(*moved, check=True)
        self.assertEqual(code, 1)
        self.assertIn("is not what the pin map gives", said)
        self.assertEqual(self.drawn(*moved), (0, ""))
        drawing = (self.folder / DRAWING).read_text(encoding="utf-8")
        self.assertEqual((drawing.count(">PA4<"), drawing.count(">PD2<")), (0, 2))

    def test_every_pin_is_in_the_drawing(self):
        drawing = (PROJECT / DRAWING).read_text(encoding="utf-8")
        pins = re.findall(r"'([A-K])', (\d+)[,)]", self.map)
        self.assertGreater(len(pins), 30)
        for port, number in pins:
            self.assertRegex(drawing, rf"\bP{port}{number}\b")

    def test_what_cannot_be_drawn_is_an_error(self):
        for line, said in (("", "has no pin for: IMU select"),
                           (TABLE_LINE + "    select('D', 2),  // brake\n", "has no place for: brake"),
                           (TABLE_LINE + "    select('D', 2),\n", "this is no pin with its use behind it: select('D', 2),"),
                           (TABLE_LINE.replace("'A', 4", "'A', 13"), "PA13 (IMU select): pin or use is there twice, or the pin is reserved"),
                           (TABLE_LINE.replace("'A', 4", "'A', 5"), "is there twice")):
            code, printed = self.drawn(TABLE_LINE, line)
            self.assertEqual(code, 1)
            self.assertIn(said, printed)
            self.assertFalse((self.folder / DRAWING).exists())

    def test_no_text_is_written_over_another(self):
        texts = list(TEXT.finditer((PROJECT / DRAWING).read_text(encoding="utf-8")))
        self.assertGreater(len(texts), 150)
        for one, other in itertools.combinations(texts, 2):
            a, b = place(one), place(other)
            apart = a[1] <= b[0] or b[1] <= a[0] or a[3] <= b[2] or b[3] <= a[2]
            self.assertTrue(apart, f"{one[5]} and {other[5]}")


unittest.main()
