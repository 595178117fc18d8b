// SPDX-License-Identifier: MIT
#include "sim/elementary.hpp"

#include "test.hpp"

namespace fantail::sim {
namespace {

TEST(Elementary, ExponentialAgreesWithTheCLibrary) {
  for (double x = -690.0; x < 690.0; x += 0.7131) {
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 5e-16) << x;
  }
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-1e9), 0.0);
  EXPECT_TRUE(std::isinf(exponential(1e9)));
}

TEST(Elementary, LogarithmAgreesWithTheCLibrary) {
  for (double x = 1e-12; x < 1e12; x *= 1.0371) {
    EXPECT_NEAR(natural_log(x), std::log(x), 5e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
  }
  for (double x = 0.9; x < 1.1; x += 0.00131) {
    EXPECT_NEAR(natural_log(x) / std::log(x), 1.0, 1e-15) << x;
  }
  EXPECT_EQ(natural_log(1.0), 0.0);
}

TEST(Elementary, SettlingAgreesWithTheExponentialOverItsWholeRange) {
  for (double x = 1e-9; x < 50.0; x *= 1.13) {
    const Settling s = settling(x);
    EXPECT_NEAR(s.gain / -std::expm1(-x), 1.0, 2e-15) << x;
    // The mean of 1 - e^-t over [0, x] is 1 - gain / x. Written plainly the weight cancels below 1e-2.
    const double weight = x < 1e-2 ? 0.5 + x / 12.0 - x * x * x / 720.0 : 1.0 / -std::expm1(-x) - 1.0 / x;
    EXPECT_NEAR(s.weight, weight, 1e-12) << x;
  }
}

}  // namespace
}  // namespace fantail::sim
