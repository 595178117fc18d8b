// SPDX-License-Identifier: MIT

#include "text/number.hpp"

#include "figures.hpp"
#include "test.hpp"
#include "text/apart.hpp"
#include "text/error.hpp"
#include "text/layout.hpp"
#include "text/quoting.hpp"

namespace fantail::text {
namespace {

TEST(Number, IsReadToTheLastBitWithSpacesAroundIt) {
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number(" \t-2e-3 \r"), -2e-3);
  EXPECT_EQ(number("+7"), 7.0);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("4.9406564584124654e-324"), 4.9406564584124654e-324) << "the smallest there is";
  EXPECT_EQ(number("0.1"), 0.1);
}

TEST(Number, WhatIsNoFiniteNumberIsNone) {
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "1e999", "1,5", "1 2", "+-1", "++1", "0x10", "1.5m", "-", "e5"}) {
    EXPECT_FALSE(number(text)) << '"' << text << '"';
  }
}

TEST(Number, BeyondAllDecimalsIsPrintedInAFewDigits) {
  EXPECT_EQ(fixed(1e300, 1), "1e+300");
  EXPECT_EQ(fixed(-1.234567e20, 2), "-1.235e+20");
  EXPECT_EQ(brief(1e20, 2), "1e+20");
  EXPECT_EQ(fixed(123456789012345.25, 2), "123456789012345.25");
}

TEST(Flag, IsOneOfFourWordsInWhateverLettersOrAZeroOrAOne) {
  for (const char* on : {"1", " true\r", "True", "YES", "1.0"}) {
    EXPECT_EQ(flag(on), true) << on;
  }
  for (const char* off : {"0", "False", "no", "0.0", "-0"}) {
    EXPECT_EQ(flag(off), false) << off;
  }
  for (const char* none : {"", "2", "-1", "0.4", "nan", "y", "on"}) {
    EXPECT_EQ(flag(none), std::nullopt) << none;
  }
}

TEST(Trimmed, LosesSpacesTabsAndACarriageReturnAtTheEndAndNothingInside) {
  EXPECT_EQ(trimmed("  a b\t \r"), "a b");
  EXPECT_EQ(trimmed("\ra"), "\ra");
  EXPECT_EQ(trimmed(" \t "), "");
}

TEST(WholeNumber, IsDigitsAndNothingElseUpToTheLargest) {
  EXPECT_EQ(whole_number("0"), 0U);
  EXPECT_EQ(whole_number("18446744073709551615"), 18446744073709551615U);
  for (const char* none : {"", "-1", "+1", " 1", "1 ", "1.0", "0x1", "18446744073709551616"}) {
    EXPECT_EQ(whole_number(none), std::nullopt) << none;
  }
}

TEST(CsvCell, IsTheTextItselfWhereNoReaderMistakesIt) {
  EXPECT_EQ(csv_cell(""), "");
  EXPECT_EQ(csv_cell("held 3.5 deg"), "held 3.5 deg");
}

TEST(CsvCell, IsInQuotesAndOnOneLineWhereAReaderWouldTakeItForMore) {
  EXPECT_EQ(csv_cell("a, b"), "\"a, b\"");
  EXPECT_EQ(csv_cell("says \"no\""), "\"says \"\"no\"\"\"");
  EXPECT_EQ(csv_cell("one\r\ntwo"), "\"one  two\"");
  EXPECT_EQ(csv_cell("# no remark"), "\"# no remark\"");
}

TEST(Decimal, IsTheNearestDoubleOfAllOfTheText) {
  EXPECT_EQ(decimal("-4.9"), -4.9);
  EXPECT_EQ(decimal("1e-3"), 0.001);
  EXPECT_EQ(decimal("9007199254740993"), 9007199254740992.0);  // between two: the even one
  EXPECT_EQ(decimal(".5"), 0.5);
}

TEST(Decimal, IsNoneOfWhatIsNotWhollyANumber) {
  for (const char* text : {"", "+1", " 1", "1 ", "1,5", "0x10", "1.5.2", "six", "1e400"}) {
    EXPECT_EQ(decimal(text), std::nullopt) << text;
  }
}

