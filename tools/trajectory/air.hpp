// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flight/table.hpp"
#include "sim/atmosphere.hpp"
#include "trajectory/series.hpp"

namespace fantail::trajectory {

/// Density at each row of a series, and where it is from.
struct Air {
  std::vector<double> density_kg_m3;
  std::vector<Quantity> read;        ///< from the file
  std::vector<std::string> derived;  ///< words for a person: "the density is that of the scenario"
};

[[nodiscard]] Air air_of(const flight::Table& table, const Columns& columns, const Series& series,
                         const std::vector<double>& height_m, const sim::Atmosphere& atmosphere);

}  // namespace fantail::trajectory
