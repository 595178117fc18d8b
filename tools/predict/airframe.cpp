// SPDX-License-Identifier: MIT
#include "predict/airframe.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/random.hpp"

namespace fantail::predict {
namespace {

/// Of the random numbers of one run; those of the world begin at one.
constexpr std::uint64_t airframe_stream = 1000;
constexpr std::uint64_t area_stream = 1001;

double chi_squared(sim::Random& random, std::size_t degrees_of_freedom) {
  double sum = 0.0;
  for (std::size_t i = 0; i < degrees_of_freedom; ++i) {
    const double normal = random.gaussian();
    sum += normal * normal;
  }
  return sum;
}

double draw_factor(const AreaFactor& area, std::uint64_t seed) {
  constexpr double z = 1.959963984540054;  // of the normal law, 2.5 % above it
  sim::Random random{seed, area_stream};
  const double middle = 0.5 * (std::log(area.low) + std::log(area.high));
  const double deviation = 0.5 * (std::log(area.high) - std::log(area.low)) / z;
  return std::exp(middle + deviation * random.gaussian());
}

std::array<double, 4> numbers(const TunnelStep& step) {
  return {step.damping_m2, step.torque_m, step.offset_begin_rad, step.offset_end_rad};
}

}  // namespace

AirframeSpread::AirframeSpread(const std::vector<TunnelStep>& steps, const DampingFactor& damping,
                               const std::optional<AreaFactor>& area, const std::vector<TunnelStep>& standard_errors)
    : degrees_of_freedom_{steps.size() - 1}, damping_{damping}, area_{area} {
  const auto count = static_cast<double>(steps.size());
  for (const TunnelStep& step : steps) {
    deviations_.push_back(numbers(step));
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      mean_[i] += deviations_.back()[i] / count;
    }
  }
  Numbers seen{};  // variance
  for (Numbers& deviation : deviations_) {
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      deviation[i] -= mean_[i];
      seen[i] += deviation[i] * deviation[i] / (count - 1.0);
    }
  }
  Numbers of_measurement{};
  for (const TunnelStep& error : standard_errors) {
    for (std::size_t i = 0; i < mean_.size(); ++i) {
      of_measurement[i] += numbers(error)[i] * numbers(error)[i] / count;
    }
  }
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    // Variance of one more airframe: what the steps have beyond measurement, and all that makes their mean uncertain.
    const double between = seen[i] > 0.0 ? std::max(1.0 - of_measurement[i] / seen[i], 0.0) : 1.0;
    const double scale = std::sqrt((between + 1.0 / count) / (count - 1.0));
    for (Numbers& deviation : deviations_) {
      deviation[i] *= scale;
    }
  }
}

TunnelStep AirframeSpread::draw(std::uint64_t seed) const {
  sim::Random random{seed, airframe_stream};
  const double factor = damping_.low + random.uniform() * (damping_.high - damping_.low);
  const double area = area_ ? draw_factor(*area_, seed) : 1.0;
  const auto freedom = static_cast<double>(degrees_of_freedom_);
  for (;;) {
    // One factor for all four numbers: their correlation stays, and each has Student's t distribution.
    const double tail = std::sqrt(freedom / chi_squared(random, degrees_of_freedom_));
    // A sum of the deviations, each with a normal factor of its own, has exactly their covariance, also where there are
    // fewer steps than numbers in a step.
    Numbers drawn = mean_;
    for (const Numbers& deviation : deviations_) {
      const double share = tail * random.gaussian();
      for (std::size_t i = 0; i < drawn.size(); ++i) {
        drawn[i] += share * deviation[i];
      }
    }
    const auto [damping_m2, torque_m, offset_begin_rad, offset_end_rad] = drawn;
    if (damping_m2 > 0.0 && torque_m > 0.0) {
      return {.damping_m2 = factor * area * damping_m2,
              .torque_m = area * torque_m,
              .offset_begin_rad = offset_begin_rad,
              .offset_end_rad = offset_end_rad};
    }
  }
}

}  // namespace fantail::predict
