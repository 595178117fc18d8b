// SPDX-License-Identifier: MIT
#include "tune/tuning.hpp"

#include <algorithm>
#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <variant>

#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "tune/alternatives.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

/// The last three of a sentence: the new plan's, of how many flights, and the old one's.
Numbers last_three(const std::string& sentence) {
  const Numbers all = figures(sentence);
  return {all.end() - std::min<std::ptrdiff_t>(3, std::ssize(all)), all.end()};
}

void unwatched(Stage /*stage*/, std::size_t /*done*/) {}

const Tuning& second_launch() {
  static const Tuning tuning = tune(input::load_scenario("tasha3_launch2", {}),
                                    {.flights = 6, .command = "fantail tune tasha3_launch2"}, unwatched);
  return tuning;
}

TEST(Tuning, OfTheSecondLaunchIsBetterThanThePublishedPlan) {
  const Tuning& t = second_launch();
  ASSERT_TRUE(t.is_proposed()) << t.why_none;
  EXPECT_TRUE(t.is_better());
  EXPECT_LT(text::degrees(*t.flown_after().mean_rad), 3.0);
  EXPECT_GT(text::degrees(*t.flown_before().mean_rad), 9.0);
  EXPECT_GE(text::degrees(t.after->least.phase_margin_rad), 45.0);
  EXPECT_LE(t.after->settling_s.value(), 1.0);
}

TEST(Tuning, ItsPlanReadsBackBitForBit) {
  const Tuning& t = second_launch();
  const std::string file = testing::TempDir() + "tuned.toml";
  std::ofstream{file} << plan_text(t);
  const core::FlightPlan read = input::read_plan(input::Document::load(file));
  for (const core::PlanField& field : core::flight_plan_fields()) {
    for (std::size_t slot = 0; slot < field.used_slots(read); ++slot) {
      EXPECT_EQ(field.get_bits(read, slot), field.get_bits(t.after->plan, slot)) << field.section << '.' << field.key;
    }
  }
  std::filesystem::remove(file);
}

TEST(Tuning, IsTheSameInTextJsonAndPage) {
  const Tuning& t = second_launch();
  const json::Value said = json::parse(result::json(answer(t, "x.toml", {})));
  EXPECT_EQ(said["proposed"], true);
  EXPECT_EQ(said["plan"], "x.toml");
  EXPECT_EQ(said["flights"].size(), 6U);
  EXPECT_NE(result::text(answer(t, "", {})).find(flights_sentence(t)), std::string::npos);
  EXPECT_NE(answer(t, "x.toml", {}).verdict.sentence.find(flights_sentence(t)), std::string::npos);
}

TEST(Tuning, SaysOfWhichFlightsTheNewPlanHasFewer) {
  Tuning t = second_launch();
  for (Pair& pair : t.pairs) {
    pair.before.outcome = report::Outcome::off_command;
    pair.after.outcome = report::Outcome::not_held;
  }
  t.pairs.front().after.outcome = report::Outcome::off_command;
  EXPECT_FALSE(t.is_proposed());
  EXPECT_EQ(last_three(flights_sentence(t)), (Numbers{"1", "6", "6"})) << "steady ones: " << flights_sentence(t);
  for (Pair& pair : t.pairs) {
    pair.after.outcome = report::Outcome::off_command;
  }
  EXPECT_TRUE(t.is_proposed());
  t.pairs.front().before.outcome = report::Outcome::held;
  EXPECT_FALSE(t.is_proposed());
  EXPECT_EQ(last_three(flights_sentence(t)), (Numbers{"0", "6", "1"})) << "held ones: " << flights_sentence(t);
}

/// The loop of a plan without schedule, observer and faults, straight from its block diagram.
std::complex<double> open_loop(const core::FlightPlan& plan, const sim::Vehicle& vehicle, double speed_m_s, double w) {
  const std::complex<double> s{0.0, w};
  const sim::RollPlant& plant = vehicle.roll_plant;
  const double per_speed = 1.225 * speed_m_s * plant.reference_area_m2 / (2.0 * plant.inertia_kg_m2);
  const std::complex<double> gains = static_cast<double>(plan.controller.proportional_gain) +
                                     static_cast<double>(plan.controller.derivative_gain_s) * s +
                                     static_cast<double>(plan.offset.integral_gain_per_s) / s;
  return gains * per_speed * speed_m_s * plant.torque_m / (s * (s + per_speed * plant.damping_m2)) /
         (1.0 + vehicle.servo.lag_s * s) * std::exp(-stability::loop_delay_s(vehicle) * s);
}

