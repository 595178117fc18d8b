// SPDX-License-Identifier: MIT
#include "detection/readings.hpp"

#include <algorithm>
#include <limits>

#include "detection/shapes.hpp"
#include "sim/rotation.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

// As the shipped vehicles have them.
constexpr float rate_noise_rad_s = static_cast<float>(0.1 * sim::radians_per_degree);
constexpr float weight_m_s2 = core::standard_gravity_m_s2;

core::Vector3 drawn_vector(sim::Random& random, double most) {
  const double x = uniform(random, -most, most);
  const double y = uniform(random, -most, most);
  const double z = uniform(random, -most, most);
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

SensorErrors drawn_errors(Kind kind, std::uint64_t event, const Motion& motion, sim::Random& random) {
  const bool far_off = kind == Kind::bias;
  const double force = (far_off ? 0.5 : 0.05) * sim::gravity_m_s2;
  const double rate = (far_off ? 5.0 : 1.0) * sim::radians_per_degree;
  SensorErrors errors;
  errors.bias_m_s2[0] = drawn_vector(random, force);
  errors.bias_m_s2[1] = drawn_vector(random, force);
  errors.gyro_bias_rad_s = drawn_vector(random, rate);
  errors.condition = condition_of(kind, event);
  errors.bad = random.uniform() < 0.5 ? 0 : 1;
  const double last = is_launch(kind) ? static_cast<double>(motion.ignition) : 0.8 * static_cast<double>(motion.length);
  errors.onset = static_cast<std::size_t>(random.uniform() * last);
  return errors;
}

void follow_up(const Motion& motion, Readings& readings) {
  const auto start = sim::sine_cosine(motion.start_pitch_rad);
  const auto x = static_cast<float>(start.cosine);
  const auto z = static_cast<float>(start.sine);
  if (!motion.turns) {
    std::fill_n(readings.up_x.begin(), motion.length, x);
    std::fill_n(readings.up_z.begin(), motion.length, z);
    return;
  }
  Turned up{.cosine = x, .sine = z};
  for (std::size_t i = 0; i < motion.length; ++i) {
    readings.up_x[i] = up.cosine;
    readings.up_z[i] = up.sine;
    up.turn(motion.pitch_rate_rad_s[i] * static_cast<float>(step_s));
  }
}

/// As the board's scaling says it: the positive end of the range bounds the value, the negative one bounds nothing.
core::SampleQuality bounded(float& value, float range) {
  if (value >= range) {
    value = range;
    return core::SampleQuality::saturated;
  }
  if (value <= -range) {
    value = -range;
    return core::SampleQuality::invalid;
  }
  return core::SampleQuality::valid;
}

void make_bad(const SensorErrors& errors, std::size_t length, Readings& readings) {
  auto& value = readings.axial_m_s2[errors.bad];
  auto& quality = readings.quality[errors.bad];
  const bool is_saturated = errors.condition == Condition::saturated;
  const float stands_at = is_saturated ? accelerometer_range_m_s2[errors.bad] : value[errors.onset];
  const core::SampleQuality says = is_saturated ? core::SampleQuality::saturated : quality[errors.onset];
  const bool is_noticed = errors.condition == Condition::dead || errors.condition == Condition::frozen;
  const std::size_t unnoticed = errors.condition == Condition::frozen ? frozen_unnoticed[errors.bad] : 0;
  for (std::size_t i = errors.onset; i < length; ++i) {
    value[i] = stands_at;
    quality[i] = is_noticed && i >= errors.onset + unnoticed ? core::SampleQuality::absent : says;
  }
}

core::Vector3 across(const core::Vector3& bias, float y, float z, float noise_y, float noise_z) {
  return {0.0F, bias.y + y + force_noise_m_s2 * noise_y, bias.z + z + force_noise_m_s2 * noise_z};
}

/// One that reads too little, or nothing for a while.
void read_low(const SensorTrouble& trouble, std::array<float, Motion::most>& axial_m_s2, std::size_t length) {
  for (std::size_t i = trouble.low.from; i < std::min(trouble.low.to, length); ++i) {
    axial_m_s2[i] -= trouble.low_by_m_s2 + trouble.low_share * axial_m_s2[i];
  }
}

}  // namespace

void Turned::turn(float angle_rad) {
  const float share = 1.0F - 0.5F * angle_rad * angle_rad;
  const float turned = cosine * share - sine * angle_rad;
  sine = sine * share + cosine * angle_rad;
  cosine = turned;
  const float stretch = 1.5F - 0.5F * (cosine * cosine + sine * sine);
  cosine *= stretch;
  sine *= stretch;
}

void begin_readings(Kind kind, std::uint64_t event, const Motion& motion, sim::Random& random, Readings& readings) {
  readings.errors = drawn_errors(kind, event, motion, random);
  follow_up(motion, readings);
  float smallest = std::numeric_limits<float>::max();
  float largest = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < motion.length; ++i) {
    const float felt = motion.axial_m_s2[i] + motion.carried[i] * weight_m_s2 * readings.up_x[i];
    readings.felt_m_s2[i] = felt;
    smallest = felt < smallest ? felt : smallest;
    largest = felt > largest ? felt : largest;
  }
  readings.smallest_felt_m_s2 = smallest;
  readings.largest_felt_m_s2 = largest;
}

