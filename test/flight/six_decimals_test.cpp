// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "flight/columns.hpp"
#include "seed.hpp"

namespace fantail::flight {
namespace {

// What the C library says, which rounds the exact binary value.
std::string printed(double value) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.6f", value);
  return std::string{text.data()} == "-0.000000" ? "0.000000" : text.data();
}

TEST(SixDecimals, AreThoseOfPrintf) {
  for (const double value :
       {0.0,       -0.0,      1.0,    -1.0,      0.1,       1e-7,       -1e-7,          4.9999999e-7,        5e-7,
        0.1234565, 0.1234575, 2.5e-6, 0.0078125, 0.0234375, -0.0078125, 999999.9999995, 123456789.123456789, 3.9e9,
        4.1e9,     -4.1e9,    1e15,   1e22,      1e300,     -1e300}) {
    EXPECT_EQ(SixDecimals{value}.text(), printed(value)) << value;
  }
}

TEST(SixDecimals, AreThoseOfPrintfForAnyNumber) {
  std::mt19937_64 random{test::seed()};
  std::uniform_real_distribution<double> mantissa{-1.0, 1.0};
  std::uniform_int_distribution<int> exponent{-12, 16};
  for (int i = 0; i < 200'000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    ASSERT_EQ(SixDecimals{value}.text(), printed(value));
  }
}

TEST(SixDecimals, AreThoseOfPrintfNextToEveryTie) {
  // 2^-7 of a millionth's multiples: exact ties, and the doubles on both sides.
  for (int i = 1; i < 20'000; i += 2) {
    const double tie = i / 128.0;
    for (const double value : {tie, std::nextafter(tie, 0.0), std::nextafter(tie, 1e9), -tie}) {
      ASSERT_EQ(SixDecimals{value}.text(), printed(value));
    }
  }
}

TEST(SixDecimals, BrieflyHaveNoZerosAtTheEnd) {
  EXPECT_EQ(SixDecimals{0.25}.brief(), "0.25");
  EXPECT_EQ(SixDecimals{-70.0}.brief(), "-70");
  EXPECT_EQ(SixDecimals{0.0}.brief(), "0");
  EXPECT_EQ(SixDecimals{0.000001}.brief(), "0.000001");
}

TEST(SixDecimals, WhatIsNoNumberIsStillText) {
  EXPECT_EQ(SixDecimals{std::numeric_limits<double>::infinity()}.text(), "inf");
  EXPECT_EQ(SixDecimals{std::nan("")}.text(), "nan");
}

}  // namespace
}  // namespace fantail::flight
