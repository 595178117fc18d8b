// SPDX-License-Identifier: MIT
#include "flight/gate.hpp"

#include <cmath>
#include <numbers>

#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::flight {
namespace {

using enum core::Phase;

TEST(PhaseEvents, TheFirstOpeningIsControlStart) {
  Events events;
  note_phase_event(events, armed, launched, 0.1);
  note_phase_event(events, launched, dormant, 0.6);
  note_phase_event(events, dormant, controlling, 3.5);
  EXPECT_EQ(events.detected_s, 0.1);
  EXPECT_EQ(events.dormant_s, 0.6);
  EXPECT_EQ(events.control_start_s, 3.5);

  note_phase_event(events, controlling, dormant, 4.0);
  EXPECT_EQ(events.dormant_s, 0.6);
  EXPECT_EQ(events.control_end_s, 4.0) << "unless the gate opens again";
  note_phase_event(events, dormant, controlling, 4.5);
  EXPECT_EQ(events.control_start_s, 3.5);
  EXPECT_FALSE(events.control_end_s);
  note_phase_event(events, controlling, finished, 9.0);
  EXPECT_EQ(events.control_end_s, 9.0);
}

TEST(PhaseEvents, ControlThatDoesNotComeBackEndedWhenTheGateClosed) {
  Events events{.control_start_s = 3.5};
  note_phase_event(events, controlling, dormant, 4.0);
  note_phase_event(events, dormant, finished, 9.0);
  EXPECT_EQ(events.control_end_s, 4.0);
}

TEST(PhaseEvents, AFlightWhoseGateStaysClosedIsOverWhenTheLawFinishes) {
  Events events;
  note_phase_event(events, launched, dormant, 0.6);
  note_phase_event(events, dormant, finished, 9.0);
  EXPECT_EQ(events.control_end_s, 9.0);
  EXPECT_FALSE(events.control_start_s);
}

TEST(PhaseEvents, ASecondDetectionCountsWhereTheFirstWasNone) {
  Events events;
  note_phase_event(events, armed, launched, 0.1);
  note_phase_event(events, launched, armed, 1.6);
  note_phase_event(events, armed, launched, 9.0);
  EXPECT_EQ(events.detected_s, 9.0);
}

Flight with_gate(core::DormantUntil until) {
  Flight flight;
  flight.plan = core::default_plan();
  flight.plan.dormancy.until = until;
  flight.plan.dormancy.height_m = 1500.0F;
  return flight;
}

TEST(Gate, IsNamedByThePlan) {
  using enum core::DormantUntil;
  EXPECT_EQ(gate_name(with_gate(burn_out)), "burn-out");
  EXPECT_EQ(gate_name(with_gate(max_dynamic_pressure)), "the largest dynamic pressure");
  EXPECT_EQ(gate_name(with_gate(height)), "1500 m");
  EXPECT_EQ(gate_name(with_gate(burn_out_and_height)), "burn-out and 1500 m");
  EXPECT_EQ(gate_has_opened(with_gate(max_dynamic_pressure_and_height)),
            "past the largest dynamic pressure and the low end of its height above 1500 m");
  EXPECT_FALSE(gate_height_m(with_gate(burn_out)));
  EXPECT_EQ(gate_height_m(with_gate(burn_out_and_height)), 1500.0);
  EXPECT_FALSE(has_gate(with_gate(guide)));

  Flight unknown = with_gate(height);
  unknown.known.plan = false;
  EXPECT_EQ(gate_name(unknown), "the plan's gate");
  EXPECT_EQ(gate_has_opened(unknown), "the plan's gate opened");
  EXPECT_FALSE(gate_height_m(unknown));
}

TEST(Gate, TheChosenTurnIsWhatTheReferenceHasBeyondThePlan) {
  Flight flight = with_gate(core::DormantUntil::burn_out);
  flight.plan.reference.kind = core::ReferenceKind::hold;
  flight.plan.reference.initial = core::Angle::from_degrees(30.0F);
  Row row;
  row.reference_rad = (30.0 - 720.0) * std::numbers::pi / 180.0;
  EXPECT_FALSE(chosen_turn(flight, row)) << "as published there is none";
  flight.plan.controller.entry = core::ControlEntry::capture;
  EXPECT_EQ(chosen_turn(flight, row), -2.0);
  row.reference_rad = 30.0 * std::numbers::pi / 180.0;
  EXPECT_EQ(chosen_turn(flight, row), 0.0);
  EXPECT_FALSE(std::signbit(*chosen_turn(flight, row)));
  row.reference_rad = std::nan("");
  EXPECT_FALSE(chosen_turn(flight, row));
  flight.plan.reference.kind = core::ReferenceKind::steps;
  flight.plan.reference.step_times_count = flight.plan.reference.step_angles_count = 1;
  flight.plan.reference.step_times[0] = core::Microseconds{2'000'000};
  flight.plan.reference.step_angles[0] = core::Angle::from_degrees(-170.0F);
  row.reference_rad = (-170.0 + 360.0) * std::numbers::pi / 180.0;
  EXPECT_EQ(chosen_turn(flight, row, 3.0), 1.0) << "the plan's step counts from control start";
}

}  // namespace
}  // namespace fantail::flight
