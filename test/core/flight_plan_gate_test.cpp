// SPDX-License-Identifier: MIT
#include "core/flight_plan.hpp"
#include "core/flight_plan_fields.hpp"
#include "expect_fault.hpp"
#include "known_roll_model.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr DormantUntil gates[] = {DormantUntil::burn_out, DormantUntil::max_dynamic_pressure, DormantUntil::height,
                                  DormantUntil::burn_out_and_height, DormantUntil::max_dynamic_pressure_and_height};

FlightPlan plan_that_waits(DormantUntil until) {
  FlightPlan plan = default_plan();
  plan.dormancy.until = until;
  plan.dormancy.burn_time = Microseconds{3'000'000};
  return plan;
}

PlanRule rule_of(const FlightPlan& plan) { return validate(plan).value().rule; }

TEST(GatedPlan, WaitsForWhatAFlightMeasuresOrForTheGuide) {
  for (const DormantUntil until : gates) {
    FlightPlan plan = plan_that_waits(until);
    EXPECT_FALSE(validate(plan)) << static_cast<int>(until);
    plan.motion.height_origin = HeightOrigin::from_detection;
    expect_fault(plan, "dormancy", "until");
    plan.motion.height_origin = HeightOrigin::velocity_only;
    EXPECT_FALSE(validate(plan));
    plan.run.start = Start::tunnel;
    expect_fault(plan, "dormancy", "until");
    EXPECT_EQ(rule_of(plan), PlanRule::gate_is_measured);
    plan.dormancy.until = DormantUntil::guide;
    EXPECT_FALSE(validate(plan));
  }
}

TEST(GatedPlan, ByBurnOutHasTheBurnTimeOfTheMotor) {
  for (const DormantUntil until : gates) {
    FlightPlan plan = plan_that_waits(until);
    plan.dormancy.burn_time = Microseconds{0};
    if (until == DormantUntil::burn_out || until == DormantUntil::burn_out_and_height) {
      expect_fault(plan, "dormancy", "burn_time_s");
      EXPECT_EQ(rule_of(plan), PlanRule::burn_out_has_time);
    } else {
      EXPECT_FALSE(validate(plan));
    }
  }
}

TEST(GatedPlan, ByHeightWaitsBeyondTheGuide) {
  for (const DormantUntil until : gates) {
    FlightPlan plan = plan_that_waits(until);
    plan.dormancy.height_m = plan.guide.length_m + plan.guide.clearance_m;
    if (until == DormantUntil::burn_out || until == DormantUntil::max_dynamic_pressure) {
      EXPECT_FALSE(validate(plan));
    } else {
      expect_fault(plan, "dormancy", "height_m");
      EXPECT_EQ(rule_of(plan), PlanRule::height_beyond_guide);
      plan.dormancy.height_m += 0.01F;
      EXPECT_FALSE(validate(plan));
    }
  }
}

FlightPlan plan_that_captures() {
  FlightPlan plan = default_plan();
  plan.controller.entry = ControlEntry::capture;
  return plan;
}

TEST(CapturingPlan, NeedsAFlightThatKnowsItsSpeed) {
  FlightPlan plan = plan_that_captures();
  EXPECT_FALSE(validate(plan));
  plan.motion.height_origin = HeightOrigin::from_detection;
  expect_fault(plan, "controller", "entry");
  EXPECT_EQ(rule_of(plan), PlanRule::speed_is_known);
}

TEST(CapturingPlan, TurnsTheRocketBackByItsAngleAndDampsItsRate) {
  FlightPlan plan = plan_that_captures();
  plan.controller.proportional_gain = 0.0F;
  expect_fault(plan, "controller", "entry");
  EXPECT_EQ(rule_of(plan), PlanRule::capture_turns_back);
  plan = plan_that_captures();
  plan.controller.rate_reference = RateReference::paper_literal;
  expect_fault(plan, "controller", "entry");
  EXPECT_EQ(rule_of(plan), PlanRule::capture_turns_back);
}

TEST(CapturingPlan, HasAWholeRollModelOrNone) {
  FlightPlan whole = plan_that_captures();
  whole.roll_model = known_roll_model;
  EXPECT_FALSE(validate(whole));
  for (float RollModelPlan::* const value : {&RollModelPlan::roll_inertia_kg_m2, &RollModelPlan::reference_area_m2,
                                             &RollModelPlan::damping_m2, &RollModelPlan::torque_m}) {
    FlightPlan lacks_one = whole;
    lacks_one.roll_model.*value = 0.0F;
    FlightPlan has_one = plan_that_captures();
    has_one.roll_model.*value = 1.0F;
    for (const FlightPlan& plan : {lacks_one, has_one}) {
      expect_fault(plan, "controller", "entry");
      EXPECT_EQ(rule_of(plan), PlanRule::capture_model_is_whole);
    }
    lacks_one.controller.entry = ControlEntry::as_published;
    EXPECT_FALSE(validate(lacks_one));
  }
}

}  // namespace
}  // namespace fantail::core
