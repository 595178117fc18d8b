// SPDX-License-Identifier: MIT
#include "identify/air.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

// In a tunnel the avionics integrates its own noise to a height of metres; over ten of them density changes by 0.1 %.
bool climbs(const logs::RollLog& log) {
  constexpr double real_climb_m = 10.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  for (const double height : log.height_m) {
    low = std::fmin(low, height);
    high = std::fmax(high, height);
  }
  return high - low > real_climb_m;
}

Air constant(double density_kg_m3, const std::string& why) {
  return {{.model = sim::DensityModel::constant, .constant_kg_m3 = density_kg_m3},
          fmt::format("{} kg/m3{}", sim::input::shown(density_kg_m3), why)};
}

Air exponential() {
  return {{.model = sim::DensityModel::exponential}, "1.225 exp(-h / 8500 m) kg/m3, h from height_m"};
}

}  // namespace

Air choose_air(const logs::RollLog& log, const std::optional<std::string>& asked) {
  if (!asked) {
    return climbs(log) ? exponential() : constant(1.2, ", as nothing was said and the log does not climb");
  }
  if (*asked == "exponential") {
    return exponential();
  }
  if (*asked == "isa") {
    return {{.model = sim::DensityModel::isa}, "of the standard atmosphere, height from height_m"};
  }
  const auto value = text::number(*asked);
  if (!value || *value <= 0.0 || *value > 100.0) {
    throw sim::InputError{sim::InputFault::bad_configuration,
                          "--density " + *asked + ": allowed: above 0 and up to 100 kg/m3, exponential, isa"};
  }
  return constant(*value, "");
}

}  // namespace fantail::identify
