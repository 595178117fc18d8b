// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "detection/event_models.hpp"
#include "detection/shapes.hpp"
#include "sim/rotation.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

constexpr double least_thrust = 3.0 * sim::gravity_m_s2;

/// Thrust over mass.
struct Burn {
  double peak;
  double rise_s;
  double sag_per_s;  ///< share of the peak
  double burn_s;

  [[nodiscard]] double at(double t) const {
    if (t < 0.0 || t > burn_s) {
      return 0.0;
    }
    if (t < rise_s) {
      return peak * t / rise_s;
    }
    return std::max(least_thrust, peak * (1.0 - sag_per_s * (t - rise_s)));
  }
};

}  // namespace

void make_launch(Streams& streams, Motion& motion, double rms_g, bool all) {
  constexpr double guide_m = 4.0;  // of Tasha III; beyond it nothing carries the rocket
  constexpr double drag_per_m = 0.5 * 1.2 * 0.005 / 4.0;
  sim::Random& random = streams.model;
  motion.begin(steps(2.5), uniform(random, 0.0, 15.0 * sim::radians_per_degree));
  motion.ignition = steps(0.25 + uniform(random, 0.0, 0.1));
  const Burn burn{.peak = log_uniform(random, 3.0, 20.0) * sim::gravity_m_s2,
                  .rise_s = log_uniform(random, 0.01, 0.6),
                  .sag_per_s = uniform(random, 0.0, 0.25),
                  .burn_s = uniform(random, 1.0, 3.0)};
  motion.peak_thrust_m_s2 = burn.peak;
  const double drawn_rms = uniform(random, 0.0, 2.0);
  const double rms = (rms_g < 0.0 ? drawn_rms : rms_g) * sim::gravity_m_s2;
  const double frequency_hz = log_uniform(random, 40.0, 450.0);
  const double weight = sim::gravity_m_s2 * sim::sine_cosine(motion.start_pitch_rad).cosine;

  double speed = 0.0;
  double distance = 0.0;
  std::array<float, Motion::most> envelope;
  for (std::size_t i = 0; i < motion.length; ++i) {
    const double t = (static_cast<double>(i) - static_cast<double>(motion.ignition)) * step_s;
    const double thrust = burn.at(t);
    const bool in_guide = distance < guide_m;
    double force = thrust - drag_per_m * speed * speed;
    if (distance <= 0.0 && force < weight) {
      force = weight;  // the pad carries the rest
    }
    motion.thrust_m_s2[i] = static_cast<float>(force);
    motion.distance_m[i] = static_cast<float>(distance);
    motion.carried[i] = in_guide ? 1.0F : 0.0F;
    motion.axial_m_s2[i] = static_cast<float>(in_guide ? force - weight : force);
    envelope[i] = static_cast<float>(std::min(1.0, thrust / least_thrust));
    const double before = speed;
    speed += (force - weight) * step_s;
    distance += 0.5 * (before + speed) * step_s;
  }
  const std::span<const float> used{envelope.data(), motion.length};
  add_band_noise({motion.axial_m_s2.data(), motion.length}, rms, frequency_hz, random, used);
  if (all) {
    add_band_noise({motion.across_m_s2.data(), motion.length}, rms, frequency_hz, streams.across, used);
  }
}

}  // namespace fantail::detection
