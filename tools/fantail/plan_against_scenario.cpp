// SPDX-License-Identifier: MIT
#include "fantail/plan_against_scenario.hpp"

#include <utility>

#include <fmt/core.h>

#include "fly/describe.hpp"
#include "text/number.hpp"

namespace fantail::tool {

std::vector<std::string> plan_against_scenario(const sim::Scenario& scenario) {
  std::vector<std::string> all;
  const core::GuidePlan& guide = scenario.plan.guide;
  const auto planned = [](float number) { return static_cast<double>(number); };
  if (scenario.guide.length_m && *scenario.guide.length_m > planned(guide.length_m) + 0.005) {
    all.push_back(
        fmt::format("guide.length_m = {} is less than the {} m of the launch guide in {}: by the plan the "
                    "rocket is clear of it {} m too early",
                    text::brief(planned(guide.length_m), 2), text::brief(*scenario.guide.length_m, 2), scenario.name,
                    text::brief(*scenario.guide.length_m - planned(guide.length_m), 2)));
  }
  if (std::string temperature = fly::wrong_air_temperature(scenario); !temperature.empty()) {
    all.push_back(std::move(temperature));
  }
  return all;
}

}  // namespace fantail::tool
