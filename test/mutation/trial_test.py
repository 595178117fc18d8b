# SPDX-License-Identifier: MIT
"""Usage: trial_test.py

Mutants of a project of one file, made by hand, with the compiler of this machine and with compilers that lie.
"""

import json
import os
import pathlib
import shutil
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True  # not between the sources
import trial
import workshop
from mutant import Mutant

PRODUCT = """constexpr int limit = 9;
int counted(int to) {
  if (to < 0) {
    return -1;
  }
  if (to > limit) {
    return -2;
  }
  volatile int i = 0;
  while (i < to) {
    i = i + 1;
  }
  return i;
}
"""
HEADER = """inline int doubled(int x) { return x * 2; }
struct Box { int value = 3; };
template <int n> struct Row { int length = n; };
using Two = Row<2>;
"""
USER = """#include "core/doubled.hpp"
int doubled_by_product(int x) { return doubled(x); }
int boxed() { return Box{}.value; }
int length_of(Two row) { return row.length; }
int four_times(int x) { return doubled(x) + doubled(x); }
int optimised() {
#ifdef __OPTIMIZE__
  return 1;
#else
  return 0;
#endif
}
"""
TEST = """#include <gtest/gtest.h>
#include "core/doubled.hpp"
int counted(int);
int doubled_by_product(int);
int optimised();
int length_of(Two row);
TEST(Box, Three) { EXPECT_EQ(Box{}.value, 3); EXPECT_EQ(length_of(Two{}), 2); }
TEST(Counted, Three) { EXPECT_EQ(counted(3), 3); }
TEST(Counted, Negative) { EXPECT_LT(counted(-1), 0); EXPECT_EQ(counted(9), 9); }
TEST(Doubled, Zero) { EXPECT_EQ(doubled_by_product(0), 0); }
"""
NINJA = ("rule link\n  command = : && c++ test.o /usr/lib/x86_64-linux-gnu/libgtest.a -o $out && :\n"
         "build test/core/test_core: link\n")
COMPILED = {}  # what never changes is compiled once: name or text -> object
RUNNER = ("runner.o", "runner.key")
# Every project lies in the same place, one after another: what one has prepared is prepared for the others of its kind.
PLACE = tempfile.mkdtemp()
PREPARED = {}  # (compiler, test) -> a copy of what the mutants have in common


class Project:
    """A root with one build folder, as much of each as the workshop looks at."""

    def __init__(self, folder, compiler="c++", test=TEST):
        self.root = pathlib.Path(folder)
        self.build = self.root / "build"
        for path, text in {"firmware/core/counted.cpp": PRODUCT, "firmware/core/user.cpp": USER,
                           "firmware/core/doubled.hpp": HEADER, "build/test.cpp": test, "build/build.ninja": NINJA,
                           workshop.RUNNER: pathlib.Path(__file__).with_name("runner.cpp").read_text()}.items():
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text(text)
        commands = [{"file": str(self.root / file), "directory": str(self.build),
                     "command": f"{compiler} -O2 -I{self.root}/firmware -o x.o -c {self.root / file}"}
                    for file in ("firmware/core/counted.cpp", "firmware/core/user.cpp")]
        commands.append({"file": str(self.build / "test.cpp"), "directory": str(self.build),
                         "command": f"c++ -std=c++20 -I{self.root}/firmware -o test.o -c {self.build}/test.cpp"})
        (self.build / "compile_commands.json").write_text(json.dumps(commands))
        if test not in COMPILED:
            workshop.tool(["c++", "-std=c++20", "-I../firmware", "-c", "test.cpp", "-o", "test.o"], self.build, "the test of this test")
            COMPILED[test] = (self.build / "test.o").read_bytes()
        (self.build / "test.o").write_bytes(COMPILED[test])
        self.shop = workshop.Workshop(self.root, self.build, self.root / "build/mutation")
        self.kind = compiler, test

    def court(self):
        court = trial.Court(self.shop)
        self.shop.folder.mkdir(exist_ok=True)
        for name in RUNNER:
            if name in COMPILED:
                (self.shop.folder / name).write_bytes(COMPILED[name])
        if self.kind in PREPARED:
            shutil.copytree(PREPARED[self.kind], self.shop.folder, dirs_exist_ok=True)
        court.prepare()
        for name in RUNNER:
            COMPILED[name] = (self.shop.folder / name).read_bytes()
        if self.kind not in PREPARED:
            PREPARED[self.kind] = f"{PLACE}/prepared{len(PREPARED)}"
            shutil.copytree(self.shop.folder, PREPARED[self.kind])
        return court

    def outcome(self, court, was, now, file="firmware/core/counted.cpp", function="", early=False):
        text = (self.root / file).read_text()
        begin = text.index(was)
        line = text.count("\n", 0, begin) + 1
        mutant = Mutant(file, begin, begin + len(was), now, "slip", line, 1, function, was, now, line, early)
        place = self.root / "build/mutation/place"
        place.mkdir(exist_ok=True)
        return court.try_mutant(mutant, place)


