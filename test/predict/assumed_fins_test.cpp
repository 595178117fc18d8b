// SPDX-License-Identifier: MIT
#include "predict/assumed_fins.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "campaign/flown_run.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "look_away.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::radians;

sim::Scenario held_launch(const std::vector<std::string>& changes = {}) {
  std::vector<std::string> all{"reference.kind=hold"};
  all.insert(all.end(), changes.begin(), changes.end());
  return input::load_scenario("tasha3_launch2", input::parse_overrides(all));
}

AssumedFins with_margin(double asked_phase_margin_rad) {
  return assume_fins(held_launch(), {}, asked_phase_margin_rad, look_away);
}

/// By the scenario's own keys, as anybody would type them.
bool is_held_alone(const AssumedAirframe& airframe, double offset_rad) {
  const auto judged =
      campaign::fly_and_judge(held_launch({fmt::format("aerodynamics.damping_m2={:.17g}", airframe.damping_m2),
                                           fmt::format("aerodynamics.torque_m={:.17g}", airframe.torque_m),
                                           fmt::format("disturbance.angles_deg=[{:.17g}]", degrees(offset_rad))}));
  return judged.verdict.outcome == report::Outcome::held;
}

TEST(AssumedFins, HoldAndFailWhereFlightsOfTheSameValuesDo) {
  const AssumedFins all = with_margin(0.0);
  ASSERT_EQ(all.airframes.size(), 5U);
  ASSERT_EQ(all.runs.size(), assumed_flights());
  EXPECT_NEAR(all.largest_offset_rad, radians(9.0), 1e-6) << "the plan's canard limit";
  EXPECT_EQ(all.airframes.front().damping_m2, held_launch().vehicle.roll_plant.damping_m2);
  int failures = 0;
  for (const AssumedAirframe& airframe : all.airframes) {
    if (airframe.held_to_rad) {
      EXPECT_TRUE(is_held_alone(airframe, *airframe.held_to_rad)) << airframe.damping_factor << airframe.torque_factor;
      EXPECT_TRUE(is_held_alone(airframe, -*airframe.held_to_rad)) << airframe.damping_factor << airframe.torque_factor;
    }
    if (airframe.fails_at_rad) {
      ++failures;
      EXPECT_FALSE(is_held_alone(airframe, *airframe.fails_at_rad) && is_held_alone(airframe, -*airframe.fails_at_rad))
          << airframe.why;
    }
  }
  EXPECT_GT(failures, 0);
  const result::Document said = answer(all, {});
  EXPECT_EQ(said.verdict.answer, result::Answer::undecided);
  EXPECT_EQ(said.verdict.heading, "Depends on the fins") << said.verdict.sentence;
}

TEST(AssumedFins, CouldBeAGoWhereOnlySomeDampingAndTorqueLeaveThePhaseMargin) {
  std::vector<double> margins_rad;
  for (const AssumedAirframe& airframe : with_margin(0.0).airframes) {
    margins_rad.push_back(airframe.phase_margin_rad.value());
  }
  std::ranges::sort(margins_rad);
  const AssumedFins all = with_margin(0.5 * (margins_rad[1] + margins_rad[2]));
  const auto straight = std::ranges::count_if(all.airframes, [](const auto& a) { return a.held_to_rad.has_value(); });
  EXPECT_EQ(straight, 3);
  const result::Document said = answer(all, {});
  EXPECT_EQ(said.verdict.answer, result::Answer::undecided);
  EXPECT_EQ(said.verdict.heading, "Could be a go");
  EXPECT_NE(said.verdict.sentence.find("the least phase margin is"), std::string::npos) << said.verdict.sentence;
}

TEST(AssumedFins, AreNoGoWhereNoFinsAreHeld) {
  const AssumedFins all = with_margin(radians(90.0));
  const result::Document said = answer(all, {});
  EXPECT_EQ(said.verdict.answer, result::Answer::no);
  EXPECT_EQ(said.verdict.heading, "No go") << said.verdict.sentence;
  EXPECT_NE(said.verdict.sentence.find("from -9.00 to 9.00 degrees meets the requirements"), std::string::npos)
      << said.verdict.sentence;
}

TEST(AssumedFins, AreNotJudgedOutsideTheModel) {
  const AssumedFins all = assume_fins(held_launch({"flight.motion=six_dof", "wind.speed_m_s=14",
                                                   "wind.speed_spread_m_s=3", "verdict.tilt_end_before_apogee_s=10"}),
                                      {}, 0.0, look_away);
  EXPECT_EQ(all.runs.front().wind.value().speed_m_s, 14.0) << "the stated one";
  const result::Document said = answer(all, {});
  EXPECT_EQ(said.verdict.answer, result::Answer::undecided);
  EXPECT_EQ(said.verdict.heading, "Outside the model") << said.verdict.sentence;
}

TEST(AssumedFins, AreNoGoWhereTheGuideLeansTooFarForAnyFins) {
  const AssumedFins all = assume_fins(held_launch({"launch_guide.tilt_deg=12"}), {}, 0.0, look_away);
  const result::Document said = answer(all, {});
  EXPECT_EQ(said.verdict.answer, result::Answer::no);
  EXPECT_NE(said.verdict.sentence.find("tilt limit"), std::string::npos) << said.verdict.sentence;
}

}  // namespace
}  // namespace fantail::predict
