# SPDX-License-Identifier: MIT
"""Usage: documentation_test.py PROJECT

Is what looks at the manual able to find something? A made project with one page and a made program, and a made site.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1)).absolute()
DEV = """#!/bin/sh
echo './dev fly SCENARIO   fly'
"""
FANTAIL = """#!/bin/sh
case "$*" in
  "--complete ") printf 'words\\nfly\\tFly\\n' ;;
  --complete*--set*) printf 'words\\nbody.mass_kg=\\tkg\\n' ;;
  --complete*--) printf 'words\\n--out\\tFolder\\n--set\\tOne value\\n' ;;
  --complete*) printf 'words\\n' ;;
  *bad*) echo 'no such thing' >&2; exit 66 ;;
  *) printf 'first\\nsecond\\nthird\\n'; echo progress >&2 ;;
esac
"""
FOUR = "```\n./dev fly\n...\nthird\n./dev fly a\nfirst\n...\n./dev fly b\n./dev fly bad # exit code 66\nno such thing\n```\n"


# A block that shows what a program prints, in a page that nobody writes anew for a release.
PRINTED_VERSION = re.compile(r"\b(?:Fantail|firmware) +\d+\.\d+\.\d+")


class Versions(unittest.TestCase):
    def test_no_page_prints_the_version_of_an_earlier_release(self):
        self.assertIsNotNone(PRINTED_VERSION.search("Fantail 0.1.0, git 3089696105cf"))
        pages = [*(PROJECT / "docs").rglob("*.md")]
        self.assertGreater(len(pages), 30)
        for page in [*pages, PROJECT / "README.md"]:
            found = PRINTED_VERSION.search(page.read_text(encoding="utf-8"))
            self.assertIsNone(found, f"{page} prints a version, which the next release makes wrong: write VERSION or ...")


class Manual(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "docs").mkdir()
        for name, text in (("dev", DEV), ("fantail", FANTAIL)):
            (self.folder / name).write_text(text, encoding="utf-8")
            (self.folder / name).chmod(0o755)

    def said(self, script, text, *words):
        (self.folder / "page.md").write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, "-B", PROJECT / script, *words], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout

    def lines(self, text):
        return self.said("test/system/documented_lines.py", text, self.folder, self.folder / "fantail", "page.md")

    def options(self, text):
        return self.said("test/system/documented_options.py", "`./dev fly` " * 300 + text, self.folder, self.folder / "fantail")

    def test_lines_that_print_what_they_say(self):
        self.assertEqual(self.lines(FOUR), (0, "page.md: 4 commands, 0 failed\n"))

    def test_a_line_that_is_not_printed_or_not_there(self):
        for wrong in (FOUR.replace("third", "fourth"), FOUR.replace("first\n...", "first"), FOUR.replace("first\n...", "second\n...")):
            code, said = self.lines(wrong)
            self.assertEqual((code, said.count("it does not print")), (1, 1))

    def test_an_exit_code_that_is_not_kept_and_too_few_lines(self):
        self.assertIn("exit code 66", self.lines(FOUR.replace(" # exit code 66", ""))[1])
        self.assertEqual(self.lines("```\n./dev fly\n```\n")[0], 1)

    def every(self, text, begin="./dev fly bad", where="A.test", why="bad"):
        system = self.folder / "test/system"
        system.mkdir(parents=True, exist_ok=True)
        made = "add_test(NAME A.test COMMAND a)\nadd_test(NAME A.${part}_one COMMAND a)\n"
        (system / "CMakeLists.txt").write_text(made, encoding="utf-8")
        (system / "a_test.cpp").write_text("TEST(Fly, Flies)\n", encoding="utf-8")
        entry = f'[[lines]]\npage = "page.md"\nbegin = ["{begin}"]\nwhy = "{why}"\nwhere = "{where}"\n'
        (system / "lines_elsewhere.toml").write_text(entry, encoding="utf-8")
        return self.said("test/system/every_line.py", text, self.folder, self.folder / "fantail")

    def test_every_line_is_run_or_run_elsewhere(self):
        page = "```\n./dev fly > a\n```\n\n```\nfantail fly && test -e a\n./dev fly bad\n```\n"
        page += "\n<!-- printed by ./dev fly -->\n\n```\nsecond\n```\n"
        for where in ("A.test", "A.other_one", "Fly.Flies", "./dev fly", "by hand"):
            code, said = self.every(page, where=where)
            self.assertEqual(code, 0, said)
            self.assertIn("3 command lines of the manual run", said)
            self.assertRegex(said, r"page\.md +3 +0 +1\n" if where == "by hand" else r"page\.md +3 +1 +0\n")

    def test_a_line_that_is_neither_and_a_name_that_is_of_nothing(self):
        good = "```\n./dev fly bad\n```\n"
        for text, words, said in (("```\n./dev fly very_bad\n```\n" + good, {}, "FAILED: page.md: ./dev fly very_bad: exit code 66"),
                                  ("```\n./dev soar\n```\n" + good, {}, "./dev knows no soar"),
                                  ("```\n./dev fly\nfourth\n```\n" + good, {}, "it does not print: fourth"),
                                  ("<!-- printed by ./dev fly -->\n\n```\nfifth\n```\n" + good, {}, "it does not print: fifth"),
                                  ("<!-- printed by ./dev fly -->\n\n```\nse ...\n```\n" + good, {}, "it does not print: se ..."),
                                  ("```\nls here\n```\n" + good, {}, "ls here: is this a command?"),
                                  ("```\n./dev fly\n```\n", {}, "page.md has no line that is not run and begins with ./dev fly bad"),
                                  (good, {"why": ""}, "no reason"), (good, {"where": "A.tes"}, "there is no A.tes"),
                                  (good, {"where": "Fly.Fly"}, "there is no Fly.Fly"), (good, {"where": "./dev f"}, "there is no ./dev f"),
                                  (good, {"where": "docs/none.md"}, "there is no docs/none.md")):
            code, printed = self.every(text, **words)
            self.assertEqual(code, 1)
            self.assertIn(said, printed)
            self.assertIn("; errors: 1\n", printed)

    def test_verbs_options_and_keys(self):
        self.assertEqual(self.options("`./dev fly x --out y --set body.mass_kg=3`")[0], 0)
        for wrong, said in (("`./dev soar x`", "no verb soar"), ("```\n./dev fly \\\n  --ot y\n```\n", "no --ot"),
                            ("`fantail fly --set body.mass=3`", "cannot set body.mass")):
            code, printed = self.options("\n\n" + wrong + "\n")
            self.assertEqual(code, 1)
            self.assertIn(said, printed)

    def test_sentences_that_are_too_long_or_odd(self):
        def plain(text, *words):
            return self.said("test/system/plain_english.py", text, self.folder, "page.md", *words)

        good = "A list:\n\n- " + "word " * 34 + "word\n- `a b c` [two words](x.md#what-is-broken).\n\n| " + "word " * 20 + "| " + "word " * 20 + "|\n"
        self.assertEqual(plain(good), (0, "\n0 sentences to mend; 82 words in 1 pages, 0 sources\n"))
        for wrong, said in (("word " * 36, "page.md:1: 36 words"), ("All but for one.", '"but for" (write: except for)'),
                            ("Found.\nThe board hears nothing.", "page.md:1"), ("| a | It was not to be found. |", "page.md:1")):
            code, printed = plain(wrong)
            self.assertEqual(code, 1, wrong)
            self.assertIn(said, printed)

    def test_texts_of_a_source_that_are_too_long_or_odd(self):
        def checked(source):
            (self.folder / "one.cpp").write_text(source, encoding="utf-8")
            return self.said("test/system/plain_english.py", "Well.", self.folder, "page.md", "one.cpp")

        half = '"' + "word " * 14 + '"'
        for good in (half + "  // goes on\n    " + half, half + ";" + half + ' "word. Word {:.{}f}"', "// " + "word " * 40, f"R\"({'word ' * 40})\"",
                     '"const f = (a) => { return a; }' + "word " * 40 + '"', '"key = ' + "word " * 40 + '"', '"' + "tick 50 u16:0.3 " * 20 + '"',
                     '"<p>' + "word " * 20 + "</p><p>" + "word " * 20 + '</p>"', '"' + "word " * 20 + "\\n\\n  " + "word " * 20 + '"'):
            self.assertEqual(checked(good)[0], 0, good)
        for wrong, said in (("\n" + half + "  // goes on\n    " + half + ' "{:g}{}"', "one.cpp:2: 29 words"),
                            ('say("All but for one.");', '"but for" (write: except for)'), ("'\"'" + half + half + '"word"', "29 words")):
            code, printed = checked(wrong)
            self.assertEqual(code, 1, wrong)
            self.assertIn(said, printed)

    def test_help_that_is_too_long(self):
        def helped(text):
            program = "#!/bin/sh\ncase $1 in --complete) printf 'words\\nfly\\tFly\\n' ;; *) printf '%s' \"" + text + "\" ;; esac\n"
            (self.folder / "fantail").write_text(program, encoding="utf-8")
            return self.said("test/system/plain_english.py", "Well.", self.folder, "page.md", "--fantail", self.folder / "fantail")

        good = "Fly it\n\nOptions:\n  --out FILE   " + "word " * 28 + "\n  --in FILE    " + "word " * 28 + "\n"
        self.assertEqual(helped(good)[0], 0)
        self.assertIn("fantail fly --help: 29 words", helped(good.replace("word \n", "word word\n", 1))[1])

    def test_links_of_a_site(self):
        def checked(link):
            (self.folder / "a.html").write_text(f'<p id="here"></p>{link}', encoding="utf-8")
            return self.said("tools/docs/check_site.py", "", self.folder)

        for good in ('<a href="#here">', '<a href="a.html#here">', '<a href="https://example.org/x">', '<img src="data:,">'):
            self.assertEqual(checked(good), (0, ""))
        for wrong, said in (('<a href="#there">', "no such place"), ('<a href="b.html">', "no such file"),
                            ('<a href="/a.html">', "not from this folder"), ('<a href="https://x">', "no address"),
                            ('<script src="https://example.org/x.js">', "fetched from a network")):
            code, printed = checked(wrong)
            self.assertEqual(code, 1)
            self.assertIn(said, printed)


unittest.main()
