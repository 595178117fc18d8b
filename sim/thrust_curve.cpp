// SPDX-License-Identifier: MIT
#include "sim/thrust_curve.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace fantail::sim {
namespace {

// Written so that a NaN is refused too.
void require(bool allowed, const char* what) {
  if (!allowed) {
    throw std::invalid_argument{std::string{"thrust curve: "} + what};
  }
}

}  // namespace

std::optional<PointFault> ThrustCurve::fault(const ThrustPoint* previous, const ThrustPoint& next) {
  if (!std::isfinite(next.time_s) || next.time_s < 0.0) {
    return PointFault::time;
  }
  if (!std::isfinite(next.thrust_n) || next.thrust_n < 0.0) {
    return PointFault::thrust;
  }
  if (previous != nullptr && next.time_s <= previous->time_s) {
    return PointFault::order;
  }
  return std::nullopt;
}

ThrustCurve::ThrustCurve(std::vector<ThrustPoint> points, double propellant_kg)
    : points_{std::move(points)}, propellant_kg_{propellant_kg} {
  require(propellant_kg_ > 0.0 && std::isfinite(propellant_kg_), "the propellant must be finite and above zero");
  require(points_.size() >= 2, "fewer than two points");
  std::vector<double> times_s;
  const ThrustPoint* previous = nullptr;
  for (const ThrustPoint& point : points_) {
    require(!fault(previous, point), "points must be finite, not below zero, and in the order of their times");
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
  require(points_.back().thrust_n == 0.0, "the last thrust is not zero");
  require(impulse_n_s_ > 0.0 && std::isfinite(impulse_n_s_), "the impulse is zero or infinite; allowed: above zero");
  ignition_s_ = times_s.front();
  burnout_s_ = times_s.back();
  index_ = SegmentIndex{std::move(times_s)};
}

}  // namespace fantail::sim
