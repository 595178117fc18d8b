// SPDX-License-Identifier: MIT
#include "sim/thrust_curve.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "sim/shown.hpp"

namespace fantail::sim {
std::optional<std::string> ThrustCurve::objection(const ThrustPoint* previous, const ThrustPoint& next) {
  if (!std::isfinite(next.time_s) || next.time_s < 0.0) {
    return "time " + shown(next.time_s) + " s; allowed: a finite number, not before ignition";
  }
  if (!std::isfinite(next.thrust_n) || next.thrust_n < 0.0) {
    return "thrust " + shown(next.thrust_n) + " N; allowed: a finite number, not negative";
  }
  if (previous != nullptr && next.time_s <= previous->time_s) {
    return "time " + shown(next.time_s) + " s comes after " + shown(previous->time_s) + " s; allowed: only forwards";
  }
  return std::nullopt;
}

ThrustCurve::ThrustCurve(std::vector<ThrustPoint> points, double propellant_kg)
    : points_{std::move(points)}, propellant_kg_{propellant_kg} {
  if (!(propellant_kg_ > 0.0) || !std::isfinite(propellant_kg_)) {
    throw std::invalid_argument{"thrust curve: propellant " + shown(propellant_kg_) + " kg; allowed: above zero"};
  }
  if (points_.size() < 2) {
    throw std::invalid_argument{"thrust curve: fewer than two points"};
  }
  std::vector<double> times_s;
  const ThrustPoint* previous = nullptr;
  for (const ThrustPoint& point : points_) {
    if (const auto complaint = objection(previous, point)) {
      throw std::invalid_argument{"thrust curve: " + *complaint};
    }
    if (previous != nullptr) {
      const double width_s = point.time_s - previous->time_s;
      const double slope_n_s = (point.thrust_n - previous->thrust_n) / width_s;
      segments_.push_back({.time_s = previous->time_s,
                           .thrust_n = previous->thrust_n,
                           .slope_n_s = std::isfinite(slope_n_s) ? slope_n_s : 0.0,  // too steep for a number: a step
                           .impulse_n_s = impulse_n_s_});
      impulse_n_s_ += 0.5 * (previous->thrust_n + point.thrust_n) * width_s;
    }
    times_s.push_back(point.time_s);
    previous = &point;
  }
  if (points_.back().thrust_n != 0.0) {
    throw std::invalid_argument{"thrust curve: the last thrust is not zero"};
  }
  if (!(impulse_n_s_ > 0.0) || !std::isfinite(impulse_n_s_)) {
    throw std::invalid_argument{"thrust curve: impulse " + shown(impulse_n_s_) + " N s; allowed: above zero"};
  }
  ignition_s_ = times_s.front();
  burnout_s_ = times_s.back();
  index_ = SegmentIndex{std::move(times_s)};
}

}  // namespace fantail::sim
