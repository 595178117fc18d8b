// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "hal/stm32f4/registers/systick.hpp"
#include "processor_world.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// The timer of PM0214 section 4.5: counts down once a clock, sets its interrupt pending where it reaches zero, stands
/// at LOAD one count later. Every access to it takes time, before and after the moment of the access; the interrupt is
/// served as soon as it is not masked and its latency is over.
class FakeSysTick {
 public:
  registers::SysTick timer{};
  registers::Scb system{};
  ProcessorWorld processor{};
  std::function<void()> handler{};
  std::function<std::uint32_t()> access_counts = [] { return 2U; };  ///< before an access, and again after it
  std::uint32_t latency_counts = 12;                                 ///< from pending to the handler: PM0214 2.3.7

  explicit FakeSysTick(RegisterWorld& world) {
    world.on_write(timer.ctrl, [this](std::uint32_t value) { ctrl_ = value; });
    world.on_write(timer.load, [this](std::uint32_t value) { load_ = value & 0xFFFFFFU; });
    world.on_write(timer.val, [this](std::uint32_t) { value_ = 0; });
    world.on_read(timer.val, [this] { return observed(value_); });
    world.on_read(system.icsr, [this] { return observed(pending_); });
    processor.on_unmask = [this] {
      if (pending_) {
        pass(latency_counts);
      }
    };
    processor.on_wait_for_interrupt = [this] {
      while (!pending_) {
        pass(1);
      }
    };
  }

  /// The processor does something else for so long.
  void pass(std::uint64_t counts) {
    for (; counts > 0; --counts) {
      count();
      serve();
    }
  }
  void serve() {
    if (pending_ && waited_ >= latency_counts && !processor.masked) {
      pending_ = false;
      handler();
    }
  }
  /// Since the timer was started.
  [[nodiscard]] std::uint64_t counts() const { return counts_; }
  [[nodiscard]] std::uint32_t load() const { return load_; }
  [[nodiscard]] std::uint32_t ctrl() const { return ctrl_; }
  [[nodiscard]] bool pending() const { return pending_; }

 private:
  void count() {
    waited_ += 1;
    if ((ctrl_ & 1U) == 0) {
      return;
    }
    counts_ += 1;
    value_ = value_ == 0 ? load_ : value_ - 1;
    if (value_ == 0 && (ctrl_ & 2U) != 0 && !pending_) {
      pending_ = true;
      waited_ = 0;
    }
  }
  std::uint32_t observed(const std::uint32_t& value) {
    pass(access_counts());
    const std::uint32_t seen = value;
    pass(access_counts());
    return seen;
  }
  std::uint32_t observed(const bool& pending) {
    pass(access_counts());
    const std::uint32_t seen = pending ? 1U << 26U : 0;
    pass(access_counts());
    return seen;
  }

  std::uint32_t ctrl_ = 0;
  std::uint32_t load_ = 0;
  std::uint32_t value_ = 0;
  std::uint64_t counts_ = 0;
  std::uint64_t waited_ = 0;
  bool pending_ = false;
};

}  // namespace fantail::hal::stm32f4::test
