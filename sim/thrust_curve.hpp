// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/segment_index.hpp"

namespace fantail::sim {

struct ThrustPoint {
  double time_s;  ///< after ignition
  double thrust_n;
};

/// Why a point may not follow another.
enum class PointFault : std::uint8_t {
  time,    ///< not finite, or before ignition
  thrust,  ///< not finite, or below zero
  order,   ///< not later than the one before
};

/// What a motor does at one instant.
struct Burn {
  double thrust_n;
  double impulse_n_s;  ///< given since ignition
};

/// A motor: straight lines between measured points, zero before the first and after the last. All integrals are exact.
class ThrustCurve {
 public:
  /// No motor: no thrust, no propellant.
  ThrustCurve() = default;

  /// Throws std::invalid_argument unless there are at least two points, each without fault(), the last thrust is
  /// zero, the impulse is positive and finite, and so is the propellant.
  ThrustCurve(std::vector<ThrustPoint> points, double propellant_kg);

  /// Why `next` may not follow `previous` (null: it is the first point); empty when it may.
  [[nodiscard]] static std::optional<PointFault> fault(const ThrustPoint* previous, const ThrustPoint& next);

  /// Thrust and impulse at any finite time, found with one search.
  [[nodiscard]] Burn at(double time_s) const {
    if (time_s >= burnout_s_) {
      return {.thrust_n = 0.0, .impulse_n_s = impulse_n_s_};
    }
    if (time_s < ignition_s_) {
      return {.thrust_n = 0.0, .impulse_n_s = 0.0};
    }
    const Segment& segment = segments_[index_.segment(time_s)];
    const double into_s = time_s - segment.time_s;
    return {.thrust_n = segment.thrust_n + segment.slope_n_s * into_s,
            .impulse_n_s = segment.impulse_n_s + into_s * (segment.thrust_n + 0.5 * segment.slope_n_s * into_s)};
  }
  [[nodiscard]] double thrust_n(double time_s) const { return at(time_s).thrust_n; }
  [[nodiscard]] double impulse_until(double time_s) const { return at(time_s).impulse_n_s; }

  [[nodiscard]] double impulse_n_s() const { return impulse_n_s_; }
  [[nodiscard]] double propellant_kg() const { return propellant_kg_; }
  [[nodiscard]] double burnout_s() const { return burnout_s_; }
  [[nodiscard]] const std::vector<ThrustPoint>& points() const { return points_; }

 private:
  struct Segment {
    double time_s;
    double thrust_n;
    double slope_n_s;
    double impulse_n_s;  ///< given before this segment
  };

  std::vector<ThrustPoint> points_;
  std::vector<Segment> segments_;
  SegmentIndex index_;
  double propellant_kg_ = 0.0;
  double impulse_n_s_ = 0.0;
  double ignition_s_ = 0.0;
  double burnout_s_ = 0.0;
};

}  // namespace fantail::sim
