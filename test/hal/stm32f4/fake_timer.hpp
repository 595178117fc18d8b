// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hal/stm32f4/registers/tim.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// TIM1 or TIM8 counting up, with the preload registers of RM0090 section 17.3: what is written is taken over at the
/// end of a frame, unless updates are disabled. Times are in counts behind the prescaler. Each of its lines has a
/// resistor to ground: a line that nobody drives is low, and a pulse that is under way then is cut.
class FakeTimer {
 public:
  registers::Tim registers{};
  std::uint32_t counts_per_access = 0;  ///< how long a write takes, or a look at the counter

  /// One frame: for how long each pin was high, and whether it was driven all the time.
  struct Frame {
    std::array<std::uint32_t, 4> high{};
    std::array<bool, 4> driven{};
    friend bool operator==(const Frame&, const Frame&) = default;
  };

  /// What a servo on one line hears. Times are in clocks of the timer before its prescaler, since the beginning.
  struct Pulse {
    std::size_t line = 0;
    std::uint64_t begin = 0;
    std::uint64_t width = 0;
    bool whole = true;  ///< from the beginning of its frame to its compare value
  };

  explicit FakeTimer(RegisterWorld& world) {
    keep(world, registers.cr1, cr1_);
    keep(world, registers.bdtr, bdtr_);
    keep(world, registers.ccer, ccer_);
    keep(world, registers.ccmr[0], ccmr_[0]);
    keep(world, registers.ccmr[1], ccmr_[1]);
    keep(world, registers.psc, written_.psc);
    world.on_read(registers.cnt, [this] {
      pass(counts_per_access);
      return static_cast<std::uint32_t>(counter_);
    });
    world.on_write(registers.cnt, [this](std::uint32_t value) {
      pass(counts_per_access);
      counter_ = value;
      now_ = Frame{.driven = {true, true, true, true}};
    });
    for (std::size_t i = 0; i < 4; ++i) {
      world.on_write(registers.ccr[i], [this, i](std::uint32_t value) {
        pass(counts_per_access);
        written_.ccr[i] = value;
        if ((mode(i) & 8U) == 0) {
          active_.ccr[i] = value;
        }
      });
    }
    world.on_read(registers.arr, [this] { return written_.arr; });
    world.on_write(registers.arr, [this](std::uint32_t value) {
      written_.arr = value;
      if ((cr1_ & 0x80U) == 0) {
        active_.arr = value;
      }
    });
    world.on_write(registers.egr, [this](std::uint32_t value) {
      if ((value & 1U) != 0) {
        counter_ = 0;
        now_ = Frame{.driven = {true, true, true, true}};
        update();
      }
    });
  }

  void pass(std::uint64_t counts) {
    if ((cr1_ & 1U) == 0) {
      clocks_ += counts * divider();
      return;
    }
    while (counts > 0) {
      const std::uint64_t left = active_.arr + 1ULL - counter_;
      const std::uint64_t step = std::min(counts, left);
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint64_t end = std::min<std::uint64_t>(counter_ + step, active_.ccr[i]);
        now_.high[i] += drives(i) && end > counter_ ? static_cast<std::uint32_t>(end - counter_) : 0;
        now_.driven[i] = now_.driven[i] && drives(i);
        write_down(i, step);
      }
      counter_ += step;
      clocks_ += step * divider();
      counts -= step;
      if (counter_ > active_.arr) {
        counter_ = 0;
        frames_.push_back(now_);
        now_ = Frame{.driven = {true, true, true, true}};
        update();
      }
    }
  }
  /// Every register as after power-up, and all lines low, whatever was under way.
  void reset() {
    for (std::size_t i = 0; i < 4; ++i) {
      cut(i);
    }
    cr1_ = bdtr_ = ccer_ = 0;
    ccmr_ = {};
    written_ = active_ = {};
    counter_ = 0;
    now_ = Frame{.driven = {true, true, true, true}};
  }
  /// So far, in the order of their ends.
  [[nodiscard]] const std::vector<Pulse>& pulses() const { return pulses_; }
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }
  /// Nobody drives a line high, and the timer itself drives all of them low: RM0090 section 17.4.18, OSSI.
  [[nodiscard]] bool holds_low() const { return (bdtr_ & 0x8400U) == 0x0400U && (ccer_ & 0x1111U) == 0x1111U; }
  /// What a reset would leave of this frame.
  [[nodiscard]] const Frame& unfinished() const { return now_; }
  /// To the end of this frame.
  void finish_frame() { pass(active_.arr + 1ULL - counter_); }
  /// The next whole one.
  Frame next_frame() {
    finish_frame();
    finish_frame();
    return frames_.back();
  }

  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }
  [[nodiscard]] std::uint64_t counter() const { return counter_; }
  [[nodiscard]] std::uint64_t counts_per_frame() const { return active_.arr + 1ULL; }
  [[nodiscard]] std::uint64_t divider() const { return active_.psc + 1ULL; }

 private:
  struct Preloaded {
    std::array<std::uint32_t, 4> ccr{};
    std::uint32_t arr = 0xFFFF;
    std::uint32_t psc = 0;
  };

  void keep(RegisterWorld& world, registers::Register& place, std::uint32_t& value) {
    world.on_read(place, [&value] { return value; });
    world.on_write(place, [this, &value](std::uint32_t written) {
      pass(counts_per_access);
      value = written;
    });
  }
  [[nodiscard]] std::uint32_t mode(std::size_t channel) const {
    return ccmr_[channel / 2] >> (8 * (channel % 2)) & 0xFFU;
  }
  [[nodiscard]] bool drives(std::size_t channel) const {
    return (bdtr_ & 0x8000U) != 0 && (ccer_ >> (4 * channel) & 3U) == 1 && (mode(channel) & 0x73U) == 0x60;
  }
  void write_down(std::size_t line, std::uint64_t step) {
    const std::uint64_t compare = active_.ccr[line];
    if (!drives(line) || counter_ >= compare) {
      cut(line);
      return;
    }
    if (!high_since_[line]) {
      high_since_[line] = clocks_;
    }
    if (counter_ + step >= compare) {
      const std::uint64_t width = clocks_ + (compare - counter_) * divider() - *high_since_[line];
      pulses_.push_back({line, *high_since_[line], width, width == compare * divider()});
      high_since_[line].reset();
    }
  }
  void cut(std::size_t line) {
    if (high_since_[line]) {
      pulses_.push_back({line, *high_since_[line], clocks_ - *high_since_[line], false});
      high_since_[line].reset();
    }
  }
  void update() {
    if ((cr1_ & 2U) == 0) {
      active_ = written_;
    }
  }

  std::uint32_t cr1_ = 0;
  std::uint32_t bdtr_ = 0;
  std::uint32_t ccer_ = 0;
  std::array<std::uint32_t, 2> ccmr_{};
  Preloaded written_{};
  Preloaded active_{};
  std::uint64_t counter_ = 0;
  Frame now_{.driven = {true, true, true, true}};
  std::vector<Frame> frames_;
  std::uint64_t clocks_ = 0;
  std::array<std::optional<std::uint64_t>, 4> high_since_{};
  std::vector<Pulse> pulses_;
};

}  // namespace fantail::hal::stm32f4::test