TEST(Tuning, ItsBodeDiagramIsThatOfTheBlockDiagramAndMarksTheMarginsOnTheCurves) {
  const Tuning& t = second_launch();
  const sim::Vehicle vehicle = input::load_scenario("tasha3_launch2", {}).vehicle;
  const std::vector<result::Block> blocks = bode_diagram(t);
  const page::Chart& gain = std::get<result::Picture>(blocks.at(0)).chart;
  const page::Chart& phase = std::get<result::Picture>(blocks.at(1)).chart;
  ASSERT_EQ(gain.series.size(), 6U) << "a curve and a mark for each of three speeds";
  ASSERT_EQ(phase.series.size(), 6U);
  double slower_m_s = 0.0;
  for (std::size_t i = 0; i < 6; i += 2) {
    const auto said_of_gain = figures(gain.series[i].name);
    const auto said_of_phase = figures(phase.series[i].name);
    const double rounded_m_s = std::stod(said_of_gain.at(0));
    EXPECT_GT(rounded_m_s, slower_m_s);
    slower_m_s = rounded_m_s;
    const double db = 20.0 / std::log(10.0);
    for (std::size_t k = 0; k < gain.series[i].x.size(); k += 40) {
      const double w = 2.0 * std::numbers::pi * gain.series[i].x[k];
      const std::complex<double> expected = open_loop(t.after->plan, vehicle, rounded_m_s, w);
      EXPECT_NEAR(gain.series[i].y[k], db * std::log(std::abs(expected)), 0.5) << "the speed is rounded";
      const double away_deg = phase.series[i].y[k] - text::degrees(std::arg(expected));
      EXPECT_NEAR(std::remainder(away_deg, 360.0), 0.0, 1.5);
    }
    // The marks: upright, from 0 dB and from half a turn, as long as the name says.
    const page::Series& gain_mark = gain.series[i + 1];
    const page::Series& phase_mark = phase.series[i + 1];
    EXPECT_EQ(gain_mark.x.at(0), gain_mark.x.at(1));
    EXPECT_NEAR(gain_mark.y.at(0) - gain_mark.y.at(1), std::stod(said_of_gain.at(1)), 0.051);
    EXPECT_NEAR(phase_mark.y.at(1) - phase_mark.y.at(0), std::stod(said_of_phase.at(1)), 0.051);
    const std::complex<double> at_mark =
        open_loop(t.after->plan, vehicle, rounded_m_s, 2.0 * std::numbers::pi * phase_mark.x.at(0));
    EXPECT_NEAR(db * std::log(std::abs(at_mark)), 0.0, 0.5);
    const std::complex<double> at_half_turn =
        open_loop(t.after->plan, vehicle, rounded_m_s, 2.0 * std::numbers::pi * gain_mark.x.at(0));
    EXPECT_NEAR(std::abs(text::degrees(std::arg(at_half_turn))), 180.0, 1.5);
  }
}

// 7.3 degrees of offset, and a limit of 6.
TEST(Tuning, OfTheFirstLaunchSaysThatNoGainsCanDoIt) {
  const Tuning t = tune(input::load_scenario("tasha3_launch1", {}), {.flights = 2}, unwatched);
  EXPECT_FALSE(t.is_proposed());
  EXPECT_NE(t.why_none.find("offset"), std::string::npos) << t.why_none;
  EXPECT_EQ(figures(t.why_none).at(0), "-7.3");
  EXPECT_EQ(figures(t.why_none).at(1), "6");
  EXPECT_TRUE(says(std::get<result::Picture>(bode_diagram(t).at(0)).caption, "old plan"));
  EXPECT_EQ(json::parse(result::json(answer(t, "", {})))["plan"].is_null(), true);
}

TEST(Tuning, SaysWhatTheShortestSettlingTimeIs) {
  const Tuning t =
      tune(input::load_scenario("tunnel_steps", {}), {.settling_s = 0.1, .spread = 1.0, .flights = 1}, unwatched);
  EXPECT_FALSE(t.is_proposed());
  EXPECT_NE(t.why_none.find("0.1 s"), std::string::npos) << t.why_none;
  EXPECT_NE(t.why_none.find("integral"), std::string::npos) << t.why_none;
}

// A dead end: no gains, no other kind of law that is better, and not a word on what to do.
TEST(Tuning, WithoutGainsOrAnythingBetterSaysWhatToDoNext) {
  Tuning t;
  t.reach_rad = 0.1;
  t.why_none = "No such gains were found.";
  t.request.spread = 2.0;
  EXPECT_NE(next_step(t).find("tunnel"), std::string::npos) << next_step(t);
  EXPECT_NE(result::text(answer(t, "", {})).find(next_step(t)), std::string::npos);
  t.request.spread = 1.0;
  EXPECT_NE(next_step(t).find("--margin"), std::string::npos) << "no spread to make smaller: " << next_step(t);
  t.alternative = "--schedule gives gains of 0.5 and 0.05 s.";
  EXPECT_EQ(next_step(t), "");
  t.alternative.clear();
  t.largest_offset_rad = -0.2;
  EXPECT_EQ(next_step(t), "") << "why there are none says what would help";
}

