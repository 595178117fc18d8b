// SPDX-License-Identifier: MIT
// A verdict says both: how steadily, and how far from what was asked. And nothing is green that was hardly seen, or
// that the model does not hold for.

#include "json/value.hpp"
#include "page/page.hpp"
#include "report/answer.hpp"
#include "report/hold.hpp"
#include "report/results.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

/// A law with so little gain that an offset of 5 degrees makes it rest 70.7 from R = 0.
SyntheticFlight far_away() {
  SyntheticFlight synthetic;
  synthetic.flight.plan.controller.proportional_gain = static_cast<float>(5.0 / 70.7);
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad = text::radians(-70.7); });
  return synthetic;
}

page::Tone tone_of(const Verdict& verdict) {
  return result::tone(summary(SyntheticFlight{}.flight, {}, verdict).verdict);
}

json::Value summary_json_of(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return json::parse(result::json(summary(flight, f, verdict(flight, f))));
}

TEST(Rest, OfALoopThatCannotSettleItIsNotSaidWhere) {
  SyntheticFlight synthetic;
  const auto says_where = [&synthetic] {
    const Figures f = figures(synthetic.flight);
    const std::vector<std::string> beside = beside_the_verdict(synthetic.flight, f, verdict(synthetic.flight, f));
    return std::ranges::any_of(beside, [](const std::string& one) { return one.starts_with("It settles at"); });
  };
  EXPECT_TRUE(says_where());
  synthetic.flight.loop_margins = {{.speed_m_s = 20.0, .phase_margin_rad = 0.5},
                                   {.speed_m_s = 60.0, .phase_margin_rad = -0.1}};
  EXPECT_FALSE(says_where()) << "unstable at one speed";
  synthetic.flight.loop_margins.clear();
  EXPECT_TRUE(says_where());
  synthetic.flight.plan.controller.canard_limit = core::Angle::from_degrees(3.0F);
  EXPECT_FALSE(says_where()) << "the canards do not reach the fin offset of 5 deg";
  EXPECT_NE(settle_point_text(synthetic.flight, false), settle_point_text(synthetic.flight, true));
  EXPECT_EQ(settle_point_text(synthetic.flight, false).find("-10 deg"), std::string::npos);
  EXPECT_NE(settle_point_text(synthetic.flight, true).find("-10 deg"), std::string::npos);
}

TEST(Rest, ARollThatRestsFarFromItsCommandIsSteadyAndNotHeld) {
  const SyntheticFlight synthetic = far_away();
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::off_command);
  EXPECT_EQ(tone_of(v), page::Tone::unsure);
  EXPECT_EQ(numbers(v), (Numbers{"70.7", "10", "0.0", "0.0", "4.0"})) << v.text;
  const json::Value summary = summary_json_of(synthetic.flight);
  EXPECT_EQ(summary["outcome"], "off_command");
  EXPECT_NEAR(summary["rest_error_deg"].number(), 70.7, 1e-3);
  EXPECT_NEAR(summary["mean_reference_error_deg"].number(), 70.7, 1e-3);
  EXPECT_NEAR(summary["rest_limit_deg"].number(), 10.0, 1e-9);
}

TEST(Rest, ARocketThatRollsFreelyHasNoFiguresOfControl) {
  SyntheticFlight synthetic;
  const auto shows = [&synthetic](const char* figure) {
    const Figures f = figures(synthetic.flight);
    return result::text(summary(synthetic.flight, f, verdict(synthetic.flight, f))).find(figure) != std::string::npos;
  };
  const std::array of_control{"time under control", "net roll under control", "mean distance from the command",
                              "canards at their limit"};
  for (const char* figure : of_control) {
    EXPECT_TRUE(shows(figure)) << figure;
  }
  synthetic.flight.plan.controller.proportional_gain = 0.0F;
  synthetic.flight.plan.controller.derivative_gain_s = 0.0F;
  for (const char* figure : of_control) {
    EXPECT_FALSE(shows(figure)) << figure;
  }
}

TEST(Rest, WhoeverAsksForLessGetsIt) {
  SyntheticFlight synthetic = far_away();
  synthetic.flight.rest_limit_rad = text::radians(71.0);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(tone_of(v), page::Tone::good);
  EXPECT_EQ(numbers(v), (Numbers{"70.7", "0.0", "0.0", "4.0"})) << v.text;
}

// Ten seconds at 0 and one at 40 are 3.6 in the mean.
TEST(Rest, OneThatMovesAwayCountsWhereItIsFarthest) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->disturbance_rad = text::radians(row.time_s < 4.0 ? 0.0 : -20.0);
    row.truth->roll_angle_rad = text::radians(row.time_s < 4.0 ? 0.0 : -40.0);
  });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::off_command) << verdict_of(synthetic.flight).text;
  EXPECT_NEAR(text::degrees(*figures(synthetic.flight).rest_error_rad), 40.0, 1e-6);
}

