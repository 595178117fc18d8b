# SPDX-License-Identifier: MIT
# From a hazard to the line of code and to what shows that it works. Reads docs/safety.md (tables of hazards and of requirements),
# docs/evidence.md (what each proof states), the sources (comments "Meets LIM-1.") and the tests, and writes docs/trace.md with a link
# to each line. The text of a requirement stands in docs/safety.md alone, to which its number leads.
#
#   trace.py ROOT           writes the page
#   trace.py ROOT --check   fails if the page is not what would be written
#
# Exit code 1 and a sentence for each fault: a requirement without code, without evidence or without a hazard; a number in the code,
# or a test, proof or figure in the table, that does not exist; a proof that no requirement names or docs/evidence.md does not state; a
# figure that neither a requirement names nor a link in these two pages leads to; a requirement without an anchor, a link to none.
import pathlib
import re
import sys

ID = r"[A-Z]{3}-\d+"
TEST = re.compile(r"\b(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+)")
MEETS = re.compile(rf"//.*\bMeets ((?:{ID})(?:, {ID})*)(.*)")
# What the compiler does not see, or a test that does nothing, shows nothing.
UNSEEN = re.compile(r"/\*.*?\*/|^[ \t]*//[^\n]*|^[ \t]*#[ \t]*if[ \t]+(?:0|false)\b.*?^[ \t]*#[ \t]*(?:endif|else|elif)[^\n]*", re.DOTALL | re.MULTILINE)
SKIPPED = re.compile(r"[^{;]*\{\s*GTEST_SKIP\(")


def rows_of(text, heading):
    """The cells of the table below a heading, and the number of each line."""
    rows = []
    inside = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("#"):
            inside = line.strip("# ") == heading
        elif inside and re.match(rf"\| *(?:<a id=\"[^\"]*\"></a>)? *(?:{ID}|H\d+) *\|", line):
            rows.append((number, [re.sub(r"<a id=\"[^\"]*\"></a>", "", cell).strip() for cell in line.strip().strip("|").split(" | ")]))
    return rows


