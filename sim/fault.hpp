// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "hal/board.hpp"
#include "sim/servo.hpp"

// What can go wrong in a run: a device, how it goes wrong, and when. Which device can go wrong in which way, and what
// each is called in files, stands in one table, tools/input/fault_words.cpp. `ActiveFaults` does it.
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
  abort_input,
  memory,
  processor,
  barometer,
};
inline constexpr std::size_t devices = 13;

/// Each canard has one of its own.
[[nodiscard]] constexpr bool is_of_canard(Device device) {
  return device == Device::encoder || device == Device::servo;
}

/// How a device goes wrong, where no number belongs to it. A count is what a converter delivers: a whole number, so
/// that none of them is "no number"; `nan` is what comes nearest to it.
enum class Behaviour : std::uint8_t {
  dead,
  stuck,
  repeated,
  saturated,
  garbage,
  nan,
  cut,              ///< pulses end at a random part of their width
  hangs,            ///< nothing is measured, and the last sample comes again
  gyro_frozen,      ///< the gyro's last counts come again, as if they were new
  sagging,          ///< below what the board allows
  pressed,          ///< stands as asks to abort, by the sense of the plan
  law_bit_flipped,  ///< once
  plan_bit_flipped,
  blocked,  ///< the static ports are closed: the bay keeps its pressure
  lit,      ///< light on the sensing element: it reads too low a pressure
};

/// Of a servo: its gear or its shaft is broken. `angle_rad` as Servo::fail.
struct GearFault {
  ServoFault fault = ServoFault::stuck;
  std::optional<double> angle_rad{};
  friend constexpr bool operator==(const GearFault&, const GearFault&) = default;
};

/// What a sensor measures, or the pulses of a servo, come so late.
struct Delayed {
  static constexpr double longest_s = 0.5;
  double delay_s = 0.02;
  friend constexpr bool operator==(const Delayed&, const Delayed&) = default;
};

/// Of an encoder, for good: standard deviation of its readings, instead of that of the vehicle.
struct Noisy {
  double noise_counts = 60.0;
  friend constexpr bool operator==(const Noisy&, const Noisy&) = default;
};

/// Of an IMU: added to the rate about the long axis.
struct RateOffset {
  double rate_rad_s = 0.0;
  friend constexpr bool operator==(const RateOffset&, const RateOffset&) = default;
};

enum class MemoryAfterReset : std::uint8_t { kept, lost };

/// Of the processor: for so long it has no ticks, and then the avionics begins anew. Until the reset a hanging loop
/// leaves the pulses as they are; from the reset to the first tick there are none.
struct Reset {
  hal::ResetCause cause = hal::ResetCause::watchdog;
  double gap_s = 0.06;
  MemoryAfterReset memory = MemoryAfterReset::kept;
  double clock_error_s = 0.0;  ///< by so much the avionics takes the gap for longer than it was
  friend constexpr bool operator==(const Reset&, const Reset&) = default;
};

/// Of any gap this much, or all of a shorter one, is the start of the firmware, in which the lines are low.
inline constexpr double start_of_firmware_s = 0.010;

using How = std::variant<Behaviour, GearFault, Delayed, Noisy, RateOffset, Reset>;

struct Fault {
  Device device = Device::imu;
  std::size_t canard = 0;  ///< 0 to 3: whose encoder or servo
  How how{};
  double from_s = 0.0;  ///< after ignition (in the tunnel: after the start command); negative on the pad, and before
                        ///< power-up it is there from the first tick
  std::optional<double> until_s{};  ///< empty: it stays
  double on_s = 0.0;                ///< comes and goes: there for so long; 0: there all the time
  double off_s = 0.0;               ///< and then gone for so long
  friend constexpr bool operator==(const Fault&, const Fault&) = default;
};

[[nodiscard]] constexpr bool is(const Fault& fault, Behaviour behaviour) {
  const auto* own = std::get_if<Behaviour>(&fault.how);
  return own != nullptr && *own == behaviour;
}

/// The same device goes wrong in the same way, whatever the numbers, the canard and the time.
[[nodiscard]] constexpr bool is_same_kind(const Fault& a, const Fault& b) {
  const auto* gear_a = std::get_if<GearFault>(&a.how);
  const auto* gear_b = std::get_if<GearFault>(&b.how);
  if (gear_a != nullptr && gear_b != nullptr) {
    return a.device == b.device && gear_a->fault == gear_b->fault;
  }
  const bool has_a_number = !std::holds_alternative<Behaviour>(a.how);
  return a.device == b.device && (a.how == b.how || (has_a_number && a.how.index() == b.how.index()));
}

/// The gear of a servo that is broken for good; null: of any other fault.
[[nodiscard]] constexpr const GearFault* broken_gear(const Fault& fault) {
  return fault.until_s ? nullptr : std::get_if<GearFault>(&fault.how);
}
/// Whether it is there when the rocket lifts off.
[[nodiscard]] constexpr bool is_there_at_liftoff(const Fault& fault) { return fault.from_s <= 0.0; }

}  // namespace fantail::sim
