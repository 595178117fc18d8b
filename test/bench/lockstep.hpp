// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bench/exercise.hpp"
#include "core/canard_mixer.hpp"
#include "core/flight_plan_fields.hpp"
#include "link/avionics_link.hpp"
#include "sim/random.hpp"
#include "sim/sensor_models.hpp"
#include "sim/servo.hpp"

namespace fantail::bench {

/// Four simulated servos and encoders behind the flight mixer, driven by an exercise tick by tick: no bus, no real
/// time.
struct LockStep {
  static constexpr double degree = 3.14159265358979323846 / 180.0;

  core::FlightPlan plan = core::default_plan();
  Each<sim::ServoParameters> servo{};
  Each<sim::ServoFault> fault{};
  Each<bool> unplugged{};
  sim::EncoderParameters encoder{};
  Each<double> more_noise_rad{};
  Each<double> jammed_at_rad{};  ///< of a stuck one
  std::array<std::size_t, 4> plug{0, 1, 2, 3};
  std::uint64_t seed = 1;

  [[nodiscard]] Bounds bounds() const {
    Bounds b;
    const core::CanardMixer mixer{plan.canards, plan.controller.canard_limit};
    for (std::size_t i = 0; i < 4; ++i) {
      b.limit_rad[i] = static_cast<double>(mixer.limit(i).radians());
      b.centre_rad[i] = static_cast<double>(plan.canards.each[i].trim.radians());
    }
    return b;
  }

  [[nodiscard]] link::Recording record(const Exercise& exercise) const {
    core::CanardMixer mixer{plan.canards, plan.controller.canard_limit};
    Each<sim::Servo> servos{sim::Servo{servo[0]}, sim::Servo{servo[1]}, sim::Servo{servo[2]}, sim::Servo{servo[3]}};
    sim::EncoderModel encoders{{}, encoder, sim::Random{seed, 7}};
    sim::Random noise{seed, 8};
    Each<std::optional<double>> pulse{};
    constexpr int settle = 1500;
    link::Recording recording;
    const int ticks = settle + static_cast<int>(std::lround(exercise.duration_s() * 1000.0));
    for (int t = 0; t < ticks; ++t) {
      if (t == settle / 2) {
        for (std::size_t i = 0; i < 4; ++i) {
          servos[i].fail(fault[i]);
        }
      }
      Each<double> shaft{};
      for (std::size_t i = 0; i < 4; ++i) {
        shaft[i] = servos[i].angle_rad() + jammed_at_rad[i] + more_noise_rad[i] * noise.gaussian();
      }
      const hal::EncoderReading reading = encoders.sample(core::Microseconds{1000LL * t}, shaft);
      core::EncoderAngles read{};
      link::Tick tick{.number = t};
      for (std::size_t i = 0; i < 4; ++i) {
        const bool answers = !unplugged[i] || t < settle / 2;
        if (answers && reading.each[i].status == hal::Status::ok) {
          const int counts = reading.each[i].counts > 8191 ? reading.each[i].counts - 16384 : reading.each[i].counts;
          const double angle_rad = counts * 360.0 / 16384.0 * degree;
          read[i] = core::Angle::from_radians(static_cast<float>(angle_rad));
          tick.encoder_rad[i] = std::clamp(std::round(angle_rad / (0.01 * degree)), -2047.0, 2047.0) * 0.01 * degree;
        }
      }
      const double time_s = 0.001 * (t - settle);
      std::array<core::Angle, 4> request{};
      const protocol::PerCanard asked = exercise.asked(time_s);
      for (std::size_t i = 0; i < 4; ++i) {
        request[i] = asked[i].value_or(plan.canards.each[i].trim);
      }
      core::CanardCommands commands;
      mixer.mix(core::Microseconds{1000LL * t}, core::Angle{}, request, read, commands);
      for (std::size_t i = 0; i < 4; ++i) {
        tick.limited[i] = commands[i].limited;
        if (commands[i].driven) {
          tick.command_rad[i] =
              std::round(static_cast<double>(commands[i].angle.radians()) / (0.01 * degree)) * 0.01 * degree;
          pulse[i] = std::round(1000.0 * static_cast<double>(commands[i].pulse_us)) / 1000.0;
        }
      }
      for (std::size_t i = 0; i < 4; ++i) {
        servos[plug[i]].step(0.001 * t, 0.001, pulse[i]);
      }
      tick.stretch = exercise.stretch_at(time_s);
      if (t >= settle) {
        recording.add(tick);
      }
    }
    return recording;
  }
};

}  // namespace fantail::bench
