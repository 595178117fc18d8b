# SPDX-License-Identifier: MIT
"""Exports of one log against the readers of others: exports_test.py EXPORT_SAMPLES PROJECT. Run by ctest."""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import can
import cantools
import lcm
import numpy
from pyulog import ULog

PROGRAM = sys.argv[1]
PROJECT = pathlib.Path(sys.argv[2])
FOLDER = tempfile.TemporaryDirectory()
HERE = pathlib.Path(FOLDER.name)
subprocess.run([PROGRAM, HERE], check=True, env=os.environ | {"FANTAIL_PYTHON": sys.executable})
subprocess.run(["lcm-gen", "--python", "--ppath", HERE, *(PROJECT / "tools/telemetry/types").glob("*.lcm")], check=True)
sys.path.insert(0, str(HERE))
import fantail_lcm  # noqa: E402  generated just now


def table(name):
    """The columns of a CSV; numbers where all cells are numbers or empty (NaN)."""
    with open(HERE / name, newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {}
    for column in rows[0]:
        cells = [row[column] for row in rows]
        try:
            columns[column] = numpy.array([float(cell) if cell else math.nan for cell in cells])
        except ValueError:
            columns[column] = cells
    return columns


class UlogByPyulog(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = ULog(str(HERE / "flight.ulg"), disable_str_exceptions=False)
        cls.csv = table("fields.csv")

    def test_it_is_whole_and_says_what_flew(self):
        self.assertFalse(self.log.file_corruption)
        self.assertEqual(self.log.start_timestamp, 10_000_000)
        self.assertEqual(self.log.last_timestamp, 10_999_000)
        for key, value in {"sys_name": "Fantail", "ver_sw": "9.8.7", "git_hash": "0123abc", "vehicle": "paper dart",
                           "flight": 4096, "power_up": 7}.items():
            self.assertEqual(self.log.msg_info_dict[key], value)

    def test_every_value_is_that_of_the_csv(self):
        recorded = self.log.get_dataset("fantail_recorded").data
        replayed = self.log.get_dataset("fantail_replayed").data
        self.assertEqual(len(recorded) + len(replayed) - 2, len(self.csv))  # each has a timestamp too
        self.assertTrue((recorded["timestamp"] == self.csv["time_us"]).all())
        reached = numpy.isin(self.csv["time_us"], replayed["timestamp"])
        self.assertEqual(reached.sum(), 940)
        words = 0
        for name, values in self.csv.items():
            found = recorded[name] if name in recorded else replayed[name]
            if isinstance(values, list):
                words += 1
                continue
            wanted = values if name in recorded else values[reached]
            # 24 bits of a float beside six decimals
            numpy.testing.assert_allclose(found, wanted, rtol=1.2e-7, atol=0.6e-6, equal_nan=True, err_msg=name)
        self.assertGreater(words, 0)

    def test_every_field_has_its_unit_and_a_description(self):
        told = {}
        for topic in ("fantail_recorded", "fantail_replayed", "fantail_health"):
            for [text] in self.log.msg_info_multiple_dict[topic]:
                name, unit, description = text.split(" ", 2)
                self.assertTrue(unit.startswith("[") and unit.endswith("]") and len(unit) > 2 and description, text)
                told[topic, name] = unit
            fields = {name for name in self.log.get_dataset(topic).data if name != "timestamp"}
            self.assertEqual(fields, {name for of, name in told if of == topic})
        self.assertEqual(told["fantail_replayed", "roll_rate_deg_s"], "[deg/s]")
        self.assertEqual(told["fantail_recorded", "time_us"], "[us]")
        self.assertEqual(told["fantail_health", "bus_state"], "[-]")

    def test_enumerations_are_numbers_in_the_order_of_their_words(self):
        phases = ["safe", "armed", "launched", "controlling", "finished"]
        found = self.log.get_dataset("fantail_recorded").data["phase"]
        self.assertEqual([phases[number] for number in found], self.csv["phase"])

    def test_events_gaps_plan_and_health_are_there(self):
        texts = [(m.timestamp, m.log_level_str(), m.message) for m in self.log.logged_messages]
        self.assertEqual(texts, [(10_100_000, "INFO", "Launched: launch detected"),
                                 (10_700_000, "WARNING", "canard 3 stalled")])
        self.assertEqual([d.duration for d in self.log.dropouts], [51])
        plan = self.log.initial_parameters
        self.assertEqual(plan["launch_detection.threshold_g"], 2.5)
        self.assertEqual(plan["launch_detection.low_pass"], 1)
        health = self.log.get_dataset("fantail_health").data
        self.assertEqual(list(health["longest_tick_us"]), [50, 150, 950])


class CandumpByCantools(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.database = cantools.database.load_file(PROJECT / "firmware/protocol/canard_bus.dbc")
        with can.CanutilsLogReader(str(HERE / "flight.log")) as reader:
            cls.frames = list(reader)
        cls.csv = table("fields.csv")
        cls.row = {round(time): i for i, time in enumerate(cls.csv["time_us"])}

    def messages(self, name):
        frame_id = self.database.get_message_by_name(name).frame_id
        return [(round(frame.timestamp * 1e6), self.database.decode_message(frame_id, frame.data, decode_choices=False))
                for frame in self.frames if frame.arbitration_id == frame_id]

    def check(self, message, signal, column, scale=1.0):
        """Every value of a signal is its column's, to the bit that the bus has."""
        resolution = self.database.get_message_by_name(message).get_signal_by_name(signal).scale
        found = self.messages(message)
        self.assertTrue(found)
        for time, values in found:
            self.assertLessEqual(abs(values[signal] - scale * self.csv[column][self.row[time]]), 0.55 * resolution,
                                 (signal, time))

    def test_every_frame_is_in_the_database(self):
        for frame in self.frames:
            self.assertEqual(frame.channel, "can0")
            self.assertEqual(frame.dlc, 8)
            self.database.decode_message(frame.arbitration_id, frame.data)
        self.assertEqual(len(self.messages("EncoderReport")), 850)

    def test_values_are_those_of_the_csv(self):
        for canard in "123":
            self.check("CommandReport", "canard_" + canard, f"command_{canard}_deg")
            self.check("EncoderReport", "canard_" + canard, f"encoder_{canard}_deg")
        self.check("MotionReport", "roll_angle", "roll_angle_deg")
        self.check("MotionReport", "roll_rate", "roll_rate_deg_s")
        self.check("MotionReport", "speed", "speed_m_s")
        self.check("StatusReport", "roll_command", "command_deg")


class LcmLogByLcm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        types = {"FANTAIL_STATE": fantail_lcm.state_t, "FANTAIL_CANARDS": fantail_lcm.canards_t,
                 "FANTAIL_EVENT": fantail_lcm.event_t, "FANTAIL_HEALTH": fantail_lcm.health_t}
        cls.messages = {channel: [] for channel in types}
        log = lcm.EventLog(str(HERE / "flight.lcmlog"), "r")
        for event in log:
            cls.messages[event.channel].append((event.timestamp, types[event.channel].decode(event.data)))
        log.close()
        cls.csv = table("fields.csv")
        cls.row = {round(time): i for i, time in enumerate(cls.csv["time_us"])}

    def test_there_is_a_state_and_the_canards_for_each_replayed_tick(self):
        replayed = [time for time, angle in zip(self.csv["time_us"], self.csv["roll_angle_deg"]) if not math.isnan(angle)]
        for channel in ["FANTAIL_STATE", "FANTAIL_CANARDS"]:
            self.assertEqual([time for time, _ in self.messages[channel]], replayed)

    def test_numbers_run_on_in_each_channel_and_the_run_is_one(self):
        self.assertEqual(len({m.run for list_ in self.messages.values() for _, m in list_}), 1)
        for channel, list_ in self.messages.items():
            self.assertEqual([m.sequence for _, m in list_], list(range(len(list_))), channel)
            self.assertEqual([m.time_us for _, m in list_], [time for time, _ in list_], channel)

    def same(self, found_rad, column, time):
        wanted = self.csv[column][self.row[time]]
        if math.isnan(wanted):
            self.assertTrue(math.isnan(found_rad), (column, time))
        else:
            self.assertAlmostEqual(math.degrees(found_rad), wanted, delta=0.6e-6, msg=(column, time))

    def test_values_are_those_of_the_csv(self):
        for time, state in self.messages["FANTAIL_STATE"]:
            self.same(state.roll_angle_rad, "roll_angle_deg", time)
            self.same(state.roll_rate_rad_s, "roll_rate_deg_s", time)
            self.same(state.command_rad, "command_deg", time)
            self.assertAlmostEqual(state.speed_m_s, self.csv["speed_m_s"][self.row[time]], delta=0.6e-6)
        for time, canards in self.messages["FANTAIL_CANARDS"]:
            for i in range(4):
                self.same(canards.command_rad[i], f"command_{i + 1}_deg", time)
                self.same(canards.encoder_rad[i], f"encoder_{i + 1}_deg", time)

    def test_changes_of_the_phase_and_health_are_those_of_the_log(self):
        phases = [(time, m.phase_before, m.phase) for time, m in self.messages["FANTAIL_EVENT"]]
        self.assertEqual(phases, [(10_100_000, 1, 2), (10_300_000, 2, 3)])
        self.assertEqual([(time, round(m.longest_tick_s * 1e6)) for time, m in self.messages["FANTAIL_HEALTH"]],
                         [(10_050_000, 50), (10_150_000, 150), (10_950_000, 950)])


class JsonByPython(unittest.TestCase):
    def test_the_lists_make_the_table_of_the_csv(self):
        with open(HERE / "flight.json") as file:
            ticks = json.load(file)["ticks"]
        columns = table("fields.csv")
        self.assertEqual(list(ticks), list(columns))
        for name, values in columns.items():
            if isinstance(values, list):
                self.assertEqual([word or "" for word in ticks[name]], values, name)
            else:
                found = [math.nan if value is None else float(value) for value in ticks[name]]
                numpy.testing.assert_allclose(found, values, rtol=0, atol=0.6e-6, equal_nan=True, err_msg=name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
