// SPDX-License-Identifier: MIT
// What happens to a rocket in hands and on the road.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "detection/event_models.hpp"
#include "detection/shapes.hpp"
#include "sim/rotation.hpp"

namespace fantail::detection {
namespace {

std::span<float> used(std::array<float, Motion::most>& values, const Motion& motion) {
  return {values.data(), motion.length};
}

/// A shock straight up in the frame of the earth, on a rocket whose pitch is this.
void add_shock(Motion& motion, double start_s, double width_s, double peak_m_s2, double pitch_rad) {
  const auto up = sim::sine_cosine(pitch_rad);
  add_half_sine(used(motion.axial_m_s2, motion), start_s, width_s, peak_m_s2 * up.cosine);
  add_half_sine(used(motion.across_m_s2, motion), start_s, width_s, peak_m_s2 * up.sine);
}

/// Turns by this angle, slowly at both ends.
double add_turn(Motion& motion, double start_s, double time_s, double angle_rad) {
  add_half_sine(used(motion.pitch_rate_rad_s, motion), start_s, time_s, angle_rad * std::numbers::pi / (2.0 * time_s));
  motion.turns = true;
  return angle_rad;
}

/// Largest half stroke [m] that arms of this reach, force and power have at this frequency with 4 kg in them.
double longest_stroke_m(double frequency_hz) {
  constexpr double mass_kg = 4.0;
  constexpr double reach_m = 0.3;
  constexpr double force_n = 300.0;
  constexpr double power_w = 600.0;
  const double w = 2.0 * std::numbers::pi * frequency_hz;
  return std::min({reach_m, force_n / (mass_kg * w * w), std::sqrt(2.0 * power_w / (mass_kg * w * w * w))});
}

}  // namespace

void make_handling(sim::Random& random, Motion& motion) {
  const double pitch = uniform(random, 0.0, 180.0 * degree);
  motion.begin(steps(2.5), pitch);
  const double lift_width = uniform(random, 0.15, 0.5);
  const double lift_speed = uniform(random, 0.3, 1.5);
  const double lift_peak = lift_speed * std::numbers::pi / (2.0 * lift_width);
  const double slow_down_s = lead_s + lift_width + uniform(random, 0.0, 0.2);
  add_shock(motion, lead_s, lift_width, lift_peak, pitch);
  add_shock(motion, slow_down_s, lift_width, -lift_peak, pitch);

  const double turned = pitch + add_turn(motion, uniform(random, lead_s, 0.8), uniform(random, 0.5, 1.5),
                                         uniform(random, -180.0 * degree, 180.0 * degree));
  // The walk's bounce goes by the way the rocket is held afterwards.
  const double walk_hz = uniform(random, 1.4, 2.5);
  const double bounce = uniform(random, 0.1, 0.5) * g;
  const double heel = uniform(random, 0.2, 1.0) * g;
  const auto up = sim::sine_cosine(turned);
  Oscillator walk{walk_hz, uniform(random, 0.0, 6.28)};
  const double walk_begins_s = slow_down_s + lift_width;
  for (std::size_t i = std::min(motion.length, steps(walk_begins_s)); i < motion.length; ++i, walk.advance()) {
    motion.axial_m_s2[i] += static_cast<float>(bounce * up.cosine * walk.sine());
    motion.across_m_s2[i] += static_cast<float>(bounce * up.sine * walk.sine());
  }
  double heel_s = walk_begins_s;
  while (heel_s < 2.3) {
    add_shock(motion, heel_s, uniform(random, 0.03, 0.08), heel, turned);
    heel_s += 1.0 / walk_hz;
  }
  add_shock(motion, 2.35, uniform(random, 0.005, 0.03), uniform(random, 1.0, 6.0) * g, turned);
}

void make_drop(sim::Random& random, Motion& motion) {
  constexpr int most_bounces = 4;
  const double pitch =
      random.uniform() < 0.5 ? uniform(random, 0.0, 20.0 * degree) : uniform(random, 0.0, std::numbers::pi);
  motion.begin(steps(1.8), pitch);
  const double height_m = uniform(random, 0.02, 1.22);
  const double restitution = uniform(random, 0.0, 0.5);
  const double width_s = log_uniform(random, 0.002, 0.04);
  double speed = std::sqrt(2.0 * g * height_m);
  double t = lead_s;
  double fall_s = speed / g;
  for (int bounce = 0; bounce <= most_bounces && t < 1.8; ++bounce) {
    const std::size_t end = std::min(motion.length, steps(t + fall_s));
    std::fill(motion.carried.begin() + static_cast<std::ptrdiff_t>(std::min(end, steps(t))),
              motion.carried.begin() + static_cast<std::ptrdiff_t>(end), 0.0F);
    const double this_width = width_s * uniform(random, 0.8, 1.2);
    const double change = speed * (1.0 + restitution);
    add_shock(motion, t + fall_s, this_width, change * std::numbers::pi / (2.0 * this_width), pitch);
    t += fall_s + this_width;
    speed *= restitution;
    fall_s = 2.0 * speed / g;
    if (speed < 0.1) {
      break;
    }
  }
  // In falling over it turns by at most a quarter.
  (void)add_turn(motion, lead_s + std::sqrt(2.0 * height_m / g), 0.5, uniform(random, -90.0 * degree, 90.0 * degree));
}

void make_transport(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  const bool lies = random.uniform() < 0.5;
  const double pitch = lies ? uniform(random, 70.0 * degree, 110.0 * degree) : uniform(random, 0.0, 20.0 * degree);
  motion.begin(steps(2.5), pitch);
  // Along a rocket that lies, a road shakes 0.7 times as much as upwards.
  const double along = lies ? 0.7 : 1.0;
  const double body_hz = uniform(random, 2.0, 5.0);
  const double body = along * uniform(random, 0.1, 0.4) * g;
  const double road_hz = log_uniform(random, 10.0, 150.0);
  const double road = along * uniform(random, 0.1, 1.1) * g;
  add_band_noise(used(motion.axial_m_s2, motion), body, body_hz, random);
  add_band_noise(used(motion.axial_m_s2, motion), road, road_hz, random);
  if (all) {
    add_band_noise(used(motion.across_m_s2, motion), body, body_hz, streams.across);
    add_band_noise(used(motion.across_m_s2, motion), road, road_hz, streams.across);
  }
  const auto holes = static_cast<int>(4.0 * random.uniform());
  for (int hole = 0; hole < holes; ++hole) {
    add_shock(motion, uniform(random, lead_s, 2.4), uniform(random, 0.015, 0.06), uniform(random, 1.0, 6.0) * g, pitch);
  }
}

void add_shaking(sim::Random& random, Motion& motion, std::size_t first, std::size_t last, double least_share) {
  const double frequency_hz = log_uniform(random, 1.0, 8.0);
  const double w = 2.0 * std::numbers::pi * frequency_hz;
  // The second harmonic's share is within the bounds, and not on top of them.
  const double harmonic = uniform(random, 0.0, 0.3);
  const double peak = uniform(random, least_share, 1.0) * longest_stroke_m(frequency_hz) * w * w / (1.0 + harmonic);
  const double second = harmonic * peak;
  Oscillator hand{frequency_hz, random.uniform() < 0.5 ? 0.0 : std::numbers::pi};
  Oscillator twice{2.0 * frequency_hz, uniform(random, 0.0, 6.28)};
  Oscillator wobble{uniform(random, 0.5, 4.0), uniform(random, 0.0, 6.28)};
  const double wobble_rate = uniform(random, 0.0, 1.5);
  motion.turns = true;
  // Half a period until the arms are up to it.
  const double rise = std::min(1.0, 2.0 * frequency_hz * step_s);
  double share = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    share = std::min(1.0, share + rise);
    motion.axial_m_s2[i] = static_cast<float>(share * (peak * hand.sine() + second * twice.sine()));
    motion.pitch_rate_rad_s[i] = static_cast<float>(share * wobble_rate * wobble.cosine());
    hand.advance();
    twice.advance();
    wobble.advance();
  }
}

void make_shaking(sim::Random& random, Motion& motion) {
  motion.begin(steps(3.0), uniform(random, 0.0, 90.0 * degree));
  add_shaking(random, motion, steps(lead_s), motion.length, 0.3);
}

}  // namespace fantail::detection
