// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "logs/interpolator.hpp"
#include "logs/roll_log.hpp"
#include "sim/units.hpp"

namespace fantail::logs {
namespace {

bool is_between(double value, double low, double high) { return low < value && value < high; }

// Angles in degrees that are numbers of radians: no canard turns beyond 34 degrees, and one that controls anything
// turns by more than 3; those are 0.6 and 0.05 rad. What moves that little in degrees hardly turns a rocket, so the
// rate and the steps of the reference are asked, too.
bool looks_like_radians(const RollLog& log) {
  const auto largest_deg = [](const std::vector<double>& list) { return largest(list) / sim::radians_per_degree; };
  return is_between(largest_deg(log.canard_rad), 0.05, 0.6) &&
         is_between(largest_deg(log.roll_rate_rad_s), 0.2, 12.0) && largest_deg(log.roll_angle_rad) > 0.05 &&
         largest_deg(log.reference_rad) < 3.2;
}

bool is_stated(const Reading& reading, files::Quantity quantity) {
  const files::Source* const source = files::find(reading.columns, quantity);
  return source != nullptr && source->unit != nullptr;
}

// "; if they are: --columns rad", for a verb that has the option.
std::string advice(const Reading& reading, std::string_view unit) {
  return reading.options.empty() ? "" : fmt::format("; if they are: {}columns {}", reading.options, unit);
}

// Slope of the roll angle over the integral of the rate, in pieces long enough for noise to be small. Empty when the
// two do not go together at all, or nothing moves.
std::optional<double> angle_over_rate(const RollLog& log) {
  constexpr double piece_s = 0.25;
  double rate_rate = 0.0;
  double rate_angle = 0.0;
  double angle_angle = 0.0;
  std::size_t begin = 0;
  double turned = 0.0;
  for (std::size_t i = 1; i < log.time_s.size(); ++i) {
    const double step_s = log.time_s[i] - log.time_s[i - 1];
    turned += 0.5 * (log.roll_rate_rad_s[i] + log.roll_rate_rad_s[i - 1]) * step_s;
    if (step_s > piece_s) {  // a gap
      begin = i;
      turned = 0.0;
    } else if (log.time_s[i] - log.time_s[begin] >= piece_s) {
      const double angle = log.roll_angle_rad[i] - log.roll_angle_rad[begin];
      rate_rate += turned * turned;
      rate_angle += turned * angle;
      angle_angle += angle * angle;
      begin = i;
      turned = 0.0;
    }
  }
  if (!(rate_rate > 0.0 && angle_angle > 0.0) || rate_angle * rate_angle < 0.8 * rate_rate * angle_angle) {
    return {};
  }
  return rate_angle / rate_rate;
}

}  // namespace

double largest(const std::vector<double>& list) {
  double most = 0.0;
  for (const double value : list) {
    most = std::max(most, std::abs(value));  // not a number: std::max keeps what it has
  }
  return most;
}

void note_doubtful_units(RollLog& log, const Reading& reading) {
  const double canard_rad = largest(log.canard_rad);
  const bool angles_are_stated = is_stated(reading, files::Quantity::canard);
  if (angles_are_stated && canard_rad > 1.6) {
    log.warnings.push_back(
        fmt::format("canard angles reach {} degrees with their stated unit, which is more than any canard turns",
                    input::about(canard_rad / sim::radians_per_degree)));
  }
  if (!angles_are_stated && reading.angles == AngleUnit::degrees && looks_like_radians(log)) {
    log.warnings.push_back(fmt::format("angles look like radians: the largest canard angle is {}{}",
                                       input::about(canard_rad / sim::radians_per_degree), advice(reading, "rad")));
  }
  if (!angles_are_stated && reading.angles == AngleUnit::radians && canard_rad > 1.6) {
    log.warnings.push_back(fmt::format("angles look like degrees: the largest canard angle is {} rad{}",
                                       input::about(canard_rad), advice(reading, "deg")));
  }
  const double interval_s = usual_interval_s(log.time_s);
  constexpr double fastest_logger_s = 2e-5;
  if (is_stated(reading, files::Quantity::time) && (interval_s >= 1.0 || interval_s < fastest_logger_s)) {
    log.warnings.push_back(
        fmt::format("samples are {} s apart with the stated unit of time", input::about(interval_s)));
  } else if (interval_s >= 1.0) {
    log.warnings.push_back(fmt::format(
        "samples are {} s apart: time_s must be in seconds and may be in milliseconds here", input::about(interval_s)));
  }
}

void note_doubtful_motion(RollLog& log) {
  if (log.roll_angle_rad.empty() || log.roll_rate_rad_s.empty()) {
    return;
  }
  const auto slope = angle_over_rate(log);
  if (!slope) {
    return;
  }
  const double off = std::abs(*slope);
  constexpr double degrees_per_radian = 1.0 / sim::radians_per_degree;
  if (is_between(off * degrees_per_radian, 0.7, 1.4) || is_between(off / degrees_per_radian, 0.7, 1.4)) {
    log.warnings.push_back(fmt::format(
        "the roll angle changes {} times as fast as the roll rate indicates: one of them seems to be in radians",
        input::about(off)));
  } else if (*slope < 0.0) {
    log.warnings.push_back("the roll angle falls while the roll rate is positive: one of them has the wrong sign");
  }
}

}  // namespace fantail::logs
