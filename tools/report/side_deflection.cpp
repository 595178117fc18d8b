// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "report/figures.hpp"

namespace fantail::report {
namespace {

constexpr double density_kg_m3 = 1.225;

std::optional<double> across_rad(const core::CanardsPlan& plan, const flight::Row& row) {
  std::array<double, core::canard_count> roll_rad{};
  for (std::size_t i = 0; i < roll_rad.size(); ++i) {
    if (!row.encoders_rad[i]) {
      return {};
    }
    roll_rad[i] = deflection_rad(plan.each[i], *row.encoders_rad[i]);
  }
  // Two that are opposite and roll alike push to opposite sides.
  return std::hypot(roll_rad[0] - roll_rad[2], roll_rad[1] - roll_rad[3]);
}

}  // namespace

double deflection_rad(const core::CanardPlan& canard, double angle_rad) {
  const double from_trim_rad = angle_rad - static_cast<double>(canard.trim.radians());
  return canard.direction == core::Direction::reversed ? -from_trim_rad : from_trim_rad;
}

std::optional<SideDeflection> side_deflection(const flight::Flight& flight, std::span<const flight::Row> control) {
  if (!flight.known.plan) {
    return {};
  }
  SideDeflection side;
  std::size_t count = 0;
  for (const flight::Row& row : control) {
    const std::optional<double> rad = across_rad(flight.plan.canards, row);
    if (!rad || row.phase != core::Phase::controlling) {
      continue;
    }
    ++count;
    side.mean_rad += *rad;
    side.largest_rad = std::max(side.largest_rad, *rad);
    const double speed_m_s = flight::best_known(row, &flight::Truth::speed_m_s, row.speed_m_s);
    if (flight.side_moment_m3 && std::isfinite(speed_m_s)) {
      const double moment_n_m = 0.5 * density_kg_m3 * speed_m_s * speed_m_s * *flight.side_moment_m3 * *rad;
      side.largest_moment_n_m = std::max(side.largest_moment_n_m.value_or(0.0), moment_n_m);
    }
  }
  if (count == 0) {
    return {};
  }
  side.mean_rad /= static_cast<double>(count);
  return side;
}

}  // namespace fantail::report
