// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "page/svg_plot.hpp"
#include "text/number.hpp"

namespace fantail::page {
namespace {

constexpr double rounding = 1e-9;  // of a step: a tick at the end of the range belongs to it

// The nearest by ratio: the geometric means of the neighbours are where one gives way to the next.
double tick_step(Range range, double wanted) {
  const double raw = (range.high - range.low) / std::max(wanted, 1.0);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double factor = 1.0;
  for (const double next : {2.0, 5.0, 10.0}) {
    if (raw <= std::sqrt(factor * next) * power) {
      return factor * power;
    }
    factor = next;
  }
  return 10.0 * power;
}

std::string superscript(int exponent) {
  static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += digits[digit - '0'];
  }
  return text;
}

// Decimals are those that the step needs. Very large and very small numbers are written with a power of ten, unless it
// takes all their figures to tell them apart.
std::string tick_text(double value, double step, double largest) {
  if (std::abs(value) < 1e-6 * step) {
    return "0";
  }
  const int finest = static_cast<int>(std::floor(std::log10(step) + rounding));
  const int exponent = static_cast<int>(std::floor(std::log10(largest) + rounding));
  const bool many_figures = exponent - finest > 3 && exponent < 15 && finest > -10;
  if ((largest < 1e6 && finest >= -4) || many_figures) {
    return text::with_minus(text::brief(value, std::max(-finest, 0)));
  }
  const double mantissa = value / std::pow(10.0, exponent);
  return text::with_minus(text::brief(mantissa, std::clamp(exponent - finest, 0, 9))) + "·10" + superscript(exponent);
}

}  // namespace

void include(std::optional<Range>& range, double value) {
  if (std::isfinite(value)) {
    range = range ? Range{std::min(range->low, value), std::max(range->high, value)} : Range{value, value};
  }
}

Range drawable(Range range) {
  constexpr double most = 1e150;  // so that differences and squares stay finite
  double low = std::isfinite(range.low) ? std::clamp(range.low, -most, most) : 0.0;
  double high = std::isfinite(range.high) ? std::clamp(range.high, -most, most) : low;
  if (low > high) {
    std::swap(low, high);
  }
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low <= 1e-9 * size || high - low < 1e-150) {
    const double half = size < 1e-140 ? 1.0 : 0.1 * size;
    const double middle = 0.5 * (low + high);
    return {middle - half, middle + half};
  }
  return {low, high};
}

Range drawable(Range range, Scale scale) {
  constexpr double decades_below_high = 1e-3;
  const Range fit = drawable(range);
  if (scale == Scale::linear || fit.low > 0.0) {
    return fit;
  }
  const double high = fit.high > 0.0 ? fit.high : 1.0;
  return {decades_below_high * high, high};
}

double part_of(double value, Range range, Scale scale) {
  if (scale == Scale::linear) {
    return (value - range.low) / (range.high - range.low);
  }
  constexpr double next_to_nothing = 1e-300;
  return std::log(std::max(value, next_to_nothing) / range.low) / std::log(range.high / range.low);
}

std::vector<Tick> even_ticks(Range range, double wanted) {
  const double step = tick_step(range, wanted);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  std::vector<Tick> ticks;
  const double first = std::ceil(range.low / step - rounding);
  const int last = static_cast<int>(std::floor(range.high / step + rounding) - first);
  for (int i = 0; i <= last; ++i) {
    ticks.push_back({(first + i) * step, tick_text((first + i) * step, step, largest)});
  }
  return ticks;
}

std::vector<Tick> decade_ticks(Range range, double wanted) {
  const int first = static_cast<int>(std::floor(std::log10(range.low)));
  const int last = static_cast<int>(std::ceil(std::log10(range.high)));
  const auto within = [&](double value) {
    return value >= range.low * (1.0 - rounding) && value <= range.high * (1.0 + rounding);
  };
  std::vector<Tick> all;
  std::vector<Tick> powers;
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = std::pow(10.0, exponent);
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (within(factor * power)) {
        all.push_back({factor * power, tick_text(factor * power, power, factor * power)});
        if (factor == 1.0) {
          powers.push_back(all.back());
        }
      }
    }
  }
  if (static_cast<double>(all.size()) <= 1.5 * wanted) {
    return all.size() >= 3 ? all : even_ticks(range, wanted);
  }
  std::vector<Tick> some;
  const auto every = static_cast<std::size_t>(std::ceil(static_cast<double>(powers.size()) / std::max(wanted, 1.0)));
  for (std::size_t i = 0; i < powers.size(); i += std::max<std::size_t>(every, 1)) {
    some.push_back(powers[i]);
  }
  return some;
}

std::vector<Tick> ticks_at(std::span<const double> values, Range range) {
  std::vector<double> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted), [&](double v) { return v >= range.low && v <= range.high; });
  std::ranges::sort(sorted);
  const auto repeats = std::ranges::unique(sorted);
  sorted.erase(repeats.begin(), repeats.end());
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const double step = std::pow(10.0, std::floor(std::log10(std::max(largest, 1e-300))) - 2.0);  // three figures
  std::vector<Tick> ticks;
  ticks.reserve(sorted.size());
  for (const double value : sorted) {
    ticks.push_back({value, tick_text(value, step, largest)});
  }
  return ticks;
}

}  // namespace fantail::page
