# SPDX-License-Identifier: MIT
"""Usage: plain_english.py PROJECT [PAGE...] [--fantail PROGRAM] [--count]

Lists sentences that are too long, and turns of phrase that read like another language put into English: in the pages of the manual and in
the texts of the program's sources (or in those that are named), and with --fantail in the help of every verb. --count prints the words of
each page. Exit code 1 if there is one.

A word has a letter or a digit; code counts as one word. A sentence ends at a full stop, a question mark or a paragraph; a cell of a
table and an element of a list are paragraphs.
"""

import argparse
import pathlib
import re
import subprocess
import sys

LONGEST_IN_DOCS, LONGEST_IN_HELP = 35, 28
# What is odd, and what to write.
ODD = [(re.compile(pattern, re.IGNORECASE), plain) for pattern, plain in (
    (r"\bbut for\b", "except for"),
    (r"\bwhat (?:is|are) (?:crooked|broken|wrong with|said|asked|left|known)\b", "a noun: the misalignment, the failed canard"),
    (r"(?-i:(?:^|[.;:] )O)f (?:a|an|the|this|each|every) ", "the subject first"),
    (r"(?<!there )\b(?:is|are) no (?!longer|more|less|better|worse|other|larger|smaller)\w+", "is not a ..., are not ..."),
    (r"\b(?:was|were|is|are) not to be (?:found|had|read|seen)\b", "could not be found"),
    (r"\bso-many(?:th|eth)\b|\bn-th so\b", "the number"),
    (r"\b(?:it|rocket|avionics|board|bench|program|law|computer|detector|rule|plan)s? (?:\w+ )?(?:believe|hear|heard)s?\b",
     "detects, receives, assumes"),
    (r"\bis told\b|\bare told\b", "receives"),
    (r"\bsound rocket\b", "healthy rocket"),
    (r"\bhard[- ]?over (?:canard|servo)\b", "a canard that runs to its stop"),
    (r"\bnobody (?:knows|has measured)\b", "unknown, not measured"),
    (r"\bas fast a\b|\bwhose each\b|\bworth its while\b|\bholds? nothing up\b", "the usual order of words"),
)]


def paragraphs(text):
    """Of a page: without code, headings and comments; a cell and an element of a list each for itself; with the number of its line."""
    text = re.sub(r"^( *)```.*?^ *```$|<!--.*?-->", lambda found: re.sub(r"[^\n]+", "", found[0]), text, flags=re.MULTILINE | re.DOTALL)
    at, lines = 0, []
    for number, line in enumerate([*text.splitlines(), ""], 1):
        is_row = line.lstrip().startswith("|")
        starts = not line.strip() or is_row or line.startswith("#") or re.match(r"\s*(?:[-*]|\d+\.) ", line)
        if starts and lines:
            yield at, " ".join(lines)
            lines = []
        if is_row:
            yield from ((number, cell.strip()) for cell in re.split(r"(?<!\\)\|", line) if cell.strip(" -:"))
        elif line.strip() and not line.startswith("#"):
            at = at if lines else number
            lines.append(re.sub(r"^\s*(?:[-*]|\d+\.) ", "", line).strip())


def plain(text):
    """As a reader hears it: a link is its text, code one word."""
    text = re.sub(r"!?\[((?:[^\[\]]|\[[^\]]*\])*)\](?:\([^)]*\)|\[[^\]]*\])", r"\1", text)
    text = re.sub(r"<[^>]+>", "", text)
    return re.sub(r"`[^`]*`", "CODE", text).replace("*", "")


def words(text):
    return [word for word in text.split() if re.search(r"\w", word)]


def sentences(text):
    return re.split(r"(?<=[.?!])[)\"”]? +(?=[\"\u201c(A-Z0-9]|\w+: )", plain(text))


def offences(where, text, longest):
    for sentence in sentences(text):
        count = len(words(sentence))
        if count > longest:
            yield f"{where}: {count} words: {sentence}"
        for pattern, better in ODD:
            if found := pattern.search(sentence):
                yield f"{where}: \"{found[0].strip()}\" (write: {better}): {sentence}"


TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>R"(?P<mark>[^( ]*)\(.*?\)(?P=mark)")|(?P<include>^\#[^\n]*)
    |"(?P<text>(?:[^"\\\n]|\\.)*)"|'(?:[^'\\\n]|\\.)+'|(?P<blank>\s+)|(?P<other>\w+|.)""", re.VERBOSE | re.DOTALL | re.MULTILINE)
