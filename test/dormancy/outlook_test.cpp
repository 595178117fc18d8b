// SPDX-License-Identifier: MIT
#include "dormancy/outlook.hpp"

#include "dormancy/sentences.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "text/degrees.hpp"

namespace fantail::dormancy {
namespace {

using core::DormantUntil;
using text::degrees;

sim::Scenario second_launch(DormantUntil until) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.plan.dormancy.until = until;
  scenario.plan.dormancy.burn_time = core::Microseconds{3'200'000};
  scenario.plan.controller.entry = core::ControlEntry::capture;
  scenario.plan.excitation.form = core::ExcitationForm::none;
  return scenario;
}

/// The same impulse, with a tail of a tenth of the thrust for nearly two seconds.
sim::Scenario with_tail(DormantUntil until) {
  sim::Scenario scenario = second_launch(until);
  scenario.vehicle.motor =
      sim::ThrustCurve{{{0.0, 0.0}, {0.05, 160.0}, {2.6, 140.0}, {2.8, 16.0}, {4.6, 14.0}, {4.7, 0.0}},
                       scenario.vehicle.motor.propellant_kg()};
  return scenario;
}

bool says(const std::vector<std::string>& all, std::string_view words) {
  return std::ranges::any_of(all, [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

std::vector<std::string> doubts_of(const sim::Scenario& scenario) {
  const Outlook found = outlook(scenario);
  return doubts(scenario, found, capture_forecast(scenario, found));
}

// The canonical curve falls from 118 N at 2.98 s to nothing at 3.20 s, its peak is 173 N: 2 % of it are left 3.1936 s
// after ignition.
TEST(Outlook, TheLastThrustIsTwoPerCentOfThePeak) {
  const sim::Scenario scenario = second_launch(DormantUntil::guide);
  EXPECT_NEAR(last_thrust_s(scenario.vehicle.motor).value(), 3.20 - 0.22 * 0.02 * 173.0 / 118.0, 1e-9);
  EXPECT_FALSE(last_thrust_s(sim::ThrustCurve{}).has_value());
  EXPECT_NEAR(last_thrust_s(sim::ThrustCurve{{{0.0, 100.0}, {1.0, 0.0}}, 0.1}).value(), 0.98, 1e-9);
}

// Row 9 and 10 of the oracle table, and the study: 82 m/s as the motor burns out.
TEST(Outlook, FliesTheAscentOfTheSecondLaunch) {
  const Outlook found = outlook(second_launch(DormantUntil::burn_out));
  EXPECT_NEAR(found.apogee.value().height_m, 421.5, 2.0);
  EXPECT_NEAR(found.apogee.value().time_s, 10.36, 0.1);
  EXPECT_NEAR(found.guide_clear.value().height_m, 4.0, 0.02);
  EXPECT_LT(found.most_pressure.value().time_s, found.thrust_is_drag.value().time_s);
  EXPECT_LT(found.thrust_is_drag.value().time_s, found.last_thrust.value().time_s);
  EXPECT_LT(found.last_thrust.value().time_s, found.thrust_end.value().time_s);
  const Opening& opening = found.opening.value();
  EXPECT_TRUE(opening.was_waited_for);
  EXPECT_NEAR(opening.time_s, 1.1 * 3.2, 0.05);
  EXPECT_NEAR(opening.speed_m_s, 76.4, 0.5);
  // Eq 27, nearly reached.
  EXPECT_NEAR(degrees(opening.rate_rad_s), -9.0 / 23.0 * 4.9 * 76.4, 8.0);
  EXPECT_GT(found.opens_after_thrust_s().value(), 0.3);
  EXPECT_LT(opening.captured_after_s.value(), 1.2);
  EXPECT_NEAR(found.burn_s.value(), 3.19, 0.05);
}

TEST(Outlook, AGateByBurnOutThatIsEarlySaysByHowMuchAndWhichFactorWouldNotBe) {
  sim::Scenario scenario = with_tail(DormantUntil::burn_out);
  scenario.plan.dormancy.burn_clock_factor = 1.0F;
  const Outlook found = outlook(scenario);
  EXPECT_LT(found.opens_after_thrust_s().value(), -0.5);
  EXPECT_LT(found.most_pressure.value().time_s, 3.0);
  EXPECT_TRUE(
      says(doubts_of(scenario), "s before the last thrust (2 % of its peak). A dormancy.burn_clock_factor of "));
  EXPECT_TRUE(says(doubts_of(scenario), "dormancy.burn_time_s = 3.2"));
  // What is advised is followed to the letter: then the motor no longer burns in any sense.
  const double to_end_s = found.burn_s.value() + found.thrust_end->time_s - found.last_thrust->time_s;
  const double advised = std::ceil(100.0 * to_end_s / 3.2) / 100.0;
  EXPECT_TRUE(says(doubts_of(scenario), fmt::format("A dormancy.burn_clock_factor of {:.2f} or more would keep it "
                                                    "closed to the end of this thrust curve",
                                                    advised)));
  scenario.plan.dormancy.burn_clock_factor = static_cast<float>(advised);
  EXPECT_GE(outlook(scenario).opening.value().time_s, found.thrust_end->time_s);
  const double factor = std::ceil(100.0 * found.burn_s.value() / 3.2) / 100.0;
  scenario.plan.dormancy.burn_clock_factor = static_cast<float>(factor);
  EXPECT_GT(outlook(scenario).opens_after_thrust_s().value(), 0.0);
  scenario.plan.dormancy.burn_clock_factor = static_cast<float>(factor - 0.02);
  EXPECT_LT(outlook(scenario).opens_after_thrust_s().value(), 0.0);
}

// A motor that rests for a second and burns again; the clock of a burn time of a second has run out by then.
TEST(Outlook, AGateThatClosesAgainIsCapturedAfterItsLastOpeningAndPromisesNoTime) {
  sim::Scenario scenario = second_launch(DormantUntil::burn_out);
  scenario.plan.dormancy.burn_time = core::Microseconds{1'000'000};
  scenario.vehicle.motor = sim::ThrustCurve{
      {{0.0, 0.0}, {0.05, 160.0}, {1.5, 140.0}, {1.55, 0.0}, {2.6, 0.0}, {2.65, 150.0}, {3.9, 140.0}, {4.0, 0.0}},
      scenario.vehicle.motor.propellant_kg()};
  const Outlook found = outlook(scenario);
  EXPECT_LT(found.opening.value().time_s, 2.6);
  EXPECT_EQ(found.opening->reopenings, 1U);
  // Counted from the first opening it would be two seconds more.
  EXPECT_LT(found.opening->captured_after_s.value(), 1.2);
  const std::string said = opening_clause(scenario, found, capture_forecast(scenario, found));
  EXPECT_NE(said.find("in the simulated flight it closes and reopens 1 time; after the last the roll is captured "),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("by calculation"), std::string::npos) << said;
}

TEST(Outlook, AtTheLargestPressureTheMotorMayStillBurn) {
  EXPECT_TRUE(says(doubts_of(with_tail(DormantUntil::max_dynamic_pressure)), "the motor still burns for 1."));
  EXPECT_TRUE(doubts_of(second_launch(DormantUntil::max_dynamic_pressure)).empty());
}

// Margin: 1 % of 300 m and of g t^2 / 2, and 60 mg of t^2 / 2: 14.2 m at 5.5 s.
TEST(Outlook, AGateByHeightSaysWhatItsMarginCosts) {
  sim::Scenario scenario = second_launch(DormantUntil::height);
  scenario.plan.dormancy.height_m = 300.0F;
  const Outlook found = outlook(scenario);
  const double t_s = found.opening.value().time_s;
  const double margin_m = 0.01 * (found.opening->height_m + 9.80665 * t_s * t_s / 2) + 0.06 * 9.80665 * t_s * t_s / 2;
  EXPECT_NEAR(found.opening->height_m - 300.0, margin_m, 1.5);
  EXPECT_NEAR(found.height_costs_s().value(), margin_m / 50.0, 0.03);
}

TEST(Outlook, AGateAboveTheApogeeIsNeverReached) {
  const sim::Scenario scenario = second_launch(DormantUntil::height);
  const Outlook found = outlook(scenario);
  EXPECT_FALSE(found.opening.has_value());
  EXPECT_EQ(found.stayed_because, core::PhaseReason::gate_never_opened);
  EXPECT_EQ(never_opened(scenario, found),
            "the gate is not reached: the apogee of 422 m is below dormancy.height_m = 1500. Control never begins");
  EXPECT_EQ(opening_clause(scenario, found, {}), "");
}

// Its guide leans, and it tilts past its limit while it waits.
TEST(Outlook, AGateAboveTheApogeeIsSaidWhateverEndsTheWait) {
  sim::Scenario scenario = second_launch(DormantUntil::height);
  scenario.motion = sim::FlightMotion::six_dof;
  scenario.guide.tilt_rad = text::radians(10.0);
  scenario.plan.run.tilt_limit = core::Angle::from_degrees(20.0F);
  const Outlook found = outlook(scenario);
  EXPECT_EQ(found.stayed_because, core::PhaseReason::tilted_too_far);
  EXPECT_NE(never_opened(scenario, found).find("is below dormancy.height_m = 1500. Control never begins"),
            std::string::npos);
}

TEST(Outlook, ARocketThatNeverLeavesThePadHasNone) {
  sim::Scenario scenario = second_launch(DormantUntil::height);
  scenario.vehicle.mass_kg = 50.0;
  const Outlook found = outlook(scenario);
  EXPECT_FALSE(found.opening || found.apogee || found.guide_clear || found.last_thrust);
  EXPECT_EQ(never_opened(scenario, found), "");
}

TEST(Outlook, ASpinNearTheEndOfTheGyroIsDoubted) {
  sim::Scenario scenario = second_launch(DormantUntil::max_dynamic_pressure);
  scenario.vehicle.imu.full_scale_rad_s = text::radians(250.0);
  EXPECT_FALSE(says(doubts_of(scenario), "the gyro measures"));
  scenario.vehicle.imu.full_scale_rad_s = text::radians(190.0);
  EXPECT_TRUE(says(doubts_of(scenario),
                   "the fin offset of 4.9 deg can turn the rocket at 158 deg/s (steady roll at 82 m/s); the gyro "
                   "measures up to 190 deg/s"));
}

TEST(Outlook, TheForecastOfCaptureIsThatOfTheFlight) {
  const sim::Scenario scenario = second_launch(DormantUntil::max_dynamic_pressure);
  const Outlook found = outlook(scenario);
  const auto forecast = capture_forecast(scenario, found);
  EXPECT_LE(found.opening.value().captured_after_s.value(), forecast.value().from_any_angle_within_s.value());
  sim::Scenario weak = scenario;
  weak.plan.controller.canard_limit = core::Angle::from_degrees(4.0F);
  const Outlook spinning = outlook(weak);
  const auto residual = capture_forecast(weak, spinning).value().residual_rate_rad_s;
  EXPECT_NEAR(degrees(residual.value()), -9.0 / 23.0 * 0.9 * spinning.opening.value().speed_m_s, 0.3);
  EXPECT_TRUE(
      says(doubts(weak, spinning, capture_forecast(weak, spinning)), "the canards cannot stop the rotation: 29 deg/s"));
}

// Each with its reason; and a promise beyond what a verdict leaves out says so.
TEST(Outlook, WhereNoCaptureTimeIsPromisedTheClauseSaysWhy) {
  const auto clause = [](const sim::Scenario& scenario) {
    const Outlook found = outlook(scenario);
    return opening_clause(scenario, found, capture_forecast(scenario, found));
  };
  const sim::Scenario scenario = second_launch(DormantUntil::max_dynamic_pressure);
  EXPECT_EQ(clause(scenario).find("promised"), std::string::npos) << clause(scenario);
  sim::Scenario faulty = scenario;
  faulty.faults.push_back({.device = sim::Device::servo, .how = sim::Behaviour::cut, .from_s = 30.0, .until_s = 31.0});
  EXPECT_TRUE(says({clause(faulty)}, "no capture time is promised: the scenario has faults"));
  sim::Scenario rates = scenario;
  rates.plan.controller.rate_reference = core::RateReference::paper_literal;
  EXPECT_TRUE(says({clause(rates)}, "no capture time is promised: controller.rate_reference is not \"zero\""));
  sim::Scenario little = scenario;
  little.plan.controller.canard_limit = core::Angle::from_degrees(5.5F);
  EXPECT_TRUE(says({clause(little)}, "no capture time is promised: the fin offset needs more than 80 % of the "));
  sim::Scenario blind = scenario;
  blind.plan.offset.rejection = core::OffsetRejection::integral;
  blind.plan.offset.integral_gain_per_s = 0.5F;
  EXPECT_TRUE(says({clause(blind)}, "the law rejects the offset, and the plan has no [roll_model]"));
}

TEST(CaptureForecast, BeyondWhatAVerdictLeavesOutIsSaidSo) {
  const sim::Scenario scenario = second_launch(DormantUntil::max_dynamic_pressure);
  const Outlook found = outlook(scenario);
  const auto clause = [&](double within_s) {
    return opening_clause(scenario, found, CaptureForecast{.within_s = within_s});
  };
  EXPECT_TRUE(says({clause(1.15)}, "the roll is captured within 1.2 s"));
  EXPECT_FALSE(says({clause(1.15)}, "leaves out"));
  EXPECT_TRUE(says({clause(2.75)}, "captured within 2.8 s (a verdict leaves out only the first 1.2 s)"));
}

TEST(SpeedsUnderControl, GoDownToTheSlowestAtWhichTheRollIsHeld) {
  const sim::Scenario late = second_launch(DormantUntil::max_dynamic_pressure);
  const std::vector<double> speeds_m_s = fly::speeds_under_control_m_s(late);
  EXPECT_NEAR(speeds_m_s.front(), 81.4, 0.2);
  EXPECT_NEAR(std::ranges::min(speeds_m_s), 20.0, 0.02);
  const auto reported = fly::fly_without_rows(late, [](const auto&, const auto&) {}).loop_margins;
  EXPECT_NEAR(reported.front().speed_m_s, 20.0, 0.02) << "as plan check and tune";
  EXPECT_NEAR(reported.back().speed_m_s, 81.4, 0.2);
}

TEST(PlanDoubts, AreThoseOfAPlanForALaunch) {
  core::FlightPlan plan = second_launch(DormantUntil::burn_out).plan;
  plan.run.tilt_limit = core::Angle::from_degrees(30.0F);
  plan.run.tilt_from = core::TiltOrigin::guide;
  EXPECT_EQ(doubts(plan),
            (std::vector<std::string>{"controller.entry = \"capture\" without [roll_model]: the turn is chosen from "
                                      "gains and spin alone"}));
  plan.roll_model.torque_m = 9.0F;
  EXPECT_TRUE(doubts(plan).empty());
  plan.run.tilt_limit = core::Angle::from_degrees(45.0F);
  plan.excitation.form = core::ExcitationForm::product;
  plan.excitation.begin = core::Microseconds{400'000};
  EXPECT_TRUE(says(doubts(plan), "run.tilt_limit_deg = 45 from the launch guide: ranges allow at most 30 degrees"));
  EXPECT_TRUE(says(doubts(plan), "excitation.begin_s = 0.4: it takes canard angle from capture"));
  plan.controller.entry = core::ControlEntry::as_published;
  EXPECT_TRUE(says(doubts(plan), "every turn that is made before control is turned back"));
  plan.run.start = core::Start::tunnel;
  EXPECT_TRUE(doubts(plan).empty());
}

}  // namespace
}  // namespace fantail::dormancy
