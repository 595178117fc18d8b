// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fantail::page {

struct Range {
  double low;
  double high;
};

/// Grows to hold the value; what is not finite changes nothing.
void include(std::optional<Range>& range, double value);

/// Fit to be drawn: low below high by more than rounding can hide, whatever came in.
[[nodiscard]] Range drawable(Range range);

struct Tick {
  double value;
  std::string text;
};

/// 1, 2 or 5 times a power of ten apart, so that their number is near `wanted`.
[[nodiscard]] std::vector<Tick> even_ticks(Range range, double wanted);
/// 1, 2 and 5 times the powers of ten, or the powers alone when that is too many; even ones when the range is narrow.
[[nodiscard]] std::vector<Tick> decade_ticks(Range range, double wanted);
/// At these values and nowhere else, each once.
[[nodiscard]] std::vector<Tick> ticks_at(std::span<const double> values, Range range);

}  // namespace fantail::page
