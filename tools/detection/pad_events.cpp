// SPDX-License-Identifier: MIT
// What happens to a rocket on its rail that does not fly.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "detection/event_models.hpp"
#include "detection/shapes.hpp"
#include "sim/elementary.hpp"
#include "sim/rotation.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

std::span<float> all_of(std::array<float, Motion::most>& values, const Motion& motion) {
  return {values.data(), motion.length};
}

std::span<float> part_of(std::array<float, Motion::most>& values, const Motion& motion, double begin_s, double time_s) {
  const std::size_t first = std::min(motion.length, steps(begin_s));
  return {values.data() + first, std::min(motion.length - first, steps(time_s))};
}

void shake(Streams& streams, Motion& motion, double begin_s, double time_s, double rms, double frequency_hz, bool all) {
  add_band_noise(part_of(motion.axial_m_s2, motion, begin_s, time_s), rms, frequency_hz, streams.model);
  if (all) {
    add_band_noise(part_of(motion.across_m_s2, motion, begin_s, time_s), rms, frequency_hz, streams.across);
  }
}

/// Knocks on the rail, mostly across it.
void add_knocks(sim::Random& random, Motion& motion, int most, double lowest_g, double highest_g, double widest_s) {
  const auto count = static_cast<int>((most + 1) * random.uniform());
  for (int i = 0; i < count; ++i) {
    const double start_s = uniform(random, lead_s, step_s * static_cast<double>(motion.length));
    const double width_s = uniform(random, 0.003, widest_s);
    const double peak = uniform(random, lowest_g, highest_g) * g * (random.uniform() < 0.5 ? -1.0 : 1.0);
    add_half_sine(all_of(motion.axial_m_s2, motion), start_s, width_s, peak * uniform(random, -0.5, 0.5));
    add_half_sine(all_of(motion.across_m_s2, motion), start_s, width_s, peak);
  }
}

/// One burst and the hop that follows from it; when the rocket has landed.
double add_chuff(Streams& streams, Motion& motion, double start_s, bool all) {
  constexpr double highest_rise_m = 3.5;
  sim::Random& random = streams.model;
  const double thrust = uniform(random, 2.0, 12.0) * g;
  double burn_s = log_uniform(random, 0.02, 0.4);
  const double weight = g * sim::sine_cosine(motion.start_pitch_rad).cosine;
  const double net = thrust - weight;
  // Risen by 0.5 net t^2 and then by (net t)^2 / (2 weight).
  const double rise_of_a_second = 0.5 * net * (1.0 + net / weight);
  burn_s = std::min(burn_s, std::sqrt(highest_rise_m / rise_of_a_second));
  burn_s = step_s * static_cast<double>(steps(burn_s));
  const double speed = net * burn_s;
  const double height = 0.5 * speed * burn_s;
  const double landing_speed = std::sqrt(speed * speed + 2.0 * weight * height);
  const double flight_s = (speed + landing_speed) / weight;

  for (float& axial : part_of(motion.axial_m_s2, motion, start_s, burn_s)) {
    axial += static_cast<float>(net);
  }
  shake(streams, motion, start_s, burn_s, uniform(random, 0.2, 2.0) * g, log_uniform(random, 40.0, 450.0), all);
  // In the air the rail carries its part across, and nothing the part along the axis.
  for (float& axial : part_of(motion.axial_m_s2, motion, start_s + burn_s, flight_s)) {
    axial -= static_cast<float>(weight);
  }
  const double landing_s = start_s + burn_s + flight_s;
  const double width_s = log_uniform(random, 0.003, 0.03);
  add_half_sine(all_of(motion.axial_m_s2, motion), landing_s, width_s,
                landing_speed * std::numbers::pi / (2.0 * width_s));
  return landing_s + width_s;
}

}  // namespace

void make_chuff(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  motion.begin(steps(3.0), uniform(random, 0.0, largest_tilt_rad));
  const auto bursts = 1 + static_cast<int>(3.0 * random.uniform());
  double t = lead_s;
  for (int i = 0; i < bursts && t < 2.5; ++i) {
    t = add_chuff(streams, motion, t, all) + uniform(random, 0.1, 0.6);
  }
}

