// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flight_plan.hpp"
#include "core/low_pass.hpp"
#include "core/motion_estimator.hpp"

namespace fantail::core {

/// Whether what the plan lets the canards wait for has come. Asked from launch detection on, beside the guide, which
/// every plan waits for.
///
/// Burn-out. The sign of the specific force alone says that thrust is less than drag, which many motors reach seconds
/// before their last thrust, and an accelerometer's zero error can hide. So two things must agree: the low-passed axial
/// specific force is below +0.15 g for 0.1 s, and the burn clock, from first thrust, has passed the plan's factor times
/// the burn time. A pause that ends in thrust again is taken off the clock. Thrust again (1 g for 0.1 s) closes the
/// gate.
///
/// Largest dynamic pressure. The estimate of density times speed squared, in the standard atmosphere above the place of
/// lift-off, has fallen 2 % below its largest value; a new largest value closes the gate. The motor may still burn.
///
/// Height. The low end of what the height can be, given the plan's errors of the accelerometer, has been above the
/// plan's height, or what a barometer makes of that low end. It never closes: what has been above it was. Without an
/// accelerometer for longer than the plan's stale time, or with a gyro at the end of its range, nobody knows height or
/// speed that well: then neither height nor dynamic pressure opens in this flight. Nor do they while two accelerometers
/// disagree: at 20 g two good ones may, but one that lies goes on.
///
/// Nothing here opens by time alone: a gate that is never reached stays closed.
class DormancyGate {
 public:
  /// `plan` has passed validate(); copied.
  [[gnu::cold]] explicit DormancyGate(const DormancyPlan& plan)
      // Not from_seconds(): in a list of initialisers the prover ends with a segmentation fault on a class it returns.
      : plan_{plan}, burn_clock_{millionths(plan.burn_clock_factor * seconds(plan.burn_time))} {}

  /// In every tick from the one after launch detection on, with the motion at `now`,
  /// and whether beyond the guide two accelerometers agree on it. `by_barometer`: the rocket is above this
  /// (BarometricHeight::least_height_m()).
  void update(Microseconds now, const Motion& motion, bool accelerometers_agree = true,
              std::optional<float> by_barometer = std::nullopt);

  /// As of the last update(); true from the beginning for a plan that waits for the guide alone.
  [[nodiscard]] bool is_open() const;

  /// Nobody saw what the rocket did since the last update: a hold begins anew.
  void interrupt() {
    coasts_since_.reset();
    thrust_since_.reset();
  }

  /// Nothing of the last flight: a launch has been detected.
  void reset() { *this = DormancyGate{plan_}; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(axial_, moves_, is_unsure_, coasts_since_, pause_since_, thrust_since_, pauses_, is_burnt_out_,
          largest_pressure_, is_past_pressure_, is_past_height_);
  }

 private:
  void watch_burn(Microseconds now, const Motion& motion);
  void watch_pressure(const Motion& motion, bool sure);
  void watch_height(Microseconds now, const Motion& motion, bool sure, std::optional<float> by_barometer);

  DormancyPlan plan_;
  Microseconds burn_clock_;  ///< from first thrust to when burn-out is believed, pauses left out
  LowPass axial_{8.0F};
  bool moves_ = false;      ///< faster than anybody carries it
  bool is_unsure_ = false;  ///< of height and speed
  std::optional<Microseconds> coasts_since_;
  std::optional<Microseconds> pause_since_;  ///< the same, once it has lasted
  std::optional<Microseconds> thrust_since_;
  Microseconds pauses_{};
  bool is_burnt_out_ = false;
  float largest_pressure_ = 0.0F;
  bool is_past_pressure_ = false;
  bool is_past_height_ = false;
};

}  // namespace fantail::core
