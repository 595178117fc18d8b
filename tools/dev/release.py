# SPDX-License-Identifier: MIT
"""What ./dev release reads and writes of the text of a release.

  release.py check VERSION       refuses a version that cannot be released from this tree
  release.py write VERSION DATE  writes it into CMakeLists.txt, CITATION.cff and CHANGELOG.md
  release.py page VERSION DATE COMMIT FOLDER   the page of the release, of what lies in FOLDER

Exit code 64 for a version that is none or not a later one, 69 for a tree that cannot be released, each with a sentence.
"""

import hashlib
import pathlib
import posixpath
import re
import subprocess
import sys

HEAD = "## Unreleased\n"
PROJECT = re.compile(r"^(project\(fantail VERSION )([0-9.]+) ", re.MULTILINE)
LINK = re.compile(r"\]\((?![a-z]+:)([^)#]*)")


def refuse(code, sentence):
    print(f"dev: release: {sentence}", file=sys.stderr)
    sys.exit(code)


def numbers(version):
    """The three numbers of a version, or None for what is no version."""
    found = re.fullmatch(r"(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)\.(0|[1-9][0-9]*)", version)
    return tuple(map(int, found.groups())) if found else None


def section(changelog, head):
    """What stands below a heading of the changelog, up to the next one; None where there is no such heading."""
    before, found, after = changelog.partition(f"\n{head}")
    return re.split(r"^## ", after, maxsplit=1, flags=re.MULTILINE)[0].strip() if found else None


def present_version():
    found = PROJECT.search(pathlib.Path("CMakeLists.txt").read_text())
    return found[2] if found else refuse(69, "CMakeLists.txt has no line project(fantail VERSION ...) with the version")


def check(version):
    wanted = numbers(version)
    if not wanted:
        refuse(64, f'"{version}" is not a version; allowed: MAJOR.MINOR.PATCH, for example 0.2.0')
    tags = subprocess.run(["git", "tag", "--list", "v*"], capture_output=True, text=True, check=True).stdout.split()
    if f"v{version}" in tags:
        refuse(69, f"the tag v{version} exists already")
    present = present_version()
    last = max([present, *(tag[1:] for tag in tags if numbers(tag[1:]))], key=numbers)
    if wanted <= numbers(last):
        refuse(64, f"{version} is not greater than {last}, the last version")
    if not section(pathlib.Path("CHANGELOG.md").read_text(), HEAD):
        refuse(69, '"## Unreleased" in CHANGELOG.md is empty, so there is nothing to release')


def replaced(file, pattern, text):
    path = pathlib.Path(file)
    content, count = re.subn(pattern, text, path.read_text(), flags=re.MULTILINE)
    if count != 1:
        refuse(69, f"{file} has {count} places for the text of the release, instead of one")
    path.write_text(content)


def write(version, date):
    replaced("CMakeLists.txt", PROJECT.pattern, rf"\g<1>{version} ")
    replaced("CITATION.cff", r"^version: .*\n(date-released: .*\n)?", f"version: {version}\ndate-released: {date}\n")
    replaced("CHANGELOG.md", f"^{HEAD}", f"{HEAD}\n## {version} ({date})\n")


def from_root(text, folder):
    """Links of a page in this folder, as they are from the folder of the sources."""
    return LINK.sub(lambda link: "](" + (posixpath.normpath(posixpath.join(folder, link[1])) if link[1] else ""), text)


def page(version, date, commit, folder):
    files = sorted(path for path in pathlib.Path(folder).iterdir() if path.name not in ("SHA256SUMS", "release.md"))
    lines = [f"# Fantail {version}", "", f"Of {date}, commit {commit}. Links lead into the sources.", ""]
    lines += ["| file | bytes | SHA-256 |", "|---|---|---|"]
    for path in files:
        lines.append(f"| `{path.name}` | {path.stat().st_size} | `{hashlib.sha256(path.read_bytes()).hexdigest()}` |")
    lines += ["", "## What has changed", "", section(pathlib.Path("CHANGELOG.md").read_text(), f"## {version} ({date})\n")]
    for figures in sorted(pathlib.Path("docs/figures").glob("*.md")):
        text = from_root(figures.read_text().strip(), figures.parent.as_posix())
        lines += ["", re.sub(r"^#", "##", text, flags=re.MULTILINE)]
    (pathlib.Path(folder) / "release.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    {"check": check, "write": write, "page": page}[sys.argv[1]](*sys.argv[2:])
