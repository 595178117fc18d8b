// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "core/flight_plan.hpp"
#include "hal/accelerometer.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "sim/delay_line.hpp"
#include "sim/random.hpp"
#include "sim/units.hpp"

namespace fantail::sim {

/// One inertial sensor: three axes of specific force and, in an IMU, three of angular rate.
struct InertialParameters {
  double rate_noise_rad_s = 0.1 * radians_per_degree;     ///< standard deviation, white from sample to sample
  double rate_bias_rad_s = 0.0;                           ///< the same on every axis
  double full_scale_rad_s = 2000.0 * radians_per_degree;  ///< 32768 counts
  double specific_force_noise_m_s2 = 0.3;                 ///< standard deviation, white from sample to sample
  double specific_force_bias_m_s2 = 0.0;                  ///< the same on every axis
  double full_scale_m_s2 = 16.0 * gravity_m_s2;           ///< 32768 counts
  double misalignment_rad = 0.0;  ///< the package is turned by this about an axis across the rocket, 0 to 0.2
  double delay_s = 0.0;           ///< from measured to delivered, 0 to 0.02
  /// How it is soldered in, in truth; what the avionics believes of it stands in its plan.
  core::SensorMounting mounting{.to_nose = core::SensorAxis::plus_x, .along_y = core::SensorAxis::plus_y};
};

/// One three-axis converter, from a true vector in the rocket's frame to counts. In this order:
///   1. mounting and misalignment: the vector is seen along the sensor's own, slightly turned axes;
///   2. bias, and 3. noise are added there;
///   4. rounding to the nearest count, 32768 of them being the full scale;
///   5. the ends of int16: beyond them it stays at that end, and a NaN stands at the lower one.
/// Delay and dropouts come after it, and are the device's.
///
/// Example: 1 g along the axis, full scale 16 g, so that a count is 0.00479 m/s2. Aligned it makes 2048 counts; a bias
/// of 0.1 m/s2 adds 20.9; noise of 0.3 m/s2 that draws +1 standard deviation adds 62.7; 2131.5 is rounded to 2132,
/// which the avionics reads as 10.21 m/s2. With a delay of 2 ms it gets that sample two ticks later, with the time of
/// its measurement.
class TriaxialConverter {
 public:
  struct Errors {
    double noise;
    double bias;
    double full_scale;
  };
  using Rotation = std::array<Vector3, 3>;  ///< rows

  TriaxialConverter(const Errors& errors, const Rotation& from_body);

  void convert(const Vector3& truth, std::span<const double, 3> gaussians, hal::Counts& counts) const {
    for (std::size_t axis = 0; axis < counts.size(); ++axis) {
      const Vector3& row = counts_per_unit_[axis];
      const double ideal = row.x * truth.x + row.y * truth.y + row.z * truth.z;
      counts[axis] = nearest_count(ideal + offset_ + noise_ * gaussians[axis]);
    }
  }

 private:
  [[nodiscard]] static std::int16_t nearest_count(double value) {
    constexpr double lowest = -32768.0;
    constexpr double highest = 32767.0;
    value = value > lowest ? value : lowest;
    value = value < highest ? value : highest;
    return static_cast<std::int16_t>(static_cast<std::int32_t>(value + 32768.5) - 32768);
  }

  Rotation counts_per_unit_;
  double offset_;  ///< counts
  double noise_;   ///< counts
};

/// Gyro and accelerometer in one package, so turned by the same misalignment.
class ImuModel {
 public:
  /// `random` is this sensor's own stream; it also picks the axis of the misalignment. Throws std::invalid_argument
  /// for a parameter outside its range.
  ImuModel(const InertialParameters& parameters, Random random);

  [[nodiscard]] hal::ImuScale scale() const { return scale_; }

  /// What the device delivers at `time`, called once per sample with increasing times. The sample's own time is the one
  /// at which it was measured. In a dropout the device hangs: nothing is measured and its last sample comes again.
  [[nodiscard]] const hal::ImuSample& sample(hal::Microseconds time, const Vector3& rate_rad_s,
                                             const Vector3& specific_force_m_s2, bool dropout) {
    if (dropout) {
      return line_.repeated();
    }
    const std::array<double, 6> noise = random_.gaussians<6>();
    hal::ImuSample& measured = line_.next();
    measured.time = time;
    measured.status = hal::Status::ok;
    gyro_.convert(rate_rad_s, std::span{noise}.first<3>(), measured.rate);
    accelerometer_.convert(specific_force_m_s2, std::span{noise}.last<3>(), measured.specific_force);
    return line_.arrived(time);
  }

