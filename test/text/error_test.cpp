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

TEST(Error, KeepsTheLettersOfEveryLanguage) {
  const std::string sentence = "Flügel 火箭.toml: no such file; 5 °C, 3 m²";
  EXPECT_EQ(Error(ErrorKind::no_such_input, sentence).what(), sentence);
}

}  // namespace
}  // namespace fantail::text
