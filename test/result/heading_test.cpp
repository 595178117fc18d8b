// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "result/document.hpp"

namespace fantail::result {
namespace {

TEST(Heading, IsNotSaidAgainByTheSentenceBehindIt) {
  struct Case {
    const char* heading;
    const char* sentence;
    const char* behind;
  };
  for (const Case& one :
       {Case{"Go", "Go: every criterion is met.", "every criterion is met."},
        {"Not held", "Roll not held: up to 24.0 deg.", "up to 24.0 deg."},
        {"Steady, off the command", "Steady, 20.1 deg from the command.", "20.1 deg from the command."},
        {"Held", "Steady, 2.0 deg from the command: roll stayed.", "Steady, 2.0 deg from the command: roll stayed."},
        {"Held", "Roll not held: up to 24.0 deg.", "Roll not held: up to 24.0 deg."},
        {"Oscillates", "The canards oscillate at 4 Hz.", "The canards oscillate at 4 Hz."},
        {"Compared", "", ""}}) {
    const Document document{
        .kind = "k", .title = "t", .verdict = {.answer = Answer::no, .heading = one.heading, .sentence = one.sentence}};
    EXPECT_EQ(behind_heading(document.verdict), one.behind);
    EXPECT_NE(text(document).find(std::string{one.heading} + ": " + one.behind + "\n"), std::string::npos)
        << text(document);
    EXPECT_EQ(json::parse(json(document))["sentence"], one.sentence) << "whole, without a heading";
  }
}

}  // namespace
}  // namespace fantail::result
