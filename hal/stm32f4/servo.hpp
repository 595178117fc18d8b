// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hal/clock.hpp"
#include "hal/servo.hpp"
#include "hal/stm32f4/registers/tim.hpp"

namespace fantail::hal::stm32f4 {

/// Four servos on the four channels of an advanced timer: a pulse each 3 ms (333 Hz), in steps of 48 ns at 168 MHz.
///
/// Compare values are preloaded: the timer takes all four over between two frames, so no pulse is ever cut, and a
/// switched-off output is a pulse of no length. Until the first pulse the pins are not driven at all, and the pull-down
/// resistors keep them low.
class Servo final : public hal::Servo {
 public:
  /// So often a frame begins: in every third tick.
  static constexpr Microseconds frame{3'000};
  /// What a hobby servo understands. Nothing else is ever driven.
  static constexpr Pulse shortest{500'000};
  static constexpr Pulse longest{2'500'000};
  using Counts = std::array<std::uint32_t, canards>;

  /// `timer_hz`: what the timer counts before its prescaler.
  [[gnu::cold]] Servo(registers::Tim& timer, std::uint32_t timer_hz);

  /// A frame begins that much later, in 0 to 3 ms, and from then on every 3 ms. Before the first pulse: it would be
  /// cut.
  [[gnu::cold]] void begin_frame_in(Microseconds time);

  /// A servo that is asked for a pulse outside of its range keeps the one it has: that is a broken command or a broken
  /// plan, and of all answers to it the end of the range would be the hardest kick.
  void write(const std::array<std::optional<Pulse>, canards>& pulses) override;

  /// Pulses that were outside of their range, since power-up.
  [[nodiscard]] std::uint32_t refused() const { return refused_; }

  /// For drive(): what these pulses are in counts of the timer. Empty, or outside of the range, is no pulse.
  [[nodiscard, gnu::cold]] Counts counts(const std::array<std::optional<Pulse>, canards>& pulses) const;

  /// All four in the next frame. Needs nothing but the timer, so a crash handler can use it with counts laid by, in
  /// whatever state it finds the rest; outputs that were never on stay off.
  static void drive(registers::Tim& timer, const Counts& counts);

  /// drive(), and then waits until a frame has had these pulses whole, for two frames at most, and holds the lines low:
  /// a reset of the processor cuts none of them off however late it comes, and the last that the servos heard were
  /// these. False when the timer stands, after some 10 ms.
  [[gnu::cold]] static bool finish(registers::Tim& timer, const Counts& counts);

  /// What was written last, in counts of the timer; 0 is no pulse.
  [[nodiscard]] const Counts& counts() const { return counts_; }

  /// The crystal has stopped, and the timer now counts at 16 MHz where it counted at 168: lets the pulses under way, of
  /// these counts, end when they were to, and holds the lines low until a reset. One under way would be one of up to
  /// 15 ms else. Takes as long as the longest of them.
  [[gnu::cold]] static void end_without_crystal(registers::Tim& timer, const Counts& counts);

  /// All four lines low at once and until a reset, which cuts off the pulses under way.
  [[gnu::cold]] static void hold_low(registers::Tim& timer);

 private:
  [[nodiscard]] std::uint32_t count(Pulse pulse) const;

  registers::Tim* timer_;
  std::uint32_t counts_per_nanosecond_;  ///< times 2^32
  Counts counts_{};
  bool on_ = false;
  std::uint32_t refused_ = 0;
};

}  // namespace fantail::hal::stm32f4
