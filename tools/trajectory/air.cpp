// SPDX-License-Identifier: MIT
#include "trajectory/air.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace fantail::trajectory {
namespace {

constexpr double gas_constant_j_kg_k = 287.05287;  // of dry air, as the ISA has it
constexpr double coarse_share = 0.02;

/// What the last digit of a column is worth, by its longest number: some writers leave trailing zeros out. Empty for
/// numbers with an exponent.
std::optional<double> last_digit(const flight::Table& table, const FoundColumn& column) {
  std::size_t decimals = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string_view cell = table.cell(row, column.index);
    if (cell.find_first_of("eE") != std::string_view::npos) {
      return std::nullopt;
    }
    const std::size_t point = cell.find('.');
    decimals = std::max(decimals, point == std::string_view::npos ? 0 : cell.size() - point - 1);
  }
  return column.scale * std::pow(10.0, -static_cast<double>(decimals));
}

bool is_coarse(const flight::Table& table, const Columns& columns, const std::vector<double>& density_kg_m3) {
  const auto digit_kg_m3 = last_digit(table, *columns.find(Quantity::density));
  return digit_kg_m3 && *digit_kg_m3 > coarse_share * density_kg_m3.front();
}

}  // namespace

Air air_of(const flight::Table& table, const Columns& columns, const Series& series,
           const std::vector<double>& height_m, const sim::Atmosphere& atmosphere) {
  Air air;
  std::string why;
  if (const auto* density_kg_m3 = series.find(Quantity::density)) {
    if (!is_coarse(table, columns, *density_kg_m3)) {
      air.density_kg_m3 = *density_kg_m3;
      air.read.push_back(Quantity::density);
      return air;
    }
    why = ", because that of the file is rounded to more than 2 % of itself";
  }
  const auto* temperature_k = series.find(Quantity::temperature);
  const auto* pressure_pa = series.find(Quantity::pressure);
  if (temperature_k != nullptr && pressure_pa != nullptr) {
    for (std::size_t i = 0; i < height_m.size(); ++i) {
      air.density_kg_m3.push_back((*pressure_pa)[i] / (gas_constant_j_kg_k * (*temperature_k)[i]));
    }
    air.read = {Quantity::temperature, Quantity::pressure};
    air.derived.push_back("the air density follows from temperature and pressure" + why);
    return air;
  }
  for (const double height : height_m) {
    air.density_kg_m3.push_back(atmosphere.density_kg_m3(height));
  }
  air.derived.push_back("the air density is that of the scenario at these heights" + why);
  return air;
}

}  // namespace fantail::trajectory