void finish_readings(const Motion& motion, sim::Random& random, Readings& readings) {
  const SensorErrors& errors = readings.errors;
  const float first_bias = errors.bias_m_s2[0].x;
  const float second_bias = errors.bias_m_s2[1].x;
  const auto& felt = readings.felt_m_s2;
  const std::size_t stuck_from = errors.condition == Condition::stuck ? errors.onset : motion.length;
  for (std::size_t i = 0; i < motion.length; ++i) {
    const auto noise = random.gaussians<2>();
    const float now = felt[i];
    const float of_the_bad = i < stuck_from ? now : felt[stuck_from];
    readings.axial_m_s2[0][i] =
        (errors.bad == 0 ? of_the_bad : now) + first_bias + force_noise_m_s2 * static_cast<float>(noise[0]);
    readings.axial_m_s2[1][i] =
        (errors.bad == 1 ? of_the_bad : now) + second_bias + force_noise_m_s2 * static_cast<float>(noise[1]);
  }
  const SensorTrouble& trouble = motion.trouble;
  read_low(trouble, readings.axial_m_s2[trouble.accelerometer], motion.length);
  for (std::size_t which = 0; which < 2; ++which) {
    for (std::size_t i = 0; i < motion.length; ++i) {
      readings.quality[which][i] = bounded(readings.axial_m_s2[which][i], accelerometer_range_m_s2[which]);
    }
  }
  if (errors.condition != Condition::well && errors.condition != Condition::stuck) {
    make_bad(errors, motion.length, readings);
  }
  auto& quality = readings.quality[trouble.accelerometer];
  for (std::size_t i = trouble.accelerometer_silent.from; i < trouble.accelerometer_silent.to; ++i) {
    quality[i] = core::SampleQuality::absent;
  }
}

InputMaker::InputMaker(const Motion& motion, const Readings& readings, sim::Random random)
    : motion_{motion}, readings_{readings}, random_{random} {
  inputs_.arm_switch_closed = true;
  inputs_.encoders.fill(core::Angle{});
  inputs_.second_gyro = core::GyroSample{};
}

void InputMaker::set_gyro(const core::Vector3& rate_rad_s, const std::array<double, 3>& noise) {
  const core::Vector3& bias = readings_.errors.gyro_bias_rad_s;
  inputs_.gyro = {.time = inputs_.time,
                  .rate_rad_s = {bias.x + rate_rad_s.x + rate_noise_rad_s * static_cast<float>(noise[0]),
                                 bias.y + rate_rad_s.y + rate_noise_rad_s * static_cast<float>(noise[1]),
                                 bias.z + rate_rad_s.z + rate_noise_rad_s * static_cast<float>(noise[2])},
                  .quality = core::SampleQuality::valid};
  // A plan that asks for two gets the same twice: they are no question of this campaign.
  inputs_.second_gyro = inputs_.gyro;
}

const core::Inputs& InputMaker::pad(int tick) {
  inputs_.time = event_begin - (pad_ticks - tick) * pad_tick;
  inputs_.arm_command = tick == pad_ticks - 1;
  const auto noise = random_.gaussians<9>();
  set_gyro({}, {noise[0], noise[1], noise[2]});
  for (std::size_t which = 0; which < 2; ++which) {
    const core::Vector3& bias = readings_.errors.bias_m_s2[which];
    core::Vector3 force = across(bias, 0.0F, weight_m_s2 * readings_.up_z[0], static_cast<float>(noise[3 + 3 * which]),
                                 static_cast<float>(noise[4 + 3 * which]));
    force.x = bias.x + weight_m_s2 * readings_.up_x[0] + force_noise_m_s2 * static_cast<float>(noise[5 + 3 * which]);
    inputs_.accelerometers[which] = {
        .time = inputs_.time, .specific_force_m_s2 = force, .quality = core::SampleQuality::valid};
  }
  return inputs_;
}

const core::Inputs& InputMaker::step(std::size_t step) {
  inputs_.time = event_begin + core::Microseconds{static_cast<std::int64_t>(step) * 1'000};
  inputs_.arm_command = false;
  const auto noise = random_.gaussians<7>();
  const float pitch_rate = motion_.pitch_rate_rad_s[step];
  float y = 0.0F;
  float z = motion_.across_m_s2[step] + motion_.carried[step] * weight_m_s2 * readings_.up_z[step];
  if (motion_.rolls) {
    set_gyro({motion_.roll_rate_rad_s[step], pitch_rate * roll_.cosine, -pitch_rate * roll_.sine},
             {noise[0], noise[1], noise[2]});
    y = z * roll_.sine;
    z *= roll_.cosine;
    roll_.turn(motion_.roll_rate_rad_s[step] * static_cast<float>(step_s));
  } else {
    set_gyro({0.0F, pitch_rate, 0.0F}, {noise[0], noise[1], noise[2]});
  }
  const SensorErrors& errors = readings_.errors;
  if (step <= errors.onset) {
    stuck_y_m_s2_ = y;
    stuck_z_m_s2_ = z;
  }
  for (std::size_t which = 0; which < 2; ++which) {
    core::AccelerometerSample& sample = inputs_.accelerometers[which];
    const bool is_bad = which == errors.bad && step > errors.onset;
    if (!is_bad || errors.condition != Condition::frozen) {
      const bool is_stuck = is_bad && errors.condition == Condition::stuck;
      sample.specific_force_m_s2 =
          across(errors.bias_m_s2[which], is_stuck ? stuck_y_m_s2_ : y, is_stuck ? stuck_z_m_s2_ : z,
                 static_cast<float>(noise[3 + 2 * which]), static_cast<float>(noise[4 + 2 * which]));
    }
    sample.time = inputs_.time;
    sample.specific_force_m_s2.x = readings_.axial_m_s2[which][step];
    sample.quality = readings_.quality[which][step];
  }
  if (motion_.trouble.gyro_silent.has(step)) {
    inputs_.gyro.quality = core::SampleQuality::absent;
    inputs_.second_gyro = inputs_.gyro;
  }
  return inputs_;
}

}  // namespace fantail::detection
