// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fantail::bench {

/// Command and encoder of one canard over time, as an SVG without style: its classes are those of page/sheet.css.
struct Chart {
  struct Band {
    double begin;
    double end;
    std::string label;
  };
  struct Level {
    double angle_deg;
    std::string label;
  };

  std::string label{};   ///< for those who do not see it
  double width = 440.0;  ///< of the drawing's own units; text is 11 of them high
  double height = 176.0;
  std::string time_unit{"s"};
  std::vector<double> time{};  ///< increasing
  std::vector<double> command_deg{};
  std::vector<double> encoder_deg{};  ///< not a number: no reading
  std::vector<Band> bands{};          ///< shaded stretches of time
  std::vector<Level> levels{};        ///< angles that matter: the limits
  std::size_t buckets = 110;          ///< of keep_extremes; no peak is lost
};

[[nodiscard]] std::string chart_svg(const Chart& chart);

}  // namespace fantail::bench
