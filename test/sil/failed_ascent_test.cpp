// SPDX-License-Identifier: MIT
// Rockets that sink, turn over or come down before their motor has burnt out, in flights of the whole avionics.

#include "campaign/flown_run.hpp"
#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/results.hpp"
#include "report/verdict.hpp"
#include "sim/rigid_flight.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::sil {
namespace {

using report::Outcome;

sim::Scenario second_launch(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

struct JudgedAscent {
  explicit JudgedAscent(const sim::Scenario& scenario)
      : flight{fly::fly_scenario(scenario)},
        figures{report::figures(flight)},
        verdict{report::verdict(flight, figures)} {}
  [[nodiscard]] bool says(const std::string& word) const { return fantail::says(verdict.text, word); }
  [[nodiscard]] bool tells(const std::vector<double>& times_s) const {
    std::vector<std::string> numbers;
    std::ranges::transform(times_s, std::back_inserter(numbers), [](double s) { return text::fixed(s, 2); });
    return fantail::tells(verdict.text, numbers);
  }
  [[nodiscard]] const flight::BeforeBurnout& before() const { return flight.before_burnout.value(); }

  flight::Flight flight;
  report::Figures figures;
  report::Verdict verdict;
};

/// A storm and a short guide: the rocket turns into the wind until it points down, with half its motor left.
std::vector<std::string> in_a_storm() {
  return {"flight.motion=six_dof", "wind.speed_m_s=20", "launch_guide.length_m=1"};
}

TEST(FailedAscent, ARocketThatTurnsOverWhileItsMotorBurnsIsNotAtApogee) {
  const JudgedAscent judged{second_launch(in_a_storm())};
  const flight::Events& e = judged.flight.events;
  EXPECT_EQ(judged.verdict.outcome, Outcome::ascent_failed) << judged.verdict.text;
  EXPECT_EQ(fantail::figures(judged.verdict.text).at(0), text::fixed(judged.before().turned_over_s.value(), 2));
  EXPECT_EQ(fantail::figures(judged.verdict.text).at(1),
            text::fixed(text::degrees(judged.before().largest_tilt_rad), 0));
  EXPECT_TRUE(judged.tells({3.19})) << "of burn-out; " << judged.verdict.text;
  // The truth of it: the axis below the horizon, and rows up to burn-out.
  ASSERT_TRUE(e.apogee_s && e.burnout_s);
  EXPECT_LT(*e.apogee_s, *e.burnout_s);
  EXPECT_GT(judged.flight.rows.back().time_s, *e.burnout_s);
  const auto over = std::ranges::find_if(
      judged.flight.path, [](const flight::PathPoint& point) { return point.tilt_rad > text::radians(90.0); });
  ASSERT_NE(over, judged.flight.path.end());
  EXPECT_NEAR(judged.before().turned_over_s.value(), over->time_s, 0.011);
  EXPECT_TRUE(judged.verdict.ended_early) << judged.verdict.text;
}

/// Whether the same rocket flies tail first while it still climbs by more than gravity takes in half a second, by the
/// equations of motion alone: without roll, avionics and report. Still air; it leaves its guide with a pitch rate.
bool flies_tail_first(const sim::Scenario& scenario) {
  const sim::Vehicle& vehicle = scenario.vehicle;
  sim::RigidFlight rocket{{.mass_kg = vehicle.mass_kg,
                           .drag_area_m2 = vehicle.drag_area_m2,
                           .roll_inertia_kg_m2 = vehicle.roll_plant.inertia_kg_m2,
                           .airframe = vehicle.airframe.value(),
                           .guide = scenario.guide,
                           .guide_length_m = static_cast<double>(scenario.plan.guide.length_m),
                           .atmosphere = scenario.atmosphere,
                           .motor = vehicle.motor}};
  for (int tick = 1; rocket.state().velocity_m_s.z >= 0.0; ++tick) {
    rocket.advance_to(1e-3 * tick, 0.0, {});
    if (rocket.is_clear_of_guide() && rocket.air_speed_m_s().x < 0.0) {
      return rocket.state().velocity_m_s.z > 4.9;
    }
  }
  return false;
}

// A rocket with its centre of pressure in front tumbles in the coast where it did not do so under thrust. A margin of
// little below zero only bends its path.
TEST(FailedAscent, AnUnstableRocketThatFliesTailFirstBeforeApogeeHasNoAscent) {
  std::size_t tumbled = 0;
  std::size_t went_well = 0;
  for (const double pressure_m : {0.80, 0.84, 0.86, 0.87, 0.885, 0.895, 0.95, 1.02}) {
    sim::Scenario scenario =
        second_launch({"flight.motion=six_dof", "airframe.centre_of_pressure_m=" + std::to_string(pressure_m)});
    scenario.guide.tip_off_rad_s = text::radians(2.0);
    const bool is_tail_first = flies_tail_first(scenario);
    const JudgedAscent judged{scenario};
    EXPECT_EQ(judged.verdict.outcome == Outcome::ascent_failed, is_tail_first)
        << pressure_m << " m: " << judged.verdict.text;
    EXPECT_EQ(judged.says("tail first"), is_tail_first && !judged.flight.before_burnout) << judged.verdict.text;
    tumbled += is_tail_first && !judged.flight.before_burnout ? 1 : 0;
    went_well += is_tail_first ? 0 : 1;
    const campaign::JudgedFlight on_the_way = campaign::fly_and_judge(scenario);
    EXPECT_EQ(on_the_way.verdict.text, judged.verdict.text);
  }
  EXPECT_GE(tumbled, 2U);
  EXPECT_GE(went_well, 2U);
}

TEST(FailedAscent, AParachuteThatOpensUnderThrustIsNamed) {
  std::vector<std::string> changes = in_a_storm();
  changes.emplace_back("recovery.drag_area_m2=0.5");
  const JudgedAscent judged{second_launch(changes)};
  const flight::Events& e = judged.flight.events;
  ASSERT_TRUE(e.parachute_s);
  EXPECT_LT(*e.parachute_s, *e.burnout_s);
  EXPECT_TRUE(judged.says("parachute") && judged.tells({*e.parachute_s, 3.19})) << judged.verdict.text;
}

TEST(FailedAscent, AShippedFlightAndOneInWindHaveNone) {
  EXPECT_FALSE(JudgedAscent{second_launch({})}.flight.before_burnout);
  EXPECT_FALSE(JudgedAscent{second_launch({"flight.motion=six_dof", "wind.speed_m_s=6"})}.flight.before_burnout);
}

// In the thin tail of a thrust curve a rocket may well be at apogee.
TEST(FailedAscent, ATailOfAHundredthOfTheImpulseIsNone) {
  sim::Scenario scenario = second_launch({"flight.motion=six_dof", "wind.speed_m_s=3"});
  std::vector<sim::ThrustPoint> points = scenario.vehicle.motor.points();
  points.back().thrust_n = 0.3;  // until 16 s: 4 N s of 465
  points.push_back({16.0, 0.3});
  points.push_back({16.01, 0.0});
  scenario.vehicle.motor = sim::ThrustCurve{points, scenario.vehicle.motor.propellant_kg()};
  const JudgedAscent judged{scenario};
  EXPECT_LT(*judged.flight.events.apogee_s, *judged.flight.events.burnout_s);
  EXPECT_FALSE(judged.flight.before_burnout) << judged.verdict.text;
}

/// Along a straight line: a push of a second, nothing for so long, and a longer push.
sim::Scenario with_pause(double pause_s) {
  sim::Scenario scenario = second_launch({});
  const double again_s = 1.0 + pause_s;
  scenario.vehicle.motor = sim::ThrustCurve{{{0.0, 0.0},
                                             {0.02, 160.0},
                                             {1.0, 160.0},
                                             {1.02, 0.0},
                                             {again_s, 0.0},
                                             {again_s + 0.02, 170.0},
                                             {again_s + 3.0, 170.0},
                                             {again_s + 3.02, 0.0}},
                                            0.3};
  return scenario;
}

TEST(FailedAscent, AMotorThatPausesHasOneApogeeHoweverLongOneLooks) {
  sim::Scenario scenario = with_pause(4.5);
  std::vector<std::string> said;
  for (const double looked_s : {0.0, 1.0, 30.0}) {
    scenario.time_after_end_s = looked_s;
    const JudgedAscent judged{scenario};
    EXPECT_GT(judged.figures.apogee_m.value(), 200.0);
    EXPECT_TRUE(judged.before().rose_again);
    EXPECT_EQ(fantail::figures(judged.verdict.text).at(0), text::fixed(judged.before().sank_m, 1));
    EXPECT_TRUE(judged.tells({judged.before().sank_s.value(), *judged.flight.events.burnout_s}));
    EXPECT_TRUE(judged.says("line")) << "on which no real rocket stays; " << judged.verdict.text;
    EXPECT_EQ(judged.verdict.outcome, Outcome::ascent_failed);
    EXPECT_EQ(judged.flight.phase_changes.back().reason, core::PhaseReason::apogee);
    EXPECT_TRUE(judged.verdict.ended_early && judged.says("apogee")) << judged.verdict.text;
    said.push_back(judged.verdict.text);
  }
  EXPECT_EQ(said[0], said[1]);
  EXPECT_EQ(said[0], said[2]);
}

TEST(FailedAscent, ARocketThatFallsToTheGroundBetweenTwoBurnsStaysThere) {
  const JudgedAscent judged{with_pause(12.0)};
  EXPECT_EQ(judged.verdict.outcome, Outcome::ascent_failed);
  EXPECT_FALSE(judged.before().left_again_s);
  EXPECT_TRUE(judged.tells({judged.before().ground_s.value(), *judged.flight.events.burnout_s})) << judged.verdict.text;
  EXPECT_LT(*judged.flight.events.apogee_s, 6.0);
  EXPECT_EQ(judged.flight.rows.back().truth->height_m, 0.0);
  EXPECT_GT(judged.flight.rows.back().time_s, *judged.flight.events.burnout_s);
}

TEST(FailedAscent, AHopOnThePadIsToldAndFailsNothing) {
  sim::Scenario scenario = second_launch({});
  scenario.vehicle.motor = sim::ThrustCurve{
      {{0.0, 0.0}, {0.02, 150.0}, {0.05, 10.0}, {0.6, 10.0}, {0.7, 160.0}, {3.5, 160.0}, {3.6, 0.0}}, 0.2};
  const JudgedAscent judged{scenario};
  EXPECT_NE(judged.verdict.outcome, Outcome::ascent_failed);
  EXPECT_TRUE(judged.tells({judged.before().ground_s.value(), judged.before().left_again_s.value()}));
  EXPECT_TRUE(judged.says("pad")) << judged.verdict.text;
}

TEST(FailedAscent, JudgedOnTheWayIsTheSame) {
  for (const sim::Scenario& scenario : {second_launch(in_a_storm()), with_pause(4.5), with_pause(12.0)}) {
    const JudgedAscent kept{scenario};
    const campaign::JudgedFlight judged = campaign::fly_and_judge(scenario);
    EXPECT_EQ(judged.verdict.text, kept.verdict.text);
    EXPECT_EQ(judged.verdict.outcome, kept.verdict.outcome);
    EXPECT_EQ(judged.figures.camera_roll, kept.figures.camera_roll);
  }
}

}  // namespace
}  // namespace fantail::sil
