// SPDX-License-Identifier: MIT
#include "report/figures.hpp"

#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

TEST(Figures, ARollAngleAtItsSettlePointHasNoHoldErrorThoughItIsTenDegreesFromTheReference) {
  const SyntheticFlight synthetic;
  const Figures f = figures(synthetic.flight);
  EXPECT_NEAR(text::degrees(f.largest_hold_error_rad.value()), 0.0, 1e-5);
  EXPECT_NEAR(text::degrees(f.mean_hold_error_rad.value()), 0.0, 1e-5);
}

TEST(Figures, ADecayingStepResponseIsJudgedFromOneSecondAfterControlStart) {
  SyntheticFlight synthetic;
  synthetic.each_controlled(
      [](flight::Row& row) { row.truth->roll_angle_rad += text::radians(10.0) * std::exp(-(row.time_s - 0.6) / 0.5); });
  EXPECT_NEAR(text::degrees(figures(synthetic.flight).largest_hold_error_rad.value()), 10.0 * std::exp(-2.0), 1e-4);
}

TEST(Figures, TheSecondAfterAReferenceStepDoesNotCount) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    if (row.time_s >= 2.6) {
      row.reference_rad = text::radians(-20.0);
      // Arrives 0.9 s late, then stays 1.5 deg short of its settle point of -30 deg.
      row.truth->roll_angle_rad = text::radians(row.time_s < 3.5 ? -10.0 : -28.5);
    }
  });
  EXPECT_NEAR(text::degrees(figures(synthetic.flight).largest_hold_error_rad.value()), 1.5, 1e-4);
}

TEST(Figures, InTheTunnelTwoSecondsDoNotCount) {
  SyntheticFlight synthetic;
  synthetic.flight.tunnel = true;
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->roll_angle_rad = text::radians(row.time_s < 0.6005 ? 0.0 : row.time_s < 2.59 ? 15.0 : -8.0);
    row.truth->speed_m_s = 22.0;
  });
  const Figures f = figures(synthetic.flight);
  EXPECT_NEAR(text::degrees(f.largest_hold_error_rad.value()), 2.0, 1e-4);
  EXPECT_FALSE(f.apogee_m);
  EXPECT_FALSE(f.control_start_height_m);
}

TEST(Figures, MeanHoldErrorIsTheMeanOfTheSettledPart) {
  SyntheticFlight synthetic;
  // Settled are 1.6 to 4.5 s, 2901 ticks; 1450 of them lie before 3.05 s.
  synthetic.each_controlled(
      [](flight::Row& row) { row.truth->roll_angle_rad += text::radians(row.time_s < 3.0495 ? 3.0 : 1.0); });
  EXPECT_NEAR(text::degrees(figures(synthetic.flight).mean_hold_error_rad.value()), (1450 * 3.0 + 1451 * 1.0) / 2901,
              1e-4);
}

TEST(Figures, SaturatedFractionCountsControlledTicksOnly) {
  SyntheticFlight synthetic;
  synthetic.flight.rows.front().saturated = true;
  int count = 0;
  synthetic.each_controlled([&count](flight::Row& row) { row.saturated = count++ < 390; });
  EXPECT_DOUBLE_EQ(figures(synthetic.flight).saturated_fraction.value(), 390.0 / 3901.0);
}

TEST(Figures, AuthorityMarginIsTheLimitLessTheLargestOffsetUnderControl) {
  SyntheticFlight synthetic;
  synthetic.flight.rows.front().truth->disturbance_rad = text::radians(-15.0);  // on the pad it does not matter
  synthetic.flight.rows[3000].truth->disturbance_rad = text::radians(-7.25);
  const Figures f = figures(synthetic.flight);
  EXPECT_NEAR(text::degrees(f.authority_margin_rad.value()), 1.75, 1e-5);
  EXPECT_NEAR(text::degrees(f.largest_disturbance_rad.value()), -7.25, 1e-9);
}

TEST(Figures, NoPlanHasMoreAuthorityThanTheHardLimit) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.controller.canard_limit = core::Angle::from_degrees(30.0F);
  EXPECT_NEAR(text::degrees(figures(synthetic.flight).authority_margin_rad.value()), 15.0, 1e-5);
}