 private:
  Random random_;  // first: the misalignment draws from it
  TriaxialConverter::Rotation from_body_;
  TriaxialConverter gyro_;
  TriaxialConverter accelerometer_;
  hal::ImuScale scale_;
  DelayLine<hal::ImuSample> line_;
};

/// The second accelerometer: the same without a gyro.
class AccelerometerModel {
 public:
  AccelerometerModel(const InertialParameters& parameters, Random random);

  /// m/s2 per count.
  [[nodiscard]] float scale() const { return scale_m_s2_; }

  /// As ImuModel::sample.
  [[nodiscard]] const hal::AccelerometerSample& sample(hal::Microseconds time, const Vector3& specific_force_m_s2,
                                                       bool dropout) {
    if (dropout) {
      return line_.repeated();
    }
    const std::array<double, 3> noise = random_.gaussians<3>();
    hal::AccelerometerSample& measured = line_.next();
    measured.time = time;
    measured.status = hal::Status::ok;
    converter_.convert(specific_force_m_s2, noise, measured.specific_force);
    return line_.arrived(time);
  }

 private:
  Random random_;  // first: the misalignment draws from it
  TriaxialConverter converter_;
  float scale_m_s2_;
  DelayLine<hal::AccelerometerSample> line_;
};

struct EncoderParameters {
  double noise_counts = 1.0;  ///< standard deviation of every reading, 0 to 1000
  int resolution_bits = 14;   ///< of a turn, 4 to 14; a coarser encoder fills the lower bits with zeros
};

/// The four canard shaft encoders: absolute, delivered as 14 bits a turn. From shaft angle to reading, in this order:
///   1. the zero of the encoder, and 2. noise are added, in counts;
///   3. rounding to the nearest step of the resolution;
///   4. wrapping from 16383 to 0.
///
/// Example: 1 degree is 45.5 counts; a zero of 10 degrees adds 455.1; noise of 1 count that draws +1 standard deviation
/// makes 501.6; with 12 bits, 4 counts a step, it reads 500, and 502 with all 14.
class EncoderModel {
 public:
  /// `zero_rad`: what each encoder reads at shaft angle zero. Throws std::invalid_argument.
  EncoderModel(const std::array<double, hal::canards>& zero_rad, const EncoderParameters& parameters, Random random);

  /// Standard deviation of one encoder's readings from now on, 0 to 1000 counts; the others keep theirs. Throws
  /// std::invalid_argument.
  void set_noise(std::size_t canard, double noise_counts);

  /// Shaft angles within 100 turns.
  [[nodiscard]] hal::EncoderReading sample(hal::Microseconds time,
                                           const std::array<double, hal::canards>& shaft_angle_rad) {
    hal::EncoderReading reading{.time = time};
    const std::array<double, hal::canards> noise = random_.gaussians<hal::canards>();
    for (std::size_t i = 0; i < hal::canards; ++i) {
      const double counts = shaft_angle_rad[i] * counts_per_radian + zero_counts_[i] + noise_counts_[i] * noise[i];
      // Whole turns are added first: a conversion to integer rounds towards zero, so only upwards of it is it right.
      const double above_zero = counts + 1000.0 * hal::encoder_counts_per_turn;
      // NOLINTNEXTLINE(bugprone-incorrect-roundings): this far from zero, adding a half is right
      const auto steps = static_cast<std::uint32_t>(above_zero * steps_per_count_ + 0.5);
      reading.each[i] = {.counts = static_cast<std::uint16_t>(steps * counts_per_step_ % hal::encoder_counts_per_turn),
                         .status = hal::Status::ok};
    }
    return reading;
  }

 private:
  static constexpr double counts_per_radian = hal::encoder_counts_per_turn / (2.0 * std::numbers::pi);

  std::array<double, hal::canards> zero_counts_{};
  std::array<double, hal::canards> noise_counts_{};
  std::uint32_t counts_per_step_;
  double steps_per_count_;
  Random random_;
};

}  // namespace fantail::sim
