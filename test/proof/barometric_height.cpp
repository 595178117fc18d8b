// SPDX-License-Identifier: MIT
// From any state of the barometer's height, with any plan, any sample and any motion, one tick:
//   - uses a sample only while an accelerometer measures, at no more than 100 m/s, and where its height agrees with the
//     accelerometer's;
//   - then adds to height and vertical speed no more than the plan says that the accelerometer may be wrong by;
//   - adds nothing where no accelerometer measures, or the two disagree;
//   - says that the rocket is above a height only in a tick in which it is used, and none above the accelerometer's.
// A pressure may stand for any height.
#include "core/barometric_height.cpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

int main() {
  SensorsPlan sensors{};
  sensors.air_temperature_c = nondet_float();
  sensors.air_temperature_error_k = nondet_float();
  DormancyPlan errors{};
  errors.scale_error = nondet_float();
  errors.bias_error_m_s2 = nondet_float();

  BarometricHeight height{sensors, errors};
  Anything anything;
  height.visit_state(anything);
  const BarometricHeight before = height;
  assume(!before.used_at_ || (before.last_time_ && *before.used_at_ <= *before.last_time_));
  assume(!before.least_height_m_ || before.state_ == BarometerState::used);
  assume(before.height_m_ == before.height_m_ && before.vertical_speed_m_s_ == before.vertical_speed_m_s_);  // numbers

  Inputs inputs{};
  inputs.time = any_instant();
  if (nondet_bool()) {
    inputs.barometer = PressureSample{.time = any_instant(), .pressure_pa = nondet_float()};
  }
  Motion motion{};
  motion.height_m = nondet_float();
  motion.horizontal_distance_m = nondet_float();
  motion.vertical_speed_m_s = nondet_float();
  motion.speed_squared_m2_s2 = nondet_float();
  motion.accelerometer = any_of<SensorState>(4);
  motion.speed_is_lower_bound = nondet_bool();
  motion.thrust_since = any_instant();
  const bool flies = nondet_bool();
  height.update(inputs, flies, motion);

  const MotionError most = motion_error(errors, inputs.time, motion);
  const bool moved = height.height_m_ != before.height_m_ || height.vertical_speed_m_s_ != before.vertical_speed_m_s_;
  const bool used = height.used_at_ != before.used_at_ && height.used_at_;
  const bool alone = motion.accelerometer == SensorState::failed || motion.speed_is_lower_bound;
  const bool compared =
      flies && !alone && height.last_time_ != before.last_time_ && motion.speed_squared_m2_s2 <= 100.0F * 100.0F;
  const bool silent = height.state_ == BarometerState::silent;

  CLAIM(!used || (!alone && motion.speed_squared_m2_s2 <= 100.0F * 100.0F && height.state_ == BarometerState::used));
  CLAIM(!used || inputs.barometer);
  CLAIM(!used || (std::abs(height.height_m_) <= std::abs(most.height_m) &&
                  std::abs(height.vertical_speed_m_s_) <= std::abs(most.vertical_speed_m_s)));
  CLAIM(used || !moved || (height.height_m_ == 0.0F && height.vertical_speed_m_s_ == 0.0F));
  CLAIM(!compared || height.agrees_since_ || (height.height_m_ == 0.0F && height.vertical_speed_m_s_ == 0.0F));
  CLAIM(!alone || silent || height.state_ == BarometerState::on_pad ||
        (height.height_m_ == 0.0F && height.vertical_speed_m_s_ == 0.0F));
  CLAIM(height.state_ != BarometerState::disagrees || height.state_ == before.state_ || height.height_m_ == 0.0F);
  CLAIM(!used || !inputs.barometer || !height.least_height_m_ ||
        !(*height.least_height_m_ >
          motion.height_m - motion.vertical_speed_m_s * seconds(inputs.time - inputs.barometer->time)));
  CLAIM(!height.least_height_m_ || height.state_ == BarometerState::used);

  REACHABLE(1, used && moved);
  REACHABLE(2, height.state_ == BarometerState::disagrees && before.state_ == BarometerState::used);
  REACHABLE(3, height.state_ == BarometerState::too_fast && before.state_ == BarometerState::used);
  REACHABLE(4, silent && before.state_ == BarometerState::used);
  return 0;
}
