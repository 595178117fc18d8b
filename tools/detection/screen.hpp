// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/flight_plan.hpp"
#include "detection/motion.hpp"
#include "detection/readings.hpp"

namespace fantail::detection {

enum class Screened : std::uint8_t {
  quiet,             ///< this rule does not fire, whatever the noise will be
  detector_decides,  ///< the launch detector alone, given every sample, says whether it fires
  law_decides,       ///< a detector that was shut off for a while and began anew may fire: that only the whole law says
};

/// Can this rule fire in this event? Of readings that have no noise yet.
///
/// The noise is bounded, and every sample is taken for as large as it can be: a low-pass gives no more than it would
/// then, so a rule whose hold such samples do not complete stays quiet. A detector that the law has shut off, because
/// the rocket moved, begins anew after a rest of the plan's rest time at the earliest, with whatever sample comes then.
/// Not quiet where all this says nothing: a plan that flies on the one that is left, a saturated accelerometer, and
/// samples that may be at the negative end of the range, which the filter is not given.
[[nodiscard]] Screened screened(const core::FlightPlan& plan, const Motion& motion, const Readings& readings);

}  // namespace fantail::detection
