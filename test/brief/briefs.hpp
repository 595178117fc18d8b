// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "brief/brief.hpp"
#include "input/scenario_file.hpp"

namespace fantail::brief {

inline sim::Scenario scenario(const std::vector<std::string>& changes, const std::string& name = "tasha3_launch2") {
  return input::load_scenario(name, input::parse_overrides(changes));
}

inline Brief brief_of(const std::vector<std::string>& changes) {
  return make({.scenario = scenario(changes), .step_s = 5.0, .threads = 2, .rules = {}},
              [](std::size_t, std::size_t) {});
}

inline std::string text_of(const Brief& brief) { return result::text(answer(brief, {})); }

}  // namespace fantail::brief
