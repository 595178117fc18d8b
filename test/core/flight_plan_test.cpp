// SPDX-License-Identifier: MIT
#include "core/flight_plan.hpp"

#include "core/flight_plan_fields.hpp"
#include "expect_fault.hpp"
#include "known_roll_model.hpp"
#include "plan_generator.hpp"
#include "properties.hpp"

namespace fantail::core {
namespace {

using namespace literals;
constexpr float infinity = std::numeric_limits<float>::infinity();

// Faults other than those of the field itself come from rules across fields.
bool out_of_range(const FlightPlan& plan, const PlanField& of, std::size_t slot) {
  const std::optional<PlanFault> fault = validate(plan);
  return fault && &flight_plan_fields()[fault->field] == &of && fault->slot == slot &&
         (fault->rule == PlanRule::in_range || fault->rule == PlanRule::finite);
}

TEST(FlightPlan, TheDefaultsFly) { EXPECT_FALSE(validate(default_plan()).has_value()); }

TEST(FlightPlan, EveryFieldSaysWhatItIsAndNoTwoShareAName) {
  std::set<std::string> names;
  for (const PlanField& f : flight_plan_fields()) {
    EXPECT_TRUE(names.insert(std::string{f.section} + "." + std::string{f.key}).second) << f.key;
    EXPECT_FALSE(f.meaning.empty()) << f.key;
    EXPECT_LE(f.meaning.size(), 100U) << f.key << ": one line";
    EXPECT_LT(f.minimum, f.maximum) << f.key;
    EXPECT_TRUE(f.allows(f.default_value)) << f.key;
    EXPECT_TRUE(f.allows(f.minimum) && f.allows(f.maximum)) << f.key;
    EXPECT_EQ(f.kind == FieldKind::choice, !f.choices.empty()) << f.key;
    if (f.kind == FieldKind::choice) {
      EXPECT_EQ(f.maximum, static_cast<float>(f.choices.size() - 1)) << f.key;
    }
  }
}

TEST(FlightPlan, TheUnitOfAFieldEndsItsName) {
  const std::pair<std::string_view, std::string_view> endings[] = {
      {"deg", "_deg"},   {"s", "_s"},         {"g", "_g"},         {"m", "_m"},         {"m/s", "_m_s"},
      {"Hz", "_hz"},     {"Hz/s", "_hz_s"},   {"deg/s", "_deg_s"}, {"us", "_us"},       {"us/deg", "_per_degree_us"},
      {"1/s", "_per_s"}, {"rad/s", "_rad_s"}, {"m2", "_m2"},       {"kg m2", "_kg_m2"}, {"kg/m3", "_kg_m3"}};
  for (const PlanField& f : flight_plan_fields()) {
    if (f.unit.empty() || f.key == "derivative_gain_s" || f.key == "pulse_centre_us") {
      continue;
    }
    const auto ending = std::ranges::find(endings, f.unit, [](const auto& pair) { return pair.first; });
    ASSERT_NE(ending, std::end(endings)) << f.key << " has the unknown unit " << f.unit;
    EXPECT_TRUE(f.key.ends_with(ending->second)) << f.key;
  }
}

TEST(FlightPlan, FieldsOfOneSectionStandTogether) {
  std::set<std::string_view> closed;
  std::string_view current;
  for (const PlanField& f : flight_plan_fields()) {
    if (f.section != current) {
      EXPECT_TRUE(closed.insert(f.section).second) << f.section;
      current = f.section;
    }
  }
}

TEST(FlightPlan, EveryFieldOwnsItsOwnMember) {
  for (const PlanField& one : flight_plan_fields()) {
    for (std::size_t slot = 0; slot < one.slots; ++slot) {
      FlightPlan plan = default_plan();
      const float other = one.default_value == one.maximum ? one.minimum : one.maximum;
      one.set(plan, slot, other);
      EXPECT_NEAR(one.get(plan, slot), other, std::abs(other) * 1e-6F + 1e-6F) << one.key;
      for (const PlanField& another : flight_plan_fields()) {
        for (std::size_t s = 0; s < another.slots; ++s) {
          if (&one != &another || s != slot) {
            ASSERT_EQ(another.get_bits(plan, s), another.get_bits(default_plan(), s)) << one.key << " " << another.key;
          }
        }
      }
    }
  }
}

TEST(FlightPlan, EveryFieldAcceptsItsEndsAndRefusesWhatLiesJustBeyond) {
  for (const PlanField& f : flight_plan_fields()) {
    for (std::size_t slot = 0; slot < f.slots; ++slot) {
      FlightPlan plan = default_plan();
      if (f.is_list()) {
        f.set_length(plan, f.slots);
      }
      for (const float end : {f.minimum, f.maximum}) {
        f.set(plan, slot, end);
        EXPECT_FALSE(out_of_range(plan, f, slot)) << f.key << " = " << end;
        EXPECT_FALSE(f.kind == FieldKind::number &&
                     f.allows(std::nextafter(end, end == f.minimum ? -infinity : infinity)));
      }
      if (f.kind != FieldKind::number) {
        continue;
      }
      const float beyond = (f.maximum - f.minimum) * 1e-3F;
      f.set(plan, slot, f.maximum + beyond);
      EXPECT_TRUE(out_of_range(plan, f, slot)) << f.key << " above";
      f.set(plan, slot, f.minimum - beyond);
      EXPECT_TRUE(out_of_range(plan, f, slot)) << f.key << " below";
    }
  }
}

TEST(FlightPlan, ANumberThatIsNotFiniteIsRefusedInEveryField) {
  for (const PlanField& f : flight_plan_fields()) {
    for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
      EXPECT_FALSE(f.allows(bad)) << f.key;
      if (f.kind != FieldKind::number || f.is_time()) {
        continue;
      }
      for (std::size_t slot = 0; slot < f.slots; ++slot) {
        FlightPlan plan = default_plan();
        if (f.is_list()) {
          f.set_length(plan, f.slots);
        }
        f.set(plan, slot, bad);
        EXPECT_TRUE(out_of_range(plan, f, slot)) << f.key << " = " << bad;
      }
    }
  }
}

TEST(FlightPlan, AFractionIsNoChoiceNoFlagAndNoInteger) {
  for (const PlanField& f : flight_plan_fields()) {
    EXPECT_EQ(f.allows(0.5F), f.kind == FieldKind::number && f.minimum <= 0.5F && f.maximum >= 0.5F) << f.key;
  }
}

TEST(FlightPlan, HoldLongerThanTheWindowIsRefusedWhereTheWindowCounts) {
  FlightPlan plan = default_plan();
  plan.launch_detection.hold = Microseconds{500'000};
  EXPECT_FALSE(validate(plan).has_value());
  plan.launch_detection.hold = Microseconds{500'001};
  expect_fault(plan, "launch_detection", "hold_s");
  plan.motion.height_origin = HeightOrigin::velocity_only;  // the speed of the hold comes out of the same window
  expect_fault(plan, "launch_detection", "hold_s");
  plan.motion.height_origin = HeightOrigin::from_detection;
  EXPECT_FALSE(validate(plan).has_value());
}

TEST(FlightPlan, AnExcitationMustEndAfterItBegins) {
  FlightPlan plan = default_plan();
  plan.excitation.end = plan.excitation.begin;
  EXPECT_FALSE(validate(plan).has_value()) << "an excitation that is off has no window";
  for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
    plan.excitation.form = form;
    expect_fault(plan, "excitation", "end_s");
  }
  plan.excitation.end += Microseconds{1};
  EXPECT_FALSE(validate(plan).has_value());
}

TEST(FlightPlan, TrimMustLieInsideThePlanLimit) {
  FlightPlan plan = default_plan();
  plan.controller.canard_limit = 3_deg;
  plan.canards.each[2].trim = 2.9_deg;
  EXPECT_FALSE(validate(plan).has_value());
  plan.canards.each[2].trim = -3_deg;
  expect_fault(plan, "canards", "trim_deg", 2);
}

TEST(FlightPlan, TheMechanicalStopMustNotLieInsideThePlanLimit) {
  FlightPlan plan = default_plan();
  plan.canards.each[3].mechanical_stop = plan.controller.canard_limit;
  EXPECT_FALSE(validate(plan).has_value());
  plan.canards.each[3].mechanical_stop = 8.9_deg;
  expect_fault(plan, "canards", "mechanical_stop_deg", 3);
}

TEST(FlightPlan, EveryAngleInsideThePlanLimitHasAPulseThatAServoUnderstands) {
  FlightPlan plan = default_plan();
  plan.controller.canard_limit = 20_deg;
  plan.canards.each[2].pulse_centre_us = 1290.0F;  // with 39 us a degree from 510 to 2070 us
  plan.canards.each[2].pulse_per_radian_us = 39.0F * 180.0F / pi;
  EXPECT_FALSE(validate(plan).has_value());
  plan.canards.each[2].pulse_centre_us = 1270.0F;  // from 490 us
  expect_fault(plan, "canards", "pulse_centre_us", 2);
  plan.canards.each[2].pulse_per_radian_us *= -1.0F;  // the same pulses the other way round
  expect_fault(plan, "canards", "pulse_centre_us", 2);
  plan.canards.each[2].pulse_centre_us = 1730.0F;  // to 2510 us
  expect_fault(plan, "canards", "pulse_centre_us", 2);
}

TEST(FlightPlan, StepsNeedAsManyTimesAsAnglesAndIncreasingTimes) {
  FlightPlan plan = default_plan();
  plan.reference.kind = ReferenceKind::steps;
  expect_fault(plan, "reference", "step_times_s");
  plan.reference.step_times_count = 2;
  plan.reference.step_times = {Microseconds{1000}, Microseconds{1000}};
  expect_fault(plan, "reference", "step_times_s");
  plan.reference.step_angles_count = 2;
  expect_fault(plan, "reference", "step_times_s", 1);
  plan.reference.step_times[1] = Microseconds{1001};
  EXPECT_FALSE(validate(plan).has_value());
}

TEST(FlightPlan, AGainScheduleNeedsAsManyFactorsAsSpeedsAndIncreasingSpeeds) {
  FlightPlan plan = default_plan();
  plan.gain_schedule.speeds_count = 2;
  plan.gain_schedule.speeds_m_s = {30.0F, 30.0F};
  expect_fault(plan, "gain_schedule", "speeds_m_s");
  plan.gain_schedule.factors_count = 2;
  expect_fault(plan, "gain_schedule", "speeds_m_s", 1);
  plan.gain_schedule.speeds_m_s[1] = 30.5F;
  EXPECT_FALSE(validate(plan).has_value());
}

FlightPlan observing_plan() {
  FlightPlan plan = default_plan();
  plan.offset.rejection = OffsetRejection::observer;
  plan.roll_model = known_roll_model;
  return plan;
}

TEST(FlightPlan, WhatGoesByTheSpeedNeedsAFlightThatKnowsIt) {
  FlightPlan scheduled = default_plan();
  scheduled.gain_schedule.speeds_count = scheduled.gain_schedule.factors_count = 1;
  FlightPlan observing = observing_plan();
  EXPECT_FALSE(validate(scheduled).has_value());
  EXPECT_FALSE(validate(observing).has_value());
  for (const bool tunnel : {true, false}) {
    for (FlightPlan* plan : {&scheduled, &observing}) {
      plan->run.start = tunnel ? Start::tunnel : Start::launch;
      plan->motion.height_origin = tunnel ? HeightOrigin::replay : HeightOrigin::from_detection;
    }
    expect_fault(scheduled, "gain_schedule", "speeds_m_s");
    expect_fault(observing, "offset", "rejection");
  }
}

TEST(FlightPlan, AnObserverNeedsEveryNumberOfItsModel) {
  for (float RollModelPlan::* const value : {&RollModelPlan::roll_inertia_kg_m2, &RollModelPlan::reference_area_m2,
                                             &RollModelPlan::damping_m2, &RollModelPlan::torque_m}) {
    FlightPlan plan = observing_plan();
    plan.roll_model.*value = 0.0F;
    const auto fault = validate(plan);
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->rule, PlanRule::observer_has_model);
    EXPECT_EQ(fault->slot, 0U);
    EXPECT_EQ(flight_plan_fields()[fault->field].get(plan, 0), 0.0F) << "the one that is missing is named";
  }
}

TEST(FlightPlan, AnIntegralStandsBesideAProportionalGain) {
  FlightPlan plan = default_plan();
  plan.offset.rejection = OffsetRejection::integral;
  EXPECT_FALSE(validate(plan).has_value());
  plan.controller.proportional_gain = 0.0F;
  expect_fault(plan, "offset", "rejection");
}

TEST(FlightPlan, AListLongerThanItsRoomIsRefused) {
  FlightPlan plan = default_plan();
  plan.reference.step_angles_count = most_reference_steps + 1;
  expect_fault(plan, "reference", "step_angles_deg");
}

TEST(FlightPlan, EveryRuleHasASentenceOfItsOwn) {
  std::set<std::string_view> sentences;
  for (int rule = 0; rule <= static_cast<int>(PlanRule::capture_model_is_whole); ++rule) {
    const std::string_view text = sentence(static_cast<PlanRule>(rule));
    EXPECT_TRUE(text != "" && text != "unknown rule") << rule;
    EXPECT_TRUE(sentences.insert(text).second) << text;
  }
  EXPECT_EQ(sentence(static_cast<PlanRule>(static_cast<int>(PlanRule::capture_model_is_whole) + 1)), "unknown rule");
}

RC_GTEST_PROP(FlightPlan, TheGeneratorOfTheseTestsMakesPlansThatFly, ()) { RC_ASSERT(!validate(arbitrary_plan())); }

}  // namespace
}  // namespace fantail::core
