// SPDX-License-Identifier: MIT

#include "predict/roll_resonance.hpp"

#include "degree.hpp"
#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "predict/decision.hpp"
#include "stability/canard_sense.hpp"
#include "test.hpp"

namespace fantail::predict {
namespace {

// Slope 10 on a body of 80 mm, margin 0.12 m, inertia 0.6 kg m2, density 1.2 kg/m3: k = 0.077665 rad/m, as in the
// oracle of the tunnel's stability (1.165, 1.553 and 2.330 rad/s at 15, 20 and 30 m/s). After burn-out the same.
sim::Scenario scenario() {
  sim::Scenario scenario;
  scenario.atmosphere = {.model = sim::DensityModel::constant, .constant_kg_m3 = 1.2};
  const sim::Airframe::MassProperties mass{.centre_of_gravity_m = 0.90, .transverse_inertia_kg_m2 = 0.6};
  scenario.vehicle.airframe = sim::Airframe{.diameter_m = 0.08,
                                            .length_m = 1.51,
                                            .normal_force_slope_per_rad = 10.0,
                                            .centre_of_pressure_m = 1.02,
                                            .at_liftoff = mass,
                                            .after_burnout = mass};
  return scenario;
}

// alpha 8.5 m2, beta 10 m: u = k alpha / beta = 0.0660 rad = 3.78 degrees.
struct Run run(double offset_deg) {
  struct Run run;
  run.airframe = {.damping_m2 = 8.5, .torque_m = 10.0, .offset_end_rad = offset_deg * degree};
  return run;
}

TEST(RollResonance, IsWhereTheRollRateOfAFinAngleMeetsThePitchFrequencyAtAnySpeed) {
  const auto found = roll_resonance(scenario(), {run(0.0)}, 0.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->least_frequency_1_m, 0.077665, 1e-6);
  EXPECT_NEAR(found->resonant_rad.p50 / degree, 3.782, 0.001);
  for (const double speed_m_s : {15.0, 97.0}) {
    const double roll_rate_rad_s = speed_m_s * 10.0 * found->resonant_rad.p50 / 8.5;
    EXPECT_NEAR(roll_rate_rad_s, 0.077665 * speed_m_s, 1e-4 * speed_m_s);
  }
}

TEST(RollResonance, TellsRunsThatStayNearItFromThoseThatSpinThroughAndThoseThatOnlyTheCanardsBringThere) {
  // A quarter below and above 3.78 degrees are 2.84 and 4.73.
  const auto found = roll_resonance(scenario(), {run(-0.5), run(2.7), run(-2.9), run(4.6), run(-7.0)}, 2.0 * degree);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->near, 2U);
  EXPECT_EQ(found->past, 1U);
  EXPECT_EQ(found->with_canards, 4U);
  EXPECT_EQ(figures(warning(*found, 2.0 * degree)),
            (std::vector<std::string>{"3.8", "3.8", "3.8", "0.078", "0.078", "2", "5", "1", "5", "2.0", "4", "5"}));
}

TEST(RollResonance, IsNotKeptByAnOffsetThatIsOver) {
  struct Run falling = run(-1.0);
  falling.airframe.offset_begin_rad = falling.offset_rad = -12.0 * degree;
  const auto found = roll_resonance(scenario(), {falling}, 1.0 * degree);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->near + found->past + found->with_canards, 0U);
}

TEST(RollResonance, SaysNothingWhereNothingComesNear) {
  const auto found = roll_resonance(scenario(), {run(0.5)}, 2.0 * degree);
  ASSERT_TRUE(found);
  EXPECT_EQ(warning(*found, 2.0 * degree), "");
}

TEST(RollResonance, IsNotKnownWithoutAirframeOrOfARocketThatDoesNotSwingBack) {
  sim::Scenario changed = scenario();
  changed.vehicle.airframe->centre_of_pressure_m = 0.85;
  EXPECT_FALSE(roll_resonance(changed, {run(7.0)}, 0.1));
  changed.vehicle.airframe.reset();
  EXPECT_FALSE(roll_resonance(changed, {run(7.0)}, 0.1));
}

// Canards that do not turn the rocket as the law commands them: no gains, no limit and no straighter fins would help.

TEST(WrongWay, CanardsThatTurnTheWrongWayAreTheCauseAndNeitherOffsetNorGains) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (core::CanardPlan& canard : scenario.plan.canards.each) {
    canard.direction = core::Direction::reversed;
  }
  const TunnelResult tunnel = read_tunnel_result(scenario.tunnel_result.value(), {});
  const Decision d = decide(predict(scenario, tunnel, {.runs = 4}, [](std::size_t) {}), {});
  EXPECT_FALSE(d.go);
  const std::string why = stability::why_uncontrollable(scenario);
  EXPECT_NE(why.find("direction"), std::string::npos) << why;
  EXPECT_TRUE(d.text.starts_with("No go: " + why)) << d.text;
  ASSERT_EQ(d.criteria.size(), 3U);
  EXPECT_EQ(d.criteria[0].clause, why) << "and no fin offset";
  EXPECT_EQ(d.criteria[1].judgement, Judgement::not_met);
  EXPECT_EQ(d.criteria[2].judgement, Judgement::not_met);
  EXPECT_EQ(d.criteria[2].clause, "") << "no word of gains";
  ASSERT_EQ(d.advice.size(), 1U);
  EXPECT_NE(d.advice[0].find(why), std::string::npos) << d.advice[0];
}

TEST(WrongWay, PromisesNothingWhereTheFinsReverseTheRoll) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.canard_air.wash = 1.2;
  scenario.vehicle.canard_air.wash_distance_m = 0.9;
  const TunnelResult tunnel = read_tunnel_result(scenario.tunnel_result.value(), {});
  const Prediction p = predict(scenario, tunnel, {.runs = 20}, [](std::size_t) {});
  EXPECT_TRUE(std::ranges::any_of(p.notes, [](const std::string& note) {
    return note.find("fins") != std::string::npos && std::ranges::count(figures(note), "1.2") > 0;
  }));
  EXPECT_EQ(p.authority.count, 0U);
  EXPECT_EQ(p.held.count, 0U);
  const Decision d = decide(p, {.authority_share = 0.5, .held_share = 0.5});
  EXPECT_FALSE(d.go);
  const std::string why = stability::why_uncontrollable(scenario);
  EXPECT_NE(why.find("fins"), std::string::npos) << why;
  EXPECT_EQ(d.criteria.at(0).clause, why);
  EXPECT_NE(d.text.find(why), std::string::npos) << d.text;
  ASSERT_EQ(d.advice.size(), 1U);
  EXPECT_NE(d.advice[0].find(why), std::string::npos) << d.advice[0];
}

}  // namespace

}  // namespace fantail::predict
