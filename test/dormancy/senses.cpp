// SPDX-License-Identifier: MIT
#include "dormancy/senses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fantail::dormancy {
namespace {

constexpr double range_m_s2 = 16.0 * g;
constexpr float range_rad_s = 35.0F;  // 2000 deg/s
constexpr double rate_noise_rad_s = 0.002;

Axes any_direction(core::RandomStream& random, double most) {
  Axes axes{};
  for (double& axis : axes) {
    axis = most * (2.0 * random.unit() - 1.0);
  }
  return axes;
}

Axes turned(const Axes& v, const Axes& by) {
  return {v[0] + by[1] * v[2] - by[2] * v[1], v[1] + by[2] * v[0] - by[0] * v[2], v[2] + by[0] * v[1] - by[1] * v[0]};
}

core::Vector3 vector(const Axes& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

std::string_view name(Part part) {
  constexpr std::array<std::string_view, parts> names{"none", "IMU",     "accelerometer 1", "accelerometer 2",
                                                      "gyro", "encoder", "clock",           "arm switch"};
  return names[static_cast<std::size_t>(part)];
}

std::string_view name(How how) {
  constexpr std::array<std::string_view, hows> names{"silent",  "error",     "stuck", "repeated", "full range",
                                                     "garbage", "no number", "late",  "shifted"};
  return names[static_cast<std::size_t>(how)];
}

Errors draw_errors(core::RandomStream& random) {
  Errors errors;
  for (std::size_t i = 0; i < 2; ++i) {
    errors.bias_m_s2[i] = any_direction(random, 0.06 * g);
    errors.scale[i] = 0.01 * (2.0 * random.unit() - 1.0);
  }
  const double angle = 0.7 * M_PI / 180.0 * random.unit();
  const double direction = 2.0 * M_PI * random.unit();
  errors.turned_rad = {0.0, angle * std::cos(direction), angle * std::sin(direction)};
  errors.rate_bias_rad_s = any_direction(random, 0.01);
  errors.rate_drift_rad_s2 = any_direction(random, 0.0005);  // half a degree a second in 20 s
  errors.rate_scale = 0.005 * (2.0 * random.unit() - 1.0);
  return errors;
}

Fault draw_fault(double burn_s, core::RandomStream& random) {
  Fault fault{.part = static_cast<Part>(random.whole(1, parts - 1)),
              .how = static_cast<How>(random.whole(0, hows - 1)),
              .from_s = 0.005 + 2.0 * burn_s * random.unit(),
              .until_s = 1e9,
              .size = 2.0 * random.unit() - 1.0,
              .canard = static_cast<std::size_t>(random.whole(0, core::canard_count - 1))};
  if (random.chance(0.5)) {
    fault.until_s = fault.from_s + 0.002 * std::pow(2'000.0, random.unit());
  }
  return fault;
}

Shaking draw_shaking(core::RandomStream& random) {
  return {.rms_m_s2 = 2.0 * g * random.unit(),
          .frequency_hz = 40.0 * std::pow(11.0, random.unit()),
          .white_m_s2 = 0.005 * g * std::pow(40.0, random.unit()),
          .lost = random.chance(0.5) ? 0.0 : 0.02 * random.unit()};
}

Senses::Senses(const Errors& errors, const Shaking& shaking, const Fault& fault, double top_pressure,
               core::RandomStream& random)
    : errors_{errors}, shaking_{shaking}, fault_{fault}, top_pressure_{top_pressure}, random_{&random} {
  const double radius = std::exp(-M_PI * 0.2 * shaking.frequency_hz * 1e-3);
  keep_last_ = 2.0 * radius * std::cos(2.0 * M_PI * shaking.frequency_hz * 1e-3);
  keep_one_before_ = -radius * radius;
  // x[n] - x[n-2] of such a resonance has the variance 2 drive^2 / (1 - radius^2).
  drive_ = std::sqrt(0.5 * (1.0 - radius * radius));
}

// Box and Muller, 1958.
double Senses::normal() {
  has_spare_ = !has_spare_;
  if (!has_spare_) {
    return spare_;
  }
  const double size = std::sqrt(-2.0 * std::log(1.0 - random_->unit()));
  const double angle = 2.0 * M_PI * random_->unit();
  spare_ = size * std::sin(angle);
  return size * std::cos(angle);
}

double Senses::shake() {
  const double next = keep_last_ * resonance_[0] + keep_one_before_ * resonance_[1] + drive_ * normal();
  const double band = next - resonance_[1];
  resonance_[1] = resonance_[0];
  resonance_[0] = next;
  return band;
}

const core::Inputs& Senses::read(core::Microseconds now, const Ascent& ascent, double gravity_m_s2) {
  const double rate = ascent.roll_rate_rad_s();
  roll_rad_ += rate * 1e-3;
  const double cosine = std::cos(roll_rad_);
  const double sine = std::sin(roll_rad_);
  const bool stands = gravity_m_s2 > 0.0;
  const double across = stands ? gravity_m_s2 * std::sin(ascent.tilt_rad()) : ascent.across_m_s2();
  const double along = stands ? gravity_m_s2 * std::cos(ascent.tilt_rad()) : ascent.axial_m_s2();
  const double size = shaking_.rms_m_s2 *
                      (0.8 * std::min(1.0, ascent.thrust()) + 0.2 * std::min(1.0, ascent.pressure() / top_pressure_));
  const double shaken = size > 0.0 ? size * shake() : 0.0;
  const Axes force =
      turned({along + shaken, across * cosine + 0.5 * shaken, -across * sine - 0.5 * shaken}, errors_.turned_rad);
  for (std::size_t i = 0; i < 2; ++i) {
    Axes read{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double noise = shaking_.white_m_s2 * (axis == 0 ? normal() : 3.4 * (random_->unit() - 0.5));
      read[axis] = std::clamp((1.0 + errors_.scale[i]) * force[axis] + errors_.bias_m_s2[i][axis] + noise, -range_m_s2,
                              range_m_s2);
    }
    inputs_.accelerometers[i] = {now, vector(read),
                                 read[0] >= range_m_s2 ? core::SampleQuality::saturated : core::SampleQuality::valid};
  }
  const double pitch = -ascent.tilt_rate_rad_s();
  Axes turn = turned({rate, pitch * sine, pitch * cosine}, errors_.turned_rad);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    turn[axis] = (1.0 + errors_.rate_scale) * turn[axis] + errors_.rate_bias_rad_s[axis] +
                 errors_.rate_drift_rad_s2[axis] * ascent.time_s() + rate_noise_rad_s * 3.4 * (random_->unit() - 0.5);
  }
  inputs_.gyro = {now, vector(turn), core::SampleQuality::valid};
  inputs_.time = now;
  inputs_.arm_switch_closed = true;
  inputs_.encoders = shafts;
  if (lost_for_ > 0 || (shaking_.lost > 0.0 && random_->chance(shaking_.lost))) {
    lost_for_ = lost_for_ > 0 ? lost_for_ - 1 : random_->whole(0, 3);
    (random_->chance(0.5) ? inputs_.gyro.quality : inputs_.accelerometers[0].quality) = core::SampleQuality::invalid;
  }
  shown_ = inputs_;
  if (fault_.part != Part::none && !stands) {
    spoil(ascent);
  }
  return shown_;
}

void Senses::spoil_sample(core::Vector3& value, core::Microseconds& time, core::SampleQuality& quality, float range) {
  const auto size = static_cast<float>(fault_.size);
  switch (fault_.how) {
    case How::silent: quality = core::SampleQuality::absent; break;
    case How::error: quality = core::SampleQuality::invalid; break;
    case How::full_range:
      quality = size > 0.0F ? core::SampleQuality::saturated : quality;
      value.x = size > 0.0F ? range : -range;
      break;
    case How::garbage:
      for (float* axis : {&value.x, &value.y, &value.z}) {
        *axis = random_->between(-range, range);
      }
      break;
    case How::no_number: value.x = std::numeric_limits<float>::quiet_NaN(); break;
    case How::late: time -= core::Microseconds{4'000}; break;
    case How::shifted: value.x += 0.3F * size * range; break;
    case How::stuck:
    case How::repeated: break;  // by what was read before
  }
}

void Senses::spoil(const Ascent& ascent) {
  if (ascent.time_s() < fault_.from_s || ascent.time_s() >= fault_.until_s) {
    before_ = inputs_;
    return;
  }
  const bool comes_again = fault_.how == How::stuck || fault_.how == How::repeated;
  const bool has_gyro = fault_.part == Part::gyro || fault_.part == Part::imu;
  for (std::size_t i = 0; i < 2; ++i) {
    if (fault_.part == (i == 0 ? Part::accelerometer_1 : Part::accelerometer_2) ||
        (i == 0 && fault_.part == Part::imu)) {
      core::AccelerometerSample& sample = shown_.accelerometers[i];
      if (comes_again) {
        sample = before_.accelerometers[i];
        sample.time = fault_.how == How::stuck ? inputs_.time : sample.time;
      }
      spoil_sample(sample.specific_force_m_s2, sample.time, sample.quality, static_cast<float>(range_m_s2));
    }
  }
  if (has_gyro) {
    if (comes_again) {
      shown_.gyro = before_.gyro;
      shown_.gyro.time = fault_.how == How::stuck ? inputs_.time : shown_.gyro.time;
    }
    spoil_sample(shown_.gyro.rate_rad_s, shown_.gyro.time, shown_.gyro.quality, range_rad_s);
  }
  if (fault_.part == Part::encoder) {
    shown_.encoders[fault_.canard] =
        fault_.how == How::silent
            ? std::nullopt
            : std::optional{core::Angle::from_degrees(static_cast<float>(20.0 * fault_.size * random_->unit()))};
  }
  if (fault_.part == Part::clock) {
    shown_.time += core::Microseconds{static_cast<std::int64_t>(fault_.size * 8'000.0)};
  }
  if (fault_.part == Part::arm_switch) {
    shown_.arm_switch_closed = random_->chance(0.5);
  }
}

}  // namespace fantail::dormancy
