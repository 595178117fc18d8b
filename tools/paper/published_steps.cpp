// SPDX-License-Identifier: MIT
#include "paper/published_steps.hpp"

#include "flight/table.hpp"
#include "input/shipped.hpp"
#include "text/error.hpp"

namespace fantail::paper {

std::vector<PublishedStep> published_steps() {
  const std::string file = input::find_input(input::Shipped::tunnel_result, "tasha3_table2").string();
  const flight::Table table = flight::Table::load(file);
  const auto number = [&](std::size_t row, std::string_view column) {
    const auto value = table.number(row, table.column(column));
    if (!value) {
      throw text::Error{text::ErrorKind::bad_data,
                        file + ":" + std::to_string(table.line(row)) + ": " + std::string{column} + " is not a number"};
    }
    return *value;
  };
  std::vector<PublishedStep> steps;
  steps.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    steps.push_back({.step = static_cast<int>(number(row, "step")),
                     .alpha_m2 = number(row, "alpha_m2"),
                     .beta_m = number(row, "beta_m"),
                     .disturbance_begin_deg = number(row, "disturbance_begin_deg"),
                     .disturbance_end_deg = number(row, "disturbance_end_deg"),
                     .mean_abs_angle_error_deg = number(row, "mean_abs_angle_error_deg"),
                     .mean_abs_rate_error_deg_s = number(row, "mean_abs_rate_error_deg_s")});
  }
  return steps;
}

}  // namespace fantail::paper
