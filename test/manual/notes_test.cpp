// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "manual/roff.hpp"

namespace fantail::manual {
namespace {

TEST(Notes, TakeAnExampleAndItsMeaningApart) {
  const Notes notes = notes_of("Examples:\n  fantail fly      the second launch\n  fantail fly --json\n");
  ASSERT_EQ(notes.examples.size(), 2U);
  EXPECT_EQ(notes.examples[0].command, "fantail fly");
  EXPECT_EQ(notes.examples[0].meaning, "the second launch");
  EXPECT_EQ(notes.examples[1].command, "fantail fly --json");
  EXPECT_EQ(notes.examples[1].meaning, "");
}

TEST(Notes, PutACommandOfTwoLinesTogetherAndFindItsMeaningBelow) {
  const Notes notes = notes_of(
      "Examples:\n"
      "  fantail identify run7.csv --speed 22 \\\n"
      "      --window 0:5        for a script\n"
      "  fantail identify flight1\n"
      "                                          another logger's run\n");
  ASSERT_EQ(notes.examples.size(), 2U);
  EXPECT_EQ(notes.examples[0].command, "fantail identify run7.csv --speed 22 --window 0:5");
  EXPECT_EQ(notes.examples[0].meaning, "for a script");
  EXPECT_EQ(notes.examples[1].meaning, "another logger's run");
}

TEST(Notes, KeepSentencesApartFromExitCodes) {
  const Notes notes = notes_of(
      "An interrupted campaign\ngoes on.\nExit code 0: go; 1: no go.\nExamples:\n  fantail predict\n\nAnd so it is.");
  ASSERT_EQ(notes.sentences.size(), 2U);
  EXPECT_EQ(notes.sentences[0], "An interrupted campaign goes on.");
  EXPECT_EQ(notes.sentences[1], "And so it is.");
  ASSERT_EQ(notes.exits.size(), 1U);
  EXPECT_EQ(notes.exits[0], "Exit code 0: go; 1: no go.");
}

}  // namespace
}  // namespace fantail::manual
