// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "sim/scenario.hpp"

namespace fantail::tool {

/// What a person says about the run: shared by every verb that has a scenario.
struct ScenarioOptions {
  std::string scenario;
  std::string seed;
  std::vector<std::string> changes;
};

/// SCENARIO, --seed and --set. A scenario that is already named is the default.
void add_scenario_options(const Verb& verb, ScenarioOptions& options);

/// Throws text::Error.
[[nodiscard]] sim::Scenario load(const ScenarioOptions& options);

}  // namespace fantail::tool
