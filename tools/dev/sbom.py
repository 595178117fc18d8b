# SPDX-License-Identifier: MIT
"""The bill of materials of a release, SPDX 2.3 in JSON: what each file that is given away contains, loads and was compiled from.

  sbom.py OUT VERSION COMMIT SECONDS FILE...   the files: .deb, .whl, .elf (with its .map beside it), .tar.gz

The builds are build/host, build/wheel and build/arm of the present folder. SECONDS is the time of the commit: the same commit and
the same files give the same bytes. Exit code 69 if something cannot be said, because half a bill would be taken for a whole one.
"""

import datetime
import functools
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

import built_from

OURS = {"licenseConcluded": "MIT", "licenseDeclared": "MIT", "copyrightText": "2026 The Fantail authors"}
NOTE = ("DYNAMIC_LINK is what an ELF file names as needed. STATIC_LINK is a package or vendored folder of which the build read files "
        "for this one: headers, those of a precompiled header included, or members of an archive; so more may be named than has left "
        "code in it, and not less. The licence of a Debian package is what Debian says of its source. DEPENDS_ON is what the wheel asks pip for. What a library loads is "
        "followed where it is carried along, and no further.")


def identifier(*words):
    return "SPDXRef-" + "-".join(re.sub(r"[^A-Za-z0-9.]", "-", word.replace("+", "plus")) for word in words)


class Bill:
    def __init__(self, version):
        self.version = version
        self.packages = {}
        self.relations = set()

    def add(self, key, name, **fields):
        # What is not known is said so.
        self.packages.setdefault(key, {"SPDXID": key, "name": name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                                       "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION",
                                       "copyrightText": "NOASSERTION", **fields})
        return key

    def relate(self, one, how, other):
        self.relations.add((one, how, other))

    def made_here(self, path, kind, name):
        """A file of the release, or a program in one."""
        checksum = {"algorithm": "SHA256", "checksumValue": hashlib.sha256(path.read_bytes()).hexdigest()}
        return self.add(identifier("made", name), path.name, versionInfo=self.version, packageFileName=name, checksums=[checksum],
                        primaryPackagePurpose=kind, **OURS)

    @functools.cache
    def debian(self, package):
        version, source, architecture = built_from.said(
            "dpkg-query", "-W", "-f", "${Version}\t${source:Package}\t${Architecture}\n", package).splitlines()[0].split("\t")
        licence, comment = built_from.licence(package)
        return self.add(identifier("debian", package), package, versionInfo=version, supplier="Organization: Debian",
                        licenseDeclared=licence, licenseComments=comment,
                        sourceInfo=f"Debian's source package {source}",
                        externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                       "referenceLocator": f"pkg:deb/debian/{package}@{version.replace('+', '%2B')}?arch={architecture}"}])

    def pypi(self, name, version, **fields):
        if version:
            fields |= {"versionInfo": version, "externalRefs": [{
                "referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": f"pkg:pypi/{name}@{version}"}]}
        return self.add(identifier("pypi", name), name, **fields)

    def compiled_from(self, program, files):
        """The packages and the vendored folders of these files."""
        root = f"{pathlib.Path.cwd()}/"
        foreign = set()
        for file in files:
            if file.startswith(root):
                part = file.removeprefix(root)
                if part.startswith("third_party/"):
                    self.relate(program, "STATIC_LINK", self.vendored(part.split("/")[1]))
                elif part.startswith("firmware/protocol/generated/"):
                    self.relate(program, "STATIC_LINK", self.cantools())
            elif "/site-packages/nanobind/" in file:
                asked = re.search(r'"nanobind==([^"]+)"', pathlib.Path("pyproject.toml").read_text())
                self.relate(program, "STATIC_LINK", self.pypi("nanobind", asked[1], licenseDeclared="BSD-3-Clause"))
                if "/ext/robin_map/" in file:
                    key = self.add(identifier("within", "nanobind", "robin-map"), "tsl robin-map", licenseDeclared="MIT",
                                   comment=f"as nanobind {asked[1]} carries it")
                    self.relate(program, "STATIC_LINK", key)
            else:
                foreign.add(file)
        packages = built_from.debian_packages(foreign)
        unknown = sorted(foreign - packages.keys())
        if unknown:
            raise LookupError(f"no installed package has {unknown[0]}, which was read for {program.removeprefix('SPDXRef-made-')}")
        for package in set(packages.values()):
            self.relate(program, "STATIC_LINK", self.debian(package))

    def vendored(self, folder):
        said = re.match(r"(\S+) ([0-9.]+), (\S+) licence", (pathlib.Path("third_party") / folder / "README.md").read_text())
        return self.add(identifier("vendored", folder), said[1], versionInfo=said[2], licenseDeclared=said[3],
                        sourceInfo=f"third_party/{folder}")

    def cantools(self):
        folder = pathlib.Path("firmware/protocol/generated")
        said = re.search(r"generated by cantools version ([0-9.]+[0-9])", (folder / "canard_bus.h").read_text())
        return self.add(identifier("vendored", "cantools"), "cantools", versionInfo=said[1], licenseDeclared="MIT",
                        sourceInfo=f"{folder}: code that it has generated, and whose notice is its own")

    def linked(self, program, file):
        paths = {name: built_from.installed_libraries().get(name) for name in built_from.loads(file)}
        packages = built_from.debian_packages(path for path in paths.values() if path)
        for name, path in paths.items():
            if path not in packages:
                raise LookupError(f"no installed package has the library {name}, which {file.name} loads")
            self.relate(program, "DYNAMIC_LINK", self.debian(packages[path]))

    def programs_of(self, archive, folder, build):
        """Every ELF file in an unpacked archive: our own, or a library that was carried along."""
        for file in sorted(path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()):
            if file.read_bytes()[:4] != b"\x7fELF":
                continue
            carried = built_from.installed_libraries().get(file.name)
            if carried and carried in (packages := built_from.debian_packages([carried])):
                self.relate(archive, "CONTAINS", self.debian(packages[carried]))
                self.linked(self.debian(packages[carried]), file)
                continue
            program = self.made_here(file, "APPLICATION", f"{self.packages[archive]['name']}/{file.relative_to(folder)}")
            self.relate(archive, "CONTAINS", program)
            self.linked(program, file)
            self.compiled_from(program, build.files(build.target(file.name)))


