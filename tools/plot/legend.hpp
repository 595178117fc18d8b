// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plot/chart.hpp"
#include "plot/drawing.hpp"

namespace fantail::plot {

constexpr double legend_row = 17.0;

/// The names of a chart's curves and areas, in rows above the frame beside the y axis' label.
class Legend {
 public:
  /// `styles` of the series, as they are drawn.
  Legend(const Chart& chart, const std::vector<std::string>& styles);

  /// 0 when there is neither a label nor more than one name.
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  void draw(Drawing& drawing) const;

 private:
  struct Entry {
    std::string name;
    const Area* area = nullptr;
    const Series* series = nullptr;
    std::string style{};
    double width = 0.0;
  };

  const Chart& chart_;
  std::vector<std::vector<Entry>> rows_{};
};

}  // namespace fantail::plot
