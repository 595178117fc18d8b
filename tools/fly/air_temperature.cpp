// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/core.h>

#include "fly/describe.hpp"

namespace fantail::fly {

std::string wrong_air_temperature(const sim::Scenario& scenario) {
  const core::SensorsPlan& sensors = scenario.plan.sensors;
  const auto planned_c = static_cast<double>(sensors.air_temperature_c);
  const auto error_k = static_cast<double>(sensors.air_temperature_error_k);
  const auto& air_c = scenario.atmosphere.air_temperature_c;
  if (sensors.barometer == core::BarometerUse::none || !air_c || std::abs(*air_c - planned_c) <= error_k) {
    return {};
  }
  return fmt::format(
      "sensors.air_temperature_c = {:g}, at most {:g} K wrong, does not cover the {:g} degrees C of {}: the "
      "heights of the barometer are wrong by more than the flight law allows for",
      planned_c, error_k, *air_c, scenario.name);
}

}  // namespace fantail::fly
