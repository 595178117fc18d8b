// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace fantail::sim {

/// What the avionics is connected to, and what it is made of.
enum class Device : std::uint8_t {
  imu,
  second_imu,
  accelerometer,  ///< the second one, beside that of the IMU
  encoder,        ///< of one canard
  servo,          ///< of one canard
  bus,
  flash,
  supply,
  arm_switch,
  memory,
  processor,
};
inline constexpr std::size_t devices = 11;

/// How a device misbehaves, as the avionics sees it through the hardware layer. What each does to which device says
/// `misbehaviours`.
enum class Behaviour : std::uint8_t {
  dead,
  stuck,
  repeated,
  saturated,
  garbage,
  nan,
  delayed,
  slow,
  cut,
  sagging,
  law_bit_flipped,
  plan_bit_flipped,
};
inline constexpr std::size_t behaviours = 12;

/// One device with one behaviour, and what happens then.
struct DeviceBehaviour {
  Device device;
  Behaviour behaviour;
  const char* meaning;  ///< a clause
};

/// Every one that can be flown. A count is what a converter delivers: a whole number, so that none of them is "no
/// number"; `nan` is what comes nearest to it.
inline constexpr auto misbehaviours = std::to_array<DeviceBehaviour>({
    {Device::imu, Behaviour::dead, "does not answer"},
    {Device::imu, Behaviour::stuck, "the counts of its last sample come again, with new times"},
    {Device::imu, Behaviour::repeated, "its last sample comes again, with its old time"},
    {Device::imu, Behaviour::saturated, "the x axes of gyro and accelerometer stand at their upper ends"},
    {Device::imu, Behaviour::garbage, "random counts on every axis, with new times and no error"},
    {Device::imu, Behaviour::nan, "counts at the lower end on every axis, with new times and no error"},
    {Device::imu, Behaviour::delayed, "its samples come `delay_s` late, with their own times"},
    {Device::second_imu, Behaviour::dead, "as `imu`"},
    {Device::second_imu, Behaviour::stuck, "as `imu`"},
    {Device::second_imu, Behaviour::repeated, "as `imu`"},
    {Device::second_imu, Behaviour::saturated, "as `imu`"},
    {Device::second_imu, Behaviour::garbage, "as `imu`"},
    {Device::second_imu, Behaviour::nan, "as `imu`"},
    {Device::second_imu, Behaviour::delayed, "as `imu`"},
    {Device::accelerometer, Behaviour::dead, "as `imu`, of the second accelerometer"},
    {Device::accelerometer, Behaviour::stuck, "as `imu`"},
    {Device::accelerometer, Behaviour::repeated, "as `imu`"},
    {Device::accelerometer, Behaviour::saturated, "as `imu`"},
    {Device::accelerometer, Behaviour::garbage, "as `imu`"},
    {Device::accelerometer, Behaviour::nan, "as `imu`"},
    {Device::accelerometer, Behaviour::delayed, "as `imu`"},
    {Device::encoder, Behaviour::dead, "does not answer"},
    {Device::encoder, Behaviour::stuck, "its last reading comes again"},
    {Device::encoder, Behaviour::saturated, "reads the last count of its turn"},
    {Device::encoder, Behaviour::garbage, "random readings without an error"},
    {Device::encoder, Behaviour::nan, "readings beyond a turn, without an error"},
    {Device::encoder, Behaviour::delayed, "its readings come `delay_s` late"},
    {Device::servo, Behaviour::dead, "hears no pulses: without power, friction holds its shaft"},
    {Device::servo, Behaviour::stuck, "its shaft is jammed where it stands"},
    {Device::servo, Behaviour::repeated, "hears its last pulse again and again"},
    {Device::servo, Behaviour::saturated, "runs to its positive stop, whatever it hears"},
    {Device::servo, Behaviour::garbage, "hears random pulses of 500 to 2500 us"},
    {Device::servo, Behaviour::nan, "hears pulses without width, which it ignores"},
    {Device::servo, Behaviour::delayed, "hears its pulses `delay_s` late"},
    {Device::servo, Behaviour::slow, "four times the lag, a quarter of the rate limit"},
    {Device::servo, Behaviour::cut, "hears each pulse cut off at a random part of its width"},
    {Device::bus, Behaviour::dead, "carries nothing"},
    {Device::bus, Behaviour::repeated, "a node sends again what it has heard, nine frames a millisecond"},
    {Device::bus, Behaviour::garbage, "a node sends 30 frames of random content a millisecond"},
    {Device::flash, Behaviour::dead, "does not answer"},
    {Device::flash, Behaviour::stuck, "stays busy"},
    {Device::supply, Behaviour::sagging, "the board finds the supply of its processor too low"},
    {Device::arm_switch, Behaviour::dead, "is open"},
    {Device::arm_switch, Behaviour::stuck, "stays as it stands"},
    {Device::memory, Behaviour::law_bit_flipped, "one random bit of the flight law flips, once"},
    {Device::memory, Behaviour::plan_bit_flipped, "one random bit of the plan flips, once"},
    {Device::processor, Behaviour::dead, "has no ticks; nothing resets it, and the servos hear the last pulses"},
});

/// What goes wrong with one device, and when.
struct Misbehaviour {
  Device device = Device::imu;
  Behaviour behaviour = Behaviour::dead;
  double on_s = 0.0;   ///< comes and goes: there for so long; 0: there all the time
  double off_s = 0.0;  ///< and then gone for so long
  double delay_s = 0.02;
  std::uint64_t variant = 0;  ///< other random numbers (garbage, which bit) with the same seed of the scenario
};

/// The longest Misbehaviour::delay_s.
inline constexpr double longest_misbehaviour_delay_s = 0.5;

[[nodiscard]] constexpr bool exists(Device device, Behaviour behaviour) {
  for (const DeviceBehaviour& one : misbehaviours) {
    if (one.device == device && one.behaviour == behaviour) {
      return true;
    }
  }
  return false;
}

/// Has one for each canard.
[[nodiscard]] constexpr bool is_of_canard(Device device) {
  return device == Device::encoder || device == Device::servo;
}

}  // namespace fantail::sim
