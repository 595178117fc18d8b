// SPDX-License-Identifier: MIT
#pragma once

#include "faults/campaign.hpp"

namespace fantail::faults {

/// The four faults of the arm switch while the launch is being detected: a campaign of 12 flights.
inline Campaign switches() {
  return {.scenario = "tasha3_launch2", .device = "arm_switch", .phase = "launched", .every = 1000};
}

}  // namespace fantail::faults
