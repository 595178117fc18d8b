// SPDX-License-Identifier: MIT
#include "report/running_figures.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

constexpr double ignition_s = 12.345;

/// As they are seen while the flight is flown: its rows count from power-up.
RunningFigures while_flown(const flight::Flight& flight) {
  RunningFigures running{flight.tunnel};
  flight::Flight so_far = flight;
  so_far.events = {};
  for (flight::Row row : flight.rows) {
    if (flight.events.apogee_s && row.time_s >= *flight.events.apogee_s) {
      so_far.events.apogee_s = *flight.events.apogee_s + ignition_s;
    }
    row.time_s += ignition_s;
    running.add(row, so_far);
  }
  return running;
}

TEST(RunningFigures, OnTheClockOfPowerUpAreThoseOfTheRowsOnTheirOwn) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.1, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 4.3;
  for (flight::Row& row : synthetic.flight.rows) {
    row.saturated = row.time_s > 3.2;
    row.truth->canard_rad = text::radians(6.0) * std::sin(2.0 * std::numbers::pi * 7.0 * row.time_s);
    row.truth->roll_angle_rad += text::radians(row.time_s);
    row.truth->speed_m_s = 30.0 - row.time_s;
    row.truth->height_m = 10.0 * row.time_s;
  }
  const Figures kept = figures(synthetic.flight);
  EXPECT_TRUE(kept.oscillation && kept.at_limit_since_s && kept.roll_after_end_rad && kept.mean_hold_error_rad);
  Figures flown = while_flown(synthetic.flight).figures(synthetic.flight, {.zero_s = ignition_s});
  flown.side_deflection = kept.side_deflection;
  EXPECT_TRUE(flown == kept);
}

TEST(RunningFigures, RollAfterControlCountsUntilTheApogeeThatLasts) {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::tilted_too_far);
  flight::Flight& flight = synthetic.flight;
  RunningFigures running{false};
  for (flight::Row& row : flight.rows) {
    const double deg = row.time_s < 3.25 ? 0.0 : row.time_s < 3.35 ? 20.0 : row.time_s < 4.0 ? 12.0 : 30.0;
    row.truth->roll_angle_rad = text::radians(deg);
    flight.events.apogee_s.reset();
    if (row.time_s >= 3.2 && row.time_s < 3.4) {
      flight.events.apogee_s = 3.2;  // a hop's
    } else if (row.time_s >= 3.9) {
      flight.events.apogee_s = 3.9;
    }
    running.add(row, flight);
  }
  EXPECT_NEAR(text::degrees(running.figures(flight).roll_after_end_rad.value()), 20.0, 1e-9);
}

TEST(RunningFigures, OfAFlightWhoseApogeeFellIntoAGapTheFirstRowBehindItCounts) {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::tilted_too_far);
  flight::Flight& flight = synthetic.flight;
  std::erase_if(flight.rows, [](const flight::Row& row) { return row.time_s >= 3.0 && row.time_s < 4.0; });
  for (flight::Row& row : flight.rows) {
    row.truth->roll_angle_rad = text::radians(row.time_s < 3.0 ? 0.0 : row.time_s < 4.0005 ? 25.0 : 70.0);
  }
  flight.events.apogee_s = 3.5;
  EXPECT_NEAR(text::degrees(figures(flight).roll_after_end_rad.value()), 25.0, 1e-9);
}

}  // namespace
}  // namespace fantail::report