def add_file(bill, path):
    kind = {".deb": "INSTALL", ".whl": "LIBRARY", ".elf": "FIRMWARE"}.get(path.suffix, "SOURCE")
    key = bill.made_here(path, kind, path.name)
    bill.relate(identifier("fantail"), "CONTAINS", key)
    with tempfile.TemporaryDirectory() as folder:
        if path.suffix == ".deb":
            subprocess.run(["dpkg-deb", "--extract", path, folder], check=True)
            bill.programs_of(key, pathlib.Path(folder), built_from.Build("build/host"))
        elif path.suffix == ".whl":
            zipfile.ZipFile(path).extractall(folder)
            bill.programs_of(key, pathlib.Path(folder), built_from.Build("build/wheel"))
            metadata = next(pathlib.Path(folder).glob("*.dist-info/METADATA")).read_text()
            for name in re.findall(r"^Requires-Dist: ([A-Za-z0-9_-]+)(?!.*extra ==)", metadata, re.MULTILINE):
                bill.relate(key, "DEPENDS_ON", bill.pypi(name, ""))
    if path.suffix == ".elf":
        build = built_from.Build("build/arm")
        bill.compiled_from(key, build.files(build.target(f"{path.stem}.unsealed.elf")) | built_from.from_archives(path.with_suffix(".map")))
    elif kind == "SOURCE":
        for folder in sorted(pathlib.Path("third_party").iterdir()):
            bill.relate(key, "CONTAINS", bill.vendored(folder.name))
        bill.relate(key, "CONTAINS", bill.cantools())


def main(out, version, commit, seconds, *files):
    bill = Bill(version)
    whole = bill.add(identifier("fantail"), "fantail", versionInfo=version, sourceInfo=f"commit {commit}", **OURS)
    for file in files:
        add_file(bill, pathlib.Path(file).resolve())
    created = datetime.datetime.fromtimestamp(int(seconds), datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    relations = sorted({("SPDXRef-DOCUMENT", "DESCRIBES", whole), *bill.relations})
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"fantail-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/fantail-{version}-{commit}", "comment": NOTE,
        "creationInfo": {"created": created, "creators": ["Organization: The Fantail authors", "Tool: tools/dev/sbom.py"]},
        "packages": [bill.packages[key] for key in sorted(bill.packages)],
        "relationships": [{"spdxElementId": one, "relationshipType": how, "relatedSpdxElement": other} for one, how, other in relations]}
    pathlib.Path(out).write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n")
    print(f"sbom: {out}: {len(document['packages'])} packages, {len(relations)} relationships")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except LookupError as error:
        print(f"sbom: {error}", file=sys.stderr)
        sys.exit(69)
