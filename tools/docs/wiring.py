# SPDX-License-Identifier: MIT
"""Usage: wiring.py PROJECT [--check]

Draws docs/images/wiring.svg from the board's pin map. A pin that moves there moves in the drawing; a pin whose use has no place in the
drawing is an error, and so is a place without a pin. --check writes nothing; exit code 1 if the stored drawing is another one.
"""

import pathlib
import re
import string
import sys

PIN_MAP, DRAWING = "firmware/boards/stm32f405/pin_map.hpp", "docs/images/wiring.svg"
ENTRY = re.compile(r"(?:PinSetup\{|spi\(|select\()'([A-K])', (\d+)\b.*[)}],  // (.+?)(?:, ((?:TIM|SPI|CAN|USART|ADC)\w+))?")
NOT_IN_THE_MAP = {"probe data": ("PA13", "SWDIO"), "probe clock": ("PA14", "SWCLK")}  # the firmware never sets these up
RESERVED = {"PA11", "PA12", "PA13", "PA14", "PC14", "PC15", "PH0", "PH1"}

# In pixels: sizes; edges of the boxes; parts of a wire, from the edge of the device or (a resistor in the wire, a trunk) of the board.
WIDTH, ROW, TITLE, GAP, TOP, DEVICES, LEFT, BOARD, RIGHT = 900, 17, 21, 12, 14, 92, (104, 236), (346, 578), (708, 888)
SERIES, PULL, TRUNKS, LIGHT = 28, {1: 34, -1: 58}, (16, 28, 40), "status light"
LIGHT_COLOURS = {"paper": "#fff", "ink": "#1f2933", "soft": "#586069", "wash": "#f4f6f8", "pin": "#0f5fb5", "hot": "#b3261e"}
DARK_COLOURS = {"paper": "#12171c", "ink": "#e6ebf0", "soft": "#a3adb8", "wash": "#1a2128", "pin": "#7cb8f7", "hot": "#ff8078"}
# Without variables, which many programs that are no browser do not know: they would draw everything black.
SHAPES = """text { font-family: system-ui, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; font-size: 12px; }
.wire { fill: none; stroke-width: 1.2; } .hot { stroke-width: 2; } .title, .pin { font-weight: 600; } .soft { font-size: 11px; }"""
COLOURS = """text, .dot { fill: $ink; } .box { fill: $wash; stroke: $ink; } .paper { fill: $paper; }
.part { fill: $paper; stroke: $ink; } .wire { stroke: $ink; } .hot { stroke: $hot; } .pin { fill: $pin; } .soft { fill: $soft; }"""
STYLE = "\n".join(("", SHAPES, string.Template(COLOURS).substitute(LIGHT_COLOURS),
                   "@media screen and (prefers-color-scheme: dark) {", string.Template(COLOURS).substitute(DARK_COLOURS), "}", ""))

# A row: its name at the device, and what it is wired to: (use in the pin map, part in the wire, part to a supply), a line, or nothing.
SUPPLY = ("3.3 V and GND", None)
LEFT_DEVICES = [
    ("IMU ICM-42688-P", [("CS", ("IMU select",)), ("SCLK", ("IMU clock",)), ("SDO", ("IMU data out",)), ("SDI", ("IMU data in",)),
                         ("INT1", ("IMU data ready",)), ("3.3 V, GND; 100 nF", None)]),
    ("CAN SN65HVD230", [("RXD", ("CAN receive",)), ("TXD", ("CAN transmit",)), ("Rs", ("CAN transceiver silent", None, "10 kΩ to 3.3 V")),
                        SUPPLY, ("CANH", "CANH"), ("CANL", "CANL")]),
    ("CAN adapter, PC", [("CANH", "CANH"), ("CANL", "CANL"), ("GND to GND", None)]),
    ("Serial console", [("RX", ("console transmit",)), ("TX", ("console receive",)), ("GND; 3.3 V levels", None)]),
    ("Arm switch", [("contact", ("arm switch",)), ("closed reads high", None), ("contact", ("3.3 V", "1 kΩ"))]),
    ("Abort contact", [("contact", ("abort contact", "1 kΩ")), ("closed reads low", None), ("optional; ends at GND", None)]),
    ("Buzzer, NPN", [("base", ("buzzer", "1 kΩ")), ("emitter to GND", None)]),
    *((f"Servo {i}", [("signal", (f"servo {i}", "100 Ω", "10 kΩ to GND")), ("+", "+"), ("−", "−")]) for i in (1, 2, 3, 4))]
