// SPDX-License-Identifier: MIT
#include "listen/lift_off.hpp"

#include <algorithm>
#include <optional>

#include "listen/range_end.hpp"

namespace fantail::listen {
namespace {

// Where the straight line between a sample and the one before it goes through the threshold.
double crossing_s(const Signal& axial, std::size_t i, double threshold_m_s2) {
  const double rise = axial.value[i] - axial.value[i - 1];
  const double part = rise == 0.0 ? 0.0 : (threshold_m_s2 - axial.value[i - 1]) / rise;
  return axial.time_s[i - 1] + std::clamp(part, 0.0, 1.0) * (axial.time_s[i] - axial.time_s[i - 1]);
}

// How long the line through the samples stands above the threshold in the window that begins at a crossing.
double above_s(const Signal& axial, std::size_t first, double from_s, double threshold_m_s2) {
  const double to_s = from_s + lift_off_window_s;
  double sum = first < axial.time_s.size() ? std::min(axial.time_s[first], to_s) - from_s : 0.0;
  for (std::size_t i = first + 1; i < axial.time_s.size() && axial.time_s[i - 1] < to_s; ++i) {
    const bool was = axial.value[i - 1] >= threshold_m_s2;
    const bool is = axial.value[i] >= threshold_m_s2;
    const double cross_s = was == is ? axial.time_s[i] : crossing_s(axial, i, threshold_m_s2);
    const double begin_s = was ? axial.time_s[i - 1] : cross_s;
    const double end_s = was && !is ? cross_s : axial.time_s[i];
    if (was || is) {
      sum += std::max(0.0, std::min(end_s, to_s) - std::min(begin_s, to_s));
    }
  }
  return sum;
}

struct Push {
  bool makes_a_flight;  ///< is more than a bump
  std::size_t end;      ///< the sample at which it is over
};

// The push that begins at a crossing, the sample before which is first - 1.
Push push_from(const Signal& axial, std::size_t first, double from_s, double threshold_m_s2,
               const std::optional<RangeEnd>& end) {
  const double pause_m_s2 = push_end_g / lift_off_g * threshold_m_s2;
  double impulse_m_s = 0.0;
  double clipped_s = 0.0;
  bool makes_a_flight = false;
  double low_since_s = from_s;
  double last_s = from_s;
  double last_m_s2 = axial.value[first];
  for (std::size_t i = first; i < axial.time_s.size(); ++i) {
    const double now_m_s2 = axial.value[i];
    const double step_s = axial.time_s[i] - last_s;
    impulse_m_s += step_s * (0.5 * (last_m_s2 + now_m_s2) - one_g_m_s2);
    clipped_s += end && end->holds(now_m_s2) && end->holds(last_m_s2) ? step_s : 0.0;
    makes_a_flight = makes_a_flight || impulse_m_s >= flight_impulse_m_s || clipped_s >= flight_clipped_s;
    if (now_m_s2 >= pause_m_s2) {
      low_since_s = axial.time_s[i];
    } else if (last_m_s2 >= pause_m_s2) {
      low_since_s = crossing_s(axial, i, pause_m_s2);
    }
    if (now_m_s2 < pause_m_s2 && axial.time_s[i] - low_since_s >= push_pause_s) {
      return {makes_a_flight, i};
    }
    last_s = axial.time_s[i];
    last_m_s2 = now_m_s2;
  }
  return {true, axial.time_s.size()};
}

}  // namespace

std::vector<double> lift_offs_s(const Signal& axial) {
  double threshold_m_s2 = lift_off_g * one_g_m_s2;
  const auto end = range_end(axial, Side::positive);
  if (end && end->value < threshold_m_s2) {
    threshold_m_s2 = end->value * (1.0 - 1e-9);
  }
  std::vector<double> found;
  for (std::size_t i = 0; i < axial.time_s.size(); ++i) {
    const bool rises = axial.value[i] >= threshold_m_s2 && (i == 0 || axial.value[i - 1] < threshold_m_s2);
    const double from_s = rises && i > 0 ? crossing_s(axial, i, threshold_m_s2) : axial.time_s[i];
    if (!rises || above_s(axial, i, from_s, threshold_m_s2) < 0.5 * lift_off_window_s) {
      continue;
    }
    if (const Push push = push_from(axial, i, from_s, threshold_m_s2, end); push.makes_a_flight) {
      found.push_back(from_s);
      i = push.end;
    }
  }
  return found;
}

}  // namespace fantail::listen