class Trace:
    def __init__(self, root):
        self.root = root
        self.faults = []
        self.safety = safety = (root / "docs/safety.md").read_text()
        page = root / "docs/evidence.md"
        self.stated = page.read_text() if page.exists() else ""
        self.hazards = [(row[0], row) for _, row in rows_of(safety, "Hazards")]
        self.requirements = {}
        for number, row in rows_of(safety, "Requirements"):
            if len(row) != 4:
                self.fault(f"docs/safety.md:{number}: a requirement has four cells (number, text, made in, shown by), not {len(row)}")
            elif row[0] in self.requirements:
                self.fault(f"docs/safety.md:{number}: {row[0]} is there twice")
            else:
                self.requirements[row[0]] = row
        if not self.requirements:
            self.fault("docs/safety.md: no table below the heading Requirements")
        self.met = self.comments()
        self.tests = self.test_places()
        self.proofs = self.proof_places()
        self.figures = self.figure_places()

    def fault(self, sentence):
        self.faults.append(sentence)

    def comments(self):
        places = {}
        for folder in ("firmware", "hal", "tools/link"):
            for path in sorted((self.root / folder).rglob("*.[ch]pp")):
                name = path.relative_to(self.root).as_posix()
                for number, line in enumerate(path.read_text().splitlines(), 1):
                    found = MEETS.search(line)
                    for further in re.findall(ID, found.group(2)) if found else ():
                        self.fault(f"{name}:{number}: {further} is not read there: numbers follow each other with commas (Meets LIM-1, LIM-2)")
                    for identifier in re.findall(ID, found.group(1)) if found else ():
                        places.setdefault(identifier, []).append((name, number))
                        if identifier not in self.requirements:
                            self.fault(f"{name}:{number}: meets {identifier}, which docs/safety.md does not have")
        return places

    def test_places(self):
        places = {}
        for path in sorted((self.root / "test").rglob("*.cpp")):
            text = UNSEEN.sub(lambda unseen: re.sub(r"[^\n]", " ", unseen[0]), path.read_text())
            for found in TEST.finditer(text):
                if SKIPPED.match(text, found.end()):
                    continue
                number = text.count("\n", 0, found.start()) + 1
                places.setdefault(f"{found[1]}.{found[2]}", (path.relative_to(self.root).as_posix(), number))
        return places

    def proof_places(self):
        places = {}
        for path in sorted((self.root / "test/proof").glob("*.py")):
            text = path.read_text()
            for found in [] if path.stem.endswith("_test") else re.finditer(r'\bProof\(\s*"(\w+)"', text):
                places[found[1]] = (path.relative_to(self.root).as_posix(), text.count("\n", 0, found.start(1)) + 1)
        return places

    def figure_places(self):
        places = {}
        for path in sorted((self.root / "docs/figures").glob("*.md")):
            for name in re.findall(r'<a id="(\w+)"></a>', path.read_text()):
                places[name] = (path.relative_to(self.root).as_posix(), f"#{name}")
        return places

    def evidence(self, identifier, cell):
        """The links of a cell: `Suite.Name` or `Suite.*` is a test, `proof NAME` a proof, `figures NAME` a table of figures."""
        links = []
        for word in re.findall(r"`([^`]+)`", cell):
            kind, _, name = word.rpartition(" ")
            if kind in ("proof", "figures"):
                place = (self.proofs if kind == "proof" else self.figures).get(name)
                found = [(word, place)] if place else []
                self.used.add((kind, name))
            else:
                wanted = word.split("/")[-1] if "." in word else word
                pattern = re.compile(re.escape(wanted).replace(r"\*", r"\w+"))
                found = [(test, place) for test, place in self.tests.items() if pattern.fullmatch(test)]
            if not found:
                self.fault(f"docs/safety.md: {identifier} names {word}, which does not exist")
            if len(found) > 1:
                found = [(word, found[0][1])]
            links += [link(text, place) for text, place in found]
        return links

    def check_links(self):
        """Each requirement has its anchor in docs/safety.md, and each number in brackets leads to one."""
        for identifier in self.requirements:
            if f'<a id="{identifier.lower()}"></a>' not in self.safety:
                self.fault(f'docs/safety.md: {identifier} has no anchor: its row begins with | <a id="{identifier.lower()}"></a>{identifier} |')
        for identifier, target in sorted(set(re.findall(rf"\[({ID})\](\([^)]*\))?", self.safety))):
            if identifier not in self.requirements:
                self.fault(f"docs/safety.md: names {identifier}, which is no requirement")
            elif target != f"(#{identifier.lower()})":
                self.fault(f"docs/safety.md: [{identifier}]{target} leads elsewhere: [{identifier}](#{identifier.lower()})")

    def page(self):
        self.used = set()
        lines = [
            "# From hazard to evidence",
            "",
            "For a reviewer of the safety case, whose [hazards](safety.md#hazards) name requirements: the code that meets each of them, and the tests",
            "and proofs that show it. A number leads to the text of the requirement. Written by `./dev trace` from the safety case, comments in",
            "the sources and names of tests; a test fails when it is not up to date. A test or a proof runs by its name:",
            "",
            "```",
            "./dev test --only FlightPhase.NeitherTheSwitchNorTheCommandAloneArms",
            "./dev prove flight_phase",
            "```",
            "",
            "| requirement | code | shown by |",
            "|---|---|---|",
        ]
        named = set()
        for identifier, row in self.hazards:
            wanted = re.findall(rf"\b{ID}\b", " ".join(row[1:]))
            named.update(wanted)
            for one in wanted:
                if one not in self.requirements:
                    self.fault(f"docs/safety.md: hazard {identifier} names {one}, which is no requirement")
            if not wanted:
                self.fault(f"docs/safety.md: hazard {identifier} names no requirement")
        for identifier, (_, _, made_in, shown_by) in self.requirements.items():
            code = self.met.get(identifier, [])
            folders = re.findall(r"`([^`]+)`", made_in)
            for wanted in folders:
                if not any(name.split(".")[0].endswith(wanted) for name, _ in code):
                    self.fault(f"docs/safety.md: {identifier} is made in {wanted}, but no comment there says that it meets {identifier}")
            for name, number in code:
                if not any(name.split(".")[0].endswith(wanted) for wanted in folders):
                    self.fault(f"{name}:{number}: meets {identifier}, but docs/safety.md does not name this file")
            shown = self.evidence(identifier, shown_by)
            if not code:
                self.fault(f"docs/safety.md: nothing in the code says that it meets {identifier}")
            if not shown:
                self.fault(f"docs/safety.md: {identifier} has no evidence")
            if identifier not in named:
                self.fault(f"docs/safety.md: no hazard names {identifier}")
            where = ", ".join(link(f"{pathlib.PurePath(name).name}:{number}", (name, number)) for name, number in code)
            anchor = identifier.lower()
            lines.append(f'| <a id="{anchor}"></a>[{identifier}](safety.md#{anchor}) | {where} | {", ".join(shown)} |')
        self.check_links()
        stated = self.stated.partition("## What is proved")[2].partition("\n## ")[0]
        for name, (path, _) in self.proofs.items():
            row = re.search(rf"^\|[^|]*`{name}`[^|]*\|[^|]*\|([^|]*)\|$", stated, re.MULTILINE)
            if not row or len(row[1].split()) < 5:
                self.fault(f"docs/evidence.md: the table of what is proved does not state the proof {name}")
            if ("proof", name) not in self.used:
                self.fault(f"{path}: no requirement in docs/safety.md names the proof {name}")
        linked = set(re.findall(r"\]\(figures/\w+\.md#(\w+)\)", self.safety + self.stated))
        for name, (path, _) in self.figures.items():
            if ("figures", name) not in self.used and name not in linked:
                self.fault(f"{path}: nothing in docs/safety.md or docs/evidence.md names the figures {name}")
        for name in sorted(linked - set(self.figures)):
            self.fault(f"docs/safety.md or docs/evidence.md: there are no figures {name} in docs/figures")
        return "\n".join(lines) + "\n"


def link(text, place):
    name, where = place
    path = f"../{name}" if not name.startswith("docs/") else name[len("docs/"):]
    return f"[{text}]({path}{where if isinstance(where, str) else f'#L{where}'})"


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--check"]):
        print("usage: trace.py ROOT [--check]", file=sys.stderr)
        return 64
    trace = Trace(pathlib.Path(arguments[0]))
    page = trace.page()
    target = trace.root / "docs/trace.md"
    if len(arguments) == 2:
        if not target.exists() or target.read_text() != page:
            trace.fault("docs/trace.md is not what the code says; ./dev trace writes it")
    elif not trace.faults:
        target.write_text(page)
    for sentence in trace.faults:
        print(f"trace: {sentence}", file=sys.stderr)
    if not trace.faults:
        print(f"trace: {len(trace.hazards)} hazards, {len(trace.requirements)} requirements, each with code and evidence")
    return 1 if trace.faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