RIGHT_DEVICES = [
    *((f"Encoder {i} AS5047P", [("CLK", ("encoder clock",)), ("MISO", ("encoder data out",)), ("MOSI", ("encoder data in",)),
                                ("CSn", (f"encoder {i} select",)), SUPPLY]) for i in (1, 2, 3, 4)),
    *((name, [("SCLK", ("accelerometer, flash, second IMU and barometer clock",)), ("SDO", ("their data out",)), ("SDI", ("their data in",)),
              (select, (use, *parts)), *rest]) for name, select, use, parts, rest in (
        ("Accelerometer KX134", "nCS", "second accelerometer select", (), [SUPPLY]),
        ("Flash W25Q128JV", "/CS", "flash select", (None, "10 kΩ to 3.3 V"), [("/WP and /HOLD to 3.3 V", None), SUPPLY]),
        ("2nd IMU ISM330DHCX", "CS", "second IMU select", (), [("optional; 3.3 V and GND", None)]),
        ("Barometer MS5611", "CSB", "barometer select", (), [("PS to GND; 100 nF", None), ("optional; 3.3 V and GND", None)]))),
    ("SWD probe", [("SWDIO", ("probe data",)), ("SWCLK", ("probe clock",)), ("GND, NRST", None)]),
    ("Battery divider", [("tap", ("battery divider",)), ("10 kΩ and 100 nF to GND", None), ("100 kΩ to battery +", None)])]
NOTES = ("Wiring", "Lines are joined only where there is a dot. Pins stand in the order of their use, not of their place on the board.",
         "Leave the microSD slot empty and take off its pull-ups at PC8 and PC9. Leave PC14 and PC15 to the 32 kHz crystal.",
         "VBAT to 3.3 V. USB (PA11, PA12) is for the boot loader alone. Pyrotechnics: own battery, own switch, nothing in common with this.")


def error(text):
    raise SystemExit(f"wiring: {text}")


def pins_of(text):
    """What each use in the pin map is wired to: pin and function."""
    table, pins = text.split("std::to_array<PinSetup>({", 1)[1].split("\n});", 1)[0], dict(NOT_IN_THE_MAP)
    for line in re.findall(r"^ *([^ /\n].*)", table, re.MULTILINE):
        found = ENTRY.fullmatch(line) or error(f"{PIN_MAP}: this is no pin with its use behind it: {line}")
        pin, use = f"P{found[1]}{found[2]}", found[3]
        if use in pins or pin in RESERVED or pin in (other for other, _ in pins.values()):
            error(f"{PIN_MAP}: {pin} ({use}): pin or use is there twice, or the pin is reserved")
        pins[use] = (pin, (found[4] or "").replace("_", " "))
    return pins


