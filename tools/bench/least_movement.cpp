// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "bench/exercise.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;

std::string in_words(double angle_rad) { return text::fixed(degrees(angle_rad), 2); }

// To the side on which the sentence stays true.
double hundredths_up(double angle_rad) { return 0.01 * std::ceil(100.0 * degrees(angle_rad) - 1e-6); }

std::string steps_allowed(double centre_rad, double limit_rad, double least_rad) {
  const std::string below = text::fixed(-hundredths_up(least_rad - centre_rad), 2);
  const std::string above = text::fixed(hundredths_up(centre_rad + least_rad), 2);
  const bool has_below = centre_rad - least_rad >= -limit_rad;
  const bool has_above = centre_rad + least_rad <= limit_rad;
  if (!has_below && !has_above) {
    return fmt::format("no angle within its limit of {} deg is large enough", in_words(limit_rad));
  }
  return fmt::format("the angle must be {}{}{} deg", has_below ? "at most " + below : "",
                     has_below && has_above ? " or " : "", has_above ? "at least " + above : "");
}

void expect_enough_step(double to_rad, double centre_rad, double limit_rad, std::size_t canard,
                        const sim::CanardTolerances& t) {
  const double least_rad = least_step_rad(t);
  if (std::abs(to_rad - centre_rad) >= least_rad) {
    return;
  }
  throw std::invalid_argument{
      fmt::format("--to: canard {} would step from its trim of {} deg to {} deg, by {} deg; {}. With reach_deg {:g}, "
                  "centring_deg {:g} and half of backlash_deg {:g}, a canard that does not move may be {} deg off",
                  canard + 1, in_words(centre_rad), in_words(to_rad), in_words(std::abs(to_rad - centre_rad)),
                  steps_allowed(centre_rad, limit_rad, least_rad), degrees(t.reach_rad), degrees(t.centring_rad),
                  degrees(t.backlash_rad), in_words(least_rad))};
}

void expect_enough_amplitude(double way_rad, const Exercise::Wave& wave, double limit_rad, std::size_t canard,
                             const sim::CanardTolerances& t) {
  const double least_rad = least_amplitude_rad(wave.frequency_hz, t);
  if (way_rad >= least_rad) {
    return;
  }
  if (degrees(least_rad) > widest_request_deg) {
    throw std::invalid_argument{
        fmt::format("--frequency: at {:g} Hz no amplitude up to {} deg shows whether a canard is fast enough. One with "
                    "slowest_slew_deg_s {:g} and longest_step_time_s {:g} moves less than twice reach_deg {:g}",
                    wave.frequency_hz, widest_request_deg, degrees(t.slowest_slew_rad_s), t.longest_step_time_s,
                    degrees(t.reach_rad))};
  }
  const bool cut_off = way_rad < std::abs(wave.amplitude_rad);
  throw std::invalid_argument{fmt::format(
      "--amplitude: canard {} would move {} deg to each side{}; at {:g} Hz it must be {:.2f} to {} deg. Below that, "
      "reach_deg {:g} and backlash_deg {:g} hide too much of the movement of a canard with longest_step_time_s {:g}",
      canard + 1, in_words(way_rad),
      cut_off ? fmt::format(", on average, within its limit of {} deg", in_words(limit_rad)) : std::string{},
      wave.frequency_hz, hundredths_up(least_rad), widest_request_deg, degrees(t.reach_rad), degrees(t.backlash_rad),
      t.longest_step_time_s)};
}

}  // namespace

double least_step_rad(const sim::CanardTolerances& t) { return t.reach_rad + t.centring_rad + 0.5 * t.backlash_rad; }

// A first-order lag that just meets the step time; at its fastest a rate limit makes triangles. What may be missing is
// to be no more than half of the way, and with all the play allowed the canard must go farther than may be missing.
double least_amplitude_rad(double frequency_hz, const sim::CanardTolerances& t) {
  constexpr double pi = std::numbers::pi;
  const double farthest_rad = 2.0 * t.slowest_slew_rad_s / (pi * pi * frequency_hz);
  if (farthest_rad < 2.0 * t.reach_rad) {
    return std::numeric_limits<double>::infinity();
  }
  const double smaller = std::hypot(1.0, 2.0 * pi * frequency_hz * t.longest_step_time_s / std::log(9.0));
  return std::max(2.0 * t.reach_rad * smaller, t.reach_rad + 0.5 * t.backlash_rad);
}

void expect_enough_movement(const Exercise& exercise, std::size_t canard, const sim::CanardTolerances& tolerances) {
  const double limit_rad = exercise.bounds().limit_rad[canard];
  const double centre_rad = exercise.bounds().centre_rad[canard];
  const auto kept = [limit_rad](double angle_rad) { return std::clamp(angle_rad, -limit_rad, limit_rad); };
  switch (exercise.kind()) {
    case ExerciseKind::limits: break;
    case ExerciseKind::step: {
      const auto step = std::ranges::find(exercise.stretches(), Part::step_out, &Stretch::part);
      expect_enough_step(kept(step->to_rad[canard]), centre_rad, limit_rad, canard, tolerances);
      break;
    }
    case ExerciseKind::sine: {
      const double amplitude_rad = exercise.wave()->amplitude_rad;
      const double way_rad = std::abs(kept(centre_rad + amplitude_rad) - kept(centre_rad - amplitude_rad));
      expect_enough_amplitude(0.5 * way_rad, *exercise.wave(), limit_rad, canard, tolerances);
      break;
    }
  }
}

}  // namespace fantail::bench
