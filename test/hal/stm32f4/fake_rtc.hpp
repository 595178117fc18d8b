// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/registers/rcc.hpp"
#include "hal/stm32f4/registers/rtc.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// The clock of the backup domain and its crystal: RM0090 sections 7.3.20 and 26. A reset of the processor leaves all
/// of it alone but the initialization.
struct FakeRtc {
  registers::Rcc rcc{};
  registers::Rtc device{};
  double crystal_starts_in_s = 1.0;  ///< below 0: there is none
  bool stands_still = false;

  explicit FakeRtc(RegisterWorld& world) {
    RegisterWorld::poke(device.prer, 0x007F00FF);
    world.on_read(rcc.bdcr, [this] { return bdcr_ | (ready() ? 2U : 0U); });
    world.on_write(rcc.bdcr, [this](std::uint32_t value) {
      const std::uint32_t source = (bdcr_ >> 8U & 3U) != 0 ? bdcr_ & 0x300U : value & 0x300U;  // once only
      bdcr_ = (value & ~0x302U) | source;
    });
    world.on_write(device.wpr, [this](std::uint32_t key) {
      unlocked_ = last_key_ == 0xCA && key == 0x53;
      last_key_ = key;
    });
    world.on_read(device.isr, [this] { return (asked_ ? 1U << 7U : 0) | (stopped() ? 1U << 6U : 0); });
    world.on_write(device.isr, [this](std::uint32_t value) {
      if (unlocked_) {
        const bool ask = (value >> 7U & 1U) != 0;
        asked_s_ = ask && !asked_ ? now_s_ : asked_s_;
        if (!ask && asked_) {
          began_s_ = now_s_;
        }
        asked_ = ask;
      }
    });
    world.on_write(device.prer, [this](std::uint32_t value) { set_stopped(device.prer, value); });
    world.on_write(device.tr, [this](std::uint32_t value) { set_stopped(device.tr, value); });
    world.on_write(device.cr, [this](std::uint32_t value) {
      if (unlocked_) {
        RegisterWorld::poke(device.cr, value);
      }
    });
    world.on_read(device.ssr, [this] { return look(), 32'767U - static_cast<std::uint32_t>(cycles() % 32'768); });
    world.on_read(device.tr, [this] {
      look();
      const auto seconds = static_cast<std::uint32_t>(cycles() / 32'768 % 86'400);
      const auto digits = [](std::uint32_t number) { return number / 10 << 4U | number % 10; };
      return digits(seconds / 3600) << 16U | digits(seconds / 60 % 60) << 8U | digits(seconds % 60);
    });
  }

  void pass(double seconds) { now_s_ += stands_still ? 0.0 : seconds; }
  void reset_of_the_processor() { asked_ = unlocked_ = false; }
  double look_s = 1e-6;  ///< passes before each look at the time

 private:
  [[nodiscard]] bool ready() const {
    return (bdcr_ & 1U) != 0 && crystal_starts_in_s >= 0 && now_s_ >= crystal_starts_in_s;
  }
  [[nodiscard]] bool clocked() const { return ready() && (bdcr_ & 0x8300U) == 0x8100U; }
  [[nodiscard]] bool stopped() const { return clocked() && asked_ && now_s_ - asked_s_ > 2.0 / 32'768; }
  [[nodiscard]] std::uint64_t cycles() const {
    const bool set = RegisterWorld::peek(device.prer) == 0x7FFF;
    return clocked() && set ? static_cast<std::uint64_t>((now_s_ - began_s_) * 32'768) : 0;
  }
  void set_stopped(registers::Register& place, std::uint32_t value) {
    if (unlocked_ && stopped()) {
      RegisterWorld::poke(place, value);
    }
  }
  void look() { pass(look_s); }

  std::uint32_t bdcr_ = 0;
  std::uint32_t last_key_ = 0;
  bool unlocked_ = false;
  bool asked_ = false;
  double asked_s_ = 0.0;
  double began_s_ = 0.0;
  double now_s_ = 0.0;
};

}  // namespace fantail::hal::stm32f4::test
