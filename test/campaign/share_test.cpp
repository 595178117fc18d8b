// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "campaign/analysis.hpp"

namespace fantail::campaign {
namespace {

// Newcombe, Two-sided confidence intervals for the single proportion, Statistics in Medicine 17 (1998), table I,
// method 3.
TEST(Share, HasTheWilsonIntervalsThatArePublished) {
  struct Case {
    std::size_t count, of;
    double low, high;
  };
  for (const Case& c : {Case{81, 263, 0.2553, 0.3662}, Case{15, 148, 0.0624, 0.1605}, Case{0, 20, 0.0, 0.1611},
                        Case{1, 29, 0.0061, 0.1718}}) {
    const Share found = share(c.count, c.of);
    EXPECT_DOUBLE_EQ(found.value, static_cast<double>(c.count) / static_cast<double>(c.of));
    EXPECT_NEAR(found.low, c.low, 5e-5) << c.count << " of " << c.of;
    EXPECT_NEAR(found.high, c.high, 5e-5) << c.count << " of " << c.of;
  }
}

TEST(Share, IsTheSameForWhatHappensAndWhatDoesNot) {
  const Share yes = share(37, 200);
  const Share no = share(163, 200);
  EXPECT_NEAR(yes.low, 1.0 - no.high, 1e-15);
  EXPECT_NEAR(yes.high, 1.0 - no.low, 1e-15);
}

TEST(Share, OfAllEndsAtOneAndOfNoneSaysNothing) {
  EXPECT_EQ(share(200, 200).high, 1.0);
  EXPECT_NEAR(share(200, 200).low, 200.0 / (200.0 + 1.959964 * 1.959964), 1e-9);
  EXPECT_EQ(share(0, 0).low, 0.0);
  EXPECT_EQ(share(0, 0).high, 1.0);
}

TEST(Quantiles, LiesBetweenItsValuesOnStraightLines) {
  const Quantiles s = quantiles({5.0, 1.0, 2.0, 4.0, 3.0});
  EXPECT_DOUBLE_EQ(s.mean, 3.0);
  EXPECT_DOUBLE_EQ(s.p5, 1.2);
  EXPECT_DOUBLE_EQ(s.p50, 3.0);
  EXPECT_DOUBLE_EQ(s.p95, 4.8);
}

TEST(Quantiles, OfOneValueIsThatValue) {
  const Quantiles s = quantiles({-7.0});
  EXPECT_EQ(s.p5, -7.0);
  EXPECT_EQ(s.p50, -7.0);
  EXPECT_EQ(s.p95, -7.0);
}

}  // namespace
}  // namespace fantail::campaign
