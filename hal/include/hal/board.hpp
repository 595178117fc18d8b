// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fantail::hal {

/// What is wrong with the board, as its own drivers found it. With any of them the rocket is not armed. The numbers are
/// those of the bits on the bus.
enum class BoardFault : std::uint8_t {
  crystal_failed,          ///< the 8 MHz crystal did not start: the processor runs on its own oscillator
  clock_failed,            ///< the PLL did not lock, or the oscillator of the watchdog does not run
  image_broken,            ///< the firmware in the processor is not what was built: its CRC is wrong
  imu_silent,              ///< does not answer
  imu_wrong_id,            ///< something answers, and it is not an ICM-42688-P
  imu_self_test_failed,    ///< its own electrical self-test
  accelerometer_silent,    ///< the second one does not answer
  accelerometer_wrong_id,  ///< something answers, and it is not that accelerometer
  encoder_silent,          ///< one of the four, at power-up
  flash_silent,            ///< does not answer
  flash_wrong_id,          ///< a device answers that is not a flash known to the driver
  flash_stuck,             ///< busy for longer than its data sheet allows
  can_failed,              ///< the controller did not leave initialisation
  entropy_failed,      ///< the random numbers repeat themselves, or their generator has no clock, no noise or no answer
  battery_unmeasured,  ///< the converter did not answer
  loop_overrun,        ///< more ticks came late than the plan allows
  crashed,             ///< the processor was reset by a hard fault, and the post-mortem record says where
  brown_out_level,     ///< the processor runs on below the supply that its flash needs at this speed
  supply_low,          ///< the processor's supply is, or was a moment ago, too low
  gyro_frozen,         ///< new samples of the IMU's gyro repeat their values: it is not used
  imu_accelerometer_frozen,  ///< the same of the accelerometer in the IMU
  accelerometer_frozen,      ///< the same of the second accelerometer
  imu_line_lost,   ///< the edges of the IMU's data-ready line do not fit its samples: their times are estimated
  memory_damaged,  ///< plan or flight law were not what they had been left as
  flash_page_bad,  ///< a page of the flash did not keep what was written
};
/// How many values BoardFault has: one that is read must be below.
inline constexpr std::size_t board_faults = 25;

/// The name of the value itself. `fault` must be one of the values: nothing checks it.
[[nodiscard]] constexpr std::string_view name(BoardFault fault) {
  constexpr std::array<std::string_view, board_faults> names{"crystal_failed",
                                                             "clock_failed",
                                                             "image_broken",
                                                             "imu_silent",
                                                             "imu_wrong_id",
                                                             "imu_self_test_failed",
                                                             "accelerometer_silent",
                                                             "accelerometer_wrong_id",
                                                             "encoder_silent",
                                                             "flash_silent",
                                                             "flash_wrong_id",
                                                             "flash_stuck",
                                                             "can_failed",
                                                             "entropy_failed",
                                                             "battery_unmeasured",
                                                             "loop_overrun",
                                                             "crashed",
                                                             "brown_out_level",
                                                             "supply_low",
                                                             "gyro_frozen",
                                                             "imu_accelerometer_frozen",
                                                             "accelerometer_frozen",
                                                             "imu_line_lost",
                                                             "memory_damaged",
                                                             "flash_page_bad"};
  return names[static_cast<std::size_t>(fault)];
}

/// A set of faults.
class BoardFaults {
 public:
  /// One that is there already changes nothing.
  constexpr void add(BoardFault fault) { bits_ |= 1U << static_cast<unsigned>(fault); }
  constexpr void add(BoardFaults others) { bits_ |= others.bits_; }
  /// Is this fault in the set?
  [[nodiscard]] constexpr bool has(BoardFault fault) const { return (bits_ >> static_cast<unsigned>(fault) & 1U) != 0; }
  /// Then the board does not stand in the way of arming.
  [[nodiscard]] constexpr bool none() const { return bits_ == 0; }
  /// As on the bus: bit n, from the lowest on, is the fault of number n.
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
  friend constexpr bool operator==(BoardFaults, BoardFaults) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// Why the processor began anew.
enum class ResetCause : std::uint8_t {
  power_on,   ///< the supply came
  brown_out,  ///< the supply was too low for a moment
  pin,        ///< the reset button, or a probe
  software,   ///< asked for by the firmware itself, as after a hard fault
  watchdog,   ///< it was not fed in time
};
/// How many values ResetCause has: one that is read must be below.
inline constexpr std::size_t reset_causes = 5;

/// The name of the value itself. `cause` must be one of the values: nothing checks it.
[[nodiscard]] constexpr std::string_view name(ResetCause cause) {
  constexpr std::array<std::string_view, reset_causes> names{"power_on", "brown_out", "pin", "software", "watchdog"};
  return names[static_cast<std::size_t>(cause)];
}

/// What the board knows about itself, at one instant.
struct BoardStatus {
  BoardFaults faults{};
  ResetCause reset_cause = ResetCause::power_on;
  std::optional<std::uint16_t> battery_mv{};  ///< empty: not measured, not yet, or no longer
  std::uint32_t overruns = 0;                 ///< control ticks that were due and did not come, since power-up
  /// Those that a simulated board left out, with the time of the world around it, because its PC was too slow. For the
  /// rocket no time has passed, so they are told and are no fault.
  std::uint32_t ticks_left_out = 0;
};

/// Lights and tones for a person at the pad.
enum class Signal : std::uint8_t {
  safe,             ///< Safe, and nothing is wrong with the board or its flash
  faulty,           ///< Safe, and it cannot be armed
  self_test,        ///< Safe, while the self-test moves the canards
  armed,            ///< Armed: a launch is waited for
  armed_not_ready,  ///< Armed, and it must rest before a launch can be detected
  flying,           ///< Launched or Controlling
  finished,         ///< Finished: until the next power cycle
};

/// What the board knows about itself, and its lamp and buzzer.
class Board {
 public:
  virtual ~Board() = default;
  /// Now; never waits.
  [[nodiscard]] virtual BoardStatus status() = 0;
  /// Cycles of the processor that the longest tick took since this was asked last; empty if they are not counted.
  virtual std::optional<std::uint32_t> take_longest_tick_cycles() { return std::nullopt; }
  /// Once a tick.
  virtual void show(Signal signal) = 0;
};

}  // namespace fantail::hal
