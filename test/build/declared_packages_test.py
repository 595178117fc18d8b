# SPDX-License-Identifier: MIT
"""Usage: declared_packages_test.py READ_LOG_SO DEV HOST_BUILD

Mistakes for declared_packages.py to find: with a small build and a database of dpkg in which this machine's files
belong to packages that do not exist, and with the real ones. Exit code 77: no dpkg here.
"""

import contextlib
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True  # not between the sources
import declared_packages

READ_LOG_SO, DEV, HOST_BUILD = sys.argv[1:]

HEADER, OTHER_HEADER = "/usr/include/stdlib.h", "/usr/include/stdio.h"
NINJA = """
rule read
  command = cp $in $out.d && cp $in $out
  deps = gcc
  depfile = $out.d
rule make
  command = cd . && %s
build tools/CMakeFiles/fantail.dir/main.cpp.o: read main
build libexec/fantail-fly: make tools/CMakeFiles/fantail.dir/main.cpp.o
build test/CMakeFiles/test_x.dir/x_test.cpp.o: read x_test
build made: make
"""


class InAFolder(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.log = self.folder / "log"
        self.dev = self.folder / "dev"

    def write_dev(self, words):
        self.dev.write_text(f"#!/bin/sh\n{words}\n")
        self.dev.chmod(0o755)

    def check(self, *builds, **environment):
        out = io.StringIO()
        with mock.patch.dict(os.environ, environment), contextlib.redirect_stdout(out):
            return declared_packages.main(str(self.dev), *builds), out.getvalue().splitlines()


class SmallMachine(InAFolder):
    """Whose packages are `packages`, where ./dev declares `fly` and `test`, and the tests have read `read`."""

    def setUp(self):
        super().setUp()
        # Of base is what every build here needs; ninja is where it is.
        base = ["/bin/sh", "/bin/echo", "/bin/cp", shutil.which("ninja")]
        self.packages = {"base": {"files": base, "Essential": "yes"},
                         "libx-dev": {"files": [HEADER]}, "liby-dev": {"files": [OTHER_HEADER]}}
        self.diversions = ""
        self.fly, self.test, self.read = "libx-dev", "libx-dev liby-dev", []
        self.make = "echo >$out"

    def write_database(self, folder):
        (folder / "info").mkdir(parents=True, exist_ok=True)
        status = ""
        for name, fields in self.packages.items():
            fields = {"Package": name, "Status": "install ok installed", "Priority": "optional", "Version": "1",
                      "Architecture": "all", "Maintainer": "m <m@m>", "Description": "d"} | fields
            status += "".join(f"{key}: {value}\n" for key, value in fields.items() if key != "files") + "\n"
            (folder / "info" / f"{name}.list").write_text("".join(f"{file}\n" for file in fields.get("files", [])))
        (folder / "status").write_text(status)
        (folder / "diversions").write_text(self.diversions)

    def verdict(self):
        database, build = self.folder / "dpkg", self.folder / "host"
        self.write_database(database)
        build.mkdir(exist_ok=True)
        (build / "CMakeCache.txt").write_text(f"CMAKE_MAKE_PROGRAM:FILEPATH={shutil.which('ninja')}\n")
        (build / "build.ninja").write_text(NINJA % self.make)
        (build / "main").write_text(f"tools/CMakeFiles/fantail.dir/main.cpp.o: {HEADER}\n")
        (build / "x_test").write_text(f"test/CMakeFiles/test_x.dir/x_test.cpp.o: {OTHER_HEADER}\n")
        subprocess.run(["ninja", "-C", build], stdout=subprocess.DEVNULL, check=True)
        self.write_dev(f'[ "$1" = packages ] && case "$2" in fly) echo {self.fly} ;; test) echo {self.test} ;; esac')
        self.log.write_text("".join("\t".join(line) + "\n" for line in self.read))
        return self.check(build, self.folder / "arm", DPKG_ADMINDIR=str(database),
                          **{"FANTAIL_READ_LOG": str(self.log)} if self.read else {})

    def expect(self, *complaints):
        code, lines = self.verdict()
        self.assertEqual((code, lines), (1, list(complaints)))

    def expect_nothing(self):
        code, lines = self.verdict()
        self.assertEqual((code, len(lines)), (0, 1), lines)
        self.assertRegex(lines[0], r"^\d+ files of \d+ packages: all of them declared")

    def test_nothing_to_find(self):
        self.expect_nothing()

    def test_header_of_a_test(self):
        self.test = "libx-dev"
        self.expect(f"liby-dev is not declared for ./dev's test: {OTHER_HEADER}, read by the build of test/x_test.cpp")

    def test_header_of_the_program_that_only_the_tests_declare(self):
        self.fly = ""
        self.expect(f"libx-dev is not declared for ./dev's fly: {HEADER}, read by the build of tools/main.cpp")

    def test_program_in_ninjas_commands(self):
        self.packages["odd"] = {"files": ["/usr/bin/env"]}
        self.make = "env >$out"
        self.expect(*(f"odd is not declared for ./dev's {tier}: /usr/bin/env, read by the commands of host/build.ninja"
                      for tier in ("fly", "test")))

    def test_library_that_what_was_built_loads(self):
        libraries = declared_packages.absolute_paths(declared_packages.run("ldd", "/bin/cat"))
        self.packages["odd"] = {"files": sorted(libraries)}
        self.packages["bin"] = {"files": ["/bin/cat"], "Essential": "yes"}
        self.make = "cp -p /bin/cat $out"
        code, lines = self.verdict()
        self.assertEqual((code, len(lines)), (1, 2))
        for line, (tier, loaded) in zip(lines, (("fly", declared_packages.PRODUCTS[0][0]), ("test", "made"))):
            self.assertRegex(line, f"^odd is not declared for ./dev's {tier}: /lib\\S+, read by the loader of {loaded}")

    def test_program_that_a_test_starts(self):
        self.packages["odd"] = {"files": ["/usr/bin/env"]}
        self.read = [("/bin/sh", "sh y.sh", "/usr/bin/env")]
        self.expect("odd is not declared for ./dev's test: /usr/bin/env, read by sh y.sh")

    def test_what_nobody_owns(self):
        self.read = [("/bin/sh", "sh y.sh", "/usr/bin/env"),
                     ("/bin/sh", "sh y.sh", "/usr/lib/os-release"), ("/bin/sh", "sh y.sh", "/etc/passwd"),
                     ("/bin/sh", "sh y.sh", "/usr/bin/there is none"), ("/bin/sh", "sh y.sh", str(self.dev))]
        self.expect("/usr/bin/env, read by sh y.sh, belongs to no package, so a bare machine has none of it")

    def test_both_spellings_of_what_moved_to_usr(self):
        self.packages["odd"] = {"files": ["/bin/cat", "/usr/bin/env"]}
        self.read = [("/bin/sh", "sh", "/usr/bin/cat"), ("/bin/sh", "sh", "/bin/env")]
        self.expect("odd is not declared for ./dev's test: /bin/env, read by sh, /usr/bin/cat")

    def test_behind_an_alternative(self):
        real = os.path.realpath("/usr/bin/awk")
        self.assertNotEqual(real, "/usr/bin/awk")
        self.packages["odd"] = {"files": [real]}
        self.read = [("/bin/sh", "sh y.sh", "/usr/bin/awk")]
        self.expect("odd is not declared for ./dev's test: /usr/bin/awk, read by sh y.sh")

    def test_a_diverted_file_is_of_who_diverted_it(self):
        self.packages |= {"odd": {"files": ["/bin/cat"]}, "base2": {"files": ["/bin/cat"], "Priority": "required"}}
        self.diversions = "/bin/cat\n/bin/cat.old\nodd\n"
        self.read = [("/bin/sh", "sh y.sh", "/bin/cat")]
        self.expect("odd is not declared for ./dev's test: /bin/cat, read by sh y.sh")

    def test_what_comes_with_the_declared(self):
        self.packages |= {"a": {"files": ["/bin/cat"], "Depends": "none | b:any (>= 1), none-at-all"},
                          "b": {"files": ["/bin/ls"], "Pre-Depends": "virtual"},
                          "c": {"files": ["/usr/bin/env"], "Provides": "other, virtual (= 2)"},
                          "minimal": {"files": ["/usr/bin/id"], "Priority": "required"}}
        self.test += " a"
        self.read = [("/bin/sh", "sh", name) for name in ("/bin/cat", "/bin/ls", "/usr/bin/env", "/usr/bin/id")]
        self.expect_nothing()

    def test_what_does_not_come_with_the_declared(self):
        self.packages |= {"a": {"files": [], "Depends": "b | c", "Recommends": "d"}, "b": {"files": []},
                          "c": {"files": ["/bin/cat"]}, "d": {"files": ["/bin/ls"]},
                          "minimal": {"Priority": "required", "Status": "deinstall ok config-files", "Depends": "d"}}
        self.test += " a"
        self.read = [("/bin/sh", "sh", "/bin/cat"), ("/bin/sh", "sh", "/bin/ls")]
        self.expect("c is not declared for ./dev's test: /bin/cat, read by sh",
                    "d is not declared for ./dev's test: /bin/ls, read by sh")

    def test_what_follows_from_an_optional_program_is_excused_for_it_alone(self):
        self.packages |= {"git": {"files": ["/bin/cat"]}, "odd": {"files": ["/usr/bin/env"]}}
        self.read = [("/bin/sh", "sh", "/bin/cat"), ("/usr/bin/cat", "git describe", "/usr/bin/env")]
        self.expect_nothing()
        self.read.append(("/bin/sh", "sh y.sh", "/usr/bin/env"))
        self.expect("odd is not declared for ./dev's test: /usr/bin/env, read by sh y.sh")

    def test_a_log_that_says_nothing_is_no_proof(self):
        self.read = [("", "", "/nowhere")]
        self.expect(f"{self.log} says nothing: is read_log.so in LD_PRELOAD?")


class ThisMachine(InAFolder):
    def test_the_real_build_without_a_package_that_it_needs(self):
        self.write_dev(f'"{DEV}" "$@" | grep -vx libfmt-dev')
        code, lines = self.check(HOST_BUILD, self.folder / "arm")
        self.assertEqual(code, 1, lines)
        self.assertRegex("\n".join(lines), r"(?m)^libfmt-dev is not declared for ./dev's fly: /usr/include/fmt/\S+, "
                                           r"read by the build of \S+\.(cpp|cxx|gch), /usr/include/fmt/")

    def run_logged(self, *command):
        library = shutil.copy(READ_LOG_SO, self.folder)  # LD_PRELOAD cannot name a folder with a space
        return subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env=os.environ | {"LD_PRELOAD": library, "FANTAIL_READ_LOG": str(self.log)})

    def logged(self, *command):
        self.log.touch()
        result = self.run_logged(*command)
        return result, [line.split("\t") for line in self.log.read_text().splitlines()]

    def test_programs_and_their_files_are_logged_once(self):
        script = "cat /etc/passwd /etc/passwd; (cat /etc/passwd)"
        result, lines = self.logged("/bin/sh", "-c", script)
        shell, cat = os.path.realpath("/bin/sh"), os.path.realpath("/bin/cat")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(lines.count([cat, "cat /etc/passwd /etc/passwd ", "/etc/passwd"]), 1)
        self.assertEqual(lines.count([cat, "cat /etc/passwd ", "/etc/passwd"]), 1)
        self.assertIn([shell, f"/bin/sh -c {script} ", cat], lines)
        self.assertIn("/libc.so.6", "".join(path for program, _, path in lines if program == cat))
        self.assertFalse([path for _, _, path in lines if not path.startswith(("/usr/", "/lib", "/etc/"))])

    def test_what_is_not_there_is_not_logged_and_errors_are_what_they_were(self):
        result, lines = self.logged("/bin/cat", "/etc/there_is_none")
        self.assertEqual(result.returncode, 1)
        self.assertIn("No such file or directory", result.stdout)
        self.assertNotIn("/etc/there_is_none", [path for _, _, path in lines])

    def test_a_limit_on_the_length_of_files_ends_nobody(self):
        result, lines = self.logged("/bin/sh", "-c", "ulimit -f 0; cat /etc/hostname >/dev/null && echo lives")
        self.assertEqual((result.returncode, result.stdout), (0, "lives\n"))

    def test_without_a_log_nothing_happens(self):
        result = self.run_logged("/bin/cat", "/etc/passwd")
        self.assertEqual((result.returncode, result.stdout), (0, pathlib.Path("/etc/passwd").read_text()))
        self.assertFalse(self.log.exists())


if __name__ == "__main__":
    if not shutil.which("dpkg-query"):
        print("SKIPPED: no dpkg here")
        sys.exit(77)
    for name in ("LD_PRELOAD", "FANTAIL_READ_LOG"):  # this test's own processes are no part of what it looks at
        os.environ.pop(name, None)
    unittest.main(argv=sys.argv[:1])
