# SPDX-License-Identifier: MIT
"""Usage: flight_image_test.py IMAGE.elf

The unmodified flight image on an emulated STM32F405, which has a processor and a serial port but none of the devices: what
it says on its console, and what it writes to the registers of everything that is not there. Expected numbers are worked
out here from the reference manual (RM0090) for the 16 MHz of the internal oscillator, because crystal and PLL are among the
things that are not there. Exit code 77: not possible here.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

CORE_HZ = 16_000_000
WATCHDOG = "I2S2ext"  # the emulator's name for the block at 0x40003000, which on this processor is the watchdog
BANNER = "Fantail "
ELF = pathlib.Path()


def run_bytes(elf, seconds, until, times=1):
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder, "changed.elf")
        image.write_bytes(elf)
        return run(image, seconds, until, times)


def run(elf, seconds, until, times=1, trace_bytes=0):
    """Console and register writes, up to when `until` has stood on the console so often and the trace is so long, or for
    so many seconds."""
    with tempfile.TemporaryDirectory() as folder:
        trace = pathlib.Path(folder, "trace")
        emulator = subprocess.Popen(
            ["qemu-system-arm", "-M", "netduinoplus2", "-display", "none", "-monitor", "none",
             "-serial", f"file:{folder}/console", "-icount", "shift=3,sleep=off",
             "-d", "unimp,guest_errors", "-D", str(trace), "-kernel", str(elf)],
            stdin=subprocess.DEVNULL)
        console = pathlib.Path(folder, "console")
        deadline = time.monotonic() + seconds
        try:
            while time.monotonic() < deadline and emulator.poll() is None:
                time.sleep(0.1)
                if (console.exists() and console.read_text(errors="replace").count(until) >= times
                        and trace.stat().st_size >= trace_bytes):
                    break
        finally:
            emulator.kill()
            emulator.wait()
        writes = []
        for line in trace.read_text(errors="replace").splitlines():
            m = re.match(r"(\S+): unimplemented device write +\(size 4, offset 0x(\w+), value 0x(\w+)\)", line)
            if m:
                writes.append((m[1], int(m[2], 16), int(m[3], 16)))
        return console.read_text(errors="replace"), writes


class FlightImage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Some 2000 ticks: the canards' first motion begins half a second after power-up.
        cls.console, cls.writes = run(ELF, 60, "battery_unmeasured", trace_bytes=8_000_000)

    def to(self, device, offset):
        return [value for d, o, value in self.writes if d == device and o == offset]

    def test_says_who_it_is_and_why_it_was_reset(self):
        self.assertRegex(self.console, r"Fantail \d+\.\d+\.\d+, git ([0-9a-f]{12}(-dirty|-archive)?|unknown)")
        self.assertIn("reset by power-on", self.console)

    def test_names_every_device_that_is_not_there_and_will_not_be_armed(self):
        said = [line for line in self.console.splitlines() if line.startswith("board: ")][-1]
        for fault in ("crystal_failed", "clock_failed", "imu_silent", "accelerometer_silent", "encoder_silent",
                      "flash_silent", "can_failed", "entropy_failed", "battery_unmeasured"):
            self.assertIn(fault, said)
        self.assertIn("it will not be armed", said)
        self.assertNotIn("image_broken", self.console)

    def test_never_leaves_safe(self):
        self.assertNotIn("phase:", self.console)

    def test_starts_the_watchdog_at_fifty_milliseconds_and_feeds_it(self):
        keys = self.to(WATCHDOG, 0x00)
        self.assertIn(0xCCCC, keys)  # start
        self.assertEqual(self.to(WATCHDOG, 0x04), [0])  # 32 kHz / 4
        self.assertEqual(self.to(WATCHDOG, 0x08), [400 - 1])  # 400 / 8 kHz = 50 ms
        self.assertGreater(keys.count(0xAAAA), 400)

    def test_keeps_the_canards_centred_and_the_servos_off_until_then(self):
        prescaler, reload = self.to("timer[8]", 0x28)[-1], self.to("timer[8]", 0x2C)[-1]
        count_s = (prescaler + 1) / CORE_HZ
        self.assertAlmostEqual((reload + 1) * count_s, 3e-3)  # 333 Hz
        centre = round(1500e-6 / count_s)
        for channel in range(4):
            self.assertLessEqual(set(self.to("timer[8]", 0x34 + 4 * channel)), {0, centre})
            self.assertEqual(self.to("timer[8]", 0x34 + 4 * channel)[-1], centre)
        # PWM mode 1 with preload on each channel, and the outputs are let out after the first pulse is known.
        self.assertEqual((self.to("timer[8]", 0x18)[-1], self.to("timer[8]", 0x1C)[-1]), (0x6868, 0x6868))
        order = [(o, v) for d, o, v in self.writes if d == "timer[8]"]
        self.assertGreater(order.index((0x44, 0x8000)), order.index((0x34, centre)))

    def test_gives_each_pin_its_function_and_no_other(self):
        # Function by pin: 0 to 15 alternate, "out", "in", "analog". After a reset the emulator's registers read zero, so
        # what is written for one pin is that pin's alone.
        expected = {
            "A": {3: 1, 4: "out", 5: 5, 6: 5, 7: 5, 8: 1, 9: 7, 10: 7, 15: "out"},
            "B": {0: "out", 1: "out", 2: "out", 3: 6, 4: 6, 5: 6, 8: 9, 9: 9, 10: "out", 11: "out", 12: "out", 13: 5, 14: 5, 15: 5},
            "C": {0: "out", 2: "analog", 3: "in", 4: "out", 5: "out", 6: 3, 7: 3, 8: 3, 9: 3},
        }
        for port, pins in expected.items():
            device = f"GPIO{port}"
            modes, functions = {}, {}
            for d, offset, value in self.writes:
                for pin in range(16):
                    if d == device and offset == 0x00 and value >> 2 * pin & 3:
                        modes[pin] = value >> 2 * pin & 3
                    if d == device and offset in (0x20, 0x24) and pin // 8 == (offset - 0x20) // 4:
                        if value >> 4 * (pin % 8) & 15:
                            functions[pin] = value >> 4 * (pin % 8) & 15
            found = {pin: functions[pin] if mode == 2 else {1: "out", 3: "analog"}[mode] for pin, mode in modes.items()}
            self.assertEqual(found, {pin: f for pin, f in pins.items() if f != "in"}, device)

    def test_gives_the_fastest_spi_clock_the_steepest_edges(self):
        # Errata sheet ES0182: at 84 MHz of APB2 a slow SCK (PA5) corrupts the last bit that SPI1 receives.
        self.assertIn(3, {value >> 2 * 5 & 3 for value in self.to("GPIOA", 0x08)})

    @staticmethod
    def code():
        return subprocess.run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", str(ELF)], capture_output=True, text=True,
                              check=True).stdout

    def test_waits_for_an_interrupt_at_an_address_from_which_it_wakes_up_well(self):
        # Errata sheet ES0182, "Debugging Sleep/Stop mode with WFE/WFI entry": after a probe has set DBG_SLEEP, which
        # lasts until the power goes, a WFI at an address that ends in 4 wakes up into wrong instructions.
        places = re.findall(r"^ *([0-9a-f]+):\twfi *\n((?:.*\n){3})", self.code(), re.M)
        self.assertEqual(len(places), 1)
        self.assertEqual(int(places[0][0], 16) % 8, 0)
        self.assertEqual(places[0][1].count("nop"), 3)

    def test_leaves_each_interrupt_with_its_stores_done(self):
        # Erratum 838869 of the Cortex-M4: a store that is still under way at the return may lead to a wrong handler.
        code = self.code()

        def last(function, count):
            body = re.search(rf"<{function}>:\n(.*?)\n\n", code, re.S)[1]
            lines = [line.split("@")[0].strip() for line in re.findall(r"^ *[0-9a-f]+:\t(.*)$", body, re.M)]
            return [line for line in lines if line != "nop"][-count:]  # behind it what aligns the next one

        [barrier] = set(re.findall(r"<(\w*finish_stores\w*)>:", code))
        self.assertEqual(last(barrier, 2), ["dsb\tsy", "bx\tlr"])
        for handler in ("systick", "can1_tx", "can1_rx0", "can1_sce", "usart1"):
            self.assertRegex(last(f"{handler}_handler", 1)[0], rf"^b(\.w|\.n)?\t.*<{barrier}>$")

    def test_touches_nothing_else(self):
        self.assertLessEqual({d for d, _, _ in self.writes},
                             {"CAN1", "GPIOA", "GPIOB", "GPIOC", WATCHDOG, "PWR", "RCC", "RNG", "timer[1]", "timer[8]",
                              "ADC"})

    def test_that_was_changed_by_one_bit_says_so(self):
        data = bytearray(ELF.read_bytes())
        data[data.index(b"reset by ")] ^= 0x20
        console, _ = run_bytes(data, 60, "image_broken")
        self.assertIn("image_broken", console)

    def run_with(self, instructions):
        """The image with these instructions where the report of rejected frames is packed, in the 56th tick."""
        symbols = subprocess.run(["arm-none-eabi-nm", "-C", str(ELF)], capture_output=True, text=True, check=True).stdout
        m = re.search(r"^(\w+) T fantail::protocol::encode\(fantail::protocol::RejectionReport const&\)$", symbols, re.M)
        sections = subprocess.run(["arm-none-eabi-readelf", "-SW", str(ELF)], capture_output=True, text=True,
                                  check=True).stdout
        text = re.search(r"\.text +PROGBITS +(\w+) (\w+)", sections)
        place = int(m[1], 16) - int(text[1], 16) + int(text[2], 16)
        data = bytearray(ELF.read_bytes())
        data[place:place + len(instructions)] = instructions
        return run_bytes(data, 20, BANNER, times=3)

    def test_that_reads_by_a_null_pointer_crashes(self):
        console, _ = self.run_with(b"\x00\x23\x1b\x68\x70\x47")  # movs r3, #0; ldr r3, [r3]; bx lr
        self.assertGreaterEqual(console.count(BANNER), 3)

    def test_that_crashes_centres_the_canards_and_begins_anew(self):
        console, writes = self.run_with(b"\x00\xde")  # undefined; no servo is driven yet
        self.assertGreaterEqual(console.count(BANNER), 3)
        pulses = [v for d, o, v in writes if d == "timer[8]" and o == 0x34]
        self.assertEqual(set(pulses), {0, 24_000})  # 1500 us of 16 MHz, which no tick has asked for
        outputs = [v for d, o, v in writes if d == "timer[8]" and o == 0x44]
        self.assertEqual(outputs[:2], [0, 0x400])  # off, and driven low until the reset: MOE 0, OSSI 1


def main():
    global ELF
    ELF = pathlib.Path(sys.argv.pop(1))
    for program in ("qemu-system-arm", "arm-none-eabi-nm"):
        if not shutil.which(program):
            print(f"SKIPPED: {program} is not installed")
            sys.exit(77)
    if not ELF.exists():
        print(f"SKIPPED: {ELF} has not been built: ./dev firmware")
        sys.exit(77)
    unittest.main(verbosity=2)


main()
