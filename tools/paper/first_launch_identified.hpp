// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identify/identification.hpp"
#include "paper/claim.hpp"

namespace fantail::paper {

struct FirstLaunchIdentified {
  const identify::model::NodeTimes& nodes_s;
  const identify::result::Identification& open;
  const identify::result::Identification& closed;
};

/// What was identified in the first launch, beside what is found in its simulated flight.
[[nodiscard]] std::vector<Claim> first_launch_identified(const FirstLaunchIdentified& ours);

}  // namespace fantail::paper