TEST(TomlText, QuotesWhatTomlReadsBack) {
  EXPECT_EQ(toml_text("a \"b\" c\\d \n\x7F \u00FC\U0001F680"),
            "\"a \\\"b\\\" c\\\\d \\u000a\\u007f \u00FC\U0001F680\"");
  EXPECT_EQ(toml_text(""), "\"\"");
}

TEST(TomlText, OfBytesThatAreNoUtf8IsRefused) {
  try {
    (void)toml_text("fl\xFCg");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_configuration);
    EXPECT_STREQ(error.what(), "\"fl?g\" is not UTF-8 text, which TOML needs; choose another name");
  }
}

Table example() {
  Table table{{{"what"}, {"least", 2}, {"median"}, {"largest", 1}}};
  table.row({"          ", "     least", "    median", "   largest"});
  table.row({"speed     ", "      10.5", "        12", "      14.5"});
  return table;
}

TEST(Table, IsItsCellsWhereThereIsRoom) {
  const std::string text = "               least    median   largest\nspeed           10.5        12      14.5\n";
  EXPECT_EQ(example().text(any_width), text);
  EXPECT_EQ(example().text(40), text);
}

TEST(Table, LosesBlanksBeforeColumns) {
  EXPECT_EQ(example().text(39), "       least  median  largest\nspeed   10.5      12     14.5\n");
}

TEST(Table, LosesColumnsInTheirOrderAndSaysWhich) {
  EXPECT_EQ(example().text(28),
            "       least  median\nspeed   10.5      12\n  Left out, for the width of this terminal: largest\n");
  EXPECT_EQ(example().text(15),
            "       median\nspeed      12\n  Left out, for the width of this terminal: largest, least\n");
  EXPECT_EQ(example().text(1), example().text(15)) << "the others stay";
}

TEST(Table, ARowMayEndEarly) {
  Table table{{{"a"}, {"b"}}};
  table.row({"a wide row of its own"});
  table.row({"x    ", "   1"});
  table.row_to_its_last_word({"y    ", "    "});
  EXPECT_EQ(table.text(any_width), "a wide row of its own\nx       1\ny\n");
  EXPECT_EQ(table.text(8), "a wide row of its own\nx  1\ny\n");
}

TEST(Wrapped, LinesThatFitStayAsTheyAre) {
  const std::string text = "one two\n\n  three   four\nfive";
  EXPECT_EQ(wrapped(text, 14), text);
  EXPECT_EQ(wrapped("a line of any length stays in a pipe\n", any_width), "a line of any length stays in a pipe\n");
}

TEST(Wrapped, ASentenceGoesOnTwoColumnsFartherIn) {
  EXPECT_EQ(wrapped("  one two three four\n", 11), "  one two\n    three\n    four\n");
}

TEST(Wrapped, ACellGoesOnBelowItself) {
  EXPECT_EQ(wrapped("  --out DIR   where all of it goes\n", 25), "  --out DIR   where all\n              of it goes\n");
  EXPECT_EQ(wrapped("                        a meaning below its option\n", 44),
            "                        a meaning below its\n                        option\n");
}

TEST(Wrapped, ACellThatWouldBeATowerOfWordsGoesBelowAsAWhole) {
  EXPECT_EQ(wrapped("  a long command line  what it does\n", 30), "  a long command line\n    what it does\n");
}

TEST(Wrapped, ACellThatIsTooNarrowForItsWordGoesBelowAsAWhole) {
  EXPECT_EQ(wrapped("  page     out/flight.html\n", 20), "  page\n    out/flight.html\n");
  EXPECT_EQ(wrapped("  page     out/a/very/long/path.html here\n", 20),
            "  page\n    out/a/very/long/path.html\n    here\n");
  EXPECT_EQ(wrapped(std::string(20, ' ') + "a meaning below its option\n", 30), "    a meaning below its option\n");
}

TEST(Wrapped, AHeadThatIsTooWideIsBrokenToo) {
  EXPECT_EQ(wrapped("  ticks with another command  17\n", 20), "  ticks with another\n    command\n    17\n");
}

