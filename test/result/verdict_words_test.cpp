// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "predict/decision.hpp"
#include "report/verdict.hpp"

namespace fantail::result {
namespace {

// docs/messages.md explains the large word of each page: does it know those of flights and predictions?
void expect_in_the_index(std::string_view word) {
  std::ifstream file{FANTAIL_TEST_SOURCE "/docs/messages.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  EXPECT_TRUE(page.find("| " + std::string{word}) != std::string::npos ||
              page.find(", " + std::string{word}) != std::string::npos)
      << word;
}

TEST(VerdictWords, OfEveryFlightAreInTheIndexOfMessages) {
  for (int i = 0; i <= static_cast<int>(report::Outcome::ascent_failed); ++i) {
    expect_in_the_index(report::display_name(static_cast<report::Outcome>(i)));
  }
}

TEST(VerdictWords, OfEveryPredictionAreInTheIndexOfMessages) {
  predict::Decision decision;
  expect_in_the_index(decision.heading());
  decision.go = true;
  expect_in_the_index(decision.heading());
  decision.cautions.emplace_back("roll resonance");
  expect_in_the_index(decision.heading());
  expect_in_the_index("Depends on the fins");
  expect_in_the_index("Could be a go");
}

}  // namespace
}  // namespace fantail::result
