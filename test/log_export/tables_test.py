# SPDX-License-Identifier: MIT
"""Exports of one log as MAT-file, Parquet and MCAP against the readers of others: tables_test.py EXPORT_SAMPLES. Run by
ctest."""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import pyarrow.parquet
import scipy.io
from mcap.reader import make_reader

FOLDER = tempfile.TemporaryDirectory()
HERE = pathlib.Path(FOLDER.name)
subprocess.run([sys.argv[1], HERE], check=True, env=os.environ | {"FANTAIL_PYTHON": sys.executable})
with open(HERE / "fields.csv", newline="") as csv_file:
    ROWS = list(csv.DictReader(csv_file))
NAMES = list(ROWS[0])
with open(HERE / "flight.json") as json_file:
    JSON = json.load(json_file)


def cells(name):
    return [row[name] for row in ROWS]


class TablesHaveTheValuesOfTheCsv(unittest.TestCase):
    def same(self, name, found):
        """Numbers to the six decimals of the CSV; words and flags as they are; None and NaN where its cell is empty."""
        self.assertEqual(len(found), len(ROWS), name)
        for value, cell in zip(found, cells(name)):
            if value is None or value == "" or (isinstance(value, float) and math.isnan(value)):
                self.assertEqual(cell, "", name)
            elif isinstance(value, str):
                self.assertEqual(value, cell, name)
            else:
                self.assertLessEqual(abs(float(value) - float(cell)), 0.51e-6, (name, value, cell))

    def test_of_a_mat_file_by_scipy(self):
        mat = scipy.io.loadmat(HERE / "flight.mat")
        flight, words = mat["flight"], mat["words"]
        self.assertEqual(list(flight.dtype.names), NAMES)
        for name in NAMES:
            column = flight[name][0, 0]
            self.assertEqual(column.shape, (950, 1), name)
            if name in words.dtype.names:
                texts = [text.item() for text in words[name][0, 0][:, 0]]
                column = [None if math.isnan(place) else texts[int(place) - 1] for place in column[:, 0]]
            else:
                column = column[:, 0].tolist()
            self.same(name, column)
        for row, word in zip(flight["phase"][0, 0][:, 0], cells("phase")):
            self.assertEqual(words["phase"][0, 0][int(row) - 1, 0].item(), word)

    def test_of_a_parquet_file_by_pyarrow(self):
        table = pyarrow.parquet.read_table(HERE / "flight.parquet", page_checksum_verification=True)
        self.assertEqual(table.column_names, NAMES)
        self.assertEqual([str(table.schema.field(name).type) for name in ("time_s", "time_us", "phase", "saturated")],
                         ["double", "int64", "string", "bool"])
        for name in NAMES:
            self.same(name, table[name].to_pylist())

    def test_of_an_mcap_file_by_mcap(self):
        found = {name: {} for name in NAMES}
        with open(HERE / "flight.mcap", "rb") as stream:
            for _, channel, message in make_reader(stream, validate_crcs=True).iter_messages():
                if channel.topic in ("/fantail/recorded", "/fantail/replayed"):
                    for name, value in json.loads(message.data).items():
                        found[name][message.log_time // 1000] = value
        for name in NAMES:
            self.same(name, [found[name].get(int(time)) for time in cells("time_us")])


class TablesSayWhatTheyHold(unittest.TestCase):
    def test_units_and_descriptions_are_those_of_the_json(self):
        mat = scipy.io.loadmat(HERE / "flight.mat", simplify_cells=True)
        about = pyarrow.parquet.read_metadata(HERE / "flight.parquet").metadata[b"fantail"]
        self.assertEqual(json.loads(about), {key: value for key, value in JSON.items() if key != "ticks"})
        properties = {}
        with open(HERE / "flight.mcap", "rb") as stream:
            for schema in make_reader(stream).get_summary().schemas.values():
                self.assertEqual(schema.encoding, "jsonschema")
                properties.update(json.loads(schema.data)["properties"])
        self.assertEqual(len(JSON["columns"]), len(NAMES))
        for name, text in JSON["columns"].items():
            self.assertEqual((mat["units"][name], mat["descriptions"][name]), (text["unit"], text["description"]))
            self.assertEqual(properties[name]["description"], f"[{text['unit']}] {text['description']}")

    def test_a_mat_file_has_vehicle_plan_events_and_gaps(self):
        about = scipy.io.loadmat(HERE / "flight.mat", simplify_cells=True)["about"]
        self.assertEqual((about["vehicle"], about["git_hash"], about["flight"]), ("paper dart", "0123abc", 4096))
        self.assertEqual(about["plan"]["launch_detection"]["threshold_g"], 2.5)
        self.assertEqual([event["value"] for event in about["events"]], ["launched", "stalled"])
        self.assertEqual(about["gaps"]["records_missing"], 50)
        self.assertEqual([record["longest_tick_us"] for record in about["health"]], [50, 150, 950])

    def test_an_mcap_file_is_indexed_and_has_events_health_and_metadata(self):
        with open(HERE / "flight.mcap", "rb") as stream:
            reader = make_reader(stream, validate_crcs=True)
            summary = reader.get_summary()
            counts = {summary.channels[channel].topic: count
                      for channel, count in summary.statistics.channel_message_counts.items()}
            self.assertEqual(counts, {"/fantail/recorded": 950, "/fantail/replayed": 950, "/fantail/health": 3,
                                      "/fantail/events": 3})
            self.assertGreater(len(summary.chunk_indexes), 1)
            self.assertEqual((summary.statistics.message_start_time, summary.statistics.message_end_time),
                             (10_000_000_000, 10_999_000_000))
            stretch = reader.iter_messages(topics=["/fantail/recorded"], start_time=10_100_000_000,
                                           end_time=10_200_000_000)
            self.assertEqual(len(list(stretch)), 100)
            events = [(message.log_time // 1000, json.loads(message.data))
                      for _, _, message in reader.iter_messages(topics=["/fantail/events"])]
            self.assertEqual([(time, event["level"], event["message"]) for time, event in events],
                             [(10_100_000, 2, "Launched: launch detected"),
                              (10_550_000, 3, "50 records are missing before this"), (10_700_000, 3, "canard 3 stalled")])
            self.assertEqual(events[0][1]["timestamp"], {"sec": 10, "nsec": 100_000_000})
            [metadata] = [record.metadata for record in reader.iter_metadata()]
            self.assertEqual(metadata["vehicle"], "paper dart")
            self.assertEqual(json.loads(metadata["plan"]), JSON["plan"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
