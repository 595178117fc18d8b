// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "core/motion_estimator.hpp"
#include "core/pd_controller.hpp"

namespace fantail::core {

/// In the place of the estimator of the fin offset: any estimate at all.
class OffsetEstimator {
 public:
  explicit OffsetEstimator(const FlightPlan&) {}
  [[nodiscard]] Angle estimate() const { return proof::any_angle(); }
  void update(const Motion&, Angle, float, const AngleRange&) {}
  void interrupt() {}
  void begin(Angle) {}
  void remember(const RollCommand&) {}
};

}  // namespace fantail::core
