// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "core/motion_estimator.hpp"
#include "protocol/state_block.hpp"

namespace fantail::protocol {
namespace {

/// Is a state still read when its byte `from_end` (1: the last one) has this value?
template <typename Part>
bool accepts(Part part, std::size_t from_end, unsigned value) {
  std::vector<std::byte> bytes(4'096);
  StateWriter writer{bytes};
  part.visit_state(writer);
  bytes.resize(writer.size());
  bytes[bytes.size() - from_end] = static_cast<std::byte>(value);
  StateReader reader{bytes};
  part.visit_state(reader);
  return reader.ok();
}

TEST(StateBlock, OfAPadWindowAPlaceInTheRingAndAsManyClosedBlocksAsItHasAreTheMost) {
  const core::PadWindow window{core::default_plan().motion};
  // Thirty blocks and the guard of five.
  EXPECT_TRUE(accepts(window, 1, 34));
  EXPECT_FALSE(accepts(window, 1, 35));
  EXPECT_TRUE(accepts(window, 2, 35));
  EXPECT_FALSE(accepts(window, 2, 36));
}

TEST(StateBlock, OfAMotionEstimatorEveryPlaceEveryStateOfASensorAndEveryDoubtIsReadAndNoOther) {
  core::FlightPlan plan = core::default_plan();
  const core::MotionEstimator one{plan.motion, plan.sensors};
  for (const std::size_t sensor : {1U, 2U}) {  // accelerometer, gyro
    EXPECT_TRUE(accepts(one, sensor, 3)) << "failed";
    EXPECT_FALSE(accepts(one, sensor, 4));
  }
  EXPECT_TRUE(accepts(one, 3, 2)) << "in free flight";
  EXPECT_FALSE(accepts(one, 3, 3));
  plan.sensors.gyros = core::GyroRule::two_agree;
  const core::MotionEstimator two{plan.motion, plan.sensors};
  EXPECT_TRUE(accepts(two, 1, 3)) << "both doubted";
  EXPECT_FALSE(accepts(two, 1, 4));
}

}  // namespace
}  // namespace fantail::protocol
