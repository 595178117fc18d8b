// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "fake_clock.hpp"
#include "hal/stm32f4/registers/tim.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A rising edge of a line, and how many there were up to it.
struct LineEdge {
  Microseconds time{};
  std::int64_t number = 0;
};

/// TIM2 as RM0090 section 18.3.5 describes its input capture, with a line at channel 4: while counter and channel are
/// on, the count at a rising edge is kept until the next one.
class FakeCapture {
 public:
  /// When the line rose last, and for the how manieth time; empty before the first.
  using Line = std::function<std::optional<LineEdge>()>;

  FakeCapture(RegisterWorld& world, const FakeClock& clock, double timer_hz, Line line)
      : clock_{clock}, timer_hz_{timer_hz}, line_{std::move(line)} {
    world.on_read(registers.cnt, [this] { return count(clock_.time); });
    world.on_read(registers.ccr[3], [this] {
      look();
      status_ &= ~0x10U;  // section 18.4.5: reading CCR4 clears CC4IF
      return captured_;
    });
    world.on_read(registers.sr, [this] {
      look();
      return status_;
    });
    world.on_write(registers.sr, [this](std::uint32_t value) { status_ &= value; });
  }

  registers::Tim registers{};

  [[nodiscard]] bool captures() const {
    const bool counts =
        (RegisterWorld::peek(registers.cr1) & 1U) != 0 && RegisterWorld::peek(registers.arr) == 0xFFFFFFFF;
    const bool input = (RegisterWorld::peek(registers.ccmr[1]) >> 8U & 3U) == 1;   // CC4S: TI4
    const bool rising = (RegisterWorld::peek(registers.ccer) >> 12U & 0xBU) == 1;  // CC4E, neither CC4P nor CC4NP
    return counts && input && rising;
  }

 private:
  void look() {
    const auto edge = line_();
    if (!captures() || !edge || edge->number == seen_) {
      return;
    }
    // CC4OF when CC4IF was set already.
    status_ |= (status_ & 0x10U) != 0 || edge->number > seen_ + 1 ? 0x1010U : 0x10U;
    seen_ = edge->number;
    captured_ = count(edge->time);
  }
  [[nodiscard]] std::uint32_t count(Microseconds time) const {
    const double hz = timer_hz_ / (RegisterWorld::peek(registers.psc) + 1.0);
    return static_cast<std::uint32_t>(
        static_cast<std::uint64_t>(std::floor(static_cast<double>(time.count()) * hz / 1e6)));
  }

  const FakeClock& clock_;
  double timer_hz_;
  Line line_;
  std::uint32_t captured_ = 0;
  std::uint32_t status_ = 0;
  std::int64_t seen_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
