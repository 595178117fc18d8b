// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "hal/stm32f4/registers/flash_interface.hpp"
#include "hal/stm32f4/registers/pwr.hpp"
#include "hal/stm32f4/registers/rcc.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// Oscillators, PLL, switch and wait states of an STM32F405 with an 8 MHz crystal. Bits and limits are those of RM0090
/// sections 3 and 7 and of the data sheet. Remembers whether anything was ever faster than it may be.
class FakeClocks {
 public:
  bool crystal_starts = true;
  bool pll_locks = true;
  bool flash_takes_wait_states = true;
  bool switch_works = true;
  int looks_until_ready = 20;       ///< at an oscillator or at the PLL, without a clock
  std::function<double()> now_s{};  ///< else the crystal takes 2 ms and the PLL 0.2: DS8626, HSE and main PLL

  registers::Rcc rcc{};
  registers::FlashInterface flash{};
  registers::Pwr pwr{};

  explicit FakeClocks(RegisterWorld& world) {
    RegisterWorld::poke(rcc.cr, 0x83);  // reset value: the internal oscillator is on and ready
    RegisterWorld::poke(rcc.pllcfgr, 0x24003010);
    world.on_read(rcc.cr, [this] { return cr(); });
    world.on_write(rcc.cr, [this](std::uint32_t value) { set_cr(value); });
    world.on_read(rcc.cfgr, [this] { return cfgr_ | running_from() << 2U; });
    world.on_write(rcc.cfgr, [this](std::uint32_t value) {
      cfgr_ = value & ~0xCU;
      look_at_limits();
    });
    world.on_read(flash.acr, [this] { return acr_; });
    world.on_write(flash.acr, [this](std::uint32_t value) {
      acr_ = flash_takes_wait_states ? value : value & ~7U;
      look_at_limits();
    });
  }

  [[nodiscard]] double core_hz() const {
    return running_from() == 2 ? pll_hz(2 * (((pllcfgr() >> 16U) & 3U) + 1)) : 16e6;
  }
  [[nodiscard]] double apb1_hz() const { return core_hz() / divider(10); }
  [[nodiscard]] double apb2_hz() const { return core_hz() / divider(13); }
  [[nodiscard]] double apb1_timers_hz() const { return divider(10) == 1 ? apb1_hz() : 2 * apb1_hz(); }
  [[nodiscard]] double apb2_timers_hz() const { return divider(13) == 1 ? apb2_hz() : 2 * apb2_hz(); }
  [[nodiscard]] double rng_hz() const { return pll_ready() ? pll_hz((pllcfgr() >> 24U) & 15U) : 0; }
  [[nodiscard]] bool crystal_is_watched() const { return css_; }
  [[nodiscard]] bool crystal_is_on() const { return hse_on_; }
  [[nodiscard]] bool pll_is_on() const { return pll_on_; }
  [[nodiscard]] std::uint32_t acr() const { return acr_; }
  [[nodiscard]] bool ever_too_fast() const { return too_fast_; }

 private:
  [[nodiscard]] std::uint32_t pllcfgr() const { return RegisterWorld::peek(rcc.pllcfgr); }
  [[nodiscard]] bool fed_by_crystal() const { return (pllcfgr() >> 22U & 1U) != 0; }
  [[nodiscard]] double pll_hz(unsigned output_divider) const {
    const double input = (fed_by_crystal() ? 8e6 : 16e6) / (pllcfgr() & 0x3FU);
    return input * (pllcfgr() >> 6U & 0x1FFU) / output_divider;
  }
  [[nodiscard]] unsigned divider(unsigned shift) const {
    const unsigned code = cfgr_ >> shift & 7U;
    return code < 4 ? 1 : 2U << (code - 4);
  }
  [[nodiscard]] std::uint32_t running_from() const { return switch_works && (cfgr_ & 3U) == 2 && pll_ready() ? 2 : 0; }

  /// In seconds, or in looks.
  [[nodiscard]] double now() const { return now_s ? now_s() : looks_; }
  [[nodiscard]] bool crystal_ready() const { return hse_on_ && crystal_starts && now() >= hse_ready_at_; }
  [[nodiscard]] bool pll_ready() const {
    return pll_on_ && pll_locks && (!fed_by_crystal() || crystal_ready()) && now() >= pll_ready_at_;
  }

  std::uint32_t cr() {
    looks_ += 1;
    return 0x83U | (hse_on_ ? 1U << 16U : 0) | (crystal_ready() ? 1U << 17U : 0) | (css_ ? 1U << 19U : 0) |
           (pll_on_ ? 1U << 24U : 0) | (pll_ready() ? 1U << 25U : 0);
  }

  void set_cr(std::uint32_t value) {
    const bool hse_on = (value >> 16U & 1U) != 0;
    const bool pll_on = (value >> 24U & 1U) != 0;
    if (hse_on && !hse_on_) {
      hse_ready_at_ = now() + (now_s ? 2e-3 : looks_until_ready);
    }
    if (pll_on && !pll_on_) {
      pll_ready_at_ = now() + (now_s ? 0.2e-3 : looks_until_ready);
    }
    hse_on_ = hse_on;
    pll_on_ = pll_on;
    css_ = css_ || (value >> 19U & 1U) != 0;  // only a reset or a failure clears it
    // RM0090 section 7.3.2: 1 to 2 MHz into the PLL, 100 to 432 MHz out of its oscillator.
    too_fast_ = too_fast_ || (pll_on && (pll_hz(1) < 100e6 || pll_hz(1) > 432e6));
  }

  // RM0090 table 10 for 2.7 V to 3.6 V: one wait state for each 30 MHz begun after the first.
  void look_at_limits() {
    const unsigned wait_states = acr_ & 7U;
    too_fast_ =
        too_fast_ || core_hz() > 30e6 * (wait_states + 1) || core_hz() > 168e6 || apb1_hz() > 42e6 || apb2_hz() > 84e6;
  }

  std::uint32_t cfgr_ = 0;
  std::uint32_t acr_ = 0;
  bool hse_on_ = false;
  bool pll_on_ = false;
  bool css_ = false;
  double looks_ = 0;
  double hse_ready_at_ = 0;
  double pll_ready_at_ = 0;
  bool too_fast_ = false;
};

}  // namespace fantail::hal::stm32f4::test
