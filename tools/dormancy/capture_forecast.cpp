// SPDX-License-Identifier: MIT
#include "dormancy/capture_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dormancy/opening.hpp"
#include "sim/units.hpp"
#include "stability/margins_asked.hpp"
#include "stability/roll_loop.hpp"
#include "text/degrees.hpp"

namespace fantail::dormancy {
namespace {

using std::numbers::pi;

// What core::Capture lets a share be.
constexpr double largest_share = 0.9;

// An offset beyond this share of the limit leaves so little to brake with that the last degrees take longer than the
// linear loop says: no promise.
constexpr double largest_promised_share = 0.8;

double damping_rate_per_s(const RollAtEntry& e, double speed_m_s) {
  return e.plant.damping_rate_per_s(e.density_kg_m3, speed_m_s);
}

double authority_per_s2(const RollAtEntry& e, double speed_m_s) {
  return e.plant.authority_per_s2(e.density_kg_m3, speed_m_s);
}

/// 1 / c: in so many metres a roll rate falls to a third.
double dying_path_m(const RollAtEntry& e) { return e.speed_m_s / damping_rate_per_s(e, e.speed_m_s); }

/// Of the speed squared: how fast drag slows it.
double drag_1_m(const RollAtEntry& e) { return 0.5 * e.density_kg_m3 * e.drag_per_mass_m2_kg; }

double way_per_rad(const RollAtEntry& e) { return e.plant.damping_m2 / e.plant.torque_m; }

/// What core::Capture counts on the way to a stand.
double believed_stop_s(const RollAtEntry& e) {
  return e.has_model ? 1.0 / damping_rate_per_s(e, e.speed_m_s) : e.derivative_gain_s / e.proportional_gain;
}

/// Where the law comes to rest beside its reference.
double rest_rad(const RollAtEntry& e) { return e.rejects_offset() ? 0.0 : e.offset_rad / e.proportional_gain; }

bool can_hold(const RollAtEntry& e) {
  return e.plant.damping_m2 > 0.0 && e.plant.torque_m > 0.0 && e.proportional_gain > 0.0 &&
         std::abs(e.offset_rad) < e.limit_rad;
}

/// By so many radians, signed, with the canards at their limit.
double path_for_m(const RollAtEntry& e, double angle_rad) {
  const double canards_rad = e.limit_rad + std::copysign(1.0, angle_rad) * e.offset_rad;
  return way_per_rad(e) * std::abs(angle_rad) / canards_rad;
}

/// From the angle at which the law takes the canards off their limit to the last degrees, in the air of this speed: the
/// slower pole of the linear loop, and no faster than its phase margin lets a swing die. Empty: it may not settle.
std::optional<double> last_degrees_s(const RollAtEntry& e, double speed_m_s) {
  constexpr double least_margin_rad = stability::least_phase_margin_rad;
  const double a = damping_rate_per_s(e, speed_m_s);
  const double b = authority_per_s2(e, speed_m_s);
  double rate_per_s = 0.5 * (a + b * e.derivative_gain_s);
  rate_per_s -= std::sqrt(std::max(0.0, rate_per_s * rate_per_s - b * e.proportional_gain));
  const auto margins = stability::margins({.proportional_gain = e.proportional_gain,
                                           .derivative_gain_s = e.derivative_gain_s,
                                           .integral_gain_per_s = e.integral_gain_per_s,
                                           .damping_rate_per_s = a,
                                           .authority_per_s2 = b,
                                           .servo_lag_s = e.servo_lag_s,
                                           .delay_s = e.delay_s});
  if (margins) {
    if (margins->phase_margin_rad < least_margin_rad) {
      return std::nullopt;
    }
    rate_per_s =
        std::min(rate_per_s, margins->crossover_rad_s * std::tan(0.5 * std::min(margins->phase_margin_rad, 0.5 * pi)));
  }
  if (e.integral_gain_per_s > 0.0) {
    rate_per_s = std::min(rate_per_s, 0.5 * e.integral_gain_per_s / e.proportional_gain);
  } else if (e.observer_bandwidth_rad_s > 0.0) {
    rate_per_s = std::min(rate_per_s, 0.5 * e.observer_bandwidth_rad_s);
  }
  const double strongest_rad = e.limit_rad + std::abs(e.offset_rad);
  const double from_rad =
      strongest_rad * (1.0 + e.derivative_gain_s * speed_m_s / way_per_rad(e)) / e.proportional_gain;
  return std::max(0.0, std::log(from_rad / captured_rad)) / rate_per_s;
}

/// A law begins to brake kd / kp of the rate before its rest, servo lag and dead time apart, and brakes with all that
/// the canards have against the offset L - |u_d| over kp later. Where they need a longer angle than is left then, the
/// rocket goes past its rest, stops and has to come back: so long a way more. Past it by less than half of captured_rad
/// it stays captured.
double way_back_m(const RollAtEntry& e, double path) {
  const double offset_rad = std::abs(e.offset_rad);
  const double brake_rad = e.limit_rad - offset_rad;
  const double steady_rad_s = e.speed_m_s * (e.limit_rad + offset_rad) / way_per_rad(e);
  const double rate_rad_s = std::max(std::abs(e.rate_rad_s), steady_rad_s * -std::expm1(-path / dying_path_m(e)));
  const auto stop_s = [&](double speed_m_s) {
    const double q = speed_m_s * brake_rad / way_per_rad(e);
    return std::log1p(rate_rad_s / q) / damping_rate_per_s(e, speed_m_s);
  };
  // In the air of the speed that is left when it has stopped.
  const double slowing_m_s2 = sim::gravity_m_s2 + drag_1_m(e) * e.speed_m_s * e.speed_m_s;
  const double speed_m_s = std::max(slowest_held_m_s, e.speed_m_s - slowing_m_s2 * stop_s(e.speed_m_s));
  const double stop_rad =
      rate_rad_s / damping_rate_per_s(e, speed_m_s) - speed_m_s * brake_rad / way_per_rad(e) * stop_s(speed_m_s);
  const double brakes_for_s = e.derivative_gain_s / e.proportional_gain - e.servo_lag_s - e.delay_s;
  const double past_rad = stop_rad - rate_rad_s * brakes_for_s + brake_rad / e.proportional_gain;
  return past_rad > 0.5 * captured_rad
             ? speed_m_s * stop_s(speed_m_s) + way_per_rad(e) * past_rad / brake_rad + dying_path_m(e)
             : 0.0;
}

struct Promise {
  std::optional<double> within_s{};
  std::string_view why_none{};
};

Promise captured_after_path(const RollAtEntry& e, std::optional<double> path) {
  constexpr std::string_view slow = "by then the air may be too slow";
  if (std::abs(e.offset_rad) > largest_promised_share * e.limit_rad) {
    return {.why_none = "the fin offset needs more than 80 % of the canards' limit"};
  }
  // An estimate of the offset that begins wrong drives the rocket away first, nobody knows how far.
  if (e.rejects_offset() && !(e.has_model && e.share)) {
    return {.why_none = e.has_model ? "[roll_model] is not that of this vehicle, or the gate opens too soon"
                                    : "the law rejects the offset, and the plan has no [roll_model]"};
  }
  if (!path) {
    return {.why_none = "the canards cannot hold an angle"};
  }
  const double way_m = *path + dying_path_m(e) + way_back_m(e, *path);
  const auto on_the_way_s = time_for_path_s(e, way_m);
  const auto stop_s = earliest_stop_s(e);
  if (!on_the_way_s || !stop_s || way_m >= path_to_slow_m(e)) {
    return {.why_none = slow};
  }
  const double v2 = e.speed_m_s * e.speed_m_s;
  const double k = drag_1_m(e);
  const double terminal2 = sim::gravity_m_s2 / k;
  const double speed_then_m_s = std::sqrt((v2 + terminal2) * std::exp(-2.0 * k * way_m) - terminal2);
  const auto last_s = last_degrees_s(e, speed_then_m_s);
  if (!last_s || !last_degrees_s(e, e.speed_m_s)) {
    return {.why_none = "the loop may not settle at this speed"};
  }
  const double within_s = e.servo_lag_s + e.delay_s + std::max(*on_the_way_s, *stop_s) + *last_s;
  const double slow_s = time_for_path_s(e, path_to_slow_m(e)).value_or(0.0);
  return within_s + shortest_capture_s < slow_s ? Promise{.within_s = within_s} : Promise{.why_none = slow};
}

}  // namespace

std::optional<double> residual_rate_rad_s(const RollAtEntry& e) {
  const double left_rad = std::abs(e.offset_rad) - e.limit_rad;
  if (left_rad < 0.0 || !(e.plant.damping_m2 > 0.0)) {
    return std::nullopt;
  }
  return std::copysign(e.speed_m_s * left_rad / way_per_rad(e), e.offset_rad);
}

std::optional<double> earliest_stop_s(const RollAtEntry& e) {
  const double a = damping_rate_per_s(e, e.speed_m_s);
  const double against_rad = e.limit_rad - std::copysign(1.0, e.rate_rad_s) * e.offset_rad;
  if (against_rad <= 0.0 || !(a > 0.0)) {
    return std::nullopt;
  }
  const double q = authority_per_s2(e, e.speed_m_s) * against_rad / a;
  return e.servo_lag_s + e.delay_s + std::log1p(std::abs(e.rate_rad_s) / q) / a;
}

std::optional<double> path_m(const RollAtEntry& e) {
  if (!can_hold(e) || !e.share) {
    return std::nullopt;
  }
  const double comes_to_rad = e.ahead_rad + e.rate_rad_s / damping_rate_per_s(e, e.speed_m_s);
  const double believed_rad = e.ahead_rad + e.rate_rad_s * believed_stop_s(e);
  const double turns = std::round((believed_rad + pi * *e.share) / (2.0 * pi));
  return path_for_m(e, 2.0 * pi * turns + rest_rad(e) - comes_to_rad);
}

std::optional<double> longest_path_m(const RollAtEntry& e) {
  if (!can_hold(e)) {
    return std::nullopt;
  }
  const double error_rad = e.rate_rad_s * (believed_stop_s(e) - 1.0 / damping_rate_per_s(e, e.speed_m_s));
  const auto longest = [&e, beside_rad = rest_rad(e) + error_rad](double share) {
    return std::max(path_for_m(e, pi * (1.0 + share) + beside_rad), path_for_m(e, pi * (share - 1.0) + beside_rad));
  };
  return e.share ? longest(*e.share) : std::max(longest(largest_share), longest(-largest_share));
}

double path_to_slow_m(const RollAtEntry& e) {
  const double k = drag_1_m(e);
  const double terminal2 = sim::gravity_m_s2 / k;
  const double slow2 = slowest_held_m_s * slowest_held_m_s;
  return std::max(0.0, std::log((e.speed_m_s * e.speed_m_s + terminal2) / (slow2 + terminal2)) / (2.0 * k));
}

std::optional<double> time_for_path_s(const RollAtEntry& e, double path) {
  const double k = drag_1_m(e);
  const double terminal = std::sqrt(sim::gravity_m_s2 / k);
  const double then2 =
      (e.speed_m_s * e.speed_m_s + terminal * terminal) * std::exp(-2.0 * k * path) - terminal * terminal;
  if (then2 < 0.0) {
    return std::nullopt;
  }
  return terminal / sim::gravity_m_s2 * (std::atan(e.speed_m_s / terminal) - std::atan(std::sqrt(then2) / terminal));
}

std::optional<double> captured_within_s(const RollAtEntry& e) { return captured_after_path(e, path_m(e)).within_s; }

std::optional<double> captured_from_any_angle_within_s(const RollAtEntry& e) {
  return captured_after_path(e, longest_path_m(e)).within_s;
}

std::string_view why_no_capture_time(const RollAtEntry& e) {
  return captured_after_path(e, longest_path_m(e)).why_none;
}

}  // namespace fantail::dormancy
