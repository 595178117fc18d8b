// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "plot/chart.hpp"
#include "plot/drawing.hpp"
#include "plot/label_places.hpp"

namespace fantail::plot {

/// The name of its colour in plot.css.
[[nodiscard]] std::string_view class_of(Role role);

/// Which samples to draw: stretches without a gap, of each not much more than one smallest and one largest value per
/// two units of the drawing. Samples beside the x range are left out except for those next to it.
[[nodiscard]] std::vector<std::vector<std::size_t>> stretches(const std::vector<double>& x,
                                                              std::span<const std::vector<double>> columns,
                                                              const Drawing& drawing);

/// `style` is added to the class. Labels are told to keep away from the curve.
void draw(Drawing& drawing, LabelPlaces& places, const Series& series, std::string_view style);
void draw(Drawing& drawing, const Area& area);

}  // namespace fantail::plot
