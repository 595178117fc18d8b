# SPDX-License-Identifier: MIT
"""Usage: mutants_test.py

The slips that are made of small texts. Exit code 77: Python's libclang is not installed (package python3-clang-19).
"""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # not between the sources
try:
    import clang.cindex
except ImportError:
    print("SKIPPED: the package python3-clang-19 is not installed")
    sys.exit(77)
import mutants

clang.cindex.Config.set_library_file("/usr/lib/x86_64-linux-gnu/libclang-19.so.1")


def changes(text, arguments=("-std=c++20", "-x", "c++")):
    """(operator, the lines that it makes) of each."""
    return {(m.operator, m.now) for m in slips(text, arguments)}


def slips(text, arguments=("-std=c++20", "-x", "c++")):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "a.cpp")
        path.write_text(text)
        found = mutants.mutants("a.cpp", str(path), list(arguments))
        again = mutants.mutants("a.cpp", str(path), list(arguments))
        assert found == again and len({m.id + m.now for m in found}) == len(found)
        return found


class Slips(unittest.TestCase):
    def made(self, text, *expected):
        found = changes(text)
        for change in expected:
            self.assertIn(change, found)

    def test_of_a_comparison_and_a_decision(self):
        self.made("bool f(int a, int b) { return a < b && b != 3; }\n",
                  ("< to <=", "bool f(int a, int b) { return a <= b && b != 3; }"),
                  ("!= to ==", "bool f(int a, int b) { return a < b && b == 3; }"),
                  ("&& to ||", "bool f(int a, int b) { return a < b || b != 3; }"),
                  ("negated", "bool f(int a, int b) { return !(a < b) && b != 3; }"),
                  ("negated", "bool f(int a, int b) { return !(a < b && b != 3); }"),
                  ("one more", "bool f(int a, int b) { return a < b && b != 4; }"))

    def test_of_arithmetic_also_of_ones_own_types(self):
        text = "struct V { float x; };\nV operator+(V a, V b);\nV operator-(V a);\nV f(V a, V b) { return -a + b; }\n"
        self.made(text, ("+ to -", "V f(V a, V b) { return -a - b; }"), ("without -", "V f(V a, V b) { return a + b; }"),
                  ("returns nothing", "V f(V a, V b) { return {}; }"))

    def test_of_constants(self):
        self.made("float f() { return 2.5F; }\n", ("zero", "float f() { return 0.0F; }"),
                  ("twice", "float f() { return 5.0F; }"))
        self.made("bool f() { return true; }\n", ("other bool", "bool f() { return false; }"))

    def test_of_statements(self):
        text = "void g(int& x);\nvoid f(int x) {\n  g(x);\n  x += 2;\n  while (x > 1) {\n    break;\n  }\n}\n"
        self.made(text, ("removed", ";"), ("+= to -=", "x -= 2;"), ("negated", "while (!(x > 1)) {"))
        self.assertEqual(sum(operator == "removed" for operator, _ in changes(text)), 1, "all read the same")

    def test_of_the_least_and_the_most(self):
        text = "namespace std { int min(int a, int b); int max(int a, int b); }\nint f(int a) { return std::min(a, 3); }\n"
        self.made(text, ("min to max", "int f(int a) { return std::max(a, 3); }"))

    def test_none_of_what_only_the_compiler_runs(self):
        self.assertEqual(changes("consteval int f() { return 3; }\nstatic_assert(1 < 2);\n"), set())

    def test_what_the_compiler_may_have_computed_is_marked(self):
        text = ("constexpr int f() { return 31; }\nint g(int x = 41);\nint g(int x) {\n  const int y = 51;\n"
                "  return x + y + 61;\n}\nint h = 71;\nstruct S {\n  int y = 81;\n  int z() { return 91; }\n};\n")
        marked = {m.replacement: m.early for m in slips(text) if m.operator == "one more"}
        self.assertEqual(marked, {"32": True, "42": True, "52": False, "62": False, "72": True, "82": True, "92": False})

    def test_a_template_is_what_stands_before_its_name_also_after_a_condition_in_parentheses(self):
        text = ("template <int n>\n  requires(n > 0)\nconstexpr int f() { return 31; }\n"
                "template <int n>\n  requires(n > 0)\nconsteval int g() { return 41; }\n"
                "template <class T>\nint h(T x) { return 51; }\n")
        marked = {m.replacement: m.early for m in slips(text) if m.operator == "one more" and m.replacement != "1"}
        self.assertEqual(marked, {"32": True, "52": False})

    def test_every_line_that_a_slip_changes_is_known(self):
        found = [m for m in slips("int g(int, int);\nvoid f(int x) {\n  g(x,\n    x);\n}\n") if m.operator == "removed"]
        self.assertEqual([(m.line, m.last_line) for m in found], [(3, 4)])

    def test_a_text_that_cannot_be_parsed_is_an_error_and_not_a_file_without_mutants(self):
        with self.assertRaisesRegex(ValueError, "cannot be parsed"):
            changes("int f( { return 1; }\n")


if __name__ == "__main__":
    unittest.main()
