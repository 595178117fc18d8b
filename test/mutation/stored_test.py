# SPDX-License-Identifier: MIT
"""What of an interrupted run is taken up again, and what is asked for by --resume alone."""

import contextlib
import io
import json
import os
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # not between the sources
import mutate
import stored

SAMPLE = {"sources": "1", "seed": 2, "all": False, "file": [], "sample": 300}
WHOLE = {"sources": "1", "seed": 3, "all": True, "file": [], "sample": 300}
TRIAL = {"id": "a.cpp:1:1:other", "outcome": "killed"}


def lines(*rows):
    return "".join(json.dumps(row) + "\n" for row in rows)


class Stored(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = stored.path_of(self.folder, SAMPLE)

    def test_a_line_that_was_cut_off_is_taken_off_and_the_next_one_begins_anew(self):
        self.path.write_text(lines(SAMPLE, TRIAL) + '{"id": "cut o')
        self.assertEqual(stored.read(self.path, SAMPLE), [TRIAL])
        with self.path.open("a") as stream:
            stream.write(lines(TRIAL))
        self.assertEqual(stored.read(self.path, SAMPLE), [TRIAL, TRIAL])
        # Whole but for its end: nobody knows whether more was to come.
        self.path.write_text(lines(SAMPLE, TRIAL) + json.dumps(TRIAL))
        self.assertEqual(stored.read(self.path, SAMPLE), [TRIAL])

    def test_results_of_other_sources_or_of_nothing_are_refused(self):
        for text in (lines(SAMPLE | {"sources": "2"}, TRIAL), "", "{"):
            self.path.write_text(text)
            with self.assertRaisesRegex(ValueError, "other sources"):
                stored.read(self.path, SAMPLE)
            self.assertEqual(self.path.read_text(), text)

    def test_a_sample_does_not_write_over_a_whole_run(self):
        paths = {stored.path_of(self.folder, header) for header in (SAMPLE, WHOLE, SAMPLE | {"file": ["a.cpp"]})}
        self.assertEqual(len(paths), 3)

    def test_resume_alone_goes_on_with_the_last_run(self):
        self.assertIsNone(stored.newest_selection(self.folder))
        self.path.write_text(lines(SAMPLE))
        whole = stored.path_of(self.folder, WHOLE)
        whole.write_text(lines(WHOLE))
        os.utime(self.path, (1, 1))
        self.assertEqual(stored.newest_selection(self.folder), {"all": True, "file": [], "sample": 300, "seed": 3})
        whole.write_text("damaged")
        self.assertEqual(stored.newest_selection(self.folder)["seed"], 2)

    def test_one_selection_is_asked_for(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        file = mutate.sources(root)[0]
        for words in (["--all", "--sample", "3"], ["--all", "--file", file], ["--sample", "0"], ["--file", "none.cpp"]):
            with self.assertRaises(SystemExit) as end, contextlib.redirect_stderr(io.StringIO()):
                mutate.parse(words, root)
            self.assertEqual(end.exception.code, 64)


if __name__ == "__main__":
    unittest.main()