TEST(Rest, WithoutTruthItIsMeasuredAndNotJudged) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth.reset(); });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_judged);
  EXPECT_NEAR(text::degrees(*figures(synthetic.flight).rest_error_rad), 10.0, 1e-6);
}

// Control from 0.6 s to 1.609 s is settled for 9 ms.
TEST(Rest, ARollThatWasSettledForNineMillisecondsIsNotJudged) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s = 4.4;
  synthetic.end_control(1.6095, core::PhaseReason::control_time_over);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_NE(v.outcome, Outcome::held);
  EXPECT_FALSE(v.roll_is_judged);
  EXPECT_EQ(numbers(v), (Numbers{"1.61", "2.79", "30", "0.0", "0.01", "1.01", "1", "0.0"})) << v.text;
  EXPECT_NEAR(summary_json_of(synthetic.flight)["judged_time_s"].number(), 0.009, 1e-6);
}

TEST(Rest, ATimeThatIsLittleBesideThatUnderControlIsSaid) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) {
    row.reference_rad = row.time_s < 2.0 ? 1e-3 : row.time_s < 2.5 ? 2e-3 : 0.0;
  });
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)), (Numbers{"10.1", "10", "0.1", "1.4", "3.9", "0.0", "4.0"}));
  EXPECT_EQ(numbers(verdict_of(SyntheticFlight{}.flight)), (Numbers{"10.0", "0.0", "0.0", "4.0"}));
}

TEST(Rest, FasterThanTheModelHoldsForIsAmberAndInTheHeadline) {
  SyntheticFlight synthetic;
  synthetic.flight.extremes.top_mach = 1.27;
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::outside_model);
  EXPECT_EQ(tone_of(v), page::Tone::unsure);
  EXPECT_EQ(numbers(v), (Numbers{"1.27", "0.8", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "Mach 1.27")) << v.text;
  EXPECT_EQ(summary_json_of(synthetic.flight)["top_mach"], 1.27);
  synthetic.flight.extremes.top_mach = 0.8;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held);
  // What is red for another reason stays so, and says it all the same.
  synthetic.flight.extremes.top_mach = 0.81;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)), (Numbers{"0.81", "0.8", "24.0", "34.0", "0.0", "4.0"}));
}

TEST(Rest, ARocketThatIsNotStableIsAmberAndInTheHeadline) {
  SyntheticFlight synthetic;
  synthetic.flight.extremes.static_margin_calibres = -5.0;
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::outside_model);
  EXPECT_EQ(tone_of(v), page::Tone::unsure);
  EXPECT_EQ(numbers(v), (Numbers{"-5.00", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "calibres")) << v.text;
  EXPECT_EQ(summary_json_of(synthetic.flight)["static_margin_calibres"], -5.0);
  synthetic.flight.extremes.static_margin_calibres = -0.001;
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)).at(0), "-0.001");
  synthetic.flight.extremes.static_margin_calibres = 0.0;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::outside_model);
  synthetic.flight.extremes.static_margin_calibres = 0.01;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held);
  // Red for another reason, it says so all the same.
  synthetic.flight.extremes.static_margin_calibres = -5.0;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad += text::radians(-24.0); });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_held);
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)), (Numbers{"-5.00", "24.0", "34.0", "0.0", "4.0"}));
}

TEST(Rest, AirThatMeetsTheRocketBeyondItsStallUnderControlIsAmberAndInTheHeadline) {
  SyntheticFlight synthetic;
  synthetic.flight.extremes.angle_of_attack_rad = text::radians(20.3);
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::outside_model);
  EXPECT_EQ(numbers(v), (Numbers{"20.3", "15", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "angle of attack")) << v.text;
  EXPECT_EQ(summary_json_of(synthetic.flight)["angle_of_attack_deg"], 20.3);
  synthetic.flight.extremes.angle_of_attack_rad = text::radians(14.9);
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::held);
  synthetic.flight.extremes = {
      .top_mach = 1.27, .static_margin_calibres = -5.0, .angle_of_attack_rad = text::radians(20.0)};
  EXPECT_EQ(numbers(verdict_of(synthetic.flight)),
            (Numbers{"1.27", "0.8", "-5.00", "20.0", "15", "10.0", "0.0", "0.0", "4.0"}));
}

TEST(Rest, EveryOutcomeHasAWordForFilesAndOneForReaders) {
  for (const Outcome outcome : outcomes) {
    EXPECT_NE(name(outcome), "unknown");
    EXPECT_NE(display_name(outcome), "Unknown");
  }
}

}  // namespace
}  // namespace fantail::report
