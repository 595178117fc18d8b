// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "core/inputs.hpp"
#include "detection/kind.hpp"
#include "detection/motion.hpp"
#include "sim/random.hpp"

namespace fantail::detection {

inline constexpr std::array<float, 2> accelerometer_range_m_s2{16.0F * core::standard_gravity_m_s2,
                                                               32.0F * core::standard_gravity_m_s2};

/// How many steps an accelerometer that repeats its sample is still used: the limits of the board's two drivers.
inline constexpr std::array<std::size_t, 2> frozen_unnoticed{20, 110};

/// What is wrong with the sensors of one event. Biases are the same through all of it.
struct SensorErrors {
  std::array<core::Vector3, 2> bias_m_s2;
  core::Vector3 gyro_bias_rad_s;
  Condition condition = Condition::well;
  std::size_t bad = 0;    ///< which accelerometer
  std::size_t onset = 0;  ///< from this step on
};

/// An angle that is turned step by step, so that no sine is needed; kept at unit length to the second order.
struct Turned {
  float cosine = 1.0F;
  float sine = 0.0F;
  void turn(float angle_rad);
};

inline constexpr float force_noise_m_s2 = 0.3F;  ///< of each accelerometer, as the shipped vehicles have it

/// What both accelerometers read along the axis, with noise, zeros, ends of range and the fault, and which way is up.
struct Readings {
  SensorErrors errors;
  std::array<float, Motion::most> felt_m_s2;  ///< specific force along the axis
  float smallest_felt_m_s2 = 0.0F;
  float largest_felt_m_s2 = 0.0F;
  std::array<std::array<float, Motion::most>, 2> axial_m_s2;
  std::array<std::array<core::SampleQuality, Motion::most>, 2> quality;
  std::array<float, Motion::most> up_x;
  std::array<float, Motion::most> up_z;
};

/// In two parts, because the second is needed for few events and takes longer than all else: what is felt and how the
/// accelerometers are, and then what they say. `random`: Streams::axial of this event.
void begin_readings(Kind kind, std::uint64_t event, const Motion& motion, sim::Random& random, Readings& readings);
void finish_readings(const Motion& motion, sim::Random& random, Readings& readings);

/// All inputs of the flight law, tick by tick. Before the event the rocket has stood still for as long as
/// the estimator's average takes; to save time these ticks are 4 ms apart, which is no gap to any plan.
class InputMaker {
 public:
  static constexpr core::Microseconds event_begin{10'000'000};
  static constexpr core::Microseconds pad_tick{4'000};
  static constexpr int pad_ticks = 950;

  /// `random`: Streams::others of this event. The rest outlives it.
  InputMaker(const Motion& motion, const Readings& readings, sim::Random random);

  /// The pad ticks in their order; with the last comes the arm command, so that nothing before the event
  /// counts.
  [[nodiscard]] const core::Inputs& pad(int tick);
  /// The steps of the event in their order.
  [[nodiscard]] const core::Inputs& step(std::size_t step);

 private:
  void set_gyro(const core::Vector3& rate_rad_s, const std::array<double, 3>& noise);

  const Motion& motion_;
  const Readings& readings_;
  sim::Random random_;
  Turned roll_;
  float stuck_y_m_s2_ = 0.0F;
  float stuck_z_m_s2_ = 0.0F;
  core::Inputs inputs_;
};

}  // namespace fantail::detection
