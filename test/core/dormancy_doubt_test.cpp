// SPDX-License-Identifier: MIT
// What keeps the gates for height and dynamic pressure closed although the estimate has passed them.
#include "core/dormancy_gate.hpp"
#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "motion_flight.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

DormancyGate gate_until(DormantUntil until) {
  DormancyPlan plan = default_plan().dormancy;  // 1 % and 60 mg
  plan.until = until;
  plan.height_m = 900.0F;
  plan.burn_time = ms(2'000);
  return DormancyGate{plan};
}

/// Ten seconds after first thrust, at 1 000 m: without a doubt about the tilt at least 955.7 m, because
/// 0.01 (1000 + 490.3) + 0.06 * 9.807 * 50 = 44.3.
Motion at_1000_m(float horizontal_distance_m) {
  Motion motion;
  motion.specific_force_m_s2 = {-1.0F, 0.0F, 0.0F};
  motion.height_m = 1'000.0F;
  motion.horizontal_distance_m = horizontal_distance_m;
  motion.speed_m_s = 80.0F;
  motion.speed_squared_m2_s2 = 6400.0F;
  motion.gyro = motion.accelerometer = SensorState::fresh;
  return motion;
}

TEST(DormancyDoubt, ATiltThatAZeroErrorHidesCostsHeightInProportionToTheWayToTheSide) {
  // (955.7 - 900) / (sqrt(2) * 0.06) = 656 m.
  for (const auto& [aside_m, opens] : {std::pair{650.0F, true}, {662.0F, false}}) {
    DormancyGate gate = gate_until(DormantUntil::height);
    gate.update(ms(10'000), at_1000_m(aside_m));
    EXPECT_EQ(gate.is_open(), opens) << aside_m;
  }
}

TEST(DormancyDoubt, WhileTwoAccelerometersDisagreeNeitherHeightNorPressureOpens) {
  for (const DormantUntil until : {DormantUntil::height, DormantUntil::max_dynamic_pressure}) {
    for (const bool agreed : {true, false}) {
      DormancyGate gate = gate_until(until);
      Motion motion = at_1000_m(0.0F);
      motion.height_m = 500.0F;
      gate.update(ms(10'000), motion);
      motion = at_1000_m(0.0F);
      motion.speed_squared_m2_s2 = 4900.0F;
      gate.update(ms(10'001), motion, agreed);
      EXPECT_EQ(gate.is_open(), agreed);
      gate.update(ms(10'002), motion);
      EXPECT_TRUE(gate.is_open());
    }
  }
}

TEST(DormancyDoubt, BurnOutNeedsNoSecondAccelerometer) {
  DormancyGate gate = gate_until(DormantUntil::burn_out);
  gate.update(ms(10'000), at_1000_m(0.0F), false);
  gate.update(ms(10'200), at_1000_m(0.0F), false);
  EXPECT_TRUE(gate.is_open());
}

TEST(DormancyDoubt, TheWayToTheSideIsThatOfATiltedGuide) {
  Flight flight{{.tilt_deg = 20.0, .azimuth_deg = 35.0}};
  flight.stand();
  flight.lift_off(40.0, 0.0);
  flight.estimator.begin_flight(flight.rig.time());
  flight.run(ms(2'000), 40.0, 0.0);
  const double aside_m = flight.rig.height_m() * std::tan(20.0 * MotionRig::degree);
  EXPECT_NEAR(static_cast<double>(flight.motion().horizontal_distance_m), aside_m, 1e-3 * aside_m);
}

}  // namespace
}  // namespace fantail::core
