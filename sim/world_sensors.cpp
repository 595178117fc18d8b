// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "sim/nearest_tick.hpp"
#include "sim/world.hpp"

// What the sensors show the avionics.
namespace fantail::sim {
namespace {

Vector3 with_offset(const Vector3& rate_rad_s, const ImuFault& fault) {
  return {rate_rad_s.x + fault.rate_offset_rad_s, rate_rad_s.y, rate_rad_s.z};
}

// A gyro that is frozen says again what it said last, as if it were new.
void deliver(const hal::ImuSample& sample, const ImuFault& fault, hal::ImuSample& place) {
  const hal::Counts said = place.rate;
  place = sample;
  if (fault.frozen) {
    place.rate = said;
  }
}

}  // namespace

void World::fill_hardware() {
  const BodyMotion motion = environment_.motion(roll_, roll_acceleration_rad_s2_);
  const bool shakes = vibration_.is_there() && motor_burns();
  const Shaking shaking = shakes ? vibration_.next() : Shaking{};
  // Empty where that is the motion itself, as by default: copying it for each sensor costs every tick.
  const auto felt_by = [&](const FeltMotion& sensor) {
    return sensor.is_ideal() && !shakes
               ? std::nullopt
               : std::optional{sensor.felt(motion, shaking, environment_.centre_of_gravity_m(), in_seconds(now_))};
  };
  const std::optional<BodyMotion> by_imu = felt_by(imu_feels_);
  const bool two_imus = hardware_.second_imu_is_fitted;
  const std::optional<BodyMotion> by_second_imu = two_imus ? felt_by(second_imu_feels_) : std::nullopt;
  const std::optional<BodyMotion> by_accelerometer = felt_by(accelerometer_feels_);
  const BodyMotion& at_imu = by_imu ? *by_imu : motion;
  const BodyMotion& at_accelerometer = by_accelerometer ? *by_accelerometer : motion;
  const hal::EncoderReading encoders = canards_.read_encoders(now_);
  const SensorFaults& wrong = sensor_faults_;
  const hal::ImuSample& imu =
      imu_model_.sample(now_, with_offset(at_imu.rate_rad_s, wrong.imu), at_imu.specific_force_m_s2, wrong.imu.hangs);
  const hal::AccelerometerSample& accelerometer =
      accelerometer_model_.sample(now_, at_accelerometer.specific_force_m_s2, wrong.accelerometer_hangs);
  // All are measured before any is copied: a copy of freshly written counts makes the processor wait, and so it waits
  // once instead of three times.
  hardware_.time = now_ + board_ahead_;
  hardware_.encoders = encoders;
  deliver(imu, wrong.imu, hardware_.imu);
  hardware_.accelerometer = accelerometer;
  if (two_imus) {
    const BodyMotion& at_second = by_second_imu ? *by_second_imu : motion;
    deliver(second_imu_model_.sample(now_, with_offset(at_second.rate_rad_s, wrong.second_imu),
                                     at_second.specific_force_m_s2, wrong.second_imu.hangs),
            wrong.second_imu, hardware_.second_imu);
  }
  if (hardware_.barometer_is_fitted) {
    hardware_.barometer = barometer_model_.sample(now_, air_at_ports(), wrong.barometer);
  }
  if (board_ahead_ != core::Microseconds{0}) {
    put_samples_on_clock_of_board(board_ahead_);
  }
}

AirAtPorts World::air_at_ports() const {
  const double height_m = environment_.height_m();
  const double speed_m_s = environment_.speed_m_s();
  const std::optional<double> ejection_s = environment_.parachute_s();
  return {.static_pa = scenario_.atmosphere.pressure_pa(height_m),
          .dynamic_pa = 0.5 * environment_.density_kg_m3() * speed_m_s * speed_m_s,
          .mach = std::abs(speed_m_s) / scenario_.atmosphere.speed_of_sound_m_s(height_m),
          .since_ejection_s = ejection_s ? std::optional{in_seconds(now_ - ignition_) - *ejection_s} : std::nullopt};
}

}  // namespace fantail::sim
