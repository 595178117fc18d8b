// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "paper/recomputed.hpp"

namespace fantail::paper {
namespace {

TEST(FirstLaunch, TheTimesOfEq35And36AreEvenInThrustAndInCoast) {
  const identify::model::NodeTimes expected{0.0, 1.47, 2.94, 5.97, 9.0};
  const identify::model::NodeTimes times = times_in_thrust_and_coast(2.94, 2, 9.0, 2);
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(times[i], expected[i], 1e-12) << i;
  }
}

}  // namespace
}  // namespace fantail::paper
