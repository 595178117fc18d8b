// SPDX-License-Identifier: MIT
#include "rules/figures.hpp"

#include <cmath>
#include <numbers>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "rules/pack.hpp"
#include "test.hpp"

namespace fantail::rules {
namespace {

const sim::Scenario& scenario() {
  static const sim::Scenario loaded = input::load_scenario("tasha3_launch2", {});
  return loaded;
}
const flight::Flight& flown() {
  static const flight::Flight flight = fly::fly_scenario(scenario());
  return flight;
}

Number number(const Findings& all, const std::string& name) {
  const auto found = all.find(name);
  return found == all.end() || !found->second.known ? Number{NAN, NAN} : std::get<Number>(*found->second.known);
}

/// As a log has it: nothing of the truth, and no burn-out.
flight::Flight logged(flight::Flight flight) {
  for (flight::Row& row : flight.rows) {
    row.truth.reset();
  }
  flight.events.burnout_s.reset();
  flight.events.apogee_s.reset();
  flight.events.liftoff_s.reset();
  return flight;
}

// The centres of the vehicle file: pressure 1.02 m, gravity 0.90 m and 0.875 m, 1.51 m long, 80 mm thick.
TEST(RocketFigures, OfMarginsFollowFromTheCentresInTheFile) {
  const Findings all = of_rocket(scenario(), flown());
  EXPECT_NEAR(number(all, "rocket.margin_calibres").low, 0.12 / 0.08, 1e-9);
  EXPECT_NEAR(number(all, "rocket.margin_at_launch_percent").low, 12.0 / 1.51, 1e-9);
  EXPECT_NEAR(number(all, "rocket.least_margin_percent").low, 12.0 / 1.51, 1e-9);
  EXPECT_NEAR(number(all, "rocket.largest_margin_percent").low, 14.5 / 1.51, 1e-9);
  EXPECT_NEAR(number(all, "rocket.total_impulse_n_s").low, scenario().vehicle.motor.impulse_n_s(), 1e-9);
}

// Its swing a'' + 2 z w a' + w^2 a = 0, by hand from the numbers of the file: z = 0.140 full and 0.134 burnt out. The
// file says that it swings with 0.14 in a tunnel.
TEST(RocketFigures, OfDampingIsThatOfThePitchEquation) {
  const auto ratio = [](double margin_m, double inertia_kg_m2) {
    const double k = 0.5 * 1.225 * (0.25 * std::numbers::pi * 0.08 * 0.08) * 10.0;
    const double stiffness = k * margin_m;                             // over v squared
    const double damping = k * (0.644 * 0.644 + margin_m * margin_m);  // over v
    return damping / (2.0 * inertia_kg_m2 * std::sqrt(stiffness / inertia_kg_m2));
  };
  const Number found = number(of_rocket(scenario(), flown()), "rocket.damping_ratio");
  EXPECT_NEAR(found.high, ratio(0.12, 0.60), 1e-9);
  EXPECT_NEAR(found.low, ratio(0.145, 0.56), 1e-9);
  EXPECT_NEAR(found.high, 0.14, 0.001);
}

TEST(RocketFigures, AreUnknownForAVehicleWithoutAShape) {
  sim::Scenario bare = scenario();
  bare.vehicle.airframe.reset();
  bare.vehicle.geometry.reset();
  const Findings all = of_rocket(bare, flown());
  for (const char* name : {"rocket.margin_calibres", "rocket.margin_at_stop_calibres", "rocket.least_margin_percent",
                           "rocket.damping_ratio"}) {
    EXPECT_FALSE(all.at(name).known) << name;
    EXPECT_NE(all.at(name).how.find("the vehicle has no [airframe]"), std::string::npos) << name;
  }
}

// Above Mach 0.8 the centre of pressure moves, and the model's does not.
TEST(RocketFigures, OfMarginsInFlightAreUnknownAboveTheModelsMachNumber) {
  flight::Flight fast = flown();
  fast.extremes.top_mach = 1.3;
  const Findings all = of_rocket(scenario(), fast);
  EXPECT_TRUE(all.at("rocket.margin_at_launch_percent").known);
  EXPECT_FALSE(all.at("rocket.least_margin_percent").known);
  EXPECT_FALSE(all.at("rocket.damping_ratio").known);
  for (const char* name : {"rocket.margin_calibres", "rocket.damping_ratio"}) {
    EXPECT_NE(all.at(name).how.find("Mach 1.30"), std::string::npos) << name;
  }
  fast.extremes.top_mach = 0.8004;
  EXPECT_NE(
      of_rocket(scenario(), fast).at("rocket.margin_calibres").how.find("reaches Mach 0.8004, and above Mach 0.8 "),
      std::string::npos);
}

Finding of_log_with_mach(const std::optional<Known>& mach, const std::string& name) {
  return of_rocket(scenario().vehicle, flown().side_moment_m3, {{"flight.largest_mach", {mach, ""}}}).at(name);
}

TEST(RocketFigures, OfALogAreThoseOfTheSimulationOnlyWhereTheLogShowsHowFastItFlew) {
  const Findings simulated = of_rocket(scenario(), flown());
  for (const char* name : {"rocket.margin_calibres", "rocket.margin_at_stop_calibres", "rocket.damping_ratio"}) {
    EXPECT_EQ(of_log_with_mach(exactly(0.25), name).known, simulated.at(name).known) << name;
    const Finding open = of_log_with_mach(Number{0.25, INFINITY}, name);
    EXPECT_FALSE(open.known) << name;
    EXPECT_NE(open.how.find("does not show the largest Mach number"), std::string::npos) << open.how;
    EXPECT_FALSE(of_log_with_mach({}, name).known) << name;
    EXPECT_NE(of_log_with_mach(Number{1.6, INFINITY}, name).how.find("reaches Mach 1.60"), std::string::npos) << name;
  }
  EXPECT_TRUE(of_log_with_mach({}, "rocket.total_impulse_n_s").known);
}

TEST(RocketFigures, OfAnUnstableRocketSayThatAStopMakesItNoBetter) {
  sim::Scenario unstable = scenario();
  unstable.vehicle.airframe->centre_of_pressure_m = 0.85;
  const Findings all = of_rocket(unstable, flown());
  EXPECT_NEAR(number(all, "rocket.margin_at_stop_calibres").low, -0.05 / 0.08, 1e-9);
  EXPECT_FALSE(all.at("rocket.damping_ratio").known);
}

TEST(FlightFigures, OfASimulatedFlightAreThoseOfItsEventsAndTruth) {
  const Findings all = of_flight(flown(), scenario().atmosphere);
  EXPECT_NEAR(number(all, "flight.burnout_s").low, *flown().events.burnout_s, 1e-9);
  EXPECT_NEAR(number(all, "flight.control_start_s").low, *flown().events.control_start_s, 1e-9);
  EXPECT_NEAR(number(all, "flight.left_trim_s").low, 0.64, 0.01);       // as the design study has it
  EXPECT_NEAR(number(all, "flight.left_trim_height_m").low, 6.0, 0.1);  // likewise
  EXPECT_NEAR(number(all, "flight.apogee_m").low, 421.0, 1.0);          // likewise
  EXPECT_EQ(all.at("flight.left_trim").known, Known{true});
}

// A path of another program shows its motor only where that pushes with more than the drag.
TEST(FlightFigures, OnATrajectoryHaveABurnOutThatMayBeLater) {
  flight::Flight flight = flown();
  flight.path_frame = flight::PathFrame::plane;
  const Number found = number(of_flight(flight, scenario().atmosphere), "flight.burnout_s");
  EXPECT_EQ(found.low, *flown().events.burnout_s);
  EXPECT_TRUE(std::isinf(found.high));
}

TEST(FlightFigures, OfALogHaveABurnOutThatIsNoEarlierThanTheLastForceAlongTheAxis) {
  flight::Flight log = logged(flown());
  const Number seen = number(of_log(log), "flight.burnout_s");
  EXPECT_NEAR(seen.low, 3.19, 0.05);
  EXPECT_TRUE(std::isinf(seen.high));
  EXPECT_EQ(number(of_log(log, 3.5), "flight.burnout_s"), exactly(3.5)) << "the motor pushes less than the drag";
  const Number longer = number(of_log(log, 2.0), "flight.burnout_s");
  EXPECT_EQ(longer, exactly(seen.low)) << "it burned longer than its curve";
}

// A range wants to know that the motor is out, and whoever wrote the plan may have been wrong.
TEST(FlightFigures, OfALogDoNotTakeThePlansBurnTimeForBurnOut) {
  flight::Flight log = logged(flown());
  const Number seen = number(of_log(log), "flight.burnout_s");
  log.plan.dormancy.burn_time = core::Microseconds{1'500'000};
  const Finding stated = of_log(log).at("flight.burnout_s");
  EXPECT_EQ(stated.known, Known{seen});
  EXPECT_NE(stated.how.find("dormancy.burn_time_s = 1.5 is the plan's word, not verified"), std::string::npos)
      << stated.how;
  EXPECT_EQ(of_log(log, 3.5).at("flight.burnout_s").how.find("the plan's word"), std::string::npos);
}

TEST(FlightFigures, OfALogThatEndsUnderThrustAreLowerBounds) {
  flight::Flight log = logged(flown());
  std::erase_if(log.rows, [](const flight::Row& row) { return row.time_s > 2.0; });
  log.events.control_end_s.reset();
  const Findings all = of_log(log, 1.0);  // the log contradicts such a motor
  for (const char* name : {"flight.burnout_s", "flight.max_q_s", "flight.apogee_m", "flight.top_speed_m_s"}) {
    EXPECT_TRUE(std::isinf(number(all, name).high)) << name;
  }
  EXPECT_NEAR(number(all, "flight.burnout_s").low, 2.0, 0.01);
}

// No canard had moved by then; whether one did before burn-out nobody recorded.
TEST(FlightFigures, OfALogThatEndsBeforeAnyCanardMovedDoNotSayThatNoneDid) {
  flight::Flight log = logged(flown());
  EXPECT_EQ(of_log(log).at("flight.left_trim").known, Known{true});
  std::erase_if(log.rows, [](const flight::Row& row) { return row.time_s > 0.5; });
  EXPECT_FALSE(of_log(log).at("flight.left_trim").known);
}

TEST(FlightFigures, OfALogWithoutALaunchOrAPlanAreUnknown) {
  flight::Flight log = logged(flown());
  log.known.plan = false;
  EXPECT_FALSE(of_log(log).at("flight.left_trim").known);
  log.events.detected_s.reset();
  for (const auto& [name, found] : of_log(log)) {
    EXPECT_FALSE(found.known) << name;
  }
}

// With its meaning: whoever writes a pack begins with a shipped one.
TEST(ShippedPacks, BeginWithEveryFigure) {
  std::ifstream file{FANTAIL_TEST_SOURCE "/tools/rules/packs/irec.toml"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const FigureText& figure : figure_texts()) {
    EXPECT_NE(page.find("#   " + std::string{figure.name} + " "), std::string::npos) << figure.name;
    EXPECT_NE(page.find(figure.meaning), std::string::npos) << figure.name;
  }
}

TEST(PlanFigures, AreTheNumbersThatAFileWouldHave) {
  const Findings all = of_plan(scenario().plan);
  EXPECT_EQ(number(all, "plan.run.tilt_limit_deg").low, 60.0);  // and not the 60.0000017 of a float of radians
  EXPECT_EQ(all.at("plan.dormancy.until").known, Known{std::string{"guide"}});
  EXPECT_EQ(all.at("plan.launch_detection.low_pass").known, Known{true});
  EXPECT_EQ(number(all, "plan.canards.mechanical_stop_deg").high, 25.0);
}

TEST(PlanFigures, OfSeveralCanardsReachFromTheLeastToTheLargest) {
  core::FlightPlan plan = scenario().plan;
  plan.canards.each[2].mechanical_stop = core::Angle::from_degrees(30.0F);
  plan.canards.each[1].direction = core::Direction::reversed;
  const Findings all = of_plan(plan);
  EXPECT_EQ(number(all, "plan.canards.mechanical_stop_deg"), (Number{25.0, 30.0}));
  EXPECT_FALSE(all.at("plan.canards.direction").known);
  EXPECT_EQ(all.size(), plan_meanings().size());
}

}  // namespace
}  // namespace fantail::rules
