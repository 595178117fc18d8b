// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "address_space.hpp"
#include "can_model.hpp"
#include "fake_adc.hpp"
#include "fake_capture.hpp"
#include "fake_clocks.hpp"
#include "fake_iwdg.hpp"
#include "fake_rng.hpp"
#include "fake_rtc.hpp"
#include "fake_slow_oscillator.hpp"
#include "fake_spi.hpp"
#include "fake_supply.hpp"
#include "fake_timer.hpp"
#include "fake_usart.hpp"
#include "register_world.hpp"
#include "timeline.hpp"

namespace fantail::board {

namespace devices = hal::stm32f4::test;

/// What of a chip a reset begins anew: clocks, ports, buses. All the rest of the STM32F405 that the firmware uses is
/// beside it, because it remembers: timer 8, whose pulses the servos have heard; the clock of the backup domain.
struct ResetDomain {
  ResetDomain(devices::RegisterWorld& world, const Timeline& timeline, const devices::FakeClock& clock,
              devices::FakeCapture::Line imu_line);

  devices::FakeClocks clocks;
  devices::FakePort port_a, port_b, port_c;
  devices::FakeSpi spi_1, spi_2, spi_3;
  devices::FakeCapture capture;
  devices::FakeUsart usart;
  devices::FakeAdc converter;
  devices::FakeRng random;
  devices::FakeIwdg watchdog;
  devices::FakeSlowOscillator slow_oscillator;
  hal::stm32f4::registers::Can can_registers{};
  devices::CanModel can;
  hal::stm32f4::registers::Tim buzzer{};
};

/// Why the chip begins anew: RCC_CSR, RM0090 section 7.3.21.
enum class ResetKind : std::uint8_t { power_on, brown_out, pin, software, watchdog };

/// What a servo on one line has heard. Times are since power-up.
struct HeardPulse {
  std::size_t line = 0;
  double begin_s = 0.0;
  double width_us = 0.0;
  bool whole = true;  ///< false: cut off before the end that it should have had
  [[nodiscard]] double end_s() const { return begin_s + 1e-6 * width_us; }
};

/// An STM32F405 around its processor, with every block that the flight image touches at its address (RM0090 table 1).
class Chip {
 public:
  Chip(Timeline& timeline, AddressSpace& space, devices::FakeCapture::Line imu_line);

  /// All blocks as after a reset, with those memories that this one leaves.
  void reset(ResetKind kind);
  /// Time has passed: what counts by itself counts.
  void follow();

  devices::RegisterWorld world;
  devices::FakeClock clock;  ///< since power-up
  std::optional<ResetDomain> domain;
  devices::FakeRtc backup{world};
  devices::FakeSupply supply{world};
  // ---- faults ----
  bool crystal_runs = true;  ///< of 8 MHz; one that stops is missed at once
  bool pll_locks = true;

  /// In the order of their ends.
  [[nodiscard]] const std::vector<HeardPulse>& pulses() const { return pulses_; }

 private:
  void add_blocks(AddressSpace& space);

  void hear_pulses();
  [[nodiscard]] double time_of(std::uint64_t clocks) const;

  /// From so many of its clocks on, which were at this time, the timer had this frequency.
  struct Pace {
    std::uint64_t clocks;
    double time_s;
    double frequency_hz;
  };

  devices::FakeTimer servo_timer_{world};
  std::vector<Pace> paces_;
  std::size_t converted_ = 0;
  std::vector<HeardPulse> pulses_;
  Timeline& timeline_;
  devices::FakeCapture::Line imu_line_;
  std::uint32_t reset_flags_ = 0;
  double followed_s_ = 0.0;
  double servo_counts_ = 0.0;  ///< of timer 8, not yet passed
};

}  // namespace fantail::board
