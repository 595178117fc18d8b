// SPDX-License-Identifier: MIT
#include "manual/completion.hpp"

#include "test.hpp"

namespace fantail::manual {
namespace {

Offer plans(std::string_view /*begun*/) { return {.words = {"first", "second"}, .paths = Paths::files}; }
Offer folders(std::string_view /*begun*/) { return {.paths = Paths::folders}; }

Command bench() {
  const Option color{.names = {"--color"}, .value = "TEXT", .meaning = "Colours", .words = {"always", "never"}};
  const Option help{.names = {"--help", "-h"}, .meaning = "Print this"};
  const Command watch{.name = "fantail bench watch", .meaning = "Look", .options = {help, color}};
  const Command plan{.name = "fantail bench plan",
                     .meaning = "Send a plan",
                     .arguments = {{.names = {"PLAN"}, .value = "TEXT", .offering = plans}},
                     .options = {help, color, {.names = {"--out"}, .value = "TEXT", .offering = folders}}};
  return {.name = "fantail bench", .meaning = "Check", .options = {help}, .commands = {watch, plan}};
}

std::string of(const std::vector<std::string>& words) { return completion(bench(), words); }

TEST(Completion, OffersVerbsWithWhatTheyDo) {
  EXPECT_EQ(of({""}), "words\nwatch\tLook\nplan\tSend a plan\n");
  EXPECT_EQ(of({"w"}), "words\nwatch\tLook\n");
  EXPECT_EQ(of({"x"}), "words\n");
}

TEST(Completion, OffersTheOptionsOfTheVerbThatStandsThere) {
  EXPECT_EQ(of({"-"}), "words\n--help\tPrint this\n-h\tPrint this\n");
  EXPECT_EQ(of({"plan", "--o"}), "words\n--out\n");
  EXPECT_EQ(of({"watch", "--o"}), "words\n");
}

TEST(Completion, OffersTheWordsOfAChoice) {
  EXPECT_EQ(of({"watch", "--color", ""}), "words\nalways\nnever\n");
  EXPECT_EQ(of({"watch", "--color", "n"}), "words\nnever\n");
  EXPECT_EQ(of({"watch", "--color=n"}), "words\n--color=never\n");
}

TEST(Completion, OffersWhatAnArgumentMayBe) {
  EXPECT_EQ(of({"plan", ""}), "files\nfirst\nsecond\n");
  EXPECT_EQ(of({"plan", "--color", "never", "s"}), "files\nsecond\n");
  EXPECT_EQ(of({"plan", "--color=never", "s"}), "files\nsecond\n");
  EXPECT_EQ(of({"plan", "first", ""}), "words\n") << "it takes one";
}

TEST(Completion, OffersOneMoreOfAnArgumentThatIsRepeated) {
  Command command = bench();
  command.commands[1].arguments[0].repeated = true;
  EXPECT_EQ(completion(command, std::vector<std::string>{"plan", "first", "s"}), "files\nsecond\n");
}

TEST(Completion, OffersNeitherOptionsNorVerbsBehindABareDoubleDash) {
  EXPECT_EQ(of({"plan", "--", "--o"}), "files\n");
  EXPECT_EQ(of({"plan", "--", "--color=n"}), "files\n");
  EXPECT_EQ(of({"plan", "--", "f"}), "files\nfirst\n");
  EXPECT_EQ(of({"plan", "--", "--odd", ""}), "words\n") << "it takes one argument";
  EXPECT_EQ(of({"--", "w"}), "words\n");
  EXPECT_EQ(of({"plan", "--out", "--", "--o"}), "words\n--out\n") << "that is the name of a folder";
}

TEST(Completion, SaysThatAFolderIsWanted) {
  EXPECT_EQ(of({"plan", "--out", "x"}), "folders\n");
  EXPECT_EQ(of({"plan", "--out=x"}), "folders\n");
}

TEST(Completion, OffersNothingForAnOptionThatNobodyKnows) { EXPECT_EQ(of({"plan", "--nonsense=x"}), "words\n"); }

}  // namespace
}  // namespace fantail::manual
