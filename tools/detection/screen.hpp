// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "detection/motion.hpp"
#include "detection/readings.hpp"

namespace fantail::detection {

/// Can this rule fire at all in this event, whatever its noise will be? Of readings that have no noise yet.
///
/// The noise is bounded, and every sample is taken for as large as it can be: a low-pass gives no more than it would
/// then, so a rule whose hold such samples do not complete stays quiet. True where that says nothing: of a plan that
/// flies on the one that is left, of a saturated accelerometer, and where a sample may be at the negative end of its
/// range, which the filter is not given.
[[nodiscard]] bool may_fire(const core::LaunchDetectionPlan& plan, const Motion& motion, const Readings& readings);

}  // namespace fantail::detection
