// SPDX-License-Identifier: MIT
#include "core/offset_estimator.hpp"

namespace fantail::core {

OffsetEstimator::OffsetEstimator(const FlightPlan& plan)
    : rejection_{plan.offset.rejection},
      captures_{plan.controller.entry == ControlEntry::capture},
      proportional_gain_{plan.controller.proportional_gain},
      canard_limit_{plan.controller.canard_limit},
      integral_{plan.controller, plan.offset},
      observer_{plan.offset, plan.roll_model} {}

}  // namespace fantail::core
