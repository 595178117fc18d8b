// SPDX-License-Identifier: MIT
#include "sim/sensor_models.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/rotation.hpp"
#include "sim/sensor_mounting.hpp"

namespace fantail::sim {
namespace {

constexpr double half_range_counts = 32768.0;

// Written so that a NaN is refused too.
void require(bool allowed, const char* what) {
  if (!allowed) {
    throw std::invalid_argument{std::string{"sensor: "} + what};
  }
}

// Taylor; below 0.2 the first term left out is under 1e-19. std::sin is not the same on every machine.
constexpr double small_sine(double x) {
  const double s = x * x;
  return x * (1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0)))));
}

// Turns about an axis across the rocket, picked evenly around it. The axis is drawn whatever the angle, so that a
// misaligned sensor has the same noise as an aligned one.
TriaxialConverter::Rotation misaligned(double angle_rad, Random& random) {
  double y = 0.0;
  double z = 0.0;
  double square = 0.0;
  do {
    y = 2.0 * random.uniform() - 1.0;
    z = 2.0 * random.uniform() - 1.0;
    square = y * y + z * z;
  } while (square > 1.0 || square < 0.01);
  const double length = std::sqrt(square);
  y /= length;
  z /= length;
  const double sine = small_sine(angle_rad);
  const double half = small_sine(0.5 * angle_rad);
  const double versine = 2.0 * half * half;  // 1 - cos
  // Rodrigues' formula for the axis (0, y, z).
  return {{{1.0 - versine, -z * sine, y * sine},
           {z * sine, 1.0 - versine * z * z, versine * y * z},
           {-y * sine, versine * y * z, 1.0 - versine * y * y}}};
}

/// `straight`: the rows of a package whose axes are the rocket's.
TriaxialConverter::Rotation mounted(const core::SensorMounting& mounting, const TriaxialConverter::Rotation& straight) {
  const auto [x, y, z] = axes_seen(mounting);
  TriaxialConverter::Rotation rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = x[i] * straight[0] + y[i] * straight[1] + z[i] * straight[2];
  }
  return rows;
}

void validate(const InertialParameters& p) {
  require(p.rate_noise_rad_s >= 0.0, "rate_noise_rad_s must not be below 0");
  require(p.full_scale_rad_s > 0.0, "full_scale_rad_s must be above 0");
  require(p.specific_force_noise_m_s2 >= 0.0, "specific_force_noise_m_s2 must not be below 0");
  require(p.full_scale_m_s2 > 0.0, "full_scale_m_s2 must be above 0");
  require(p.misalignment_rad >= 0.0 && p.misalignment_rad <= 0.2, "misalignment_rad must be 0 to 0.2");
  require(is_rotation(p.mounting), "mounting must name two different axes");
  require(p.delay_s >= 0.0 && p.delay_s <= 0.02, "delay_s must be 0 to 0.02");
}

// The first thing made of the parameters, so the place to refuse them.
TriaxialConverter::Rotation validated_mounting(const InertialParameters& parameters, Random& random) {
  validate(parameters);
  return mounted(parameters.mounting, misaligned(parameters.misalignment_rad, random));
}

TriaxialConverter::Errors rate_errors(const InertialParameters& p) {
  return {.noise = p.rate_noise_rad_s, .bias = p.rate_bias_rad_s, .full_scale = p.full_scale_rad_s};
}

TriaxialConverter::Errors specific_force_errors(const InertialParameters& p) {
  return {.noise = p.specific_force_noise_m_s2, .bias = p.specific_force_bias_m_s2, .full_scale = p.full_scale_m_s2};
}

hal::Microseconds delay(const InertialParameters& p) { return hal::Microseconds{std::llround(p.delay_s * 1e6)}; }

}  // namespace

TriaxialConverter::TriaxialConverter(const Errors& errors, const Rotation& from_body)
    : counts_per_unit_{from_body},
      offset_{errors.bias * half_range_counts / errors.full_scale},
      noise_{errors.noise * half_range_counts / errors.full_scale} {
  const double counts_per_unit = half_range_counts / errors.full_scale;
  for (Vector3& row : counts_per_unit_) {
    row = {row.x * counts_per_unit, row.y * counts_per_unit, row.z * counts_per_unit};
  }
}

ImuModel::ImuModel(const InertialParameters& parameters, Random random)
    : random_{random},
      from_body_{validated_mounting(parameters, random_)},
      gyro_{rate_errors(parameters), from_body_},
      accelerometer_{specific_force_errors(parameters), from_body_},
      scale_{.rate_rad_s = static_cast<float>(parameters.full_scale_rad_s / half_range_counts),
             .specific_force_m_s2 = static_cast<float>(parameters.full_scale_m_s2 / half_range_counts)},
      line_{delay(parameters)} {}

AccelerometerModel::AccelerometerModel(const InertialParameters& parameters, Random random)
    : random_{random},
      converter_{specific_force_errors(parameters), validated_mounting(parameters, random_)},
      scale_m_s2_{static_cast<float>(parameters.full_scale_m_s2 / half_range_counts)},
      line_{delay(parameters)} {}

EncoderModel::EncoderModel(const std::array<double, hal::canards>& zero_rad, const EncoderParameters& parameters,
                           Random random)
    : random_{random} {
  require(parameters.resolution_bits >= 4 && parameters.resolution_bits <= 14, "resolution_bits must be 4 to 14");
  counts_per_step_ = 1U << static_cast<unsigned>(14 - parameters.resolution_bits);
  steps_per_count_ = 1.0 / counts_per_step_;
  for (std::size_t i = 0; i < hal::canards; ++i) {
    require(std::abs(zero_rad[i]) <= 2.0 * std::numbers::pi, "zero_rad must be within one turn");
    zero_counts_[i] = zero_rad[i] * counts_per_radian;
    set_noise(i, parameters.noise_counts);
  }
}

void EncoderModel::set_noise(std::size_t canard, double noise_counts) {
  require(noise_counts >= 0.0 && noise_counts <= 1000.0, "noise_counts must be 0 to 1000");
  noise_counts_[canard] = noise_counts;
}

}  // namespace fantail::sim