void make_misfire(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  motion.begin(steps(2.5), uniform(random, 0.0, largest_tilt_rad));
  add_half_sine(all_of(motion.axial_m_s2, motion), lead_s, uniform(random, 0.002, 0.005),
                uniform(random, 0.5, 4.0) * g);
  // A thrust below the weight is taken off what the pad carries, and the accelerometer reads no less.
  const double begin_s = lead_s + uniform(random, 0.01, 0.3);
  const double time_s = uniform(random, 0.3, 2.0);
  shake(streams, motion, begin_s, time_s, uniform(random, 0.1, 2.0) * g, log_uniform(random, 20.0, 450.0), all);
}

void make_neighbour(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  motion.begin(steps(2.0), uniform(random, 0.0, largest_tilt_rad));
  const double rms = log_uniform(random, 0.05, 1.0) * g;
  const double frequency_hz = log_uniform(random, 40.0, 450.0);
  const double rise_s = uniform(random, 0.1, 0.5);
  const double decay_s = uniform(random, 0.3, 1.5);
  std::array<float, 2'000> envelope;
  const std::size_t first = steps(lead_s);
  const double decay_a_step = sim::exponential(-step_s / decay_s);
  double level = 0.0;
  for (std::size_t i = 0; i < motion.length - first; ++i) {
    level = static_cast<double>(i) * step_s < rise_s ? static_cast<double>(i) * step_s / rise_s : level * decay_a_step;
    envelope[i] = static_cast<float>(level);
  }
  const std::span<const float> used{envelope.data(), motion.length - first};
  add_band_noise(all_of(motion.axial_m_s2, motion).subspan(first), rms, frequency_hz, random, used);
  if (all) {
    add_band_noise(all_of(motion.across_m_s2, motion).subspan(first), rms, frequency_hz, streams.across, used);
  }
  const double thump = uniform(random, 0.2, 1.0) * g;
  add_half_sine(all_of(motion.axial_m_s2, motion), lead_s, uniform(random, 0.02, 0.06), thump);
}

void make_gust(sim::Random& random, Motion& motion) {
  const double amplitude = uniform(random, 0.2, 5.0) * sim::radians_per_degree;
  motion.begin(steps(2.5), uniform(random, 0.0, largest_tilt_rad));
  motion.turns = true;
  const double frequency_hz = log_uniform(random, 0.5, 5.0);
  const double w = 2.0 * std::numbers::pi * frequency_hz;
  const double arm_m = uniform(random, 0.5, 2.0);
  Oscillator swing{frequency_hz, 0.0};
  for (std::size_t i = steps(lead_s); i < motion.length; ++i, swing.advance()) {
    const double rate = amplitude * w * swing.cosine();
    motion.pitch_rate_rad_s[i] = static_cast<float>(rate);
    motion.axial_m_s2[i] = static_cast<float>(-arm_m * rate * rate);
    // Turning towards positive pitch moves the upper part towards -z.
    motion.across_m_s2[i] = static_cast<float>(arm_m * amplitude * w * w * swing.sine());
  }
  add_knocks(random, motion, 6, 0.5, 4.0, 0.02);
}

void make_vibration(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  motion.begin(steps(2.0), uniform(random, 0.0, largest_tilt_rad));
  const double rms = uniform(random, 0.0, 2.0) * g;
  shake(streams, motion, lead_s, 2.0, rms, log_uniform(random, 20.0, 450.0), all);
}

void make_tilt(sim::Random& random, Motion& motion) {
  const double from = uniform(random, 0.0, largest_tilt_rad);
  const double to = uniform(random, 0.0, largest_tilt_rad);
  motion.begin(steps(2.5), from);
  motion.turns = true;
  const double time_s = uniform(random, 0.5, 2.0);
  add_half_sine(all_of(motion.pitch_rate_rad_s, motion), lead_s, time_s,
                (to - from) * std::numbers::pi / (2.0 * time_s));
  add_knocks(random, motion, 4, 1.0, 5.0, 0.03);
}

}  // namespace fantail::detection