ESCAPES = {"n": "\n", "t": " ", '"': '"', "\\": "\\"}
# What a person does not read as sentences: style and script of a page, and settings.
NO_PROSE = re.compile(r"=>|\)\s*;\s*$|\bfunction\b|^\s*[\w.\"]+ = |\w:[^ ]+;|^\s*[{}]")


def literals(source):
    """The texts of a C++ source with their lines. Those that follow each other are one; raw ones are files and pages."""
    line, begin, text = 1, 0, None
    for token in TOKEN.finditer(source):
        if token["text"] is not None:
            text, begin = (token["text"], line) if text is None else (text + token["text"], begin)
        elif not (token["blank"] or token["comment"]) and text is not None:
            yield begin, text
            text = None
        line += token[0].count("\n")
    if text is not None:
        yield begin, text


def is_prose(text):
    """More words than names and numbers."""
    all_words = words(text)
    return not NO_PROSE.search(text) and 2 * sum(bool(re.search(r"[\d_]", word)) for word in all_words) <= len(all_words)


def prose(literal):
    """Its paragraphs as a person reads them: what is put in later is one word, whatever it is."""
    text = re.sub(r"\\u([0-9a-fA-F]{4})", lambda found: chr(int(found[1], 16)), literal)
    text = re.sub(r"\\(.)", lambda found: ESCAPES.get(found[1], " "), text)
    text = re.sub(r"\{\w*(?::[^{}]*(?:\{\w*\}[^{}]*)*)?\}", "X", text)
    text = re.sub(r"</?[a-z][^<>]*>", "\n ", text)
    return [one.replace("\n", " ") for one in re.split(r"\n(?=[\s#-])", text) if is_prose(one)]


def help_paragraphs(text):
    """An option and a line that is further in than the one before begin a paragraph."""
    lines, indent = [], 0
    for line in [*text.splitlines(), ""]:
        own = len(line) - len(line.lstrip())
        named = re.match(r"  \S.*?\s{2,}\S", line)  # an option, an argument, an inner verb, with its meaning
        if lines and (not line.strip() or own < indent or named or re.match(r"\s*(?:-|fantail |\./dev )", line)):
            yield " ".join(lines)
            lines = []
        if line.strip() and not re.match(r"\s*(?:fantail |\./dev )", line):
            indent = own
            lines.append(re.sub(r"^\s*-\S.*?(?:\s{2,}|$)|^  \S.*?\s{2,}", "", line).strip())


def helps(program):
    def printed(*command):
        return subprocess.run([program, *command], capture_output=True, text=True, check=True).stdout

    for row in printed("--complete", "").splitlines()[1:]:
        verb = row.split("\t")[0]
        if not verb.startswith("-"):
            yield f"fantail {verb} --help", printed(verb, "--help")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("project", type=pathlib.Path)
    parser.add_argument("pages", nargs="*")
    parser.add_argument("--fantail")
    parser.add_argument("--count", action="store_true")
    asked = parser.parse_args()
    pages = [asked.project / page for page in asked.pages] or [
        asked.project / "README.md", *sorted((asked.project / "docs").rglob("*.md")),
        *(source for folder in ("firmware", "hal", "sim", "tools") for source in sorted((asked.project / folder).rglob("*.[ch]pp")))]
    sources = [page for page in pages if page.suffix != ".md"]
    pages = [page for page in pages if page.suffix == ".md"]
    found, total = [], 0
    for source in sources:
        for line, literal in literals(source.read_text(encoding="utf-8")):
            for paragraph in prose(literal):
                found += offences(f"{source.relative_to(asked.project)}:{line}", paragraph, LONGEST_IN_HELP)
    for page in pages:
        text, name = page.read_text(encoding="utf-8"), page.relative_to(asked.project)
        total += (count := len(words(text)))
        if asked.count:
            print(f"{count:7} {name}")
        for line, paragraph in paragraphs(text):
            found += offences(f"{name}:{line}", paragraph, LONGEST_IN_DOCS)
    for verb, text in helps(asked.fantail) if asked.fantail else ():
        for paragraph in help_paragraphs(text):
            found += offences(verb, paragraph, LONGEST_IN_HELP)
    print("\n".join(found))
    print(f"{len(found)} sentences to mend; {total} words in {len(pages)} pages, {len(sources)} sources")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
