// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "avionics/board_rig.hpp"
#include "avionics/flight_memory.hpp"

namespace fantail::avionics {

/// A rocket that really rolls: the canards of the table accelerate it, its fins brake it, the motor burns for three
/// seconds. Its processor may be reset in between; the rocket does not wait.
struct FlyingRig : BoardRig {
  static constexpr double alpha = 2.0;   // 1/s
  static constexpr double beta = 400.0;  // 1/s2
  /// What the firmware takes a gap to be.
  static constexpr Microseconds nominal_gap{60'000};

  explicit FlyingRig(const core::FlightPlan& plan = core::default_plan()) : BoardRig{plan} {}

  double rate_rad_s = 0.0;
  double angle_rad = 0.0;
  double largest_acceleration = 0.0;  ///< in the last gap
  double largest_rate = 0.0;
  double disturbance_rad = 0.004;     ///< as if the fins stood askew
  std::optional<Microseconds> lit{};  ///< true time
  Microseconds true_time{};

  /// One millisecond of the world, and the avionics' tick in it.
  const core::TickRecord& fly() {
    move();
    return tick();
  }
  const core::TickRecord* fly_for(Microseconds duration) {
    const core::TickRecord* record = nullptr;
    for (Microseconds end = true_time + duration; true_time < end;) {
      record = &fly();
    }
    return record;
  }
  /// From power-up to the first tick of a phase, or to the end of so long a time.
  const core::TickRecord* fly_to(core::Phase phase, Microseconds longest = 5 * second) {
    const core::TickRecord* record = nullptr;
    for (Microseconds end = true_time + longest; true_time < end && (record == nullptr || record->phase != phase);) {
      record = &fly();
    }
    return record;
  }
  void launch() {
    ASSERT_EQ(arm().phase, core::Phase::armed);
    fly_for(5 * second);
    lit = true_time;
  }
  void launch_to_control() {
    launch();
    ASSERT_EQ(fly_to(core::Phase::controlling)->phase, core::Phase::controlling);
  }

  /// The processor stands still for so long, and begins anew with its clock where the firmware puts it.
  void reset(hal::ResetCause cause, Microseconds gap = nominal_gap) {
    largest_acceleration = largest_rate = 0.0;
    for (Microseconds end = true_time + gap; true_time < end;) {
      move();
    }
    hardware.board.reset_cause = cause;
    hardware.time = clock_after_reset(backup_memory, cause, nominal_gap).value_or(Microseconds{0});
    reset_processor();
  }

 private:
  void move() {
    true_time += millisecond;
    const double canard_deg = (shaft_deg[0] + shaft_deg[1] + shaft_deg[2] + shaft_deg[3]) / 4.0;
    const bool flies = lit && true_time > *lit;
    if (flies) {
      const double deflection = canard_deg * 3.14159265358979 / 180.0 + disturbance_rad;
      const double acceleration = beta * deflection - alpha * rate_rad_s;
      rate_rad_s += 0.001 * acceleration;
      angle_rad += 0.001 * rate_rad_s;
      largest_acceleration = std::max(largest_acceleration, std::abs(acceleration));
      largest_rate = std::max(largest_rate, std::abs(rate_rad_s));
    }
    const bool burns = flies && true_time <= *lit + 3 * second;
    const auto axial = static_cast<std::int16_t>(burns ? 6000 : flies ? -300 : 1000);
    hardware.imu.rate = {static_cast<std::int16_t>(std::lround(rate_rad_s * 1000.0)), 0, 0};
    hardware.imu.specific_force = hardware.accelerometer.specific_force = {axial, 0, 0};
  }
};

}  // namespace fantail::avionics
