// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include "link/avionics_link.hpp"

namespace fantail::link {
namespace {

TEST(Recording, CountsTheNumbersThatNeverCame) {
  Recording recording;
  for (const std::int64_t number : {10, 11, 14, 15, 20}) {
    EXPECT_TRUE(recording.add({.number = number}));
  }
  EXPECT_EQ(recording.lost_ticks(), 6U);
  EXPECT_EQ(recording.refused_ticks(), 0U);
}

TEST(Recording, RefusesWhatComesTwiceOrLate) {
  Recording recording;
  EXPECT_TRUE(recording.add({.number = 10}));
  EXPECT_FALSE(recording.add({.number = 10}));
  EXPECT_FALSE(recording.add({.number = 9}));
  EXPECT_TRUE(recording.add({.number = 11}));
  EXPECT_EQ(recording.ticks().size(), 2U);
  EXPECT_EQ(recording.refused_ticks(), 2U);
}

TEST(Recording, HoldsNoMoreThanItsBoundWhateverNumbersCome) {
  Recording recording{100};
  for (int i = 0; i < 1000; ++i) {
    recording.add({.number = i});
  }
  EXPECT_EQ(recording.ticks().size(), 100U);
  EXPECT_FALSE(recording.add({.number = std::numeric_limits<std::int64_t>::max()}));
  Recording far{100};
  EXPECT_TRUE(far.add({.number = std::numeric_limits<std::int64_t>::min()}));
  EXPECT_FALSE(far.add({.number = std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(far.lost_ticks(), 0U);
}

TEST(Recording, AnEmptyOneHasLostNothing) { EXPECT_EQ(Recording{}.lost_ticks(), 0U); }

}  // namespace
}  // namespace fantail::link