TEST(Figures, TheSmallestStopOfPlanAndWorldIsTheAuthority) {
  SyntheticFlight plan_stop;
  plan_stop.flight.plan.canards.each.fill({.direction = core::Direction::reversed,
                                           .trim = core::Angle::from_degrees(0.0F),
                                           .pulse_centre_us = 1500.0F,
                                           .pulse_per_radian_us = 570.0F,
                                           .encoder_zero = {},
                                           .mechanical_stop = core::Angle::from_degrees(7.0F)});
  EXPECT_NEAR(text::degrees(figures(plan_stop.flight).authority_margin_rad.value()), 2.0, 1e-5);
  // What the simulation knows of its canards goes before what the plan says; the offset is negative.
  SyntheticFlight simulated;
  simulated.flight.canard_reach = {.lowest_rad = text::radians(-14.0), .highest_rad = text::radians(4.5)};
  EXPECT_NEAR(text::degrees(figures(simulated.flight).authority_margin_rad.value()), -0.5, 1e-5);
  // A trim of 2 degrees towards the side that is needed leaves 7 of 9 degrees; away from it no more than the command.
  SyntheticFlight trimmed;
  trimmed.flight.plan.canards.each[0].trim = core::Angle::from_degrees(2.0F);
  EXPECT_NEAR(text::degrees(figures(trimmed.flight).authority_margin_rad.value()), (7.0 + 3 * 9.0) / 4.0 - 5.0, 1e-5);
  trimmed.flight.plan.canards.each[0].trim = core::Angle::from_degrees(-2.0F);
  EXPECT_NEAR(text::degrees(figures(trimmed.flight).authority_margin_rad.value()), 4.0, 1e-5);
}

TEST(Figures, TheHoldErrorIsThatOfTheTrueRollAngleAndNotOfWhatTheAvionicsBelieves) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(30.0); });
  EXPECT_NEAR(text::degrees(figures(synthetic.flight).largest_hold_error_rad.value()), 30.0, 1e-4);
}

TEST(Figures, SaturationToTheEndIsSeenFromItsFirstTick) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.saturated = row.time_s >= 1.4795;
    row.command_rad = text::radians(9.0);
    row.truth->disturbance_rad = text::radians(row.time_s < 3.0 ? -9.5 : -9.2);
  });
  const Figures f = figures(synthetic.flight);
  EXPECT_NEAR(f.at_limit_since_s.value(), 1.48, 1e-9);
  EXPECT_TRUE(f.offset_beyond_limit);
  EXPECT_NEAR(text::degrees(f.offset_at_limit_rad.value()), -9.5, 1e-9);
}

// The plan's limit is a float, a little off the number.
TEST(Figures, AnOffsetThatIsAtTheLimitIsNotBeyondIt) {
  SyntheticFlight synthetic;
  for (const double more_rad : {0.0, 1e-8}) {
    const double limit_rad = flight::canard_limit_rad(synthetic.flight.plan) + more_rad;
    synthetic.each_controlled([&](flight::Row& row) {
      row.saturated = row.time_s >= 1.4795;
      row.command_rad = text::radians(9.0);
      row.truth->disturbance_rad = -limit_rad;
    });
    EXPECT_TRUE(figures(synthetic.flight).at_limit_since_s);
    EXPECT_FALSE(figures(synthetic.flight).offset_beyond_limit) << more_rad;
  }
}

TEST(Figures, AShortSaturationAtTheEndIsNotALastingOne) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.saturated = row.time_s > 4.1; });
  EXPECT_FALSE(figures(synthetic.flight).at_limit_since_s);
}

TEST(Figures, HeightsAndSpeedsAreTrueOnesWhereTruthExists) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.0;
  for (flight::Row& row : synthetic.flight.rows) {
    row.height_m = 1000.0;
    row.speed_m_s = 1000.0;
    row.truth->height_m = 100.0 * row.time_s;
    row.truth->speed_m_s = 50.0 - row.time_s;
  }
  Figures f = figures(synthetic.flight);
  EXPECT_NEAR(f.apogee_m.value(), 450.0, 1e-9);
  EXPECT_NEAR(f.max_speed_m_s.value(), 50.5, 1e-9);
  EXPECT_NEAR(f.control_start_height_m.value(), 60.0, 1e-9);
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth.reset();
  }
  // In wind the one above is through the air; a path knows the one over ground.
  synthetic.flight.path = {{.time_s = 1.0, .north_m_s = 2.0, .east_m_s = 3.0, .up_m_s = 6.0}, {.time_s = 2.0}};
  EXPECT_NEAR(figures(synthetic.flight).max_speed_m_s.value(), 7.0, 1e-9);
  synthetic.flight.path.clear();
  f = figures(synthetic.flight);
  EXPECT_EQ(f.apogee_m, 1000.0);
  EXPECT_EQ(f.max_speed_m_s, 1000.0);
  EXPECT_EQ(f.control_start_height_m, 1000.0);
  EXPECT_FALSE(f.authority_margin_rad);
  EXPECT_FALSE(f.largest_hold_error_rad);
}

