// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"

namespace fantail::fly {

/// Flown after apogee, unless the rocket lands before.
inline constexpr double longest_fall_s = 600.0;

[[nodiscard]] bool has_parachute(const sim::Vehicle& vehicle);

/// A flight in six degrees of freedom from the pad and under the parachute to the ground, however soon after apogee the
/// scenario's own run ends. A fall without a parachute is at angles of attack at which nothing is known of the air
/// loads: there it ends at apogee, or at burn-out where that is later.
class ToGround {
 public:
  explicit ToGround(const sim::Scenario& scenario);

  /// The next millisecond; false: it is over.
  bool tick();

  [[nodiscard]] const sim::World& world() const { return world_; }
  /// From ignition to apogee, or to burn-out where that is later.
  [[nodiscard]] bool is_ascent() const;
  [[nodiscard]] double after_ignition_s(core::Microseconds time) const;
  /// From the foot of the guide: x north, y west. Empty until it has landed under the parachute.
  [[nodiscard]] std::optional<sim::Vector3> landing_m() const { return landing_m_; }

 private:
  sim::Scenario scenario_;  ///< the world refers to it
  sim::World world_;
  core::Microseconds ignition_;
  std::optional<core::Microseconds> ascent_until_{};
  std::optional<sim::Vector3> landing_m_{};
  bool has_begun_ = false;
  bool is_finished_ = false;
  bool is_over_ = false;
};

[[nodiscard]] flight::PathPoint path_point(const sim::Path& path, double time_s);

/// Takes the path of a flight in six degrees of freedom on to the ground under the parachute, however soon after apogee
/// the scenario's own run ended, and notes when the parachute began to open. Does nothing without one.
void add_descent(flight::Flight& flight, sim::World& world, const sim::Scenario& scenario);

/// Where a flight lands. Empty: not under a parachute, or not within longest_fall_s after apogee.
[[nodiscard]] std::optional<sim::Vector3> landing_m(const sim::Scenario& scenario);

}  // namespace fantail::fly