class InAFolder(unittest.TestCase):
    def setUp(self):
        self.folder = f"{PLACE}/project"
        os.mkdir(self.folder)
        self.addCleanup(shutil.rmtree, self.folder)
        for what, only in (("workshop.FOLDERS", ("core",)), ("trial.PROGRAMS", {"core": ("core",)})):
            patched = unittest.mock.patch(what, only)
            patched.start()
            self.addCleanup(patched.stop)


class Trial(InAFolder):
    def test_each_outcome(self):
        project = Project(self.folder)
        court = project.court()
        with unittest.mock.patch("trial.LEAST_LIMIT_S", 1):
            outcome, test = project.outcome(court, "i = i + 1", "i = i")
        # Both tests of the loop notice it; which is begun first depends on how long they took before.
        self.assertEqual(outcome, "timeout")
        self.assertIn(test, ("test_core Counted.Three", "test_core Counted.Negative"))
        outcome, test = project.outcome(court, "i < to", "i <= to")
        self.assertIn((outcome, test), [("killed", "test_core Counted.Three"), ("killed", "test_core Counted.Negative")])
        self.assertEqual(project.outcome(court, "i < to", "i != to"), ("survived", "2 tests reach it, nor do 2 others notice it"))
        self.assertEqual(project.outcome(court, "i = i + 1", "i = 1 + i"), ("same", ""))
        self.assertEqual(project.outcome(court, "i < to", "i <"), ("invalid", ""))
        self.assertEqual(project.outcome(court, "return i", "__builtin_trap()")[0], "killed")

    def test_what_only_the_optimiser_sees_to_be_the_same_is_the_same(self):
        project = Project(self.folder)
        court = project.court()
        self.assertEqual(project.outcome(court, "doubled(x) + doubled(x)", "x * 2 + x * 2", "firmware/core/user.cpp"), ("same", ""))

    def test_a_mutant_of_a_header_takes_the_place_of_every_copy(self):
        project = Project(self.folder)
        court = project.court()
        header = "firmware/core/doubled.hpp"
        self.assertEqual(project.outcome(court, "x * 2", "x + 2", header, "doubled")[0], "killed")
        self.assertEqual(project.outcome(court, "x * 2", "x * 3", header, "doubled")[0], "survived")
        self.assertEqual(project.outcome(court, "x * 2", "2 * x", header, "doubled")[0], "same")
        self.assertEqual(project.outcome(court, "x * 2", "x + 2", header)[0], "killed")

    def test_tests_that_reach_a_line_are_asked_first(self):
        project = Project(self.folder)
        court = project.court()
        self.assertEqual(project.outcome(court, "return -2", "return -3")[1], "0 tests reach it, nor do 4 others notice it")
        self.assertEqual(project.outcome(court, "return -1", "return -3")[1], "1 tests reach it, nor do 3 others notice it")
        # What the compiler may have computed is noticed by whoever reaches the file.
        self.assertEqual(project.outcome(court, "return -2", "return -3", early=True)[1], "2 tests reach it, nor do 2 others notice it")
        self.assertEqual(project.outcome(court, "limit = 9", "limit = 8", early=True), ("killed", "test_core Counted.Negative"))

    def test_one_that_the_table_of_lines_has_missed_is_asked_before_anything_is_called_a_survivor(self):
        project = Project(self.folder)
        court = project.court()
        with unittest.mock.patch.object(court.reach, "of", return_value=[]):
            self.assertEqual(project.outcome(court, "return i", "return 4")[0], "killed")
            self.assertEqual(project.outcome(court, "x * 2", "x + 2", "firmware/core/doubled.hpp", "doubled")[0], "killed")

    def test_a_test_that_has_a_value_of_a_header_itself_notices_another_value(self):
        project = Project(self.folder)
        court = project.court()
        header = "firmware/core/doubled.hpp"
        self.assertEqual(project.outcome(court, "value = 3", "value = 4", header, early=True), ("killed", "test_core Box.Three"))
        self.assertEqual(project.outcome(court, "value = 3", "value = 3.5", header, early=True), ("same", ""))

    def test_a_header_that_changes_the_name_of_a_function_is_compiled_into_the_tests_too(self):
        project = Project(self.folder)
        court = project.court()
        header = "firmware/core/doubled.hpp"
        self.assertEqual(project.outcome(court, "Row<2>", "Row<3>", header, early=True), ("killed", "test_core Box.Three"))

    def test_what_was_prepared_is_kept_until_something_changes(self):
        project = Project(self.folder)
        project.court()
        again = Project(self.folder)
        with unittest.mock.patch("trial.run_tests", side_effect=AssertionError), \
                unittest.mock.patch.object(again.shop, "keep", side_effect=AssertionError):
            again.court()
        other = Project(self.folder, test=TEST.replace("counted(3), 3", "counted(4), 4"))
        with unittest.mock.patch("trial.run_tests", side_effect=workshop.ToolFailure("asked")):
            self.assertRaisesRegex(workshop.ToolFailure, "asked", other.court)
        (project.root / "firmware/core/doubled.hpp").write_text(HEADER.replace("x * 2", "x * 0"))
        court = trial.Court(workshop.Workshop(project.root, project.build, project.shop.folder))
        court.prepare()
        self.assertEqual(project.outcome(court, "x * 0", "0 * x", "firmware/core/doubled.hpp", "doubled")[0], "same")

    def test_tests_that_fail_without_a_mutant_are_no_judge(self):
        with self.assertRaisesRegex(workshop.ToolFailure, "fails without any mutant"):
            Project(self.folder, test=TEST.replace("counted(3), 3", "counted(3), 4")).court()

    def test_nor_are_those_that_fail_only_as_they_are_compiled_for_mutants(self):
        project = Project(self.folder, test=TEST.replace("doubled_by_product(0), 0", "optimised(), 0"))
        court = project.court()
        with self.assertRaisesRegex(workshop.ToolFailure, "fails without any mutant"):
            project.outcome(court, "return 1", "return 2", "firmware/core/user.cpp")

    def test_tests_that_run_nothing_are_no_judge(self):
        with self.assertRaisesRegex(workshop.ToolFailure, "has not run what it should"):
            Project(self.folder, test=TEST.replace("EXPECT_EQ(counted(3), 3)", "GTEST_SKIP()")).court()
        with self.assertRaisesRegex(workshop.ToolFailure, "names no tests"):
            Project(self.folder, test="#include <gtest/gtest.h>\nint counted(int);\nint three = counted(3);\n").court()

    def test_a_program_that_ends_in_the_middle_is_loud(self):
        for script in ("exit 0", "echo passed A.B 0.1; exit 0", "echo failed A.B 0.1", "echo passed A.B 0.1; echo end; exit 1"):
            program = pathlib.Path(self.folder, "program")
            program.write_text(f"#!/bin/sh\n{script}\n")
            program.chmod(0o755)
            with self.assertRaisesRegex(workshop.ToolFailure, "has not run what it should"):
                trial.run_tests(program, [("A.B", 1)], program.parent)

    def test_a_program_that_cannot_be_linked_is_loud(self):
        project = Project(self.folder)
        court = project.court()
        with self.assertRaisesRegex(workshop.ToolFailure, "cannot be linked"):
            project.outcome(court, "return i", "extern int nowhere(); return nowhere()")


