// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "sim/roll_plant.hpp"

namespace fantail::dormancy {

/// A rocket that coasts as control begins, for closed forms by the model of roll (Eq 1-3):
///   p' = -a p + b (u + u_d),   a = rho v A alpha / (2 I),   b = rho v^2 A beta / (2 I).
/// Over the way x through the air, of which each metre is v dt, the speed drops out of it: with c = a / v
///   d(p/v)/dx = -c p/v + c (beta / alpha) (u + u_d),
/// but for what the rocket slows down meanwhile.
struct RollAtEntry {
  sim::RollPlant plant{};
  double density_kg_m3 = 1.225;
  double speed_m_s = 0.0;            ///< above zero
  double drag_per_mass_m2_kg = 0.0;  ///< drag area over mass: how fast it slows down; above zero
  double rate_rad_s = 0.0;
  double ahead_rad = 0.0;          ///< roll angle less the reference of the plan, whole turns and all
  double offset_rad = 0.0;         ///< u_d
  double limit_rad = 0.0;          ///< L: so far the canards go both ways
  double proportional_gain = 0.0;  ///< kp and kd, the gain schedule in them
  double derivative_gain_s = 0.0;
  double integral_gain_per_s = 0.0;  ///< zero, as the next: the law does not reject the offset so
  double observer_bandwidth_rad_s = 0.0;
  double servo_lag_s = 0.0;
  double delay_s = 0.0;    ///< all dead time of the loop
  bool has_model = false;  ///< the plan has: without it core::Capture counts kd / kp for 1 / (c v)
  /// f of core::Capture, by which it lets the two ways differ. Empty: nobody knows what it makes of the spin, because
  /// it has not watched the spin for long.
  std::optional<double> share{};

  /// The law comes to rest at the reference, and else u_d / kp beside it.
  [[nodiscard]] bool rejects_offset() const { return integral_gain_per_s > 0.0 || observer_bandwidth_rad_s > 0.0; }
};

/// Where the rotation ends with the canards at their limit against an offset that is not smaller: alpha p = beta v
/// (|u_d| - L). With the sense of the offset. Empty: they can stop it.
[[nodiscard]] std::optional<double> residual_rate_rad_s(const RollAtEntry& entry);

/// When full canards against the rotation have stopped it, at this speed, after servo lag and dead time. Empty: never.
///   t = lag + delay + ln(1 + |p| / q) / a,   q = b (L - sgn(p) u_d) / a
[[nodiscard]] std::optional<double> earliest_stop_s(const RollAtEntry& entry);

/// The way to rest at R + u_d / kp and the whole turn of core::Capture, canards at their limit: what is left of
/// phi + p / (c v) by (beta / alpha) (L +- |u_d|) a metre. Needs the share.
[[nodiscard]] std::optional<double> path_m(const RollAtEntry& entry);

/// The longest such way from any angle. With f = u_d / L and a law that rejects the offset: (alpha / beta) pi / L.
[[nodiscard]] std::optional<double> longest_path_m(const RollAtEntry& entry);

/// The way until a coasting rocket, going straight up, is too slow (slowest_held_m_s), and how long it takes for a way.
[[nodiscard]] double path_to_slow_m(const RollAtEntry& entry);
/// Empty: it does not come that far.
[[nodiscard]] std::optional<double> time_for_path_s(const RollAtEntry& entry, double path_m);

/// Why captured_from_any_angle_within_s() promises nothing, a clause; empty: it does.
[[nodiscard]] std::string_view why_no_capture_time(const RollAtEntry& entry);

/// Within this time after control begins the roll is captured (see Opening), from its angle or from any. Cautious: the
/// way, the metres 1 / c in which canards set the rocket turning, and what the law takes for the last degrees. Empty:
/// nothing is promised.
[[nodiscard]] std::optional<double> captured_within_s(const RollAtEntry& entry);
[[nodiscard]] std::optional<double> captured_from_any_angle_within_s(const RollAtEntry& entry);

}  // namespace fantail::dormancy
