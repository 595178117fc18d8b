// SPDX-License-Identifier: MIT
#include "bench/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;
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

Check reached(Measure measure, const std::optional<double>& radians, double told_rad, const Figures& f,
              const sim::CanardTolerances& t) {
  Check result = within(measure, radians, told_rad, t.reach_rad);
  // The bus ends at 20.47 deg: what reads so may stand anywhere beyond.
  result.passed = result.passed && !f.saturated;
  return result;
}

// As far as a servo that is just quick enough, give or take what may be missing at a limit: a share of what was asked
// for, because a command that came out smaller would allow more.
Check follows_wave(const Figures& f, const sim::CanardTolerances& t) {
  if (!f.asked_amplitude_rad || !f.slowest_ratio) {
    return between(Measure::amplitude_ratio, std::nullopt, std::nullopt, std::nullopt);
  }
  const double share = t.reach_rad / *f.asked_amplitude_rad;
  const double lowest = *f.slowest_ratio - share;
  return between(Measure::amplitude_ratio, f.amplitude_ratio, lowest > 0.0 ? std::optional{lowest} : std::nullopt,
                 1.0 + share);
}

}  // namespace

const MeasureText& text_of(Measure measure) {
  // In the order of Measure.
  static constexpr std::array<MeasureText, 15> texts{{{"sign", "Sign", "", 0},
                                                      {"reached_positive_deg", "Reached, positive", "deg", 2},
                                                      {"reached_negative_deg", "Reached, negative", "deg", 2},
                                                      {"reached_positive_deg", "Reached", "deg", 2},
                                                      {"largest_command_deg", "Largest command", "deg", 2},
                                                      {"limit_reported", "Clamping reported", "", 0},
                                                      {"tracking_error_deg", "Tracking error", "deg", 2},
                                                      {"centring_error_deg", "Centring error", "deg", 2},
                                                      {"backlash_deg", "Backlash", "deg", 2},
                                                      {"slew_deg_s", "Slew rate", "deg/s", 0},
                                                      {"step_time_s", "Step, 10 to 90 %", "s", 3},
                                                      {"noise_deg", "Encoder noise", "deg", 3},
                                                      {"dropout_percent", "Encoder dropouts", "%", 2},
                                                      {"amplitude_ratio", "Amplitude ratio", "", 3},
                                                      {"others_moved_deg", "Others moved", "deg", 2}}};
  static_assert(static_cast<std::size_t>(Measure::others_moved) + 1 == texts.size());
  return texts[static_cast<std::size_t>(measure)];
}

std::string allowed_text(const Check& check) {
  const int decimals = text_of(check.measure).decimals;
  if (check.measure == Measure::sign) {
    return "+";
  }
  if (check.measure == Measure::limit_reported) {
    return "yes";
  }
  if (check.lowest && check.highest) {
    return fixed(*check.lowest, decimals) + " to " + fixed(*check.highest, decimals);
  }
  return check.lowest    ? "at least " + fixed(*check.lowest, decimals)
         : check.highest ? "at most " + fixed(*check.highest, decimals)
                         : std::string{};
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

double least_travel_rad() { return text::radians(0.5); }

bool too_little_travel(const Bounds& bounds, std::size_t canard) {
  const double half_bus_step_rad = text::radians(0.005);
  return bounds.limit_rad[canard] - std::abs(bounds.centre_rad[canard]) < least_travel_rad() - half_bus_step_rad;
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
      reached(Measure::reached, f.reached_positive_rad, f.told_positive_rad.value_or(0.0), f, t),
      at_most(Measure::limit_kept, f.largest_command_rad, limit_rad),
      between(Measure::limit_reported, reported, 1.0, 1.0),
      at_most(Measure::tracking_error, f.tracking_error_rad, t.tracking_rad),
      within(Measure::centring_error, f.centring_error_rad, 0.0,
             // A sine shows the centre from one side alone: half of the play is in it.
             t.centring_rad + (f.amplitude_rad ? 0.5 * t.backlash_rad : 0.0)),
      at_most(Measure::backlash, f.backlash_rad, t.backlash_rad),
      between(Measure::slew, in_degrees(f.slew_rad_s),
              degrees(required_slew_rad_s(f.slew_way_rad.value_or(2.0 * limit_rad), t)), std::nullopt),
      between(Measure::step_time, f.step_time_s, std::nullopt, t.longest_step_time_s),
      at_most(Measure::noise, f.noise_rad, t.noise_rad),
      between(Measure::dropouts, 100.0 * f.dropout_share(), std::nullopt, 100.0 * t.dropout_share),
      follows_wave(f, t),
  };
  all[4].passed = f.largest_command_rad && !beyond_limit(f, limit_rad);  // reports come in steps
  if (alone) {
    Check others = at_most(Measure::others_moved, f.others_moved_rad, most_others_move_rad());
    // Nobody to be seen is nobody's fault: the others' encoders have their own turn.
    others.passed = others.passed || !others.value;
    all.push_back(others);
  }
  return all;
}

}  // namespace fantail::bench
