// SPDX-License-Identifier: MIT
#include "predict/tunnel_result.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::radians;

constexpr double largest_angle_deg = 45.0;

struct Limits {
  double minimum;
  double maximum;
};

/// A column whose every cell must be a number within limits.
class NumberColumn {
 public:
  NumberColumn(const flight::Table& table, std::string_view name, Limits limits)
      : table_{table}, name_{name}, column_{table.column(name)}, limits_{limits} {}

  [[nodiscard]] double operator[](std::size_t row) const {
    const std::optional<double> value = table_.number(row, column_);
    if (!value || *value < limits_.minimum || *value > limits_.maximum) {
      throw text::Error{text::ErrorKind::bad_data,
                        fmt::format("{}:{}: {} = \"{}\"; allowed: {:g} to {:g}", table_.name(), table_.line(row), name_,
                                    table_.cell(row, column_), limits_.minimum, limits_.maximum)};
    }
    return *value;
  }

 private:
  const flight::Table& table_;
  std::string name_;
  std::size_t column_;
  Limits limits_;
};

/// What is taken off each row; `given` goes before the column swirl_deg.
std::vector<double> swirl_of_rows(const flight::Table& table, const Limits& angle, const std::optional<double>& given) {
  if (given) {
    return std::vector<double>(table.rows(), *given);
  }
  if (!table.find("swirl_deg")) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("{}: the swirl of the tunnel is not given. It is a part of the measured disturbance, is absent in "
                    "flight and may hide the fin offset. Give it with --swirl DEG (in Python swirl_deg), as fantail "
                    "tunnel swirl finds it, or in a column swirl_deg; --swirl 0 means that there was none",
                    table.name())};
  }
  const NumberColumn column{table, "swirl_deg", angle};
  std::vector<double> all;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    all.push_back(radians(column[row]));
  }
  return all;
}

std::string describe_swirl(const std::string& file, const std::vector<double>& swirl_rad, bool given) {
  const auto [lowest_rad, highest_rad] = std::ranges::minmax(swirl_rad);
  const std::string lowest = brief(degrees(lowest_rad), 2);
  if (given) {
    return fmt::format("Swirl subtracted: {} degrees (from --swirl).", lowest);
  }
  return fmt::format("Swirl subtracted: {} (column swirl_deg of {}).",
                     lowest_rad == highest_rad ? fmt::format("{} degrees", lowest)
                                               : fmt::format("a value for each row, {} to {} degrees", lowest,
                                                             brief(degrees(highest_rad), 2)),
                     file);
}

/// What a column says in every row; empty where it is absent or its cells are.
std::optional<std::string> same_in_all_rows(const flight::Table& table, std::string_view name) {
  const std::optional<std::size_t> column = table.find(name);
  if (!column) {
    return std::nullopt;
  }
  const std::string first{table.cell(0, *column)};
  for (std::size_t row = 1; row < table.rows(); ++row) {
    if (table.cell(row, *column) != first) {
      throw text::Error{text::ErrorKind::bad_data,
                        fmt::format("{}: {} = \"{}\", and \"{}\" in the first row; allowed: the same in all rows",
                                    table.where(row), name, table.cell(row, *column), first)};
    }
  }
  return first.empty() ? std::nullopt : std::optional{first};
}

std::optional<double> same_number_in_all_rows(const flight::Table& table, std::string_view name, const Limits& limits) {
  if (!same_in_all_rows(table, name)) {
    return std::nullopt;
  }
  return NumberColumn{table, name, limits}[0];
}

// All four or none: a spread of which one part lacks its error would look wider than it is, beside the others.
std::vector<TunnelStep> read_standard_errors(const flight::Table& table) {
  if (!table.find("alpha_standard_error_m2")) {
    return {};
  }
  constexpr Limits damping_error{0.0, 1e4};
  constexpr Limits angle_error{0.0, largest_angle_deg};
  const NumberColumn damping{table, "alpha_standard_error_m2", damping_error};
  const NumberColumn torque{table, "beta_standard_error_m", damping_error};
  const NumberColumn begin{table, "disturbance_begin_standard_error_deg", angle_error};
  const NumberColumn end{table, "disturbance_end_standard_error_deg", angle_error};
  std::vector<TunnelStep> errors;
  errors.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    errors.push_back({.damping_m2 = damping[row],
                      .torque_m = torque[row],
                      .offset_begin_rad = radians(begin[row]),
                      .offset_end_rad = radians(end[row])});
  }
  return errors;
}

std::vector<std::string> sources(const flight::Table& table) {
  std::vector<std::string> found;
  const std::optional<std::size_t> column = table.find("source");
  for (std::size_t row = 0; column && row < table.rows(); ++row) {
    const std::string text{table.cell(row, *column)};
    if (!text.empty() && std::ranges::find(found, text) == found.end()) {
      found.push_back(text);
    }
  }
  return found;
}

}  // namespace

TunnelResult read_tunnel_result(const std::filesystem::path& file, const std::optional<double>& swirl_rad) {
  const flight::Table table = flight::Table::load(file.string());
  constexpr Limits angle{-largest_angle_deg, largest_angle_deg};
  const NumberColumn damping{table, "alpha_m2", {1e-3, 1e4}};
  const NumberColumn torque{table, "beta_m", {1e-3, 1e4}};
  const NumberColumn begin{table, "disturbance_begin_deg", angle};
  const NumberColumn end{table, "disturbance_end_deg", angle};
  if (table.rows() < fewest_tunnel_steps) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: has {} of the rows that a spread is made from, one for each step. Allowed: {} "
                                  "or more, better eight. Fewer show almost nothing of the scatter",
                                  table.name(), table.rows(), fewest_tunnel_steps)};
  }
  TunnelResult result;
  result.name = file.filename().string();
  result.sources = sources(table);
  result.vehicle = same_in_all_rows(table, "vehicle");
  result.reference_area_m2 = same_number_in_all_rows(table, "reference_area_m2", {1e-8, 1.0});
  result.inertia_kg_m2 = same_number_in_all_rows(table, "inertia_kg_m2", {1e-6, 1e3});
  result.standard_errors = read_standard_errors(table);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    result.steps.push_back({.damping_m2 = damping[row],
                            .torque_m = torque[row],
                            .offset_begin_rad = radians(begin[row]),
                            .offset_end_rad = radians(end[row])});
  }
  const std::vector<double> swirl = swirl_of_rows(table, angle, swirl_rad);
  for (std::size_t row = 0; row < swirl.size(); ++row) {
    result.steps[row].offset_begin_rad -= swirl[row];
    result.steps[row].offset_end_rad -= swirl[row];
    result.swirl_rad += swirl[row] / static_cast<double>(swirl.size());
  }
  result.swirl_words = describe_swirl(result.name, swirl, swirl_rad.has_value());
  return result;
}

}  // namespace fantail::predict
