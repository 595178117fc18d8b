// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "allowed_canards.hpp"
#include "core/flight_plan.hpp"
#include "core/flight_plan_fields.hpp"
#include "plan_generator.hpp"
#include "properties.hpp"

namespace fantail::core {
namespace {

// Rules of a flight plan at their very limits, and for each canard and sensor.

// Which field is at fault, and where more than one of it exist, which.
std::string fault_of(const FlightPlan& plan) {
  const std::optional<PlanFault> fault = validate(plan);
  if (!fault) {
    return "none";
  }
  const PlanField& field = flight_plan_fields()[fault->field];
  return std::string{field.key} + " " + std::to_string(fault->slot) + ": " + std::string{sentence(fault->rule)};
}

// Of its three axes a sensor has one to the nose, and another along y: the same one, or its opposite, is no mounting.
TEST(FlightPlan, TwoAxesOfASensorDiffer) {
  struct Sensor {
    SensorMounting SensorsPlan::* mounting;
    std::string_view field;
  };
  constexpr std::array<char, 6> axis_of{'x', 'x', 'y', 'y', 'z', 'z'};  // +x, -x, +y, ...
  for (const Sensor& sensor :
       {Sensor{&SensorsPlan::imu, "imu_along_y"}, Sensor{&SensorsPlan::second_imu, "second_imu_along_y"},
        Sensor{&SensorsPlan::accelerometer, "accelerometer_along_y"}}) {
    for (std::size_t to_nose = 0; to_nose < axis_of.size(); ++to_nose) {
      for (std::size_t along_y = 0; along_y < axis_of.size(); ++along_y) {
        FlightPlan plan = default_plan();
        plan.sensors.*sensor.mounting = {static_cast<SensorAxis>(to_nose), static_cast<SensorAxis>(along_y)};
        const std::string expected =
            axis_of[to_nose] == axis_of[along_y]
                ? std::string{sensor.field} + " 0: must be another axis than the one that points to the nose"
                : "none";
        EXPECT_EQ(fault_of(plan), expected) << to_nose << " " << along_y;
      }
    }
  }
}

TEST(FlightPlan, AMicrosecondARadianIsTheLeastThatAServoMovesBy) {
  for (std::size_t canard = 0; canard < canard_count; ++canard) {
    for (const float pulse : {1.0F, -1.0F, 1.5F, -1.5F}) {
      FlightPlan plan = default_plan();
      plan.canards.each[canard].pulse_per_radian_us = pulse;
      EXPECT_EQ(fault_of(plan), "none");
      plan.canards.each[canard].pulse_per_radian_us = pulse < 0.0F ? -0.75F : 0.75F;
      EXPECT_EQ(fault_of(plan), "pulse_per_degree_us " + std::to_string(canard) + ": must not be zero");
    }
    FlightPlan dead = default_plan();
    dead.canards.each[canard].pulse_per_radian_us = 0.0F;
    EXPECT_EQ(fault_of(dead), "pulse_per_degree_us " + std::to_string(canard) + ": must not be zero");
  }
}

// 2048 us a radian on a quarter of a radian are 512 us on each side.
TEST(FlightPlan, PulsesOf500And2500MicrosecondsAreStillUnderstood) {
  for (std::size_t canard = 0; canard < canard_count; ++canard) {
    FlightPlan plan = default_plan();
    plan.controller.canard_limit = Angle::from_radians(0.25F);
    CanardPlan& changed = plan.canards.each[canard];
    for (const float pulse : {2048.0F, -2048.0F}) {
      changed.pulse_per_radian_us = pulse;
      for (const float centre : {1012.0F, 1988.0F}) {
        changed.pulse_centre_us = centre;
        EXPECT_EQ(fault_of(plan), "none") << centre;
      }
      for (const float centre : {1011.5F, 1988.5F}) {
        changed.pulse_centre_us = centre;
        EXPECT_EQ(fault_of(plan).substr(0, 17), "pulse_centre_us " + std::to_string(canard)) << centre;
      }
    }
  }
}

RC_GTEST_PROP(ProofRanges, NoPlanThatMayFlyIsOutsideOfWhatTheProofsOfTheMixerLookAt, ()) {
  const FlightPlan plan = arbitrary_plan();
  RC_ASSERT(proof::is_allowed(plan.canards, plan.controller.canard_limit));
}

TEST(ProofRanges, TheirPredicateIsFalseForWhatNoPlanMayHave) {
  const FlightPlan plan = default_plan();
  const Angle limit = plan.controller.canard_limit;
  EXPECT_TRUE(proof::is_allowed(plan.canards, limit));
  EXPECT_FALSE(proof::is_allowed(plan.canards, Angle{}));
  EXPECT_FALSE(proof::is_allowed(plan.canards, Angle::from_degrees(46.0F)));
  CanardsPlan canards = plan.canards;
  canards.each[3].trim = -limit;
  EXPECT_FALSE(proof::is_allowed(canards, limit));
}

}  // namespace

}  // namespace fantail::core
