// SPDX-License-Identifier: MIT
#include "core/compensated_sum.hpp"

#include "properties.hpp"

namespace fantail::core {
namespace {

TEST(CompensatedSum, HoursOfSmallIncrementsAreNotLost) {
  CompensatedSum sum;
  const float increment = 1e-4F;
  double truth = 0.0;
  float plain = 0.0F;
  for (int i = 0; i < 10'000'000; ++i) {
    sum.add(increment);
    plain += increment;
    truth += static_cast<double>(increment);
  }
  EXPECT_NEAR(sum.value(), truth, truth * 1e-7);
  EXPECT_GT(std::abs(static_cast<double>(plain) - truth), 1.0);  // what a plain float sum would have lost
}

TEST(CompensatedSum, IncrementsBelowTheLastBitStillCount) {
  CompensatedSum sum;
  sum.add(1000.0F);
  for (int i = 0; i < 1000; ++i) {
    sum.add(1e-5F);  // the last bit of 1000 is 6e-5
  }
  EXPECT_NEAR(sum.value(), 1000.01F, 6.2e-5F);
}

TEST(CompensatedSum, ResetForgetsTheSumAndWhatItCarried) {
  CompensatedSum sum;
  sum.add(1000.0F);
  sum.add(1e-5F);
  sum.reset();
  EXPECT_EQ(sum.value(), 0.0F);
  sum.add(1.0F);
  EXPECT_EQ(sum.value(), 1.0F);
}

RC_GTEST_PROP(CompensatedSum, KeepsToKahansBoundHoweverManyIncrements, ()) {
  const auto increments = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-1'000'000, 1'000'000));
  CompensatedSum sum;
  double truth = 0.0;
  double absolute = 0.0;
  for (const int i : increments) {
    const float increment = static_cast<float>(i) * 1e-5F;
    sum.add(increment);
    truth += static_cast<double>(increment);
    absolute += std::abs(static_cast<double>(increment));
  }
  RC_ASSERT(std::abs(static_cast<double>(sum.value()) - truth) <= 1.2e-7 * absolute);
}

}  // namespace
}  // namespace fantail::core
