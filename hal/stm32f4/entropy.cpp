// SPDX-License-Identifier: MIT
#include "hal/stm32f4/entropy.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

// A number takes 40 cycles of the generator's 48 MHz, 0.9 us: RM0090 section 24.1. A look takes 50 ns or more.
constexpr std::uint32_t looks_for_number = 200;

}  // namespace

// Section 24.3.1: the first number after the start is only there to be compared with the next.
Entropy::Entropy(Rng& device) : device_{&device} {
  device.cr.write(rng_cr_rngen);
  last_ = draw();
}

std::uint32_t Entropy::draw() {
  const bool ready = wait_for(device_->sr, rng_sr_drdy, rng_sr_drdy, looks_for_number);
  if (!ready || device_->sr.any(rng_sr_cecs | rng_sr_secs | rng_sr_ceis | rng_sr_seis)) {
    begin_anew();
    return last_;
  }
  const std::uint32_t number = device_->dr.read();
  if (number == last_) {
    failed_ = true;
    return last_;
  }
  last_ = number;
  return number;
}

// Section 24.3.2: a seed error ends with its flag cleared and the generator started again.
void Entropy::begin_anew() {
  failed_ = true;
  device_->sr.write(0);
  device_->cr.write(0);
  device_->cr.write(rng_cr_rngen);
}

}  // namespace fantail::hal::stm32f4
