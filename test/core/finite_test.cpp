// SPDX-License-Identifier: MIT
#include "core/finite.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fantail::core {
namespace {

using Limits = std::numeric_limits<float>;

TEST(Finite, IsEveryNumberAndNothingElse) {
  for (const float number : {0.0F, -0.0F, Limits::denorm_min(), Limits::min(), Limits::max(), Limits::lowest()}) {
    EXPECT_TRUE(is_finite(number)) << number;
  }
  for (const float other : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()}) {
    EXPECT_FALSE(is_finite(other)) << other;
  }
}

TEST(Finite, OneBadComponentSpoilsAVector) {
  EXPECT_TRUE(is_finite(Vector3{1.0F, 2.0F, 3.0F}));
  EXPECT_FALSE(is_finite(Vector3{Limits::quiet_NaN(), 0.0F, 0.0F}));
  EXPECT_FALSE(is_finite(Vector3{0.0F, Limits::infinity(), 0.0F}));
  EXPECT_FALSE(is_finite(Vector3{0.0F, 0.0F, -Limits::infinity()}));
}

TEST(Finite, TheLimitItselfIsWithinItAndTheNextNumberIsNot) {
  constexpr float most = 2.5F;
  const float beyond = std::nextafter(most, Limits::infinity());
  for (const float sense : {1.0F, -1.0F}) {
    EXPECT_TRUE(is_within(sense * most, most));
    EXPECT_FALSE(is_within(sense * beyond, most));
    EXPECT_TRUE(is_within(Vector3{sense * most, -sense * most, sense * most}, most));
    EXPECT_FALSE(is_within(Vector3{sense * beyond, 0.0F, 0.0F}, most));
    EXPECT_FALSE(is_within(Vector3{0.0F, sense * beyond, 0.0F}, most));
    EXPECT_FALSE(is_within(Vector3{0.0F, 0.0F, sense * beyond}, most));
  }
  EXPECT_FALSE(is_within(Limits::quiet_NaN(), most));
}

}  // namespace
}  // namespace fantail::core
