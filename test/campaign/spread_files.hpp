// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "campaign/spread.hpp"
#include "input/scratch_file.hpp"

namespace fantail::campaign {

/// The second launch, with spreads behind it.
inline std::vector<Spread> spreads_of(const std::string& tables) {
  const input::ScratchFile file{
      "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n"
      "[disturbance]\ntimes_s = [0, 2]\nangles_deg = [-4.9, -5.1]\n" +
          tables,
      "spread.toml"};
  return read_spreads(input::ScenarioFiles::load(file.path().string()));
}

}  // namespace fantail::campaign
