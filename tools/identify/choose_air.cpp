// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "identify/make_record.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using logs::RollLog;
using text::Error;
using text::ErrorKind;

// In a tunnel the avionics integrates its own noise to a height of metres; over ten of them density changes by 0.1 %.
bool climbs(const RollLog& log) {
  constexpr double real_climb_m = 10.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double height : log.height_m) {
    low = std::fmin(low, height);
    high = std::fmax(high, height);
  }
  return high - low > real_climb_m;
}

Air constant_air(double density_kg_m3, const std::string& why) {
  return {{.model = sim::DensityModel::constant, .constant_kg_m3 = density_kg_m3},
          fmt::format("{} kg/m3{}", input::plain_number(density_kg_m3), why)};
}

Air exponential_air() {
  return {{.model = sim::DensityModel::exponential},
          "1.225 exp(-h / 8500 m) kg/m3, h from height_m, for a site at sea level"};
}

Air standard_air(const RollLog& log, double site_elevation_m) {
  const sim::Atmosphere standard{.model = sim::DensityModel::isa};
  const double at_site_kg_m3 = standard.density_kg_m3(site_elevation_m);
  const std::string site =
      fmt::format("standard atmosphere at {} m above the sea", input::plain_number(site_elevation_m));
  if (!climbs(log)) {
    return {{.model = sim::DensityModel::constant, .constant_kg_m3 = at_site_kg_m3},
            fmt::format("{:.4f} kg/m3, {}", at_site_kg_m3, site)};
  }
  return {standard, fmt::format("{}, {:.4f} kg/m3, and above it by height_m", site, at_site_kg_m3)};
}

}  // namespace

Air choose_air(const RollLog& log, const std::optional<std::string>& asked,
               const std::optional<double>& site_elevation_m) {
  if (site_elevation_m) {
    if (asked && *asked != "isa") {
      throw Error{ErrorKind::bad_configuration,
                  "--density " + *asked + ": --elevation means the standard atmosphere; give one of the two"};
    }
    return standard_air(log, *site_elevation_m);
  }
  if (!asked) {
    return climbs(log) ? exponential_air()
                       : constant_air(1.2, log.height_m.empty() ? ", the default for a log without heights"
                                                                : ", the default for a log that does not climb");
  }
  if (*asked == "exponential") {
    return exponential_air();
  }
  if (*asked == "isa") {
    return {{.model = sim::DensityModel::isa}, "standard atmosphere, height from height_m, for a site at sea level"};
  }
  const auto value = text::number(*asked);
  if (!value || *value <= 0.0 || *value > 100.0) {
    throw Error{ErrorKind::bad_configuration,
                "--density " + *asked + ": allowed: above 0 and up to 100 kg/m3, exponential, isa"};
  }
  return constant_air(*value, "");
}

}  // namespace fantail::identify
