// SPDX-License-Identifier: MIT
#include "hal/stm32f4/edge_timer.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t count_hz = 1'000'000;
// Eight samples at the timer's clock: what is shorter than 95 ns at 84 MHz is no edge.
constexpr std::uint32_t filter = 3;

}  // namespace

EdgeTimer::EdgeTimer(Tim& timer, std::uint32_t timer_hz) : timer_{&timer} {
  timer.cr1.write(0);
  timer.ccer.write(0);  // the direction of a channel changes only while it is off
  timer.psc.write(timer_hz / count_hz - 1);
  timer.arr.write(0xFFFF'FFFF);
  timer.ccmr[1].write((tim_ccmr_input | filter << tim_ccmr_input_filter_shift) << tim_ccmr_bits_per_channel);
  timer.ccer.write(tim_ccer_cce << (3 * tim_ccer_bits_per_channel));
  timer.egr.write(tim_egr_ug);  // takes over the prescaler
  timer.cr1.write(tim_cr1_cen);
}

bool EdgeTimer::take_overrun() {
  const bool overrun = timer_->sr.any(tim_sr_cc4of);
  if (overrun) {
    timer_->sr.write(~tim_sr_cc4of);
  }
  return overrun;
}

}  // namespace fantail::hal::stm32f4
