// SPDX-License-Identifier: MIT
#include "bench/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::in_degrees;

const double command_resolution_rad = text::radians(0.02);  // two steps of the bus

Check between(Measure measure, const std::optional<double>& value, std::optional<double> lowest,
              std::optional<double> highest) {
  const bool passed = value && (!lowest || *value >= *lowest) && (!highest || *value <= *highest);
  return {.measure = measure, .value = value, .lowest = lowest, .highest = highest, .passed = passed};
}

Check within(Measure measure, const std::optional<double>& radians, double middle_rad, double tolerance_rad) {
  return between(measure, in_degrees(radians), degrees(middle_rad - tolerance_rad),
                 degrees(middle_rad + tolerance_rad));
}

Check at_most(Measure measure, const std::optional<double>& radians, double highest_rad) {
  return between(measure, in_degrees(radians), std::nullopt, degrees(highest_rad));
}

Check reached(Measure measure, const std::optional<double>& radians, double limit_rad, const Figures& f,
              const sim::CanardTolerances& t) {
  Check result = within(measure, radians, limit_rad, t.reach_rad);
  // The bus ends at 20.47 deg: what reads so may stand anywhere beyond.
  result.passed = result.passed && !f.saturated;
  return result;
}

}  // namespace

MeasureWords words(Measure measure) {
  switch (measure) {
    case Measure::sign: return {"sign", "Sign", "", 0};
    case Measure::reached_positive: return {"reached_positive_deg", "Reached, positive", "deg", 2};
    case Measure::reached_negative: return {"reached_negative_deg", "Reached, negative", "deg", 2};
    case Measure::limit_kept: return {"largest_command_deg", "Largest command", "deg", 2};
    case Measure::limit_reported: return {"limit_reported", "Clamping reported", "", 0};
    case Measure::tracking_error: return {"tracking_error_deg", "Tracking error", "deg", 2};
    case Measure::centring_error: return {"centring_error_deg", "Centring error", "deg", 2};
    case Measure::backlash: return {"backlash_deg", "Backlash", "deg", 2};
    case Measure::slew: return {"slew_deg_s", "Slew rate", "deg/s", 0};
    case Measure::step_time: return {"step_time_s", "Step, 10 to 90 %", "s", 3};
    case Measure::noise: return {"noise_deg", "Encoder noise", "deg", 3};
    case Measure::dropouts: return {"dropout_percent", "Encoder dropouts", "%", 2};
    case Measure::others_moved: return {"others_moved_deg", "Others moved", "deg", 2};
  }
  return {"unknown", "Unknown", "", 2};
}

bool beyond_limit(const Figures& figures, double limit_rad) {
  return figures.largest_command_rad && *figures.largest_command_rad > limit_rad + command_resolution_rad;
}

double required_slew_rad_s(double way_rad, const sim::CanardTolerances& tolerances) {
  constexpr double measured_over_s = 0.01;
  const double longest_lag_s = tolerances.longest_step_time_s / std::log(9.0);
  const double reachable_rad_s = way_rad * (1.0 - std::exp(-measured_over_s / longest_lag_s)) / measured_over_s;
  return std::min(tolerances.slowest_slew_rad_s, reachable_rad_s);
}

double most_others_move_rad() { return text::radians(0.5); }

std::vector<Check> check(const Figures& f, const Bounds& bounds, std::size_t canard, bool alone,
                         const sim::CanardTolerances& t) {
  const double limit_rad = bounds.limit_rad[canard];
  const std::optional<double> sign = f.sign ? std::optional{static_cast<double>(*f.sign)} : std::nullopt;
  const std::optional<double> reported = f.limit_reported ? std::optional{*f.limit_reported ? 1.0 : 0.0} : std::nullopt;
  std::vector<Check> all{
      between(Measure::sign, sign, 1.0, 1.0),
      reached(Measure::reached_positive, f.reached_positive_rad, limit_rad, f, t),
      reached(Measure::reached_negative, f.reached_negative_rad, -limit_rad, f, t),
      at_most(Measure::limit_kept, f.largest_command_rad, limit_rad),
      between(Measure::limit_reported, reported, 1.0, 1.0),
      at_most(Measure::tracking_error, f.tracking_error_rad, t.tracking_rad),
      within(Measure::centring_error, f.centring_error_rad, 0.0, t.centring_rad),
      at_most(Measure::backlash, f.backlash_rad, t.backlash_rad),
      between(Measure::slew, in_degrees(f.slew_rad_s),
              degrees(required_slew_rad_s(f.slew_way_rad.value_or(2.0 * limit_rad), t)), std::nullopt),
      between(Measure::step_time, f.step_time_s, std::nullopt, t.longest_step_time_s),
      at_most(Measure::noise, f.noise_rad, t.noise_rad),
      between(Measure::dropouts, 100.0 * f.dropout_share(), std::nullopt, 100.0 * t.dropout_share),
  };
  all[3].passed = f.largest_command_rad && !beyond_limit(f, limit_rad);  // reports come in steps
  if (alone) {
    Check others = at_most(Measure::others_moved, f.others_moved_rad, most_others_move_rad());
    // Nobody to be seen is nobody's fault: the others' encoders have their own turn.
    others.passed = others.passed || !others.value;
    all.push_back(others);
  }
  return all;
}

}  // namespace fantail::bench
