// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "manual/roff.hpp"

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

}  // namespace
}  // namespace fantail::manual
