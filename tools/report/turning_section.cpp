// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "page/page.hpp"
#include "report/phase_colors.hpp"
#include "report/sections.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using flight::TurnPoint;
using page::Role;
using Member = double TurnPoint::*;

page::Series series(const flight::Flight& flight, std::string name, Role role, Member member) {
  page::Series result{.name = std::move(name), .role = role};
  for (const TurnPoint& point : flight.turning) {
    result.x.push_back(point.time_s);
    result.y.push_back(text::degrees(point.*member));
  }
  return result;
}

result::Picture figure(const flight::Flight& flight, std::string label, std::string unit, Member truth,
                       std::pair<const char*, Member> measured) {
  constexpr double height = 220.0;
  page::Chart chart{.label = std::move(label),
                    .x_label = "time / s",
                    .y_label = std::move(unit),
                    .width = page::half_page,
                    .height = height,
                    .series = {series(flight, "true", Role::target, truth),
                               series(flight, measured.first, Role::measured, measured.second)},
                    .sampled = true};
  shade_phases(chart, flight);
  const std::string caption = chart.label + ".";
  return {std::move(chart), caption};
}

/// The pad is not counted: until it has been at rest for a while the avionics does not know how the rocket stands.
std::string how_far_apart(const flight::Flight& flight) {
  double largest_rad = 0.0;
  double error_rad = 0.0;
  for (const TurnPoint& point : flight.turning) {
    if (point.time_s >= 0.0) {
      largest_rad = std::max(largest_rad, point.true_tilt_rad);
      error_rad = std::max(error_rad, std::abs(point.tilt_rad - point.true_tilt_rad));
    }
  }
  return fmt::format(
      "From {} on the rocket tilted by up to {} deg, and the avionics' estimate of the tilt was wrong by at most {} "
      "deg. Points are 10 ms apart; turning.csv beside this page has them.",
      flight.events.control_start_s ? "control start" : "the start command", text::fixed(text::degrees(largest_rad), 1),
      text::fixed(text::degrees(error_rad), 2));
}

}  // namespace

result::Section turning_section(const flight::Flight& flight) {
  if (flight.turning.empty()) {
    return {};
  }
  return {"All three axes",
          {figure(flight, "Roll rate, about the long axis", "deg/s", &TurnPoint::true_roll_rate_rad_s,
                  {"gyro", &TurnPoint::gyro_roll_rate_rad_s}),
           figure(flight, "Pitch rate, about y", "deg/s", &TurnPoint::true_pitch_rate_rad_s,
                  {"gyro", &TurnPoint::gyro_pitch_rate_rad_s}),
           figure(flight, "Yaw rate, about z", "deg/s", &TurnPoint::true_yaw_rate_rad_s,
                  {"gyro", &TurnPoint::gyro_yaw_rate_rad_s}),
           figure(flight, "Tilt of the long axis from the vertical", "deg", &TurnPoint::true_tilt_rad,
                  {"estimate", &TurnPoint::tilt_rad}),
           how_far_apart(flight)},
          result::Readers::files};
}

}  // namespace fantail::report
