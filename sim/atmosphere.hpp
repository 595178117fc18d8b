// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/elementary.hpp"
#include "sim/units.hpp"

namespace fantail::sim {

enum class DensityModel : std::uint8_t {
  exponential,  ///< 1.225 exp(-h / 8500): what the published flights were fitted with
  isa,          ///< International Standard Atmosphere (ISO 2533)
  constant,     ///< the same at every height: wind tunnels and closed forms
};

/// Air density over height above the launch site, taken to lie at sea level. One choice serves ascent and roll plant.
struct Atmosphere {
  DensityModel model = DensityModel::exponential;
  double constant_kg_m3 = 1.2;  ///< for DensityModel::constant only
  double elevation_m = 0.0;     ///< of the launch site above the sea; heights count from the site
  /// At the launch site, for pressure_pa() only; empty: that of the ISA there, 15 at sea level.
  std::optional<double> air_temperature_c{};

  /// Above the sea, height is geopotential height in the ISA (0.24 % below the geometric one at 15 km). The ISA holds
  /// up to 20 km; above, its isothermal layer is carried on.
  [[nodiscard]] double density_kg_m3(double height_above_site_m) const {
    const double height_m = height_above_site_m + elevation_m;
    switch (model) {
      case DensityModel::constant: return constant_kg_m3;
      case DensityModel::isa: return isa_density_kg_m3(height_m);
      case DensityModel::exponential: break;
    }
    return 1.225 * exponential(height_m * (-1.0 / 8500.0));
  }

  /// That of the ISA at the height above the sea, whatever the density is taken to be.
  [[nodiscard]] double speed_of_sound_m_s(double height_above_site_m) const {
    constexpr double heat_capacity_ratio = 1.4;
    const double temperature_k = isa_temperature_k(height_above_site_m + elevation_m);
    return std::sqrt(heat_capacity_ratio * gas_constant_j_kg_k * temperature_k);
  }

  /// That of the ISA at the height above the sea, whatever the density is taken to be. Where the air is warmer than the
  /// ISA at the site, every layer above the site is as much thicker as its air is warmer; the lapse rate stays. So at
  /// the height h a standard altimeter, set to zero at the site, shows h times ISA over true temperature of the site.
  [[nodiscard]] double pressure_pa(double height_above_site_m) const {
    if (!air_temperature_c) {
      return isa_pressure_pa(elevation_m + height_above_site_m);
    }
    constexpr double zero_celsius_k = 273.15;
    const double shown = isa_temperature_k(elevation_m) / (*air_temperature_c + zero_celsius_k);
    return isa_pressure_pa(elevation_m + height_above_site_m * shown);
  }

 private:
  static constexpr double gas_constant_j_kg_k = 287.05287;
  static constexpr double lapse_k_m = 0.0065;
  static constexpr double tropopause_m = 11000.0;
  static constexpr double sea_level_k = 288.15;
  static constexpr double tropopause_k = sea_level_k - lapse_k_m * tropopause_m;

  static constexpr double sea_level_pa = 101325.0;

  [[nodiscard]] static double isa_temperature_k(double height_m) {
    return height_m < tropopause_m ? sea_level_k - lapse_k_m * height_m : tropopause_k;
  }

  [[nodiscard]] static double isa_pressure_pa(double height_m) {
    constexpr double exponent = gravity_m_s2 / (gas_constant_j_kg_k * lapse_k_m);
    if (height_m <= tropopause_m) {
      return sea_level_pa * exponential(exponent * natural_log(1.0 - height_m * (lapse_k_m / sea_level_k)));
    }
    constexpr double at_tropopause_pa = sea_level_pa * exponential(exponent * natural_log(tropopause_k / sea_level_k));
    constexpr double scale_height_m = gas_constant_j_kg_k * tropopause_k / gravity_m_s2;
    return at_tropopause_pa * exponential((tropopause_m - height_m) / scale_height_m);
  }

  [[nodiscard]] static double isa_density_kg_m3(double height_m) {
    constexpr double sea_level_kg_m3 = sea_level_pa / (gas_constant_j_kg_k * sea_level_k);
    // Density falls one power slower than pressure: the air is colder, too.
    constexpr double exponent = gravity_m_s2 / (gas_constant_j_kg_k * lapse_k_m) - 1.0;
    if (height_m <= tropopause_m) {
      return sea_level_kg_m3 * exponential(exponent * natural_log(1.0 - height_m * (lapse_k_m / sea_level_k)));
    }
    constexpr double at_tropopause_kg_m3 =
        sea_level_kg_m3 * exponential(exponent * natural_log(tropopause_k / sea_level_k));
    constexpr double scale_height_m = gas_constant_j_kg_k * tropopause_k / gravity_m_s2;
    return at_tropopause_kg_m3 * exponential((tropopause_m - height_m) / scale_height_m);
  }
};

}  // namespace fantail::sim