class Drawing:
    def __init__(self, pins):
        self.pins, self.parts, self.rows = pins, [], {}

    def text(self, x, y, text, kind="", anchor="start"):
        self.parts += [f'<text x="{x}" y="{y + 4}" class="{kind}" text-anchor="{anchor}">{text}</text>'] * bool(text)

    def wire(self, *points, kind="", dots=()):
        self.parts.append(f'<path class="wire {kind}" d="M{" L".join(f"{x} {y}" for x, y in points)}"/>')
        self.parts += [f'<circle class="dot" cx="{x}" cy="{y}" r="3"/>' for x, y in dots]

    def box(self, x, y, width, height, kind="box", title=""):
        self.parts.append(f'<rect class="{kind}" x="{x}" y="{y}" width="{width}" height="{height}" rx="3"/>')
        self.text(x + width / 2, y + 12, title, "title", "middle")

    def resistor(self, x, y, value, to=None):
        """In a wire, or (where `to` names a supply) from a wire down to that supply."""
        if to:
            self.wire((x, y), (x, y + 34), dots=[(x, y)])
            self.text(x, y + 41, to, "soft", "middle")
        self.box(x - (5 if to else 13), y + (8 if to else -5), *((10, 18) if to else (26, 10)), "part")
        self.text(x + 9 * bool(to), y + (18 if to else -12), value, "soft", "start" if to else "middle")

    def row(self, at_left, y, name, goes):
        edge, away, board, outside, near, far = (
            (LEFT[1], 1, BOARD[0], LEFT[0], "end", "start") if at_left else (RIGHT[0], -1, BOARD[1], RIGHT[1], "start", "end"))
        use, part, pull = (goes, None, None) if isinstance(goes, str) else (*(goes or [None]), None, None)[:3]
        self.text(edge - 8 * away, y, name, "" if goes else "soft", near)
        if use == "3.3 V":
            self.wire((edge, y), (board - 48, y))
            self.text(board - 44, y, use, "soft")
            board -= 50
        elif isinstance(goes, tuple):
            pin, function = self.pins.get(use) or error(f"{PIN_MAP} has no pin for: {use}")
            self.text(outside + 8 * away, y, pin, "pin", far)
            if use not in self.rows:
                self.wire((edge, y), (board, y))
                self.text(board + 8 * away, y, pin, "pin", far)
                self.text(board + 48 * away, y, function, "soft", far)
        self.rows.setdefault(use, []).append(y)
        if part:
            self.resistor(board - SERIES * away, y, part)
        if pull:
            self.resistor(edge + PULL[away] * away, y, *pull.split(" to "))

    def column(self, at_left, devices):
        (x, end), y = LEFT if at_left else RIGHT, DEVICES
        for title, rows in devices:
            self.box(x, y, end - x, TITLE + ROW * len(rows) + 5, title=title)
            for i, (name, goes) in enumerate(rows):
                self.row(at_left, y + TITLE + ROW * i + 8, name, goes)
            y += TITLE + ROW * len(rows) + 5 + GAP
        return y - GAP

    def buses(self):
        """A trunk with a branch to each row but the first, which has its wire already."""
        for i, rows in enumerate(rows for use, rows in self.rows.items() if use in self.pins and len(rows) > 1):
            x = BOARD[1] + TRUNKS[i % len(TRUNKS)]
            self.wire((x, rows[0]), (x, rows[-1]), dots=[(x, y) for y in rows[:-1]])
            for y in rows[1:]:
                self.wire((x, y), (RIGHT[0], y))

    def margin(self, y):
        """At the far left: the CAN bus with a terminator at each end; the servos' supply, with its switch above the box at y."""
        high, low = self.rows["CANH"][0] - 22, self.rows["CANL"][-1] + 22
        self.wire((22, high), (76, high), (76, low), (22, low), (22, high))
        for x, name, last in ((36, "+", y + 28), (70, "−", y + 45)):
            self.wire((x, self.rows[name][0]), (x, last), (LEFT[0], last), kind="hot" * (name == "+"))
            self.text(LEFT[0] + 8, last, name)
        for x, name in ((22, "CANH"), (76, "CANL"), (36, "+"), (70, "−")):
            for row in self.rows[name]:
                self.wire((x, row), (LEFT[0], row), kind="hot" * (name == "+"), dots=[(x, row)])
        self.resistor(49, high, "120 Ω")
        self.resistor(49, low, "120 Ω")
        self.box(28, y - 42, 16, 26, "paper")
        self.wire((36, y - 16), (24, y - 40), kind="hot")
        self.text(82, y - 30, "switch of the servos, within reach; 1000 µF at the connector", "soft")

    def supply(self, y, board_end):
        """Below the board: servo supply, battery and regulator."""
        plus, ground = y + 28, y + 78
        for x, end, title, under in ((LEFT[0], 270, "Servo supply", "5 to 7.4 V, 10 A peak"), (400, 524, "Battery", "2S or 3S"),
                                     (*RIGHT, "Regulator", "to 5 V, 1 A, switching")):
            self.box(x, y, end - x, 56, title=title)
            self.text((x + end) / 2, plus + 17, under, "soft", "middle")
            self.wire(((x + end) / 2, y + 56), ((x + end) / 2, ground), dots=[((x + end) / 2, ground)])
            self.text((x + end) / 2 + 6, y + 66, "−")
        for x, end in ((400, 270), (524, RIGHT[0])):
            self.wire((x, plus), (end, plus), kind="hot")
        for x, name, anchor in ((262, "in +", "end"), (408, "+", "start"), (516, "+", "end"), (716, "in +", "start")):
            self.text(x, plus, name, "", anchor)
        self.wire((798, y), (798, y - 20), (540, y - 20), (540, board_end), kind="hot")
        self.text(540, board_end - 12, "5V pin", "pin", "middle")
        self.text(790, y - 10, "out 5 V", "", "end")
        self.wire((187, ground), (798, ground))
        self.text(462, ground + 14, "one common ground point, also for board, sensors, servos and CAN", "soft", "middle")

    def whole(self):
        end = max(self.column(True, LEFT_DEVICES), self.column(False, RIGHT_DEVICES)) + 28
        light, _ = self.pins.get(LIGHT) or error(f"{PIN_MAP} has no pin for: {LIGHT}")
        if unknown := [use for use in self.pins if use not in self.rows and use != LIGHT]:
            error(f"{PIN_MAP}: the drawing has no place for: {'; '.join(unknown)}")
        self.buses()
        self.supply(end + 46, end)
        self.margin(end + 46)
        self.text(sum(BOARD) / 2, TOP + 36, "as on the WeAct Studio core board", "soft", "middle")
        self.text(sum(BOARD) / 2, TOP + 60, f"status light: {light}, on the board", "soft", "middle")
        for i, note in enumerate(NOTES):
            self.text(16, end + 151 + ROW * i if i else TOP + 12, note, "soft" if i else "title")
        shapes, self.parts = self.parts, []
        self.box(BOARD[0], TOP, BOARD[1] - BOARD[0], end - TOP, title="STM32F405RG")
        size = f'viewBox="0 0 {WIDTH} {end + 216}" width="{WIDTH}" height="{end + 216}"'
        return "\n".join((f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img">', "<title>Wiring of the board</title>",
                          f"<style>{STYLE}</style>", '<rect class="paper" width="100%" height="100%"/>', *self.parts, *shapes, "</svg>", ""))


def main():
    project = pathlib.Path(sys.argv[1])
    made, stored = Drawing(pins_of((project / PIN_MAP).read_text(encoding="utf-8"))).whole(), project / DRAWING
    if sys.argv[2:] != ["--check"]:
        stored.write_text(made, encoding="utf-8")
    elif not stored.exists() or stored.read_text(encoding="utf-8") != made:
        error(f"{DRAWING} is not what the pin map gives: python3 tools/docs/wiring.py . draws it")


if __name__ == "__main__":
    main()