TEST(Figures, AFlightThatEndsBeforeApogeeHasNone) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.apogee_s.reset();
  EXPECT_FALSE(figures(flight).apogee_m);
}

/// It is fastest at 2 s and highest at 4 s, without the rows of which `is_missing` says so.
Figures figures_without(const std::function<bool(double)>& is_missing) {
  SyntheticFlight synthetic;
  flight::Flight& flight = synthetic.flight;
  flight.events.apogee_s = 4.0;
  for (flight::Row& row : flight.rows) {
    row.truth->speed_m_s = 50.0 - 10.0 * std::abs(row.time_s - 2.0);
    row.truth->height_m = 400.0 - 5.0 * (row.time_s - 4.0) * (row.time_s - 4.0);
  }
  std::erase_if(flight.rows, [&](const flight::Row& row) { return is_missing(row.time_s); });
  return figures(flight);
}

TEST(Figures, TopSpeedAndApogeeAreThoseOfTheFlightAndNotTheLargestOfTheRowsThatAreLeft) {
  const auto between = [](double from_s, double to_s) {
    return figures_without([=](double time_s) { return time_s > from_s + 1e-9 && time_s < to_s - 1e-9; });
  };
  const Figures whole = between(9.0, 9.0);
  EXPECT_TRUE(whole.max_speed_m_s == 50.0 && whole.apogee_m == 400.0 && whole.roll.holes.empty());
  const Figures coasting = between(2.5, 3.5);
  EXPECT_TRUE(coasting.max_speed_m_s == 50.0 && coasting.apogee_m == 400.0);
  ASSERT_EQ(coasting.roll.holes.size(), 1U);
  EXPECT_NEAR(coasting.roll.holes[0].from_s, 2.5, 1e-9);
  EXPECT_NEAR(coasting.roll.holes[0].to_s, 3.5, 1e-9);
  const Figures boosting = between(0.5, 1.5);
  EXPECT_TRUE(boosting.max_speed_m_s == 50.0);
  EXPECT_FALSE(between(1.6, 2.3).max_speed_m_s);
  EXPECT_FALSE(between(3.7, 4.2).apogee_m);
  EXPECT_TRUE(between(3.7, 4.2).max_speed_m_s);
  EXPECT_FALSE(figures_without([](double time_s) { return time_s > 1.5; }).max_speed_m_s);
  EXPECT_FALSE(figures_without([](double time_s) { return time_s > 3.5; }).apogee_m);
  EXPECT_FALSE(figures_without([](double time_s) { return time_s < 2.5; }).max_speed_m_s);
  EXPECT_FALSE(
      figures_without([](double time_s) { return std::abs(time_s - std::round(time_s)) > 1e-6; }).max_speed_m_s);
}

TEST(Figures, OnThePadNoTopSpeedIsKnownOfAFlightThatWentOn) {
  SyntheticFlight synthetic;
  synthetic.flight.events.burnout_s = 3.0;
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s > 0.0; });
  EXPECT_FALSE(figures(synthetic.flight).max_speed_m_s);
  synthetic.flight.events.burnout_s.reset();
  EXPECT_EQ(figures(synthetic.flight).max_speed_m_s, 0.0);
}

TEST(Figures, ATableThatHasARowEveryFifthOfASecondHasNoHolesForThat) {
  const Figures thin = figures_without([](double time_s) {
    const double steps = time_s / 0.2;
    return std::abs(steps - std::round(steps)) > 1e-6;
  });
  EXPECT_TRUE(thin.roll.holes.empty() && thin.roll.is_thin());
  EXPECT_TRUE(thin.max_speed_m_s && thin.apogee_m);
}

TEST(Figures, NetRollIsCountedInTurnsUnderControl) {
  SyntheticFlight synthetic;
  synthetic.flight.rows.front().truth->roll_angle_rad = text::radians(3600.0);
  synthetic.each_controlled(
      [](flight::Row& row) { row.truth->roll_angle_rad = text::radians(-180.0 * (row.time_s - 0.6)); });
  EXPECT_NEAR(figures(synthetic.flight).roll_turns.value(), -1.95, 1e-9);
}

TEST(Figures, WithoutControlThereAreNoFiguresOfControl) {
  SyntheticFlight synthetic;
  synthetic.never_controlled(-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command);
  const Figures f = figures(synthetic.flight);
  EXPECT_FALSE(f.control_time_s || f.saturated_fraction || f.roll_turns || f.authority_margin_rad);
  EXPECT_EQ(f.final_phase, core::Phase::armed);
  EXPECT_FALSE(figures(flight::Flight{}).max_speed_m_s);
}

}  // namespace
}  // namespace fantail::report
