# SPDX-License-Identifier: MIT
"""Usage: documented_options.py PROJECT FANTAIL

Every command line that a page of the manual shows, in a block of code or within a sentence: is there that verb, and does it have these
options, and what --set sets? Nothing is run but what answers the shells (fantail --complete) and ./dev help.
"""

import functools
import pathlib
import re
import shlex
import subprocess
import sys

sys.dont_write_bytecode = True  # not between the sources
import page_lines

PROJECT, FANTAIL = pathlib.Path(sys.argv[1]).absolute(), sys.argv[2]
LEAST = 290  # fewer, and the pages are not read as they should be
NO_VERBS = {"apogee": "the example of CONTRIBUTING.md", "for": "the package fantail for Python"}
HANDED_ON = {"bench-speed": "test/benchmark/bench_speed.py", "validate": "test/validation/validate.py"}
ENDS = {"&&", "||", "|", "&", ";", ">", "<"}


def printed(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


@functools.cache
def completions(*words):
    return {line.split("\t")[0] for line in printed(FANTAIL, "--complete", *words).splitlines()[1:]}


@functools.cache
def help_of_dev():
    """The lines of help on each verb of ./dev."""
    verbs, verb = {}, ""
    for line in printed(PROJECT / "dev", "help").splitlines():
        verb = line.split()[1] if line.startswith("./dev ") else verb
        verbs[verb] = verbs.get(verb, "") + line + "\n"
    return verbs


def command_lines(text):
    """As they stand in the text, without what a shell does with their results."""
    blocks = [block for _, block, _ in page_lines.blocks_of(text)]
    sentences = re.sub(r"^ *```.*?^ *```$", "", text, flags=re.MULTILINE | re.DOTALL)
    spans = [re.sub(r"\s+", " ", span) for span in re.findall(r"(?<!`)`([^`]+)`(?!`)", sentences)]
    for line in [*"\n".join(blocks).replace("\\\n", " ").splitlines(), *spans]:
        for match in re.finditer(r"(?<![\w/.-])(\./dev|fantail) (?=[a-z])", line):
            yield match[1], line[match.end():]


def words_of(rest):
    """Up to the end of this command; a quote that began before it ends it, too."""
    try:
        lexer = shlex.shlex(rest, posix=True, punctuation_chars=True)
        lexer.whitespace_split = True
        words = list(lexer)
    except ValueError:
        words = re.split(r"['\"]", rest)[0].split()
    end = next((i for i, word in enumerate(words) if word in ENDS), len(words))
    return words[:end]


def wrong(program, words):
    """What is wrong with a command, or nothing."""
    verb, tool = words[0].rstrip(",.:`"), completions("")
    if verb in NO_VERBS:
        return None
    if verb not in tool and not (program == "./dev" and verb in help_of_dev()):
        return f"there is no verb {verb}"
    options = [word.split("=")[0].rstrip(",.:") for word in words if re.match(r"--\w", word)]
    if verb not in tool:
        if verb == "with-vcan":
            return None  # its words are another command, which has been looked at
        known = help_of_dev()[verb] + ((PROJECT / HANDED_ON[verb]).read_text(encoding="utf-8") if verb in HANDED_ON else "")
        return next((f"{verb} has no {option}" for option in options if option not in known), None)
    path = [verb]
    if len(words) > 1 and words[1] in completions(verb, ""):
        path.append(words[1])
    known = completions(*path, "--") | completions(verb, "--") | {"--help", "--version", "--color"}
    for option in options:
        if option not in known:
            return f"{' '.join(path)} has no {option}"
    for name, value in zip(words, words[1:]):
        key = value.split("=")[0]
        if name == "--set" and re.fullmatch(r"[a-z_.0-9]+", key) and f"{key}=" not in completions(*path, "--set", ""):
            return f"{' '.join(path)} cannot set {key}"
    return None


def main():
    count, failures = 0, 0
    for page in sorted([*PROJECT.glob("*.md"), *PROJECT.glob("docs/**/*.md")]):
        for program, rest in command_lines(page.read_text(encoding="utf-8")):
            count += 1
            if what := wrong(program, words_of(rest)):
                failures += 1
                print(f"FAILED: {page.relative_to(PROJECT)}: {program} {rest}: {what}")
    print(f"{count} commands, {failures} failed")
    return count < LEAST or failures > 0


sys.exit(main())