TEST(Wrapped, ACommentStaysOne) {
  EXPECT_EQ(wrapped("x = 1   # how it begins\n", 18), "x = 1   # how it\n        # begins\n");
  EXPECT_EQ(wrapped("a_long_name = 1   # how it begins\n", 20), "a_long_name = 1\n    # how it begins\n");
}

TEST(Wrapped, AWordIsNeverSplitEvenWhenItIsWiderThanTheLine) {
  EXPECT_EQ(wrapped("page /a/very/long/path/page.html there\n", 12), "page\n  /a/very/long/path/page.html\n  there\n");
}

// "Up to Mach 0.80, but valid only to Mach 0.8."
TEST(Number, ApartFromALimitHasTheDigitsThatShowOnWhichSideOfItItIs) {
  EXPECT_EQ(apart(0.81, 0.8, 2), "0.81");
  EXPECT_EQ(apart(0.801, 0.8, 2), "0.801");
  EXPECT_EQ(apart(0.79996, 0.8, 2), "0.79996");
  EXPECT_EQ(apart(-0.001, 0.0, 2), "-0.001");
  EXPECT_EQ(apart(15.0, 15.0, 1), "15.0") << "the same";
  EXPECT_EQ(apart(15.0 + 1e-9, 15.0, 1), "15.0") << "as good as";
}

TEST(Wrapped, ALineOfNothingButBlanksIsAnEmptyOne) {
  EXPECT_EQ(wrapped("a\n" + std::string(50, ' ') + "\nb\n", 40), "a\n\nb\n");
}

TEST(Wrapped, ACommandStaysWhole) {
  EXPECT_EQ(wrapped("again: fantail fly --run 3\n", 20), "again:\n  fantail fly --run 3\n");
  EXPECT_EQ(wrapped("  fantail fly my_rocket --seed 3\n", 20), "  fantail fly my_rocket --seed 3\n");
}

TEST(Wrapped, ThePatternOfACommandIsNoCommand) {
  EXPECT_EQ(wrapped("Usage: fantail fly [OPTIONS] [SCENARIO]\n", 20),
            "Usage: fantail fly\n  [OPTIONS]\n  [SCENARIO]\n");
}

TEST(Wrapped, CharactersCountAndNotTheirBytes) {
  EXPECT_EQ(display_width("\u221220 \u00b0"), 5U);
  EXPECT_EQ(wrapped("\u00b1\u00b1\u00b1\u00b1 \u00b1\u00b1\u00b1\u00b1\n", 9),
            "\u00b1\u00b1\u00b1\u00b1 \u00b1\u00b1\u00b1\u00b1\n");
  EXPECT_EQ(wrapped("\u00b1\u00b1 \u00b1\u00b1\n", 4), "\u00b1\u00b1\n  \u00b1\u00b1\n");
}

TEST(Wrapped, AColourTakesNoRoom) {
  EXPECT_EQ(display_width("\033[31mNo go\033[0m"), 5U);
  EXPECT_EQ(wrapped("\033[31mNo go\033[0m: why\n", 10), "\033[31mNo go\033[0m: why\n");
}

TEST(Counted, IsOneOrMany) {
  EXPECT_EQ(counted(0, "run"), "0 runs");
  EXPECT_EQ(counted(1, "run"), "1 run");
  EXPECT_EQ(counted(2, "run"), "2 runs");
  EXPECT_EQ(counted(1, "record was", "records were"), "1 record was");
  EXPECT_EQ(counted(12, "record was", "records were"), "12 records were");
}

TEST(Figures, OfASentenceAreItsNumbersAsTheyStandInItAndNoDigitsOfNames) {
  EXPECT_EQ(figures("No go: -3 to 4.50 s in 98 % of tasha3's runs, canard1_x2 at 3-4."),
            (std::vector<std::string>{"-3", "4.50", "98", "3", "4"}));
  EXPECT_TRUE(figures("Held: canard_2 is -").empty());
}

}  // namespace

}  // namespace fantail::text