class LyingCompiler(InAFolder):
    def says(self, script, words):
        compiler = pathlib.Path(self.folder, "g++")
        compiler.write_text(f"#!/bin/sh\n{script}\n")
        compiler.chmod(0o755)
        with self.assertRaisesRegex(workshop.ToolFailure, words):
            Project(self.folder, str(compiler)).court()

    def test_that_writes_nothing(self):
        self.says("exit 0", "takes a file with an #error|written nothing")

    def test_that_takes_everything_for_a_program(self):
        self.says('while [ $# -gt 1 ]; do shift; done; echo object >"$1"; exit 0', "#error")

    def test_that_makes_the_same_of_everything(self):
        self.says('! grep -q "#error" source/* || { echo "error: no"; exit 1; }\n'
                  'for last; do :; done; echo object >"$last"', "the same object of two different programs")

    def test_that_fails_without_an_error(self):
        self.says("echo out of luck; exit 1", "failed without an error")

    def test_that_is_killed(self):
        self.says("kill -9 $$", "ended with -9")

    def test_that_is_not_there(self):
        with self.assertRaisesRegex(workshop.ToolFailure, "No such file"):
            Project(self.folder, "/nowhere/g++").court()


if __name__ == "__main__":
    try:
        unittest.main()
    finally:
        shutil.rmtree(PLACE)
