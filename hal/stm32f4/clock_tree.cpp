// SPDX-License-Identifier: MIT
#include "hal/stm32f4/clock_tree.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

// A look takes eight cycles of HSI or more, half a microsecond. The crystal starts within 2 ms (data sheet, HSE
// oscillator characteristics), the PLL locks within 300 us (PLL characteristics), the others answer in a few cycles.
constexpr std::uint32_t looks_for_crystal = 20'000;
constexpr std::uint32_t looks_for_pll = 4'000;
constexpr std::uint32_t looks_for_switch = 1'000;

constexpr std::uint32_t pll_input_hz = 1'000'000;
constexpr std::uint32_t pll_multiplier = 336;
constexpr std::uint32_t pll_core_divider = 2;
constexpr std::uint32_t pll_48_mhz_divider = 7;  // for the random number generator
constexpr std::uint32_t core_hz = pll_input_hz * pll_multiplier / pll_core_divider;
static_assert(core_hz == 168'000'000);
static_assert(pll_input_hz * pll_multiplier / pll_48_mhz_divider == 48'000'000);

// RM0090 table 10: above 150 MHz at 2.7 V to 3.6 V. Below, the flash may give wrong instructions, and only the
// brown-out reset ends that: its level 3 begins at 2.7 V (data sheet, embedded reset and power control block).
constexpr std::uint32_t wait_states = 5;

constexpr Frequencies fast{.core_hz = core_hz,
                           .apb1_hz = core_hz / 4,
                           .apb1_timers_hz = core_hz / 2,
                           .apb2_hz = core_hz / 2,
                           .apb2_timers_hz = core_hz};
constexpr Frequencies slow{.core_hz = internal_oscillator_hz,
                           .apb1_hz = internal_oscillator_hz,
                           .apb1_timers_hz = internal_oscillator_hz,
                           .apb2_hz = internal_oscillator_hz,
                           .apb2_timers_hz = internal_oscillator_hz};

bool start_crystal(Rcc& rcc) {
  rcc.cr.set(rcc_cr_hseon);
  if (wait_for(rcc.cr, rcc_cr_hserdy, rcc_cr_hserdy, looks_for_crystal)) {
    return true;
  }
  rcc.cr.clear(rcc_cr_hseon);
  return false;
}

bool start_pll(Rcc& rcc, bool from_crystal) {
  const std::uint32_t source_hz = from_crystal ? crystal_hz : internal_oscillator_hz;
  rcc.pllcfgr.write((source_hz / pll_input_hz) << rcc_pllcfgr_pllm_shift | pll_multiplier << rcc_pllcfgr_plln_shift |
                    (pll_core_divider / 2 - 1) << rcc_pllcfgr_pllp_shift |
                    pll_48_mhz_divider << rcc_pllcfgr_pllq_shift | (from_crystal ? rcc_pllcfgr_pllsrc_hse : 0));
  rcc.cr.set(rcc_cr_pllon);
  return wait_for(rcc.cr, rcc_cr_pllrdy, rcc_cr_pllrdy, looks_for_pll);
}

// The wait states come first, and are seen to have come: RM0090 section 3.5.1.
bool slow_flash_down(FlashInterface& flash) {
  flash.acr.write(wait_states | flash_acr_prften | flash_acr_icen | flash_acr_dcen);
  return wait_for(flash.acr, flash_acr_latency, wait_states, looks_for_switch);
}

bool run_from_pll(Rcc& rcc) {
  rcc.cfgr.write(rcc_cfgr_ppre1_4 | rcc_cfgr_ppre2_2);  // the buses before the core, or they would be too fast
  rcc.cfgr.set(rcc_cfgr_sw_pll);
  return wait_for(rcc.cfgr, rcc_cfgr_sws, rcc_cfgr_sws_pll, looks_for_switch);
}

}  // namespace

ClockTree start_clocks(Rcc& rcc, FlashInterface& flash, Pwr& pwr) {
  ClockTree result{.frequencies = fast};
  rcc.apb1enr.set(rcc_apb1enr_pwr);
  pwr.cr.set(pwr_cr_vos);  // while the PLL is off: section 5.1.3

  if ((flash.optcr.read() & flash_optcr_bor_lev) != 0) {
    result.faults.add(BoardFault::brown_out_level);
  }
  const bool from_crystal = start_crystal(rcc);
  if (!from_crystal) {
    result.faults.add(BoardFault::crystal_failed);
  }
  if (start_pll(rcc, from_crystal) && slow_flash_down(flash) && run_from_pll(rcc)) {
    if (from_crystal) {
      rcc.cr.set(rcc_cr_csson);
    }
    return result;
  }
  rcc.cfgr.write(0);  // HSI, no bus divided
  rcc.cr.clear(rcc_cr_pllon);
  result.faults.add(BoardFault::clock_failed);
  result.frequencies = slow;
  return result;
}

void enable_peripherals(Rcc& rcc) {
  rcc.ahb1enr.set(rcc_ahb1enr_gpioa | rcc_ahb1enr_gpiob | rcc_ahb1enr_gpioc);
  rcc.ahb2enr.set(rcc_ahb2enr_rng);
  rcc.apb1enr.set(rcc_apb1enr_tim2 | rcc_apb1enr_spi2 | rcc_apb1enr_spi3 | rcc_apb1enr_can1 | rcc_apb1enr_pwr);
  rcc.apb2enr.set(rcc_apb2enr_tim1 | rcc_apb2enr_tim8 | rcc_apb2enr_usart1 | rcc_apb2enr_adc1 | rcc_apb2enr_spi1);
  // A clock is there two bus cycles after it was asked for (errata sheet ES0182, delay after an RCC peripheral clock
  // enabling); a read takes longer.
  static_cast<void>(rcc.apb2enr.read());
}

}  // namespace fantail::hal::stm32f4
