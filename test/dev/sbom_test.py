# SPDX-License-Identifier: MIT
"""The bill of materials of a package with one program of the present build. Usage: sbom_test.py PROJECT"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, str(PROJECT / "tools/dev"))
import built_from  # noqa: E402

PROGRAM = PROJECT / "build/host/libexec/fantail-plan"
FMT = next(name for name in built_from.loads(PROGRAM) if name.startswith("libfmt"))  # 9 in Debian 12, 10 in 13
FMT_PACKAGE = built_from.debian_packages([built_from.installed_libraries()[FMT]])[built_from.installed_libraries()[FMT]]


def installed(package):
    return built_from.said("dpkg-query", "-W", "-f", "${Version}\n", package).splitlines()[0]


class BillOfMaterials(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.tree = self.folder / "tree"
        (self.tree / "usr/bin").mkdir(parents=True)
        (self.tree / "DEBIAN").mkdir()
        (self.tree / "DEBIAN/control").write_text(
            "Package: x\nVersion: 1\nArchitecture: all\nMaintainer: Nobody <nobody@localhost>\nDescription: x\n")
        shutil.copy(PROGRAM, self.tree / "usr/bin")
        shutil.copy(built_from.installed_libraries()[FMT], self.tree / "usr/bin" / FMT)
        (self.tree / "usr/bin/read.me").write_text("no program\n")

    def bill(self, name="sbom.json"):
        subprocess.run(["dpkg-deb", "--build", "-Zgzip", "-z1", self.tree, self.folder / "x.deb"], check=True, capture_output=True,
                       env=os.environ | {"SOURCE_DATE_EPOCH": "1700000000"})
        out = self.folder / name
        self.ended = subprocess.run([sys.executable, "-B", "tools/dev/sbom.py", out, "0.2.0", "abc123", "1700000000", self.folder / "x.deb"],
                                    cwd=PROJECT, capture_output=True, text=True)
        return out.read_bytes() if out.exists() else b""

    def test_names_what_a_program_loads_and_was_compiled_from(self):
        bill = json.loads(self.bill())
        packages = {package["SPDXID"]: package for package in bill["packages"]}
        self.assertEqual(len(packages), len(bill["packages"]))
        program = next(package for package in packages.values() if package["name"] == "fantail-plan")
        self.assertEqual(program["checksums"][0]["checksumValue"], hashlib.sha256(PROGRAM.read_bytes()).hexdigest())
        related = {}
        for relation in bill["relationships"]:
            self.assertIn(relation["relatedSpdxElement"], packages)
            if relation["spdxElementId"] == program["SPDXID"]:
                related.setdefault(relation["relationshipType"], set()).add(packages[relation["relatedSpdxElement"]]["name"])
        self.assertTrue({"libc6", "libstdc++6", FMT_PACKAGE} <= related["DYNAMIC_LINK"], related)
        self.assertTrue({"libc6-dev", "libtomlplusplus-dev", "libeigen3-dev", "nlohmann-json3-dev"} <= related["STATIC_LINK"], related)
        self.assertFalse({"libgtest-dev", "librapidcheck-dev", "libpython3.11-dev"} & related["STATIC_LINK"], related)
        toml = packages["SPDXRef-debian-libtomlplusplus-dev"]
        self.assertEqual((toml["versionInfo"], toml["licenseDeclared"]), (installed("libtomlplusplus-dev"), "MIT"))
        self.assertIn({"spdxElementId": "SPDXRef-made-x.deb", "relationshipType": "CONTAINS",
                       "relatedSpdxElement": f"SPDXRef-debian-{FMT_PACKAGE}"}, bill["relationships"])
        self.assertIn({"spdxElementId": f"SPDXRef-debian-{FMT_PACKAGE}", "relationshipType": "DYNAMIC_LINK",
                       "relatedSpdxElement": "SPDXRef-debian-libc6"}, bill["relationships"])

    def test_names_what_is_vendored_in_a_page(self):
        shutil.copy(PROGRAM.with_name("fantail-report"), self.tree / "usr/bin")
        bill = json.loads(self.bill())
        uplot = next(package for package in bill["packages"] if package["name"] == "uPlot")
        self.assertIn(f"uPlot {uplot['versionInfo']}, MIT", (PROJECT / "third_party/uplot/README.md").read_text())
        makers = [relation["spdxElementId"] for relation in bill["relationships"] if relation["relatedSpdxElement"] == uplot["SPDXID"]]
        self.assertIn("SPDXRef-made-x.deb-usr-bin-fantail-report", makers)

    def test_is_the_same_bytes_again_and_of_the_time_of_the_commit(self):
        first, second = self.bill("first.json"), self.bill("second.json")
        self.assertEqual(first, second)
        bill = json.loads(first)
        self.assertEqual(bill["creationInfo"]["created"], "2023-11-14T22:13:20Z")
        self.assertEqual(bill["documentNamespace"], "https://spdx.org/spdxdocs/fantail-0.2.0-abc123")

    def test_is_none_where_nobody_knows_what_a_program_was_made_of(self):
        shutil.copy("/bin/true", self.tree / "usr/bin")
        self.assertEqual(self.bill(), b"")
        self.assertEqual(self.ended.returncode, 69)
        self.assertIn("links 0 files named true", self.ended.stderr)

    def test_takes_licences_only_from_what_programs_can_read(self):
        head = "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
        for text, wanted in (
            (head + "\nFiles: debian/*\nLicense: GPL-2+\n\nFiles: *\nLicense: Expat\n", "MIT"),
            (head + "\nFiles: a\nLicense: ISC\n\nFiles: *\nLicense: LGPL-2.1+ or MPL-2\n", "LGPL-2.1-or-later OR MPL-2.0"),
            (head + "\nFiles: *\nLicense: Expat with embedded exception\n", "NOASSERTION"),
            (head + "\nLicense: Expat\n Free.\n", "NOASSERTION"),
            ("It is free.\nLicense: Expat\n", "NOASSERTION"),
        ):
            (self.folder / "x").mkdir(exist_ok=True)
            (self.folder / "x/copyright").write_text(text)
            self.assertEqual(built_from.licence("x", self.folder)[0], wanted, text)
        self.assertEqual(built_from.licence("none", self.folder)[0], "NOASSERTION")


class LinkersMap(unittest.TestCase):
    def test_says_which_archives_were_taken_from_and_not_which_were_offered(self):
        with tempfile.NamedTemporaryFile("w") as linker_map:
            linker_map.write("Archive member included to satisfy reference by file (symbol)\n\n/usr/lib/a/../b/libc.a(memcpy.o)\n"
                             "                              main.o (memcpy)\nLOAD main.o\nLOAD /usr/lib/crti.o\nLOAD /usr/lib/a/libm.a\n")
            linker_map.flush()
            self.assertEqual(built_from.from_archives(linker_map.name), {"/usr/lib/b/libc.a", "/usr/lib/crti.o"})


unittest.main(argv=[sys.argv[0]])
