// SPDX-License-Identifier: MIT
#include "hal/stm32f4/battery.hpp"

#include <algorithm>
#include <limits>

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t full_scale = 4095;
constexpr std::uint32_t first_slow_channel = 10;  // whose sample time is in the first of the two registers

}  // namespace

Battery::Battery(Adc& converter, AdcCommon& common, const Wiring& wiring) : converter_{&converter}, wiring_{wiring} {
  common.ccr.write(adc_ccr_divide_by_4);  // 21 MHz of 84 MHz; at most 36 MHz by the data sheet
  converter.cr1.write(0);                 // 12 bits, no interrupt
  // The longest sample time, 23 us at 21 MHz, for the high resistance of the divider.
  converter.smpr[0].write(adc_smpr_480_cycles << ((wiring.channel - first_slow_channel) * adc_smpr_bits_per_channel));
  converter.sqr[0].write(0);  // a sequence of one
  converter.sqr[2].write(wiring.channel);
  converter.cr2.write(adc_cr2_adon);
}

void Battery::update() {
  if (converter_->sr.any(adc_sr_eoc)) {
    const std::uint32_t counts = std::min(converter_->dr.read(), full_scale);
    const std::uint64_t millivolts = std::uint64_t{counts} * wiring_.reference_mv * wiring_.divider / full_scale;
    constexpr std::uint64_t most = std::numeric_limits<std::uint16_t>::max();
    millivolts_ = static_cast<std::uint16_t>(std::min(millivolts, most));
    ticks_without_ = 0;
  } else if (ticks_without_ < patience_ticks) {
    ticks_without_ += 1;
    if (failed()) {
      millivolts_.reset();
    }
  }
  // Switched on in the constructor, a tick or more before the first of these: it needs 3 us to settle.
  converter_->cr2.write(adc_cr2_adon | adc_cr2_swstart);
}

}  // namespace fantail::hal::stm32f4
