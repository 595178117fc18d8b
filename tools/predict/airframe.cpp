// SPDX-License-Identifier: MIT
#include "predict/airframe.hpp"

#include <algorithm>
#include <cmath>

#include "distributions/quantiles.hpp"
#include "sim/random.hpp"

namespace fantail::predict {
namespace {

/// Of the random numbers of one run; those of the world begin at one.
constexpr std::uint64_t airframe_stream = 1000;
constexpr std::uint64_t area_stream = 1001;

double draw_factor(const AreaFactor& area, std::uint64_t seed) {
  constexpr double z = distributions::normal_975;
  sim::Random random{seed, area_stream};
  const double middle = 0.5 * (std::log(area.low) + std::log(area.high));
  const double deviation = 0.5 * (std::log(area.high) - std::log(area.low)) / z;
  return std::exp(middle + deviation * random.gaussian());
}

std::vector<campaign::NextRow::Row> rows(const std::vector<TunnelStep>& steps) {
  std::vector<campaign::NextRow::Row> all;
  all.reserve(steps.size());
  for (const TunnelStep& step : steps) {
    all.push_back({step.damping_m2, step.torque_m, step.offset_begin_rad, step.offset_end_rad});
  }
  return all;
}

}  // namespace

AirframeSpread::AirframeSpread(const std::vector<TunnelStep>& steps, const DampingFactor& damping,
                               const std::optional<AreaFactor>& area, const std::vector<TunnelStep>& standard_errors)
    : next_step_{rows(steps), rows(standard_errors)}, damping_{damping}, area_{area} {}

TunnelStep AirframeSpread::draw(std::uint64_t seed) const {
  sim::Random random{seed, airframe_stream};
  const double factor = damping_.low + random.uniform() * (damping_.high - damping_.low);
  const double area = area_ ? draw_factor(*area_, seed) : 1.0;
  std::vector<double> normals(next_step_.normals());
  for (;;) {
    std::ranges::generate(normals, [&] { return random.gaussian(); });
    const std::vector<double> step = next_step_.draw(normals);
    if (step[0] > 0.0 && step[1] > 0.0) {
      return {.damping_m2 = factor * area * step[0],
              .torque_m = area * step[1],
              .offset_begin_rad = step[2],
              .offset_end_rad = step[3]};
    }
  }
}

}  // namespace fantail::predict
