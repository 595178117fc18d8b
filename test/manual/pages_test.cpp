// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include <gmock/gmock.h>

#include "manual/roff.hpp"
#include "test.hpp"

namespace fantail::manual {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::array codes{ExitCode{0, "done"}, ExitCode{64, "usage"}};

std::string page(const Command& command) {
  return command_page(command, {.name = "fantail-fly", .section = 1, .date = "2026-11-22", .version = "1.2"}, codes);
}

TEST(CommandPage, SaysAllThatIsKnownOfAnOption) {
  const std::string text = page({.name = "fantail fly",
                                 .meaning = "Fly",
                                 .options = {{.names = {"--runs"},
                                              .value = "UINT",
                                              .allowed = "from 1 to 9",
                                              .usual = "3",
                                              .meaning = "How many",
                                              .needs = {"--seed"},
                                              .excludes = {"--json", "--all"},
                                              .required = true}}});
  EXPECT_THAT(text,
              HasSubstr(".TP\n\\fB\\-\\-runs\\fR \\fIUINT\\fR\nHow many (required; from 1 to 9; default "
                        "\\fB3\\fR; needs \\fB\\-\\-seed\\fR; not with \\fB\\-\\-json\\fR, \\fB\\-\\-all\\fR)\n"));
}

TEST(CommandPage, ShowsTheWordsOfAChoiceAsItsValue) {
  const std::string text = page({.name = "fantail fly",
                                 .meaning = "Fly",
                                 .options = {{.names = {"--loop"}, .value = "TEXT", .words = {"open", "closed"}}}});
  EXPECT_THAT(text, HasSubstr("\\fB\\-\\-loop\\fR \\fIopen|closed\\fR\n"));
}

TEST(CommandPage, ShowsArgumentsInTheSynopsis) {
  const std::string text =
      page({.name = "fantail fly",
            .meaning = "Fly",
            .arguments = {{.names = {"A"}, .required = true}, {.names = {"B"}, .repeated = true}}});
  EXPECT_THAT(text, HasSubstr("\\fBfantail fly\\fR [\\fIoptions\\fR] \\fIA\\fR [\\fIB\\fR ...]\n"));
}

TEST(CommandPage, ShowsInTheSynopsisWhichOptionsAreRequired) {
  const Option can{.names = {"-c", "--can"}, .value = "IF", .required = true};
  const std::string text = page(
      {.name = "fantail bench",
       .meaning = "Check",
       .commands = {{.name = "fantail bench watch", .options = {can}}, {.name = "fantail bench arm", .options = {can}}},
       .needs_command = true});
  EXPECT_THAT(text, HasSubstr("\\fBfantail bench watch\\fR \\fB\\-\\-can\\fR \\fIIF\\fR [\\fIoptions\\fR]\n.br\n"));
}

TEST(CommandPage, HasASectionForEachVerbOfTheCommand) {
  const Command watch{.name = "fantail bench watch",
                      .meaning = "Look",
                      .options = {{.names = {"--json"}, .meaning = "For a script"}},
                      .notes = "Examples:\n  fantail bench watch  look"};
  const std::string text =
      page({.name = "fantail bench", .meaning = "Check", .commands = {watch}, .needs_command = true});
  EXPECT_THAT(text, HasSubstr(".SH bench watch\n"));
  EXPECT_THAT(text, HasSubstr("For a script"));
  EXPECT_THAT(text, HasSubstr(".SS Examples\n"));
  EXPECT_THAT(text, Not(HasSubstr("\\fBfantail bench\\fR [")));
}

TEST(CommandPage, KeepsACommandOfItsExamplesAsLinesThatAShellTakes) {
  const std::string text = page({.name = "fantail fly",
                                 .meaning = "Fly",
                                 .notes = "Examples:\n  fantail fly  once\n"
                                          "  fantail fly --to " +
                                          std::string(40, 'x') + " --from " + std::string(40, 'y') + "\n"});
  EXPECT_THAT(text, HasSubstr(".nf\n\\fBfantail fly\\fR\n.fi\n.RS 4\nonce\n.RE\n"));
  EXPECT_THAT(text, HasSubstr("\\fBfantail fly \\-\\-to " + std::string(40, 'x') + " \\e\\fR\n\\fB    \\-\\-from yyy"));
}

TEST(CommandPage, ListsExitCodesBelowWhatTheCommandSaysOfThem) {
  const std::string text = page({.name = "fantail fly", .meaning = "Fly", .notes = "Exit code 0: go."});
  EXPECT_THAT(text, HasSubstr(".SH EXIT STATUS\n.PP\nExit code 0: go.\n.TP\n\\fB0\\fR\ndone\n"));
}

TEST(CommandPage, BeginsItsNameLineSmallUnlessThatIsAnAbbreviation) {
  EXPECT_THAT(page({.name = "fantail fly", .meaning = "Fly a scenario"}),
              HasSubstr("fantail\\-fly \\- fly a scenario\n"));
  EXPECT_THAT(page({.name = "fantail fly", .meaning = "CAN and LCM"}), HasSubstr("fantail\\-fly \\- CAN and LCM\n"));
}

TEST(Markdown, TakesThePassagesThatAreMarked) {
  EXPECT_EQ(passages_for_manual("a\n<!-- manual -->\nb\n<!-- end of manual -->\nc\n<!-- manual -->\nd\n"
                                "<!-- end of manual -->\n"),
            "b\n\nd\n\n");
  EXPECT_THROW((void)passages_for_manual("nothing"), std::runtime_error);
}

TEST(Markdown, KeepsTheWordsOfALinkAndDropsStars) {
  EXPECT_EQ(roff_of_markdown("See **[the `law`](control.md)** [0, 1]\nand `a*b[1](2)`.\n"),
            ".PP\nSee the \\fBlaw\\fR [0, 1] and \\fBa*b[1](2)\\fR.\n");
}

TEST(Markdown, LeavesOutALinkThatStandsAloneInBrackets) {
  EXPECT_EQ(roff_of_markdown("As they are ([an example](a.md)) (so [it](b.md) is).\n"),
            ".PP\nAs they are (so it is).\n");
}

TEST(Markdown, MakesAnItemOfEachRowOfATable) {
  EXPECT_EQ(roff_of_markdown("| key | unit | default | meaning |\n|---|---|---|---|\n"
                             "| `tilt` | deg | 0 | Against the vertical. |\n| `roll` |  | required | Free. |\n"),
            ".TP\n\\fBtilt\\fR  (deg; default 0)\nAgainst the vertical.\n"
            ".TP\n\\fBroll\\fR  (required)\nFree.\n");
}

TEST(Markdown, PutsWhatIsTooLongForATagBehindTheText) {
  const std::string many(70, 'x');
  EXPECT_EQ(roff_of_markdown("| key | range | meaning |\n|---|---|---|\n| `kind` | " + many + " | Which. |\n"),
            ".TP\n\\fBkind\\fR\nWhich. (" + many + ")\n");
}

TEST(Markdown, KeepsCodeAsItIs) {
  EXPECT_EQ(roff_of_markdown("```toml\n[body]  # *x*\n```\nEnd.\n"),
            ".PP\n.RS 4\n.nf\n[body]  # *x*\n.fi\n.RE\n.PP\nEnd.\n");
}

TEST(Markdown, PutsAWideCommentBeforeItsLine) {
  const std::string word(31, 'x');
  EXPECT_EQ(
      roff_of_markdown("```\nkey = 1        # " + word + " " + word + "\n               # and more\nlast = 2\n```\n"),
      ".PP\n.RS 4\n.nf\n# " + word + " " + word + "\n# and more\nkey = 1\nlast = 2\n.fi\n.RE\n");
}

TEST(Markdown, KnowsHeadingsAndLists) {
  EXPECT_EQ(roff_of_markdown("## The format: `x`\n\n- one\n  and more\n  - within\n- two\n"),
            ".SH THE FORMAT: x\n.IP \\(bu 2\none and more\n.RS 4\n.IP \\(bu 2\nwithin\n.RE\n.IP \\(bu 2\ntwo\n");
  EXPECT_EQ(roff_of_markdown("`[wind]`\n\nText.\n"), ".SS [wind]\n.PP\nText.\n");
}

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

TEST(Roff, TakesNoTextForAnInstruction) {
  EXPECT_EQ(roff("a\\b --set"), "a\\eb \\-\\-set");
  EXPECT_EQ(paragraph(".SH no heading"), ".PP\n\\&.SH no heading\n");
  EXPECT_EQ(paragraph("'tis none"), ".PP\n\\&'tis none\n");
  EXPECT_EQ(verbatim(".x\ny"), ".PP\n.RS 4\n.nf\n\\&.x\ny\n.fi\n.RE\n");
}

TEST(Roff, NamesCharactersThatAreNotAscii) { EXPECT_EQ(roff("−5 °, 𝄞"), "\\[u2212]5 \\[u00B0], \\[u1D11E]"); }

TEST(Roff, MakesBackticksBold) { EXPECT_EQ(sentence("of `--plan`, too"), "of \\fB\\-\\-plan\\fR, too"); }

TEST(Roff, LeavesOutABreakThatFollowsAHeading) {
  EXPECT_EQ(tidied(heading("NAME") + paragraph("a") + paragraph("b")), ".SH NAME\na\n.PP\nb\n");
}

}  // namespace

}  // namespace fantail::manual
