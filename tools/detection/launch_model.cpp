// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "detection/burn.hpp"
#include "detection/event_models.hpp"
#include "detection/shapes.hpp"
#include "sim/rotation.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

constexpr double least_thrust = 3.0 * sim::gravity_m_s2;
constexpr double after_ignition_s = 2.25;

/// From step `first` on; ignition is that of the motion.
void add_launch(Streams& streams, Motion& motion, double pitch_rad, std::size_t first, double rms_g, bool all) {
  sim::Random& random = streams.model;
  const Burn burn{.peak = log_uniform(random, 3.0, 20.0) * sim::gravity_m_s2,
                  .rise_s = log_uniform(random, 0.01, 0.6),
                  .sag_per_s = uniform(random, 0.0, 0.25),
                  .burn_s = uniform(random, 1.0, 3.0),
                  .least = least_thrust};
  motion.peak_thrust_m_s2 = burn.peak;
  const double drawn_rms = uniform(random, 0.0, 2.0);
  const BurnVibration vibration{.rms_m_s2 = (rms_g < 0.0 ? drawn_rms : rms_g) * sim::gravity_m_s2,
                                .frequency_hz = log_uniform(random, 40.0, 450.0)};
  (void)rise(burn, vibration, pitch_rad, first, motion.ignition, streams, motion, all);
}

}  // namespace

std::size_t rise(const Burn& burn, const BurnVibration& vibration, double pitch_rad, std::size_t first,
                 std::size_t ignition, Streams& streams, Motion& motion, bool all) {
  constexpr double guide_m = 4.0;  // of Tasha III; beyond it nothing carries the rocket
  constexpr double drag_per_m = 0.5 * 1.2 * 0.005 / 4.0;
  constexpr std::size_t longest_burn = 5'000;
  const double weight = sim::gravity_m_s2 * sim::sine_cosine(pitch_rad).cosine;

  double speed = 0.0;
  double distance = 0.0;
  std::array<float, longest_burn> envelope;
  const std::size_t shaken = std::min(longest_burn, motion.length - first);
  std::size_t end = first;
  for (; end < motion.length; ++end) {
    const double t = (static_cast<double>(end) - static_cast<double>(ignition)) * step_s;
    if (t > burn.burn_s && speed <= 0.0) {
      break;
    }
    const double thrust = burn.at(t);
    const bool in_guide = distance < guide_m;
    double force = thrust - drag_per_m * speed * speed;
    if (distance <= 0.0 && force < weight) {
      force = weight;  // the pad carries the rest
    }
    motion.thrust_m_s2[end] = static_cast<float>(force);
    motion.distance_m[end] = static_cast<float>(distance);
    motion.carried[end] = in_guide ? 1.0F : 0.0F;
    motion.axial_m_s2[end] += static_cast<float>(in_guide ? force - weight : force);
    if (end - first < shaken) {
      envelope[end - first] = static_cast<float>(std::min(1.0, thrust / burn.least));
    }
    const double before = speed;
    speed += (force - weight) * step_s;
    distance += 0.5 * (before + speed) * step_s;
  }
  const std::span<const float> used{envelope.data(), std::min(shaken, end - first)};
  add_band_noise({motion.axial_m_s2.data() + first, used.size()}, vibration.rms_m_s2, vibration.frequency_hz,
                 streams.model, used);
  if (all) {
    add_band_noise({motion.across_m_s2.data() + first, used.size()}, vibration.rms_m_s2, vibration.frequency_hz,
                   streams.across, used);
  }
  return end;
}

void make_launch(Streams& streams, Motion& motion, double rms_g, bool all) {
  sim::Random& random = streams.model;
  motion.begin(steps(2.5), uniform(random, 0.0, largest_tilt_rad));
  motion.ignition = steps(0.25 + uniform(random, 0.0, 0.1));
  add_launch(streams, motion, motion.start_pitch_rad, 0, rms_g, all);
}

void make_stirred_launch(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  const double which = uniform(random, 0.0, 4.0);
  if (which < 1.0) {
    make_gust(random, motion);
  } else if (which < 2.0) {
    make_misfire(streams, motion, all);
  } else if (which < 3.0) {
    make_neighbour(streams, motion, all);
  } else {
    make_vibration(streams, motion, all);
  }
  double pitch = motion.start_pitch_rad;
  for (std::size_t i = 0; i < motion.length; ++i) {
    pitch += step_s * static_cast<double>(motion.pitch_rate_rad_s[i]);
  }
  motion.ignition = motion.length + steps(uniform(random, 0.0, 1.0));
  motion.stand(motion.ignition - motion.length + steps(after_ignition_s));
  std::fill_n(motion.distance_m.begin(), motion.ignition, 0.0F);
  add_launch(streams, motion, pitch, motion.ignition, -1.0, all);
}

void make_raised_rail(Streams& streams, Motion& motion, bool all) {
  sim::Random& random = streams.model;
  const double pitch = uniform(random, 0.0, largest_tilt_rad);
  const double raised = uniform(random, 5.0, 90.0) * sim::radians_per_degree;
  const double raising_s = uniform(random, 1.0, 5.0);
  const double still_s = uniform(random, 0.2, 10.0);
  const double knock_s = random.uniform() < 0.5 ? 0.0 : uniform(random, 0.005, 0.03);
  const double knock = uniform(random, 1.0, 4.0) * sim::gravity_m_s2;
  const std::size_t still_from = steps(lead_s + raising_s + knock_s);
  motion.begin(still_from + steps(still_s + after_ignition_s), pitch + raised);
  motion.still_from = still_from;
  motion.ignition = motion.still_from + steps(still_s);
  std::fill_n(motion.distance_m.begin(), motion.ignition, 0.0F);
  motion.turns = true;
  add_half_sine({motion.pitch_rate_rad_s.data(), motion.length}, lead_s, raising_s,
                -raised * std::numbers::pi / (2.0 * raising_s));
  if (knock_s > 0.0) {
    add_half_sine({motion.across_m_s2.data(), motion.length}, lead_s + raising_s, knock_s, knock);
    add_half_sine({motion.axial_m_s2.data(), motion.length}, lead_s + raising_s, knock_s, 0.5 * knock);
  }
  add_launch(streams, motion, pitch, motion.ignition, -1.0, all);
}

}  // namespace fantail::detection
