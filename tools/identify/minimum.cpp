// SPDX-License-Identifier: MIT
#include "identify/minimum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fantail::identify {
namespace {

struct Point {
  double x;
  double value;
};

// Brent's method (Algorithms for Minimization without Derivatives, 1973, chapter 5): the vertex of a parabola through
// the three best points where that makes headway, else a golden section. `best` lies within the span.
Point brent(const std::function<double(double)>& function, Span span, Point best, double relative_tolerance) {
  constexpr double golden = 0.3819660112501051;
  constexpr int most_steps = 60;
  const double tolerance = relative_tolerance * (span.high - span.low);
  Point second = best;
  Point third = best;
  double step = 0.0;
  double step_before_last = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const double middle = 0.5 * (span.low + span.high);
    if (std::abs(best.x - middle) <= 2.0 * tolerance - 0.5 * (span.high - span.low)) {
      break;
    }
    const double a = (best.x - second.x) * (best.value - third.value);
    const double b = (best.x - third.x) * (best.value - second.value);
    double upper = (best.x - third.x) * b - (best.x - second.x) * a;
    double lower = 2.0 * (b - a);
    upper = lower > 0.0 ? -upper : upper;
    lower = std::abs(lower);
    const bool parabola = std::abs(step_before_last) > tolerance &&
                          std::abs(upper) < std::abs(0.5 * lower * step_before_last) &&
                          upper > lower * (span.low - best.x) && upper < lower * (span.high - best.x);
    if (parabola) {
      step_before_last = std::exchange(step, upper / lower);
      const double x = best.x + step;
      if (x - span.low < 2.0 * tolerance || span.high - x < 2.0 * tolerance) {
        step = best.x < middle ? tolerance : -tolerance;
      }
    } else {
      step_before_last = (best.x < middle ? span.high : span.low) - best.x;
      step = golden * step_before_last;
    }
    const double x = best.x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const Point tried{.x = x, .value = function(x)};
    if (tried.value <= best.value) {
      (tried.x < best.x ? span.high : span.low) = best.x;
      third = second;
      second = best;
      best = tried;
    } else {
      (tried.x < best.x ? span.low : span.high) = tried.x;
      if (tried.value <= second.value || second.x == best.x) {
        third = second;
        second = tried;
      } else if (tried.value <= third.value || third.x == best.x || third.x == second.x) {
        third = tried;
      }
    }
  }
  return best;
}

}  // namespace

double least_over(const std::function<double(double)>& function, Span span, int places, double tolerance) {
  std::vector<Point> looked;
  for (int i = 0; i < places; ++i) {
    const double x = span.low + (span.high - span.low) * static_cast<double>(i) / static_cast<double>(places - 1);
    looked.push_back({.x = x, .value = function(x)});
  }
  const auto best = std::ranges::min_element(looked, {}, &Point::value);
  const double low = best == looked.begin() ? best->x : (best - 1)->x;
  const double high = best + 1 == looked.end() ? best->x : (best + 1)->x;
  return brent(function, {.low = low, .high = high}, *best, tolerance).x;
}

}  // namespace fantail::identify
