// SPDX-License-Identifier: MIT
#include "flight/flight.hpp"

#include "figures.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::flight {
namespace {

using namespace core::literals;

TEST(Flight, ARowTakesEveryFigureOfTheRecord) {
  core::TickRecord record;
  record.phase = core::Phase::controlling;
  record.motion.roll_angle = 30_deg;
  record.motion.roll_rate_rad_s = 1.5F;
  record.motion.specific_force_m_s2 = {20.0F, 1.0F, 2.0F};
  record.motion.height_m = 7.0F;
  record.motion.speed_m_s = 25.0F;
  record.reference = -20_deg;
  record.excitation = 4_deg;
  record.command = 9_deg;
  record.saturated = true;
  record.canards[1] = {.angle = 8_deg, .driven = true};
  record.encoders[3] = 7_deg;
  record.canard_angle = 6_deg;
  const Row r = row(record, 1.5);
  EXPECT_EQ(r.time_s, 1.5);
  EXPECT_EQ(r.phase, core::Phase::controlling);
  EXPECT_NEAR(text::degrees(r.roll_angle_rad), 30.0, 1e-5);
  EXPECT_EQ(r.roll_rate_rad_s, 1.5);
  EXPECT_EQ(r.specific_force_m_s2, 20.0);
  EXPECT_EQ(r.height_m, 7.0);
  EXPECT_EQ(r.speed_m_s, 25.0);
  EXPECT_NEAR(text::degrees(r.reference_rad), -20.0, 1e-5);
  EXPECT_NEAR(text::degrees(r.excitation_rad), 4.0, 1e-5);
  EXPECT_NEAR(text::degrees(r.command_rad), 9.0, 1e-5);
  EXPECT_TRUE(r.saturated);
  EXPECT_FALSE(r.commands_rad[0]) << "a servo that is off has no command";
  EXPECT_NEAR(text::degrees(r.commands_rad[1].value()), 8.0, 1e-5);
  EXPECT_FALSE(r.encoders_rad[0]);
  EXPECT_NEAR(text::degrees(r.encoders_rad[3].value()), 7.0, 1e-5);
  EXPECT_NEAR(text::degrees(r.canard_rad.value()), 6.0, 1e-5);
}

// A flight was "up to Mach 0.80, but the simulation of roll is valid only to Mach 0.8".
TEST(ModelEnd, NamesNumbersThatDiffer) {
  EXPECT_EQ(figures(how_far_beyond({.top_mach = 0.803})), (std::vector<std::string>{"0.803", "0.8"}));
  EXPECT_EQ(figures(how_far_beyond({.angle_of_attack_rad = text::radians(15.02)})),
            (std::vector<std::string>{"15.02", "15"}));
  EXPECT_EQ(figures(how_far_beyond({.static_margin_calibres = -0.002})), (std::vector<std::string>{"-0.002"}));
  EXPECT_EQ(figures(which_are_beyond({{.top_mach = 0.803, .angle_of_attack_rad = text::radians(20.0)}})),
            (std::vector<std::string>{"1", "1", "0.8", "0.803", "1", "1", "15", "20.0"}));
  EXPECT_EQ(which_are_beyond({{.top_mach = 0.803, .angle_of_attack_rad = text::radians(20.0)}}).find(';'),
            std::string::npos);
}

TEST(Flight, AnEncoderThatReadsNoNumberIsMissing) {
  core::TickRecord record;
  record.encoders[0] = core::Angle::from_radians(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(row(record, 0.0).encoders_rad[0]);
}

TEST(Flight, TicksTellPhaseChangesEventsAndCanardVerdicts) {
  Flight flight;
  core::TickRecord record;
  const auto tick = [&](double time_s, core::Phase phase, core::PhaseReason reason) {
    record.phase = phase;
    record.reason = reason;
    add_tick(flight, record, time_s, Truth{.height_m = time_s});
  };
  tick(-1.0, core::Phase::safe, core::PhaseReason::power_on);
  tick(-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command);
  tick(0.1, core::Phase::launched, core::PhaseReason::launch_detected);
  tick(0.6, core::Phase::controlling, core::PhaseReason::guide_clear);
  record.verdicts[2] = core::CanardVerdict::dead;
  tick(0.7, core::Phase::controlling, core::PhaseReason::guide_clear);
  tick(0.8, core::Phase::controlling, core::PhaseReason::guide_clear);
  record.verdicts[2] = core::CanardVerdict::healthy;
  tick(9.0, core::Phase::finished, core::PhaseReason::apogee);

  ASSERT_EQ(flight.rows.size(), 7U);
  EXPECT_EQ(flight.rows[3].truth.value().height_m, 0.6);
  ASSERT_EQ(flight.phase_changes.size(), 4U);
  EXPECT_EQ(flight.phase_changes[3].reason, core::PhaseReason::apogee);
  EXPECT_EQ(flight.events.detected_s, 0.1);
  EXPECT_EQ(flight.events.control_start_s, 0.6);
  EXPECT_EQ(flight.events.control_end_s, 9.0);
  ASSERT_EQ(flight.canard_verdict_changes.size(), 2U);
  EXPECT_EQ(flight.canard_verdict_changes[0].time_s, 0.7);
  EXPECT_EQ(flight.canard_verdict_changes[0].canard, 2U);
  EXPECT_EQ(flight.canard_verdict_changes[1].verdict, core::CanardVerdict::healthy);
}

// The first tick after it is the one that calls it a timing fault.
TEST(Flight, ControlThatAStandstillEndedEndedWithTheLastTickBeforeIt) {
  Flight flight;
  core::TickRecord record;
  const auto tick = [&](double time_s, core::Phase phase, core::PhaseReason reason) {
    record.phase = phase;
    record.reason = reason;
    note_tick(flight, record, time_s);
  };
  tick(0.6, core::Phase::controlling, core::PhaseReason::guide_clear);
  tick(0.601, core::Phase::controlling, core::PhaseReason::guide_clear);
  tick(9.0, core::Phase::finished, core::PhaseReason::timing_fault);
  end_control_with_outage(flight);
  ASSERT_EQ(flight.outages.size(), 1U);
  EXPECT_EQ(flight.outages[0].from_s, 0.601);
  EXPECT_EQ(flight.outages[0].to_s, 9.0);
  EXPECT_EQ(flight.events.control_end_s, 0.601);
  EXPECT_EQ(flight.phase_changes.back().time_s, 9.0) << "when it was seen";
}

// u_d = 3 degrees and kp = 0.5: 6 degrees off; where the fins take 40 % back, 10.
TEST(Flight, TheLawSettlesWhereTheCanardsWithWhatTheFinsLeaveBalanceTheOffset) {
  Flight flight;
  flight.plan.controller.proportional_gain = 0.5F;
  const Row row{.reference_rad = text::radians(20.0), .truth = Truth{.disturbance_rad = text::radians(3.0)}};
  const auto settles_at_deg = [&](double left_by_fins) {
    flight.left_by_fins = left_by_fins;
    return text::degrees(settle_point_rad(row, flight).value());
  };
  EXPECT_NEAR(settles_at_deg(1.0), 26.0, 1e-9);
  EXPECT_NEAR(settles_at_deg(0.6), 30.0, 1e-9);
  EXPECT_NEAR(settles_at_deg(-0.3), 26.0, 1e-9) << "nowhere: counted from where it should";
  flight.plan.offset.rejection = core::OffsetRejection::integral;
  EXPECT_NEAR(settles_at_deg(0.6), 20.0, 1e-9);
  flight.known.plan = false;
  EXPECT_FALSE(settle_point_rad(row, flight));
}

TEST(Flight, AScheduledLawSettlesByTheGainOfItsSpeed) {
  core::FlightPlan plan{};
  plan.controller.proportional_gain = 0.5F;
  plan.gain_schedule = {.speeds_count = 2, .speeds_m_s = {40.0F, 80.0F}, .factors_count = 2, .factors = {2.0F, 1.0F}};
  const Row row{.speed_m_s = 60.0, .truth = Truth{.disturbance_rad = text::radians(3.0)}};
  EXPECT_NEAR(text::degrees(settle_point_rad(row, plan).value()), 3.0 / 0.75, 1e-6);
}

// As the law does: a speed that is only a lower bound takes the last row.
TEST(Flight, AScheduledLawWhoseSpeedIsALowerBoundSettlesByTheLastRow) {
  Flight flight;
  flight.plan.controller.proportional_gain = 0.5F;
  flight.plan.gain_schedule = {
      .speeds_count = 2, .speeds_m_s = {40.0F, 80.0F}, .factors_count = 2, .factors = {2.0F, 1.0F}};
  flight.unmeasured.speed_bound_from_s = 3.0;
  const auto settles_at_deg = [&](double time_s) {
    const Row row{.time_s = time_s, .speed_m_s = 60.0, .truth = Truth{.disturbance_rad = text::radians(3.0)}};
    return text::degrees(settle_point_rad(row, flight).value());
  };
  EXPECT_NEAR(settles_at_deg(2.9), 3.0 / 0.75, 1e-6);
  EXPECT_NEAR(settles_at_deg(3.0), 3.0 / 0.5, 1e-6);
}

TEST(Flight, TimeZeroMovesEverythingWithATime) {
  Flight flight;
  flight.rows.resize(2);
  flight.rows[0].time_s = 5.000;
  flight.rows[1].time_s = 5.001;
  flight.events.liftoff_s = 5.001;
  flight.imposed_roll = ImposedRoll{.time_s = 5.211};
  flight.phase_changes = {{5.001, core::Phase::armed, core::PhaseReason::power_on}};
  flight.canard_verdict_changes = {{6.001, 0, core::CanardVerdict::dead}};
  set_time_zero(flight, 5.001);
  EXPECT_EQ(flight.rows[0].time_s, -0.001);
  EXPECT_EQ(flight.rows[1].time_s, 0.0);
  EXPECT_EQ(flight.events.liftoff_s, 0.0);
  EXPECT_EQ(flight.imposed_roll.value().time_s, 0.21);
  EXPECT_EQ(flight.phase_changes[0].time_s, 0.0);
  EXPECT_EQ(flight.canard_verdict_changes[0].time_s, 1.0);
  EXPECT_FALSE(flight.events.apogee_s);
}

}  // namespace
}  // namespace fantail::flight
