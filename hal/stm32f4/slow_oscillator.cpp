// SPDX-License-Identifier: MIT
#include "hal/stm32f4/slow_oscillator.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t cycles_per_capture = 8;
// A look takes three cycles of APB1 or more, 70 ns; eight cycles of 17 kHz take 0.47 ms.
constexpr std::uint32_t looks_for_capture = 10'000;
constexpr std::uint32_t slowest_hz = 17'000;  // data sheet, LSI oscillator characteristics
constexpr std::uint32_t fastest_hz = 47'000;

bool captured(const Tim& timer) { return wait_for(timer.sr, tim_sr_cc4if, tim_sr_cc4if, looks_for_capture); }

}  // namespace

// RM0090 section 7.2.11. The first capture may come at any time after the start, the second eight cycles after it.
std::optional<std::uint32_t> measure_slow_oscillator(Rcc& rcc, Tim& tim5, std::uint32_t timer_hz) {
  rcc.csr.set(rcc_csr_lsion);
  rcc.apb1enr.set(rcc_apb1enr_tim5);
  static_cast<void>(rcc.apb1enr.read());  // errata sheet ES0182: the clock is there two cycles after it was asked for
  tim5.option.write(tim5_option_ti4_rmp_lsi);
  tim5.ccmr[1].write(tim_ccmr2_cc4s_ti4 | tim_ccmr2_ic4psc_8);
  tim5.ccer.write(tim_ccer_cc4e);
  tim5.arr.write(0xFFFFFFFF);
  tim5.cr1.write(tim_cr1_cen);
  const bool first = captured(tim5);
  const std::uint32_t begin = tim5.ccr[3].read();
  const bool second = first && captured(tim5);
  const std::uint32_t counts = tim5.ccr[3].read() - begin;
  tim5.cr1.write(0);
  tim5.ccer.write(0);
  rcc.apb1enr.clear(rcc_apb1enr_tim5);
  if (!second || counts == 0) {
    return std::nullopt;
  }
  const std::uint32_t hz = timer_hz * cycles_per_capture / counts;
  constexpr std::uint32_t tolerance_hz = 500;  // what the measurement and a cold one may add
  return hz >= slowest_hz - tolerance_hz && hz <= fastest_hz + tolerance_hz ? std::optional{hz} : std::nullopt;
}

}  // namespace fantail::hal::stm32f4
