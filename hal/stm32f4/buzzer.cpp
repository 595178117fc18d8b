// SPDX-License-Identifier: MIT
#include "hal/stm32f4/buzzer.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t count_hz = 1'000'000;

}  // namespace

Buzzer::Buzzer(Tim& timer, std::uint32_t timer_hz, std::uint32_t tone_hz)
    : timer_{&timer}, half_a_wave_{count_hz / tone_hz / 2} {
  timer.cr1.write(0);
  timer.psc.write(timer_hz / count_hz - 1);
  timer.arr.write(count_hz / tone_hz - 1);
  timer.rcr.write(0);
  timer.ccr[0].write(0);
  timer.ccmr[0].write(tim_ccmr_ocm_pwm1 | tim_ccmr_ocpe);
  timer.ccer.write(tim_ccer_cce);
  timer.egr.write(tim_egr_ug);
  timer.bdtr.write(tim_bdtr_moe);
  timer.cr1.write(tim_cr1_cen | tim_cr1_arpe);
}

void Buzzer::sound(bool on) {
  if (on != on_) {
    timer_->ccr[0].write(on ? half_a_wave_ : 0);
    on_ = on;
  }
}

}  // namespace fantail::hal::stm32f4
