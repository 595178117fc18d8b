// SPDX-License-Identifier: MIT
#include "text/error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

TEST(Error, WhatItQuotesFromAFileWritesNothingToATerminal) {
  const Error error{ErrorKind::bad_data, "x.eng:2: propellant mass \"0.2\x1b[2J\x0e\n\x7f\xff\"; allowed: a number"};
  EXPECT_STREQ(error.what(), "x.eng:2: propellant mass \"0.2?[2J????\"; allowed: a number");
}

TEST(Error, QuotesOfAWordOfThousandsOfCharactersItsBeginningAndItsEnd) {
  const std::string error =
      Error{ErrorKind::usage, "--columns \"" + std::string(4000, 'x') + "\"; allowed: a name"}.what();
  EXPECT_LT(error.size(), 3100U);
  EXPECT_TRUE(error.starts_with("--columns \"xxx"));
  EXPECT_TRUE(error.ends_with("xxx\"; allowed: a name"));
  EXPECT_NE(error.find("xxx ... xxx"), std::string::npos);
}

TEST(Error, KeepsTheLettersOfEveryLanguage) {
  const std::string sentence = "Flügel 火箭.toml: no such file; 5 °C, 3 m²";
  EXPECT_EQ(Error(ErrorKind::no_such_input, sentence).what(), sentence);
}

}  // namespace
}  // namespace fantail::text