// The plan of a new rocket has 30 degrees within a factor of two, and "No gains" in red was all that was said of it.
TEST(Tuning, WithoutABetterLawSaysThatAPlanWithEnoughMarginCanStay) {
  Tuning t;
  t.reach_rad = 0.1;
  t.why_none = "No such gains were found.";
  t.before.least = {.speed_m_s = 180.0, .phase_margin_rad = text::radians(30.1)};
  t.before.settling_s = 1.0;
  t.old_alone = Sum{.flights = 24, .held = 24};
  const auto said = [&t] { return result::text(answer(t, "", {})); };
  EXPECT_EQ(figures(present_plan(t)), (Numbers{"24", "30.1", "180", "1.00"}));
  EXPECT_NE(said().find("Keep the present plan: " + present_plan(t) + t.why_none), std::string::npos) << said();
  t.before.least.phase_margin_rad = text::radians(29.9);
  EXPECT_FALSE(t.is_old_enough());
  EXPECT_NE(said().find("No gains: " + t.why_none), std::string::npos) << said();
  t.request.phase_margin_rad = text::radians(20.0);
  EXPECT_TRUE(t.is_old_enough()) << "more than was asked for";
  t.old_alone->held = 23;
  EXPECT_FALSE(t.is_old_enough());
  t.old_alone->held = 24;
  t.before.settling_s.reset();
  EXPECT_FALSE(t.is_old_enough());
}

TEST(Tuning, NamesOfTheReferenceOnlyWhatItHas) {
  Tuning t = second_launch();
  EXPECT_NE(flights_sentence(t).find("of each step"), std::string::npos) << flights_sentence(t);
  t.before.plan.reference.kind = core::ReferenceKind::hold;
  EXPECT_EQ(flights_sentence(t).find("of each step"), std::string::npos) << flights_sentence(t);
}

// The nearest demands that the search found a law for, flown before they are named.
TEST(Tuning, NamesLowerDemandsOnlyWhereTheirLawLosesNoFlight) {
  Tuning t = second_launch();
  t.after.reset();
  t.within_reach = t.request;
  t.within_reach->scenario_command = "fantail tune tasha3_launch2 --seed 7";
  t.within_reach->settling_s = 1.9;
  t.within_reach->phase_margin_rad = text::radians(45.0);
  const Judged law = *second_launch().after;
  try_lower_demands(t, [&law](Tuning& other) { other.after = law; });
  const Numbers named = figures(t.alternative);
  ASSERT_GE(named.size(), 2U) << t.alternative;
  EXPECT_TRUE(t.alternative.ends_with(
      "Its command: fantail tune tasha3_launch2 --seed 7 --rejection integral --settling 1.9 --flights 6"))
      << t.alternative;
  t.within_reach->replaces = true;  // the plan of an earlier run is there
  try_lower_demands(t, [&law](Tuning& other) { other.after = law; });
  EXPECT_TRUE(t.alternative.ends_with(" --flights 6 --force")) << t.alternative;
  t.alternative.clear();
  try_lower_demands(t, [&law](Tuning& other) {
    other.after = law;
    other.pairs.front().before.outcome = report::Outcome::held;
    other.pairs.front().after.outcome = report::Outcome::not_held;
  });
  EXPECT_EQ(t.alternative, "");
  try_lower_demands(t, [](Tuning& other) { other.after.reset(); });
  EXPECT_EQ(t.alternative, "");
}

TEST(Tuning, OfCanardsThatTurnTheWrongWayIsRefused) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (core::CanardPlan& canard : scenario.plan.canards.each) {
    canard.direction = core::Direction::reversed;
  }
  try {
    (void)tune(scenario, {.flights = 1}, unwatched);
    ADD_FAILURE() << "was not refused";
  } catch (const text::Error& error) {
    EXPECT_STREQ(error.what(),
                 "tasha3_launch2: all canards turn the rocket against the roll command (direction differs "
                 "between plan and vehicle), so no gains can be tuned");
  }
}

TEST(Tuning, WithoutAirIsRefused) {
  EXPECT_THROW((void)tune(input::load_scenario("gimbal", {}), {}, unwatched), text::Error);
}

TEST(Tuning, OfARocketThatIsNotStableSaysSoFirst) {
  Tuning tuning;
  EXPECT_EQ(model_sentence(tuning), "");
  tuning.pairs.resize(2);
  tuning.pairs[1].after.extremes.static_margin_calibres = -5.0;
  EXPECT_EQ(figures(model_sentence(tuning)), Numbers{"-5.00"});
  EXPECT_NE(model_sentence(tuning).find("stable"), std::string::npos) << model_sentence(tuning);
}

}  // namespace
}  // namespace fantail::tune
