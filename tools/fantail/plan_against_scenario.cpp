// SPDX-License-Identifier: MIT
#include "fantail/plan_against_scenario.hpp"

#include <cmath>

#include <fmt/core.h>

#include "text/number.hpp"

namespace fantail::tool {

std::vector<std::string> plan_against_scenario(const sim::Scenario& scenario) {
  std::vector<std::string> all;
  const core::GuidePlan& guide = scenario.plan.guide;
  const core::SensorsPlan& sensors = scenario.plan.sensors;
  const auto planned = [](float number) { return static_cast<double>(number); };
  if (scenario.guide.length_m && *scenario.guide.length_m > planned(guide.length_m) + 0.005) {
    all.push_back(
        fmt::format("guide.length_m = {} is less than the {} m of the launch guide in {}: by the plan the "
                    "rocket is clear of it {} m too early",
                    text::brief(planned(guide.length_m), 2), text::brief(*scenario.guide.length_m, 2), scenario.name,
                    text::brief(*scenario.guide.length_m - planned(guide.length_m), 2)));
  }
  const auto& air_c = scenario.atmosphere.air_temperature_c;
  if (sensors.barometer != core::BarometerUse::none && air_c &&
      std::abs(*air_c - planned(sensors.air_temperature_c)) > planned(sensors.air_temperature_error_k)) {
    all.push_back(
        fmt::format("sensors.air_temperature_c = {}, at most {} K wrong, does not cover the {} degrees C of {}: the "
                    "heights of the barometer are wrong by more than the flight law allows for",
                    text::brief(planned(sensors.air_temperature_c), 1),
                    text::brief(planned(sensors.air_temperature_error_k), 1), text::brief(*air_c, 1), scenario.name));
  }
  return all;
}

}  // namespace fantail::tool
