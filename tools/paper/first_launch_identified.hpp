// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "identify/identification.hpp"
#include "paper/claim.hpp"

namespace fantail::paper {

/// Eq 35 and 36: even intervals to the end of thrust, and from there to the end of the data. The first time is 0.
[[nodiscard]] identify::model::NodeTimes times_in_thrust_and_coast(double thrust_s, std::size_t in_thrust, double end_s,
                                                                   std::size_t in_coast);

struct FirstLaunchIdentified {
  const identify::model::Record& record;
  const identify::model::Airframe& rocket;
  double thrust_s = 0.0;  ///< from the begin of the record
  const identify::result::Identification& open;
  const identify::result::Identification& closed;
};

/// What was identified in the first launch, beside what is found in its simulated flight.
[[nodiscard]] std::vector<Claim> first_launch_identified(const FirstLaunchIdentified& ours);

}  // namespace fantail::paper
