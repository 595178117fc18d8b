// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "avionics/write_state.hpp"
#include "core/flight_plan_fields.hpp"

namespace fantail::avionics {
namespace {

// By the sizes that protocol/state_block.hpp gives: of each gyro the time of its last sample, three rates and how often
// it has said the same; the three differences, of how many samples, since when they disagree, and who is doubted.
TEST(TwoGyrosState, ALawThatFliesOnTwoGyrosRemembers74BytesMore) {
  core::FlightPlan plan = core::default_plan();
  core::Autopilot one{plan};
  plan.sensors.gyros = core::GyroRule::two_agree;
  core::Autopilot two{plan};
  for (const auto extent : {protocol::StateExtent::whole, protocol::StateExtent::in_flight}) {
    EXPECT_EQ(write_state(two, {}, extent), write_state(one, {}, extent) + 2 * (8 + 12 + 4) + 12 + 4 + (1 + 8) + 1);
  }
}

}  // namespace
}  // namespace fantail::avionics
