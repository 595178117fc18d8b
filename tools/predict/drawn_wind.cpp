// SPDX-License-Identifier: MIT
#include <numbers>

#include "predict/run.hpp"
#include "sim/random.hpp"

namespace fantail::predict {
namespace {

constexpr std::uint64_t wind_stream = 1002;  // after those of airframe.cpp

}  // namespace

sim::WindParameters drawn_wind(const sim::WindParameters& stated, const sim::WindSpread& spread, std::uint64_t seed) {
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  sim::WindParameters wind = stated;
  sim::Random random{seed, wind_stream};
  if (spread.direction_rad > 0.0) {
    wind.from_rad = stated.from_rad + spread.direction_rad * (2.0 * random.uniform() - 1.0);
    wind.from_rad += wind.from_rad < 0.0 ? turn_rad : wind.from_rad >= turn_rad ? -turn_rad : 0.0;
  }
  if (spread.speed_m_s > 0.0) {
    do {
      wind.speed_m_s = stated.speed_m_s + spread.speed_m_s * random.gaussian();
    } while (wind.speed_m_s < 0.0);
  }
  return wind;
}

}  // namespace fantail::predict
