// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "bench/signal.hpp"
#include "bench/turn_figures.hpp"

namespace fantail::bench {
namespace {

bool reported_in(const Course& course, const Window& window) {
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (course.limited[i]) {
      return true;
    }
  }
  return false;
}

// Way from the centre over the way commanded.
std::optional<double> share(const std::optional<double>& reached_rad, const std::optional<double>& told_rad,
                            double centre_rad, double told_centre_rad) {
  constexpr double least_way_rad = 1e-3;
  if (!reached_rad || !told_rad || std::abs(*told_rad - told_centre_rad) < least_way_rad) {
    return std::nullopt;
  }
  return (*reached_rad - centre_rad) / (*told_rad - told_centre_rad);
}

}  // namespace

void add_ends(const Course& course, Figures& f) {
  const Window above = at_rest(course, Part::hold_positive);
  const Window below = at_rest(course, Part::hold_negative);
  f.reached_positive_rad = level_rad(course, above);
  f.reached_negative_rad = level_rad(course, below);
  f.saturated = beyond_bus(f.reached_positive_rad.value_or(0.0)) || beyond_bus(f.reached_negative_rad.value_or(0.0));
  if (above.size() == 0 || below.size() == 0) {
    return;
  }
  f.limit_reported = reported_in(course, above) && reported_in(course, below);
  f.told_positive_rad = course.command_rad[above.end - 1];
  f.told_negative_rad = course.command_rad[below.end - 1];
  const double told_rad = *f.told_positive_rad - *f.told_negative_rad;
  if (f.reached_positive_rad && f.reached_negative_rad && told_rad > 0.0) {
    f.gain = (*f.reached_positive_rad - *f.reached_negative_rad) / told_rad;
  }
}

void add_centre(const Course& course, Figures& f) {
  const Window above = at_rest(course, Part::centre_from_above);
  const Window below = at_rest(course, Part::centre_from_below);
  const auto from_above = level_rad(course, above);
  const auto from_below = level_rad(course, below);
  if (!from_above || !from_below) {
    return;
  }
  const double told_rad = course.command_rad[above.end - 1];
  f.from_above_rad = *from_above - told_rad;
  f.from_below_rad = *from_below - course.command_rad[below.end - 1];
  f.centring_error_rad = 0.5 * (*f.from_above_rad + *f.from_below_rad);
  f.backlash_rad = std::abs(*f.from_above_rad - *f.from_below_rad);
  const double centre_rad = told_rad + *f.centring_error_rad;
  f.positive_share = share(f.reached_positive_rad, f.told_positive_rad, centre_rad, told_rad);
  f.negative_share = share(f.reached_negative_rad, f.told_negative_rad, centre_rad, told_rad);
}

void add_rest(const Course& course, Figures& f) {
  double squares = 0.0;
  double readings = 0.0;
  double levels = 0.0;
  double counted = 0.0;
  for (const Part part : {Part::settle, Part::hold_positive, Part::centre_from_above, Part::hold_negative,
                          Part::centre_from_below, Part::step_out, Part::step_home}) {
    const Window window = at_rest(course, part);
    if (const auto rest = rest_of(course, window)) {
      squares += rest->variance_rad2 * (rest->readings - 2.0);
      readings += rest->readings - 2.0;
      f.drift_rad_s = std::max(f.drift_rad_s.value_or(0.0), std::abs(rest->drift_rad_s));
    }
    if (const auto level = level_rad(course, window)) {
      levels += *level;
      counted += 1.0;
    }
  }
  if (readings > 0.0) {
    f.noise_rad = std::sqrt(squares / readings);
  }
  if (counted > 0.0) {
    f.stands_at_rad = levels / counted;
  }
}

}  // namespace fantail::bench
