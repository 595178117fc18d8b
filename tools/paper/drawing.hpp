// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "page/chart.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

/// A chart of a page on which two stand side by side, as a figure.
[[nodiscard]] std::string half_width_figure(page::Chart chart, const std::string& caption);

/// What a row of a flight contributes to a curve; not a number where there is nothing.
using RowValue = std::function<double(const flight::Row&)>;

/// A curve of a run over its clock (minus `zero_s`) between two times of that clock.
struct Stretch {
  double zero_s = 0.0;
  double from_s = 0.0;
  double to_s = 0.0;
};
[[nodiscard]] page::Series curve(const Run& run, const Stretch& stretch, std::string name, page::Role role,
                                 const RowValue& value);

/// A list over another, both as they are.
[[nodiscard]] page::Series curve(const std::vector<double>& x, std::vector<double> y, std::string name,
                                 page::Role role);

[[nodiscard]] double true_angle_deg(const flight::Row& row);
[[nodiscard]] double true_rate_deg_s(const flight::Row& row);
[[nodiscard]] double true_canard_deg(const flight::Row& row);
[[nodiscard]] double true_disturbance_deg(const flight::Row& row);

}  // namespace fantail::paper
